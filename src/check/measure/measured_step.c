#include "check/measure/measured_step.h"

#include <math.h>

#include "base/ablation.h"
#include "base/minmax.h"
#include "base/same_double.h"
#include "check/step.h"
#include "scene/near_pair.h"

/*
 * The largest number of halvings of a step to find parts for which planes hold. Measured: with 4 halvings, an eighth to
 * a sixteenth of the sweeps remain that are needed without halving; with 5, half of those. Most of the remaining ones
 * are where planes do not help at all.
 */
#define HALVINGS 5

/*
 * If the smaller of the distances at the ends of a part of a step is at least this share of the larger one, planes are
 * measured in the middle of the part.
 */
#define ALIKE 0.8

void measured_pair_init(struct measured_pair *pair, const struct body_pair *bodies)
{
	*pair = (struct measured_pair){.bodies = *bodies};
	pair->bodies.coherence = &pair->coherence;
	plane_cells_init(&pair->planes, &pair->bodies);
	plane_account_init(&pair->account, bodies->a->mesh.count + bodies->b->mesh.count);
}

void measured_pair_release(struct measured_pair *pair)
{
	plane_cells_release(&pair->planes);
}

void measured_step_init(struct measured_step *measured, const struct measured_pair *pair,
			const struct motion_step *step)
{
	measured->step = step;
	measured->errors = step_errors(pair->bodies.chain, step);
	measured->path = 0;
	measured->seen = INFINITY;
	measured->wanted = pair->bound;
}

/* Two triangles are `distance` mm apart somewhere on the step. */
static void see(struct measured_step *measured, const struct measured_pair *pair, double distance)
{
	if (!(distance < measured->seen))
		return;
	measured->seen = distance;
	measured->wanted = smaller(pair->bound, clearance_accuracy_enough(pair->accuracy, distance - measured->path,
									  pair->bound));
}

/* mm: the gap that planes must leave to prove the wanted distance. */
static double needed_of(const struct measured_step *measured)
{
	return measured->wanted + measured->path;
}

static bool is_at(const struct chain *chain, const axis_values *a, const axis_values *b)
{
	for (size_t i = 0; i < chain->count; i++)
		if (!same_double(a->v[chain->joints[i].slot], b->v[chain->joints[i].slot]))
			return false;
	return true;
}

/* The bodies' pose at q; valid until the next call with another position. */
static const xform *pose_at(struct measured_pair *pair, const axis_values *q)
{
	struct posed *posed = &pair->posed;

	if (!posed->known || !is_at(pair->bodies.chain, &posed->q, q))
		*posed = (struct posed){true, *q, body_pair_pose(&pair->bodies, q)};
	return &posed->pose;
}

/*
 * mm: if two triangles are this close, the distance that planes have proved (`kept`) is nearly the whole distance, so
 * closer triangles are not needed.
 */
static double useful_distance(const struct measured_pair *pair, const struct measured_step *measured, double kept)
{
	return kept > 0 ? clearance_accuracy_distance(pair->accuracy, kept) + measured->path : 0;
}

/*
 * Searches for triangles that are close to each other at q, unless the distance `kept` that planes have proved is
 * already enough.
 */
static void look_at(struct measured_pair *pair, struct sweep *sweep, struct measured_step *measured,
		    const axis_values *q, double kept)
{
	see(measured, pair, near_pair_improve(&pair->bodies, pose_at(pair, q), useful_distance(pair, measured, kept),
					      &sweep->visits));
}

/* The same at a fraction of the cost: searches only near the triangles that were close before. */
static void look_beside(struct measured_pair *pair, struct sweep *sweep, struct measured_step *measured,
			const axis_values *q, double kept)
{
	see(measured, pair, near_pair_improve_once(&pair->bodies, pose_at(pair, q),
						   useful_distance(pair, measured, kept), &sweep->visits));
}

