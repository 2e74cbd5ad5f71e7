#include "check/measure/measured_step.h"

#include <math.h>

#include "base/ablation.h"
#include "base/minmax.h"
#include "base/same_double.h"
#include "check/step.h"
#include "scene/near_pair.h"

/*
 * How often a step is halved until planes last for a part of it. Measured: with 4 an eighth to a 16th of the sweeps are
 * left that are needed without, with 5 half of those again; then most are left where planes do not help at all.
 */
#define HALVINGS 5

/* Where the distances at the ends of a part of a step have at least this ratio, planes are measured in its middle. */
#define ALIKE 0.8

void measured_step_init(struct measured_step *measured, const struct block_clearance *block,
			const struct motion_step *step)
{
	measured->step = step;
	measured->errors = step_errors(block->bodies.chain, step);
	measured->path = 0;
	measured->seen = INFINITY;
}

/* mm: what is wanted of planes, as far as it is known how near the bodies come. */
static double wanted_of(const struct block_clearance *block, const struct measured_step *measured)
{
	return fmin(block->bound, clearance_accuracy_enough(block->accuracy, measured->seen - measured->path,
						     block->bound));
}

/* mm: the gap that planes must leave for that. */
static double needed_of(const struct block_clearance *block, const struct measured_step *measured)
{
	return wanted_of(block, measured) + measured->path;
}

static bool is_at(const struct chain *chain, const axis_values *a, const axis_values *b)
{
	for (size_t i = 0; i < chain->count; i++)
		if (!same_double(a->v[chain->joints[i].slot], b->v[chain->joints[i].slot]))
			return false;
	return true;
}

/* The bodies' pose at q, until it is asked for elsewhere. */
static const xform *pose_at(struct block_clearance *block, const axis_values *q)
{
	struct posed *posed = &block->posed;

	if (!posed->known || !is_at(block->bodies.chain, &posed->q, q))
		*posed = (struct posed){true, *q, body_pair_pose(&block->bodies, q)};
	return &posed->pose;
}

/* Looks for triangles that are near each other at q. If planes have proved `kept`, others than those are of no use. */
static void look_at(struct block_clearance *block, struct sweep *sweep, struct measured_step *measured,
		    const axis_values *q, double kept)
{
	const double useful =
	    kept > 0 ? clearance_accuracy_distance(block->accuracy, kept) + measured->path : 0;

	measured->seen = smaller(measured->seen,
				 near_pair_improve(&block->bodies, pose_at(block, q), useful, &sweep->visits));
}

/* mm: what kept planes prove of the motion; they are not asked for more than what is wanted of them. */
static double kept_for(struct block_clearance *block, const struct measured_step *measured,
		       const struct plane_motion *motion, enum planes_asked asked)
{
	if (!WITH_PLANES)
		return -INFINITY;
	return plane_cells_rest(&block->planes, motion, needed_of(block, measured), asked) - measured->path;
}

/* Does a search for planes at q pay, and prove what is wanted of them in this part of the step? */
static bool new_planes_prove(struct block_clearance *block, const struct measured_step *measured,
			     const struct plane_motion *part, const axis_values *q)
{
	const long before = block->planes.visits;
	bool held;

	if (!WITH_PLANES || !plane_account_allows(&block->account))
		return false;
	/* Of kept planes what they prove is known already, and that other triangles are nearer, too. */
	held = plane_cells_search(&block->planes, q, part, needed_of(block, measured));
	plane_account_add_search(&block->account, block->planes.visits - before);
	return held;
}

/* The triangles that were close before, as they were seen at q; NULL: they were not, or are others now. */
static const struct seen_distance *seen_at(const struct block_clearance *block, const axis_values *q)
{
	const struct coherence *coherence = &block->coherence;

	for (int i = 0; i < SEEN_KEPT; i++) {
		const struct seen_distance *seen = &block->seen[i];

		if (seen->known && seen->triangles[0] == coherence->near_a &&
		    seen->triangles[1] == coherence->near_b && is_at(block->bodies.chain, &seen->q, q))
			return seen;
	}
	return NULL;
}

