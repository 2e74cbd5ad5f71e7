#include "check/certified/proof.h"

#include <assert.h>
#include <math.h>

#include "check/certified/merged_steps.h"
#include "check/step.h"
#include "geom/tolerance.h"
#include "machine/motion_bound.h"

/*
 * A target beyond the clearance need not be decided exactly: an error of this share of the part beyond the clearance is
 * permitted.
 */
#define MEASURE_SHARE 0.1

/* The largest number of node pairs for one rapid whose path is not known. Beyond it the check reports an error. */
#define BOX_VISITS 50000000L

void pair_proof_init(struct pair_proof *proof, const struct body_pair *bodies, double clearance, double tolerance)
{
	*proof = (struct pair_proof){
		.bodies = *bodies, .clearance = clearance, .target = clearance, .tolerance = tolerance};
	proof->bodies.coherence = &proof->coherence;
	kept_budgets_init(&proof->budgets, bodies->chain);
	plane_cells_init(&proof->planes, &proof->bodies);
}

void pair_proof_release(struct pair_proof *proof)
{
	plane_cells_release(&proof->planes);
}

void pair_proof_copy(struct pair_proof *to, const struct pair_proof *from)
{
	*to = *from;
	to->bodies.coherence = &to->coherence;
	plane_cells_copy(&to->planes, &from->planes);
	to->planes.bodies = &to->bodies;
}

void pair_proof_take(struct pair_proof *to, struct pair_proof *from)
{
	pair_proof_release(to);
	*to = *from;
	to->bodies.coherence = &to->coherence;
	to->planes.bodies = &to->bodies;
	plane_cells_init(&from->planes, &from->bodies);
}

double pair_proof_needed(const struct pair_proof *proof)
{
	return proof->target + proof->tolerance;
}

void pair_proof_aim(struct pair_proof *proof, double wanted)
{
	double target = wanted > proof->clearance + proof->tolerance ? wanted : proof->clearance;

	assert(target <= proof->target);
	if (target < proof->target)
		plane_cells_join(&proof->planes);
	proof->target = target;
}

void pair_proof_forget_position(struct pair_proof *proof)
{
	proof->clear_at_end = proof->position_known = false;
}

/* A piece of motion ended at q. */
static void follow_to(struct pair_proof *proof, const axis_values *q, bool clear)
{
	kept_budgets_resume(&proof->budgets, q);
	proof->position_known = clear;
	proof->clear_at_end = clear;
}

void pair_proof_add_distance(struct pair_proof *proof, const axis_values *q, const struct chain_state *state,
			     double distance)
{
	kept_budgets_set(&proof->budgets, q, state, distance - pair_proof_needed(proof));
	proof->position_known = false;
}

bool pair_proof_still(const struct pair_proof *proof, const struct motion_step *step)
{
	const struct chain *chain = proof->bodies.chain;

	return proof->clear_at_end && !step_moves(chain, step) && !step_may_leave_path(chain, step);
}

bool pair_proof_box(struct pair_proof *proof, const axis_values *low, const axis_values *high,
		    const struct position_errors *errors, const axis_values *end, bool recall)
{
	if (!kept_budgets_cover_box(&proof->budgets, low, high, end, errors, recall))
		return false;
	proof->clear_at_end = proof->position_known = true;
	return true;
}

bool pair_proof_step_by_budget(struct pair_proof *proof, const struct motion_step *step,
			       const struct position_errors *errors)
{
	const struct span *span = &step->span;
	axis_values low, high;

	if (step_is_box(step)) {
		step_box(step, &low, &high);
		return pair_proof_box(proof, &low, &high, errors, &span->q1, true);
	}
	if (!proof->position_known)
		kept_budgets_resume(&proof->budgets, &span->q0);
	proof->position_known = kept_budgets_cover(&proof->budgets, &span->q0, &span->q1, errors);
	proof->clear_at_end |= proof->position_known;
	return proof->position_known;
}

/* mm: planes must leave a larger gap than this. */
static double needed_of_planes(const struct pair_proof *proof, const struct plane_motion *motion,
			       const struct position_errors *errors)
{
	return pair_proof_needed(proof) + plane_motion_path(motion, &proof->bodies, errors);
}

