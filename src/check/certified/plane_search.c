#include "check/certified/plane_search.h"

#include <math.h>
#include <string.h>

#include "base/minmax.h"

/*
 * A plane that holds for this many motions like the current one is good enough: no other shapes of the parts are tried.
 */
#define LIFE_ENOUGH 8

/*
 * The same for a kept plane that is measured again. If it holds for a part of the motion only, other planes seldom hold
 * longer: halving the motion pays more. Measured: 0.3 to 0.6 perform alike; 1 takes a quarter longer.
 */
#define LIFE_AGAIN 0.3

/*
 * The permitted error of a support: a share of the part of the gap beyond what is needed, and a share of the largest
 * gap. Exact supports of balls of 500,000 triangles cost 6 times as much.
 */
#define GAP_SHARE 0x1p-4
#define APART_SHARE 0x1p-6

void plane_search_init(struct plane_search *search, const struct body_pair *bodies, const axis_values *q,
		       const struct plane_motion *motion, double needed, long *visits)
{
	search->bodies = bodies;
	search->motion = motion;
	search->needed = needed;
	search->visits = visits;
	plane_pose_init(&search->pose, bodies, q);
	search->has_end[0] = search->has_end[1] = false;
	search->apart = 0;
	search->life = -1;
	search->held = false;
}

/* Keeps the plane with normal n that travels with the link, if it holds longer than the best one. */
static void try_plane(struct plane_search *search, const struct convex *a, const struct convex *b, vec3 n, size_t link,
		      double gap)
{
	const struct chain *chain = search->bodies->chain;
	struct travelling_plane plane;
	double lost, life;

	travelling_plane_init(&plane, &search->pose, a, b, n, link, gap, search->visits);
	lost = gap - travelling_plane_rest(&plane, chain, search->motion, -INFINITY);
	life = lost > 0 ? (gap - search->needed) / lost : INFINITY;
	if (life > search->life || (isinf(life) && gap > search->best.plane.gap)) {
		search->life = life;
		search->best = (struct kept_plane){plane, {a->profile != NULL, b->profile != NULL}};
	}
}

/*
 * mm: the gap along n at the pose; `most`: an estimate that the gap hardly exceeds. The result may be too small by a
 * share of the part of that estimate beyond what is needed, or by a smaller share of the distance of the shapes.
 */
static double gap_of(const struct plane_search *search, const struct plane_pose *pose, const struct convex *a,
		     const struct convex *b, vec3 n, double most)
{
	const double slack = larger(GAP_SHARE * (most - search->needed), APART_SHARE * search->apart);

	return travelling_plane_gap(pose, a, b, n, larger(slack, 0), search->visits);
}

/* Tries the normal with every link that makes a difference; the gap along the normal is at most `most`. */
static void try_normal(struct plane_search *search, const struct convex *a, const struct convex *b, vec3 n, double most)
{
	const struct chain *chain = search->bodies->chain;
	double gap;

	if (!(most > search->needed))
		return;
	gap = gap_of(search, &search->pose, a, b, n, most);
	if (!(gap > search->needed))
		return;
	for (size_t link = 0; link <= chain->count; link++) {
		/* A link behind a linear joint is as good as the one before it. */
		if (link && !chain->joints[link - 1].rotary)
			continue;
		if ((a->profile && link == 0) || (b->profile && link == chain->count))
			continue;
		try_plane(search, a, b, n, link, gap);
	}
}

/* mm: an upper bound of the gap along n. */
static double most_along(const struct convex_search *between, vec3 n)
{
	double most = INFINITY;

	for (int k = 0; k < between->count; k++)
		most = fmin(most, vec3_dot(n, between->seen[k]));
	return most;
}

/* Tries the direction between the parts, and the joints' axes. */
static void try_shapes(struct plane_search *search, const struct convex *a, const struct convex *b)
{
	const struct chain *chain = search->bodies->chain;
	struct convex_search between;

	search->apart = 0;
	if (convex_direction(a, b, &between, search->visits)) {
		search->apart = most_along(&between, between.direction) - search->needed;
		try_normal(search, a, b, between.direction, search->apart + search->needed);
	}
	for (size_t i = 0; i < chain->count; i++) {
		vec3 d = search->pose.direction[i];

		if (vec3_dot(d, vec3_sub(b->centre, a->centre)) < 0)
			d = vec3_scale(-1, d);
		try_normal(search, a, b, d, most_along(&between, d));
	}
}

static struct convex mesh_of(const struct plane_pose *pose, struct plane_part *part)
{
	return convex_of_mesh(&part->mesh, &pose->places[part->body], &part->seen);
}

static struct convex rings_of(const struct plane_pose *pose, struct plane_part *part)
{
	size_t joint = part->body ? pose->bodies->chain->count - 1 : 0;

	return convex_of_profile(&part->profile, pose->location[joint], pose->direction[joint]);
}

static struct convex shape_of(const struct plane_pose *pose, struct plane_part *part, bool rings)
{
	return rings ? rings_of(pose, part) : mesh_of(pose, part);
}

/* Measures a kept plane again, at the place to which its link has carried it. */
static void try_again(struct plane_search *search, struct plane_part *const parts[2],
		      const struct kept_plane *kept)
{
	struct convex a = shape_of(&search->pose, parts[0], kept->rings[0]);
	struct convex b = shape_of(&search->pose, parts[1], kept->rings[1]);
	vec3 n = travelling_plane_normal(&kept->plane, &search->pose);
	double gap = gap_of(search, &search->pose, &a, &b, n, kept->plane.gap);

	if (gap > search->needed)
		try_plane(search, &a, &b, n, kept->plane.link, gap);
}

/*
 * mm: the gap that the best plane leaves at an end of the motion, less the rounding of its normal. `before`: the plane
 * whose new measurement gave the best plane; NULL: none.
 */