/* mm: how far apart the triangles that were close before are at q: the bodies are no farther apart. */
static double distance_at(struct block_clearance *block, struct measured_step *measured, const axis_values *q)
{
	const struct coherence *coherence = &block->coherence;
	const struct seen_distance *known = seen_at(block, q);
	const double distance = known ? known->distance : near_pair_distance(&block->bodies, pose_at(block, q));

	if (!known) {
		block->oldest_seen = (block->oldest_seen + 1) % SEEN_KEPT;
		block->seen[block->oldest_seen] = (struct seen_distance){
			.known = true,
			.q = *q,
			.triangles = {coherence->near_a, coherence->near_b},
			.distance = distance,
		};
	}
	measured->seen = smaller(measured->seen, distance);
	return distance;
}

/*
 * Looks where the triangles that were close before are nearest to each other at the ends of the part, or in its middle
 * if the ends are alike. Stops as soon as what planes prove (`kept`) is all that is wanted of them. Returns the place.
 */
static axis_values look_around(struct block_clearance *block, struct sweep *sweep, struct measured_step *measured,
			       const struct plane_motion *part, double kept)
{
	const double at1 = distance_at(block, measured, &part->q1);
	axis_values nearest = part->q1;
	double at0;

	if (kept > wanted_of(block, measured))
		return nearest;
	at0 = distance_at(block, measured, &part->q0);
	if (kept > wanted_of(block, measured))
		return nearest;
	if (part->straight && smaller(at0, at1) > ALIKE * larger(at0, at1))
		nearest = plane_motion_middle(part);
	else if (at0 < at1)
		nearest = part->q0;
	look_at(block, sweep, measured, &nearest, kept);
	return nearest;
}

/*
 * Do travelling planes prove nearly all that there can be for this part of the step, of which they prove `kept` as it
 * is? What there can be becomes less as nearer triangles are found: those that were nearest before have moved apart as
 * a rule.
 */
static bool planes_prove(struct block_clearance *block, struct sweep *sweep, struct measured_step *measured,
			 const struct plane_motion *part, double kept, int halvings)
{
	axis_values middle, nearest;

	if (kept > wanted_of(block, measured))
		return true;
	nearest = look_around(block, sweep, measured, part, kept);
	if (kept > wanted_of(block, measured))
		return true;
	if (!(wanted_of(block, measured) > 0))
		return false;
	if (new_planes_prove(block, measured, part, &nearest))
		return true;
	if (!part->straight || !halvings)
		return false;
	middle = plane_motion_middle(part);
	for (int half = 0; half < 2; half++) {
		struct plane_motion shorter = *part;

		*(half ? &shorter.q0 : &shorter.q1) = middle;
		if (!planes_prove(block, sweep, measured, &shorter, kept_for(block, measured, &shorter, PLANES_ALL),
				  halvings - 1))
			return false;
	}
	return true;
}

/* What is proved is much less than what there seems to be: the bodies may be far nearer where the step begins. */
#define SEEN_TOO_FAR 0.5

/* Looks for nearer triangles where the step ends, and where it begins if the bodies may be far nearer there. */
static void look_at_ends(struct block_clearance *block, struct sweep *sweep, struct measured_step *measured,
			 const struct plane_motion *motion, double kept)
{
	look_at(block, sweep, measured, &motion->q1, kept);
	if (kept < SEEN_TOO_FAR * wanted_of(block, measured) &&
	    distance_at(block, measured, &motion->q0) <= measured->seen)
		look_at(block, sweep, measured, &motion->q0, kept);
}

/*
 * Bodies that slide past each other in large steps have the same plane between them in step after step, but it lasts
 * for less than one. The last step's is measured again where this one ends. Only if that is not enough, triangles are
 * looked for that are as near as to show that there is no more, or else in which direction there is. Returns mm: what
 * is proved, of which kept planes prove `kept`.
 */
