/* proof.h - what is proved of one pair of bodies. Every answer that a pair stays apart comes from here. */
#ifndef FIVECHECK_CHECK_CERTIFIED_PROOF_H
#define FIVECHECK_CHECK_CERTIFIED_PROOF_H

#include <stdbool.h>

#include "check/batch.h"
#include "check/certified/clearance_query.h"
#include "check/certified/kept_budgets.h"
#include "scene/coherence.h"

/*
 * Below, D is the distance of the bodies at a position on the programmed path, W the path displacement there
 * (motion_bound.h), t the target, which is at least the clearance c, and e the tolerance.
 *
 * The exact sweep of a step reports no position where D > c + W + e. Each quick way proves D > t + W + e for every position
 * that it passes. So it passes nothing that the sweep would report, and no verdict depends on which way was tried
 * (test_one_verdict).
 *
 * The proof counts nothing and chooses nothing: strategy.h asks, and decides what to ask next.
 */
struct pair_proof {
	struct body_pair bodies;
	double clearance;	/* mm: c */
	double target;	/* mm: t; INFINITY: not chosen yet, nothing can be proved */
	double tolerance;	/* mm: e */
	struct coherence coherence;
	struct kept_budgets budgets;	/* regions of joint space, in each of which D > t + e at its chosen target */
	bool clear_at_end;	/* proved where the last piece of motion ended: the pair is apart there */
};

/* The proof must stay where it is from here on; pair_proof_copy copies one. */
void pair_proof_init(struct pair_proof *proof, const struct body_pair *bodies, double clearance, double tolerance);
void pair_proof_copy(struct pair_proof *to, const struct pair_proof *from);

/* mm: t + e. */
double pair_proof_needed(const struct pair_proof *proof);

/* Motion was left out: of what the axes do next only the budgets know. */
void pair_proof_forget_position(struct pair_proof *proof);

/* The axes stand at q, without having been followed there. */
void pair_proof_resume(struct pair_proof *proof, const axis_values *q);

/* A distance of more than `distance` mm was proved at q, where the chain's state is `state`: it makes a new budget. */
void pair_proof_add_distance(struct pair_proof *proof, const axis_values *q, const struct chain_state *state,
			     double distance);

/*
 * A step that moves no joint between the bodies, and that the control may not leave, begins where the last piece ended: what was
 * proved there holds throughout. A sweep of the step could report only what that of the piece had reported at its end.
 */
bool pair_proof_still(const struct pair_proof *proof, const struct motion_step *step);

/* Box: by a budget, D > t + W + e wherever the axes stand between low and high, give or take `errors`. They end at `end`. */
bool pair_proof_box(struct pair_proof *proof, const axis_values *low, const axis_values *high,
		    const struct position_errors *errors, const axis_values *end);

/* Step: by a budget, D > t + W + e on all of it. */
bool pair_proof_step_by_budget(struct pair_proof *proof, const struct motion_step *step,
			       const struct position_errors *errors);

/* Is the first of several steps within an earlier budget? That one is in use then. Proves nothing by itself. */
bool pair_proof_recall(struct pair_proof *proof, const struct motion_step *step);

/* Chord of several steps (merged_steps.h): by a sweep, D > t + W + e on all of them. */
bool pair_proof_chord(struct pair_proof *proof, struct sweep *sweep, const struct chord *chord);

/*
 * Step, by the sweep that has the last word. At t = c: CLEAR: D > c + W at every instant of it. CONTACT: *contact is the first
 * instant, within the motion e; D <= c + W + e there. At t > c + e: CLEAR: D > t + W; CONTACT: not so, *contact shows it.
 */
enum query_answer pair_proof_step(struct pair_proof *proof, struct sweep *sweep, const struct motion_step *step,
				  struct contact *contact);

#endif
