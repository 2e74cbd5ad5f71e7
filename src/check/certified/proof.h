/*
 * proof.h - the proof for one pair of bodies: every statement of the certified method that two bodies stay apart comes
 * from here. Two other files prove more: check/stock_pair.h for bodies and stock, and scene/pairs.h for pairs that can
 * never meet. man/fivecheck.7 ("Certificates", "Budgets") derives the bounds.
 */
#ifndef FIVECHECK_CHECK_CERTIFIED_PROOF_H
#define FIVECHECK_CHECK_CERTIFIED_PROOF_H

#include <stdbool.h>

#include "check/batch.h"
#include "check/certified/clearance_query.h"
#include "check/certified/kept_budgets.h"
#include "check/certified/plane_cells.h"
#include "scene/coherence.h"

/*
 * Below, D is the distance of the bodies at a position on the programmed path, W the path displacement there
 * (motion_bound.h), t the target, which is at least the clearance c, and e the tolerance.
 *
 * The exact sweep of a step reports no position with D > c + W + e. Each quick method proves D > t + W + e for every
 * position that it passes. So it never passes a position that the sweep would report, and no verdict depends on which
 * method was tried (test_one_verdict).
 *
 * The proof counts nothing and chooses nothing: strategy.h decides which proof to try next. The strategy must call
 * pair_proof_forget_position whenever it leaves out motion, and may call pair_proof_add_distance only with proved
 * distances.
 */
struct pair_proof {
	struct body_pair bodies;
	double clearance;	/* mm: c */
	double target;	/* mm: t, set by pair_proof_aim; INFINITY: not set yet, nothing can be proved */
	double tolerance;	/* mm: e */
	struct coherence coherence;
	struct kept_budgets budgets;	/* regions of joint space, in each of which D > t + e for the t of its time */
	struct plane_cells planes;	/* gaps that hold near the positions where they were measured */
	bool clear_at_end;	/* proved: the pair is apart at the end of the last piece of motion */
	int box_halvings;	/* PATH_BOX: how often the effort of a sweep is halved */
	bool position_known;	/* the current budget includes all motion up to the start of the next piece */
};

/*
 * The proof must not be moved; pair_proof_copy copies one, and pair_proof_take moves one to the place of another.
 * Release each of them.
 */
void pair_proof_init(struct pair_proof *proof, const struct body_pair *bodies, double clearance, double tolerance);
void pair_proof_release(struct pair_proof *proof);
void pair_proof_copy(struct pair_proof *to, const struct pair_proof *from);
void pair_proof_take(struct pair_proof *to, struct pair_proof *from);

/* mm: t + e. */
double pair_proof_needed(const struct pair_proof *proof);

/*
 * Sets t: `wanted` mm, or c if `wanted` is at most c + e; a target is c, or above c + e. A target may only become
 * smaller: then the budgets of a larger one still hold.
 */
void pair_proof_aim(struct pair_proof *proof, double wanted);

/* Motion was left out: the next piece does not begin where the last one ended. Only the budgets still hold. */
void pair_proof_forget_position(struct pair_proof *proof);

/* sweep_distance proved more than `distance` mm at q, with the chain's state `state`: this becomes a new budget. */
void pair_proof_add_distance(struct pair_proof *proof, const axis_values *q, const struct chain_state *state,
			     double distance);

/*
 * Still: the step moves no joint between the bodies, the control may not leave it, and the pair was proved apart at its
 * start. This holds for the whole step: a sweep of it could only report what the last piece's sweep reports at its end.
 */
bool pair_proof_still(const struct pair_proof *proof, const struct motion_step *step);

/*
 * Box: by a budget, D > t + W + e at all positions between low and high, plus or minus `errors`. The motion ends at
 * `end`. recall: also try earlier budgets.
 */
bool pair_proof_box(struct pair_proof *proof, const axis_values *low, const axis_values *high,
		    const struct position_errors *errors, const axis_values *end, bool recall);

/* Step: by a budget, D > t + W + e on all of it. */
bool pair_proof_step_by_budget(struct pair_proof *proof, const struct motion_step *step,
			       const struct position_errors *errors);

/*
 * Box and step: by travelling planes. Every part of one body is more than t + W + e from every part of the other along
 * the normal of a plane. `search`: new planes are measured where the kept ones fail: at the middle of the box, or at
 * the end of the step.
 */
bool pair_proof_box_by_planes(struct pair_proof *proof, const axis_values *low, const axis_values *high,
			      const struct position_errors *errors, bool search);
bool pair_proof_step_by_planes(struct pair_proof *proof, const struct motion_step *step,
			       const struct position_errors *errors, bool search);

/*
 * The same, with different planes for parts of the step, which is halved up to this number of times if no plane lasts
 * longer. New planes are measured at the middle of each part.
 */
bool pair_proof_halves_by_planes(struct pair_proof *proof, const struct motion_step *step,
				 const struct position_errors *errors, int halvings);

/* Is the step inside an earlier budget? Then this budget becomes the current one. Proves nothing by itself. */
bool pair_proof_recall(struct pair_proof *proof, const struct motion_step *step);

/* Chord of several steps, made by merged_steps_chord: by a sweep, D > t + W + e on all of them. */
bool pair_proof_chord(struct pair_proof *proof, struct sweep *sweep, const struct chord *merged);

/*
 * Step, by the sweep, which has the last word. If t = c: CLEAR means D > c + W at every instant of the step; CONTACT
 * means that *contact is the first instant, within the motion e, and D <= c + W + e there. If t > c + e: CLEAR means
 * D > t + W; CONTACT means that this does not hold, and *contact shows where.
 */
enum query_answer pair_proof_step(struct pair_proof *proof, struct sweep *sweep, const struct motion_step *step,
				  struct contact *contact);

#endif