/* mm: the distance that kept planes prove for the motion, at most what is needed. */
static double kept_for(struct measured_pair *pair, const struct measured_step *measured,
		       const struct plane_motion *motion, enum planes_asked asked)
{
	if (!WITH_PLANES)
		return -INFINITY;
	return plane_cells_rest(&pair->planes, motion, needed_of(measured), asked) - measured->path;
}

/* Does a search for planes at q pay, and prove the needed distance in this part of the step? */
static bool new_planes_prove(struct measured_pair *pair, const struct measured_step *measured,
			     const struct plane_motion *part, const axis_values *q)
{
	const long before = pair->planes.visits;
	bool held;

	if (!WITH_PLANES || !plane_account_allows(&pair->account))
		return false;
	/* The result of kept planes is already known, and other triangles are closer now. */
	held = plane_cells_search(&pair->planes, q, part, needed_of(measured));
	plane_account_add_search(&pair->account, pair->planes.visits - before);
	return held;
}

/* The kept distance, at q, of the triangles that were close before; NULL: there is none. */
static const struct seen_distance *seen_at(const struct measured_pair *pair, const axis_values *q)
{
	const struct coherence *coherence = &pair->coherence;

	for (int i = 0; i < SEEN_KEPT; i++) {
		const struct seen_distance *seen = &pair->seen[i];

		if (seen->known && seen->triangles[0] == coherence->near_a &&
		    seen->triangles[1] == coherence->near_b && is_at(pair->bodies.chain, &seen->q, q))
			return seen;
	}
	return NULL;
}

/* mm: the distance at q of the triangles that were close before: an upper bound for the bodies. */
static double distance_at(struct measured_pair *pair, struct measured_step *measured, const axis_values *q)
{
	const struct coherence *coherence = &pair->coherence;
	const struct seen_distance *known = seen_at(pair, q);
	const double distance = known ? known->distance : near_pair_distance(&pair->bodies, pose_at(pair, q));

	if (!known) {
		pair->oldest_seen = (pair->oldest_seen + 1) % SEEN_KEPT;
		pair->seen[pair->oldest_seen] = (struct seen_distance){
			.known = true,
			.q = *q,
			.triangles = {coherence->near_a, coherence->near_b},
			.distance = distance,
		};
	}
	see(measured, pair, distance);
	return distance;
}

/*
 * Searches for close triangles at the end of the part where the triangles that were close before are closest, or in its
 * middle if the ends are alike. Stops as soon as the distance `kept` that planes have proved is enough. Returns the
 * position.
 */
static axis_values look_around(struct measured_pair *pair, struct sweep *sweep, struct measured_step *measured,
			       const struct plane_motion *part, double kept)
{
	const double at1 = distance_at(pair, measured, &part->q1);
	axis_values nearest = part->q1;
	double at0;

	if (kept > measured->wanted)
		return nearest;
	at0 = distance_at(pair, measured, &part->q0);
	if (kept > measured->wanted)
		return nearest;
	if (part->straight && smaller(at0, at1) > ALIKE * larger(at0, at1))
		nearest = plane_motion_middle(part);
	else if (at0 < at1)
		nearest = part->q0;
	look_at(pair, sweep, measured, &nearest, kept);
	return nearest;
}

/*
 * Does the last measured plane leave a large enough gap where it was measured? Then the motion is too long for this
 * plane, and for others.
 */
static bool is_good_where_measured(const struct measured_pair *pair, const struct measured_step *measured)
{
	return plane_cells_gap_of_whole(&pair->planes) > needed_of(measured);
}

/*
 * mm: the distance proved by the plane of the whole bodies, measured again at the motion's end; `along` as in
 * plane_cells.h.
 */
static double carried_on(struct measured_pair *pair, const struct measured_step *measured,
			 const struct plane_motion *motion, const vec3 *along)
{
	return plane_cells_carry_whole(&pair->planes, &motion->q1, motion, needed_of(measured), along) -
	       measured->path;
}

/*
 * mm: the distance proved for a half of a step by kept planes, or else by the plane of the whole bodies measured again.
 */