static double carry_whole(struct block_clearance *block, struct sweep *sweep, struct measured_step *measured,
			  const struct plane_motion *motion, double kept)
{
	struct plane_cells *planes = &block->planes;
	double proved = plane_cells_carry_whole(planes, &motion->q1, motion, needed_of(block, measured), NULL);
	vec3 along;

	proved = larger(kept, proved - measured->path);
	if (proved > wanted_of(block, measured) || !(proved > 0))
		return proved;
	look_at_ends(block, sweep, measured, motion, proved);
	if (proved > wanted_of(block, measured))
		return proved;
	along = near_pair_direction(&block->bodies, pose_at(block, &motion->q1));
	kept = plane_cells_carry_whole(planes, &motion->q1, motion, needed_of(block, measured), &along);
	return larger(proved, kept - measured->path);
}

/* The same of the planes between parts. */
static double carry_parts(struct block_clearance *block, struct sweep *sweep, struct measured_step *measured,
			  const struct plane_motion *motion, double kept)
{
	double proved;

	if (kept > wanted_of(block, measured))
		return kept;
	proved = plane_cells_carry_parts(&block->planes, &motion->q1, motion, needed_of(block, measured));
	proved = larger(kept, proved - measured->path);
	if (proved > 0 && !(proved > wanted_of(block, measured)))
		look_at_ends(block, sweep, measured, motion, proved);
	return proved;
}

/* mm: what planes prove that are carried on from step to step, if that may pay; kept ones prove `kept`. */
static double carry_planes(struct block_clearance *block, struct sweep *sweep, struct measured_step *measured,
			   const struct plane_motion *motion, double kept)
{
	const long before = block->planes.visits;
	const bool by_parts = block->by_parts, allowed = WITH_PLANES && plane_account_allows_carrying(&block->account);

	if (allowed) {
		distance_at(block, measured, &motion->q1);
		if (!(kept > wanted_of(block, measured)))
			kept = carry_whole(block, sweep, measured, motion, kept);
	}
	block->by_parts = !(kept > wanted_of(block, measured));
	if (block->by_parts && !by_parts)
		kept = larger(kept, kept_for(block, measured, motion, PLANES_OF_PARTS));
	if (!allowed)
		return kept;
	if (block->by_parts)
		kept = carry_parts(block, sweep, measured, motion, kept);
	plane_account_add_carried(&block->account, block->planes.visits - before, kept > wanted_of(block, measured));
	return kept;
}

bool measured_step_by_planes(struct measured_step *measured, struct block_clearance *block, struct sweep *sweep)
{
	const struct motion_step *step = measured->step;
	const struct plane_motion motion = {.straight = !step_is_box(step), .q0 = step->span.q0, .q1 = step->span.q1,
					    .chord_error = measured->errors.chord};
	double kept, wanted;

	measured->path = plane_motion_path(&motion, &block->bodies, &measured->errors);
	/* Where the step begins the triangles were seen by every other step: then they need not be looked at where it ends. */
	if (block->is_near)
		distance_at(block, measured, seen_at(block, &motion.q0) ? &motion.q0 : &motion.q1);
	kept = kept_for(block, measured, &motion, block->by_parts ? PLANES_ALL : PLANES_OF_WHOLE);
	block->is_near = !(kept > block->bound);
	if (!(kept > wanted_of(block, measured)))
		kept = carry_planes(block, sweep, measured, &motion, kept);
	if (!planes_prove(block, sweep, measured, &motion, kept, WITH_PLANES ? HALVINGS : 0))
		return false;
	wanted = wanted_of(block, measured);
	if (block->accuracy == CLEARANCE_SHARP)
		wanted = larger(wanted, kept > wanted ? kept : kept_for(block, measured, &motion, PLANES_ALL));
	block->bound = smaller(block->bound, wanted);
	plane_account_add_saved(&block->account, 1);
	return true;
}