static double gap_at_end(struct plane_search *search, struct plane_part *const parts[2],
			 const struct travelling_plane *before, int end)
{
	const struct body_pair *bodies = search->bodies;
	const axis_values *q = end ? &search->motion->q1 : &search->motion->q0;
	const struct kept_plane *best = &search->best;
	struct plane_pose *pose = &search->ends[end];
	struct convex a, b;
	vec3 n;

	if (travelling_plane_is_at(&best->plane, bodies->chain, q))
		return best->plane.gap - best->plane.rounding;
	if (before && travelling_plane_is_at(before, bodies->chain, q))
		return before->gap - before->rounding;
	if (!search->has_end[end])
		plane_pose_init(pose, bodies, q);
	search->has_end[end] = true;
	n = travelling_plane_normal(&best->plane, pose);
	a = shape_of(pose, parts[0], best->rings[0]);
	b = shape_of(pose, parts[1], best->rings[1]);
	return gap_of(search, pose, &a, &b, n, best->plane.gap) - pose->rounding;
}

/* If the best plane does not hold for the whole motion, its gaps at both ends may prove the motion. */
static void try_ends(struct plane_search *search, struct plane_part *const parts[2],
		     const struct travelling_plane *before)
{
	const struct plane_motion *motion = search->motion;
	double gap0, gap1;

	if (!motion->straight || search->life < 0 || search->life > 1)
		return;
	gap0 = gap_at_end(search, parts, before, 0);
	gap1 = gap0 > search->needed ? gap_at_end(search, parts, before, 1) : -INFINITY;
	search->held = travelling_plane_between(&search->best.plane, search->bodies->chain, motion, gap0, gap1) >
		       search->needed;
}

/* The permitted error of the gap of a plane that is measured again at the next step, as a share of its last gap. */
#define CARRIED_SHARE 0x1p-7

/*
 * mm: the gap that the plane leaves at the start of the motion, computed from its last measurement. The two planes need
 * not agree to the last bit.
 */
static double gap_at_start(const struct travelling_plane *plane, const struct chain *chain,
			   const struct plane_motion *motion)
{
	const struct plane_motion start = {.straight = true, .q0 = motion->q0, .q1 = motion->q0};

	return travelling_plane_rest(plane, chain, &start, -INFINITY) - plane->rounding;
}

/* mm: the gap that the best plane leaves throughout the straight motion; gap0: its gap at the start. */
static double rest_between(struct plane_search *search, struct plane_part *const parts[2],
			   const struct travelling_plane *before, double gap0)
{
	const double gap1 = gap0 > 0 ? gap_at_end(search, parts, before, 1) : -INFINITY;

	return travelling_plane_between(&search->best.plane, search->bodies->chain, search->motion, gap0, gap1);
}

double plane_search_carry(struct plane_search *search, struct plane_part *a, struct plane_part *b,
			  const struct kept_plane *last, const vec3 *along)
{
	struct plane_part *const parts[2] = {a, b};
	const struct travelling_plane *before = along ? NULL : &last->plane;
	const struct chain *chain = search->bodies->chain;
	const struct convex of_a = shape_of(&search->pose, a, last->rings[0]);
	const struct convex of_b = shape_of(&search->pose, b, last->rings[1]);
	const vec3 n = along ? *along : travelling_plane_normal(&last->plane, &search->pose);
	const double slack = larger(CARRIED_SHARE * last->plane.gap, 0);
	const double gap = travelling_plane_gap(&search->pose, &of_a, &of_b, n, slack, search->visits);
	double rest;

	if (!(gap > 0))
		return -INFINITY;
	memcpy(search->best.rings, last->rings, sizeof(last->rings));
	travelling_plane_init(&search->best.plane, &search->pose, &of_a, &of_b, n, last->plane.link, gap,
			      search->visits);
	rest = travelling_plane_rest(&search->best.plane, chain, search->motion, -INFINITY);
	if (!search->motion->straight)
		return rest;
	if (before && !(rest > search->needed))
		rest = larger(rest, rest_between(search, parts, before, gap_at_start(before, chain, search->motion)));
	if (!(rest > search->needed))
		rest = larger(rest, rest_between(search, parts, before, gap_at_end(search, parts, before, 0)));
	return rest;
}

static void try_all_shapes(struct plane_search *search, struct plane_part *of_a, struct plane_part *of_b)
{
	const struct plane_pose *pose = &search->pose;
	struct convex mesh_a = mesh_of(pose, of_a), mesh_b = mesh_of(pose, of_b), rings_a, rings_b;

	if (of_a->has_profile) {
		rings_a = rings_of(pose, of_a);
		try_shapes(search, &rings_a, &mesh_b);
	}
	if (of_b->has_profile && !(search->life > LIFE_ENOUGH)) {
		rings_b = rings_of(pose, of_b);
		try_shapes(search, &mesh_a, &rings_b);
		if (of_a->has_profile && search->bodies->chain->count > 1)
			try_shapes(search, &rings_a, &rings_b);
	}
	if (!(search->life > 1))
		try_shapes(search, &mesh_a, &mesh_b);
}

bool plane_search_between(struct plane_search *search, struct plane_part *a, struct plane_part *b,
			  const struct kept_plane *last)
{
	struct plane_part *const parts[2] = {a, b};

	search->life = -1;
	search->apart = 0;
	search->held = false;
	search->best.plane.gap = 0;
	if (last) {
		try_again(search, parts, last);
		try_ends(search, parts, &last->plane);
		if (search->held || search->life > LIFE_AGAIN)
			return search->held || search->life > 1;
	}
	try_all_shapes(search, a, b);
	try_ends(search, parts, NULL);
	return search->held || search->life > 1;
}