static double proved_of_half(struct measured_pair *pair, const struct measured_step *measured,
			     const struct plane_motion *half)
{
	const double kept = kept_for(pair, measured, half, PLANES_ALL);

	return kept > measured->wanted ? kept : larger(kept, carried_on(pair, measured, half, NULL));
}

static bool halves_prove(struct measured_pair *pair, struct sweep *sweep, struct measured_step *measured,
			 const struct plane_motion *part, int halvings);

/*
 * Do travelling planes prove nearly the largest possible distance for this part of the step? `kept`: the distance that
 * they have proved already. The largest possible distance decreases when closer triangles are found: the triangles that
 * were closest before have usually moved apart.
 */
static bool planes_prove(struct measured_pair *pair, struct sweep *sweep, struct measured_step *measured,
			 const struct plane_motion *part, double kept, int halvings)
{
	const bool may_halve = part->straight && halvings > 0;
	axis_values nearest;

	if (kept > measured->wanted)
		return true;
	nearest = look_around(pair, sweep, measured, part, kept);
	if (kept > measured->wanted)
		return true;
	if (!(measured->wanted > 0))
		return false;
	if (!(may_halve && is_good_where_measured(pair, measured)) && new_planes_prove(pair, measured, part, &nearest))
		return true;
	return may_halve && halves_prove(pair, sweep, measured, part, halvings);
}

/* The same for both halves of a part. */
static bool halves_prove(struct measured_pair *pair, struct sweep *sweep, struct measured_step *measured,
			 const struct plane_motion *part, int halvings)
{
	struct plane_motion halves[2] = {*part, *part};
	bool proved = true;

	halves[0].q1 = halves[1].q0 = plane_motion_middle(part);
	for (int i = 0; i < 2 && proved; i++)
		proved = planes_prove(pair, sweep, measured, &halves[i], proved_of_half(pair, measured, &halves[i]),
				      halvings - 1);
	return proved;
}

/*
 * If the proved distance is less than this share of the wanted one, the bodies may be far closer at the start of the
 * step.
 */
#define SEEN_TOO_FAR 0.5

/* Searches for closer triangles at the end of the step, and at its start if the bodies may be far closer there. */
static void look_at_ends(struct measured_pair *pair, struct sweep *sweep, struct measured_step *measured,
			 const struct plane_motion *motion, double kept)
{
	look_at(pair, sweep, measured, &motion->q1, kept);
	if (kept < SEEN_TOO_FAR * measured->wanted &&
	    distance_at(pair, measured, &motion->q0) <= measured->seen)
		look_at(pair, sweep, measured, &motion->q0, kept);
}

/* A multiple of the cap. Beyond it a search seldom finds closer triangles, and they would not help. */
#define FAR_TIMES 2

static bool is_far(const struct measured_pair *pair, const struct measured_step *measured)
{
	return measured->seen > FAR_TIMES * pair->bound;
}

/*
 * Bodies that slide past each other in large steps keep the same separating plane from step to step, but a plane holds
 * for less than one step. The function tries, in order of cost: 1. closer triangles, which usually show that the kept
 * planes prove nearly the whole distance; 2. the last step's plane, measured again at the end of this step; 3. a search
 * for triangles that are close enough to show this, or else that give the direction of a new plane. Returns the proved
 * distance (mm); `kept`: the distance that kept planes prove.
 */
static double carry_whole(struct measured_pair *pair, struct sweep *sweep, struct measured_step *measured,
			  const struct plane_motion *motion, double kept)
{
	const bool far = is_far(pair, measured);
	double proved;
	vec3 along;

	if (kept > 0 && !far)
		look_beside(pair, sweep, measured, &motion->q1, kept);
	if (kept > measured->wanted)
		return kept;
	proved = larger(kept, carried_on(pair, measured, motion, NULL));
	if (proved > measured->wanted || !(proved > 0) || far)
		return proved;
	look_at_ends(pair, sweep, measured, motion, proved);
	if (proved > measured->wanted)
		return proved;
	along = near_pair_direction(&pair->bodies, pose_at(pair, &motion->q1));
	return larger(proved, carried_on(pair, measured, motion, &along));
}