/* Planes have proved a piece of motion, so the axes are past the positions that the budget in use has counted. */
static bool passed_by_planes(struct pair_proof *proof, bool passed)
{
	if (!passed)
		return false;
	proof->clear_at_end = true;
	proof->position_known = false;
	return true;
}

/* Proves a piece of motion with the kept planes, or else with new ones at q. */
static bool by_planes(struct pair_proof *proof, const struct plane_motion *motion, const struct position_errors *errors,
		      const axis_values *q, bool search)
{
	double needed = needed_of_planes(proof, motion, errors);

	return passed_by_planes(proof, search ? plane_cells_search(&proof->planes, q, motion, needed)
					      : plane_cells_cover(&proof->planes, motion, needed));
}

bool pair_proof_box_by_planes(struct pair_proof *proof, const axis_values *low, const axis_values *high,
			      const struct position_errors *errors, bool search)
{
	const struct plane_motion motion = {.q0 = *low, .q1 = *high, .chord_error = errors->chord};
	const axis_values middle = plane_motion_middle(&motion);

	return by_planes(proof, &motion, errors, &middle, search);
}

static struct plane_motion motion_of(const struct motion_step *step, const struct position_errors *errors)
{
	return (struct plane_motion){
		.straight = !step_is_box(step),
		.q0 = step->span.q0,
		.q1 = step->span.q1,
		.chord_error = errors->chord,
	};
}

bool pair_proof_step_by_planes(struct pair_proof *proof, const struct motion_step *step,
			       const struct position_errors *errors, bool search)
{
	const struct plane_motion motion = motion_of(step, errors);

	return by_planes(proof, &motion, errors, &step->span.q1, search);
}

/* `needed` of the whole motion is enough for each part of it. */
static bool halves_by_planes(struct plane_cells *planes, const struct plane_motion *motion, double needed, int halvings)
{
	const axis_values middle = plane_motion_middle(motion);
	struct plane_motion half[2] = {*motion, *motion};

	if (plane_cells_cover(planes, motion, needed) || plane_cells_search(planes, &middle, motion, needed))
		return true;
	if (!halvings)
		return false;
	half[0].q1 = half[1].q0 = middle;
	return halves_by_planes(planes, &half[0], needed, halvings - 1) &&
	       halves_by_planes(planes, &half[1], needed, halvings - 1);
}

bool pair_proof_halves_by_planes(struct pair_proof *proof, const struct motion_step *step,
				 const struct position_errors *errors, int halvings)
{
	const struct plane_motion motion = motion_of(step, errors);

	return motion.straight && passed_by_planes(proof, halves_by_planes(&proof->planes, &motion,
									   needed_of_planes(proof, &motion, errors),
									   halvings));
}

bool pair_proof_recall(struct pair_proof *proof, const struct motion_step *step)
{
	const struct position_errors errors = step_errors(proof->bodies.chain, step);

	return kept_budgets_recall(&proof->budgets, &step->span.q0, &step->span.q1, &errors);
}

bool pair_proof_chord(struct pair_proof *proof, struct sweep *sweep, const struct chord *merged)
{
	const struct clearance_query query = {
		.sweep = sweep,
		.bodies = &proof->bodies,
		.clearance = pair_proof_needed(proof),
		.tolerance = proof->tolerance,
		.any = true,
	};
	struct chord chord = *merged;
	struct contact contact;
	axis_values tolerance;

	chord.tolerance = merged_steps_tolerance(proof->bodies.chain, merged, &tolerance);
	if (clearance_query_chord(&query, &chord, &contact) != QUERY_CLEAR)
		return false;
	follow_to(proof, &chord.q1, true);
	return true;
}

enum query_answer pair_proof_step(struct pair_proof *proof, struct sweep *sweep, const struct motion_step *step,
				  struct contact *contact)
{
	double beyond = proof->target - proof->clearance;
	const struct clearance_query query = {
		.sweep = sweep,
		.bodies = &proof->bodies,
		.clearance = proof->target,
		.tolerance = fmax(proof->tolerance, MEASURE_SHARE * beyond),
		.any = beyond > 0,
		.box_visits = BOX_VISITS >> proof->box_halvings,
	};
	enum query_answer answer = clearance_query_step(&query, step, contact);

	follow_to(proof, &step->span.q1, answer == QUERY_CLEAR);
	return answer;
}