/* The same for the planes between parts. */
static double carry_parts(struct measured_pair *pair, struct sweep *sweep, struct measured_step *measured,
			  const struct plane_motion *motion, double kept)
{
	double proved;

	if (kept > measured->wanted)
		return kept;
	proved = plane_cells_carry_parts(&pair->planes, &motion->q1, motion, needed_of(measured));
	proved = larger(kept, proved - measured->path);
	if (proved > 0 && !(proved > measured->wanted))
		look_at_ends(pair, sweep, measured, motion, proved);
	return proved;
}

/*
 * mm: the distance proved by planes that are measured again from step to step, if that may pay; kept planes prove
 * `kept`.
 */
static double carry_planes(struct measured_pair *pair, struct sweep *sweep, struct measured_step *measured,
			   const struct plane_motion *motion, double kept)
{
	const long before = pair->planes.visits;
	const bool by_parts = pair->by_parts, allowed = WITH_PLANES && plane_account_allows_carrying(&pair->account);

	if (allowed) {
		distance_at(pair, measured, &motion->q1);
		if (!(kept > measured->wanted))
			kept = carry_whole(pair, sweep, measured, motion, kept);
	}
	pair->by_parts = !(kept > measured->wanted);
	if (pair->by_parts && !by_parts)
		kept = larger(kept, kept_for(pair, measured, motion, PLANES_OF_PARTS));
	if (!allowed)
		return kept;
	if (pair->by_parts)
		kept = carry_parts(pair, sweep, measured, motion, kept);
	plane_account_add_carried(&pair->account, pair->planes.visits - before, kept > measured->wanted);
	return kept;
}

/*
 * The same with new planes and halves, if kept planes are not enough. As long as this fails, fewer and fewer steps are
 * tried: between nested curved bodies it costs several times as much as the queries that follow.
 */
static bool parts_prove(struct measured_pair *pair, struct sweep *sweep, struct measured_step *measured,
			const struct plane_motion *motion, double kept)
{
	bool proved;

	if (WITH_PLANES && !plane_account_allows_parts(&pair->account))
		return false;
	proved = planes_prove(pair, sweep, measured, motion, kept, WITH_PLANES ? HALVINGS : 0);
	plane_account_add_parts(&pair->account, proved);
	return proved;
}

bool measured_step_by_planes(struct measured_step *measured, struct measured_pair *pair, struct sweep *sweep)
{
	const struct motion_step *step = measured->step;
	const struct plane_motion motion = {.straight = !step_is_box(step), .q0 = step->span.q0, .q1 = step->span.q1,
					    .chord_error = measured->errors.chord};
	double kept, wanted;

	measured->path = plane_motion_path(&motion, &pair->bodies, &measured->errors);
	/* Every other step knows the triangles at its start; then they need not be measured at its end. */
	if (pair->is_near)
		distance_at(pair, measured, seen_at(pair, &motion.q0) ? &motion.q0 : &motion.q1);
	kept = kept_for(pair, measured, &motion, pair->by_parts ? PLANES_ALL : PLANES_OF_WHOLE);
	pair->is_near = !(kept > pair->bound);
	if (!(kept > measured->wanted))
		kept = carry_planes(pair, sweep, measured, &motion, kept);
	if (!(kept > measured->wanted) && !parts_prove(pair, sweep, measured, &motion, kept))
		return false;
	wanted = measured->wanted;
	if (pair->accuracy == CLEARANCE_SHARP)
		wanted = larger(wanted, kept > wanted ? kept : kept_for(pair, measured, &motion, PLANES_ALL));
	pair->bound = smaller(pair->bound, wanted);
	plane_account_add_saved(&pair->account, 1);
	return true;
}

