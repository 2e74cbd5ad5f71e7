#include "scene/near_pair.h"

#include <stdbool.h>

#include "base/minmax.h"
#include "geom/moved_tri.h"
#include "geom/point_distance.h"
#include "scene/coherence.h"

/* Measured: the first two rounds find nearly everything that more rounds would find; usually the search ends there. */
enum { ROUNDS = 6 };

/* A round that reduces the distance by less than this share is the last one. */
#define ROUND_SHARE 0.01

/* Points that have moved by less than this share of the distance since their measurement count as unchanged. */
#define MOVED_SHARE 0.25

/* Two triangles at this distance, and a point of each, in a's mesh coordinates. */
struct near_pair {
	double distance;	/* mm */
	vec3 on_a, on_b;
	bool measured;	/* the points are the closest ones; else each is within `distance` of the other triangle */
	bool is_new;	/* the points or triangles differ from the remembered ones */
};

static struct near_pair measure(const struct body_pair *pair, const xform *pose)
{
	const struct coherence *coherence = pair->coherence;
	tri a = tri_of(&pair->a->mesh, coherence->near_a), b = tri_of(&pair->b->mesh, coherence->near_b);
	struct near_pair near = {.measured = true, .is_new = true};

	b = tri_transform(&b, pose);
	near.distance = tri_distance(&a, &b, &near.on_a, &near.on_b);
	return near;
}

/* Transforms a point of a to b's mesh coordinates. */
static vec3 in_b(const xform *pose, vec3 point)
{
	return mat3_apply_transposed(&pose->rotation, vec3_sub(point, pose->translation));
}

static void remember(const struct body_pair *pair, const xform *pose, const struct near_pair *near)
{
	struct near_points *points = &pair->coherence->points;

	points->known = true;
	points->a = pair->coherence->near_a;
	points->b = pair->coherence->near_b;
	points->on_a = near->on_a;
	points->on_b = in_b(pose, near->on_b);
}

/*
 * The distance of the triangles, computed from the points that were closest when they were measured. This costs a small
 * part of a measurement, and is nearly as exact while the triangles have not turned far.
 */
static struct near_pair recall(const struct body_pair *pair, const xform *pose)
{
	const struct coherence *coherence = pair->coherence;
	const struct near_points *points = &coherence->points;
	struct near_pair near = {.measured = false};

	if (!points->known || points->a != coherence->near_a || points->b != coherence->near_b) {
		near = measure(pair, pose);
		remember(pair, pose, &near);
		near.is_new = false;
		return near;
	}
	near.on_a = points->on_a;
	near.on_b = xform_apply(pose, points->on_b);
	near.distance =
	    smaller(triangle_point_distance(&pair->a->mesh.triangles[coherence->near_a], near.on_b),
		    triangle_point_distance(&pair->b->mesh.triangles[coherence->near_b], in_b(pose, near.on_a)));
	return near;
}

double near_pair_distance(const struct body_pair *pair, const xform *pose)
{
	return recall(pair, pose).distance;
}

/* Replaces one of the triangles by one that is closer to the other's point. False: there is none. */
static bool replace(const struct body_pair *pair, const xform *pose, bool of_a, struct near_pair *near, double enough,
		    long *visits)
{
	const struct bvh *bvh = of_a ? pair->a : pair->b;
	const vec3 point = of_a ? near->on_b : in_b(pose, near->on_a);
	struct nearest_triangle nearest;

	if (!mesh_nearest_triangle(bvh, point, (1 - ROUND_SHARE) * near->distance, enough, &nearest, visits))
		return false;
	*(of_a ? &pair->coherence->near_a : &pair->coherence->near_b) = nearest.triangle;
	pair->coherence->points.a_replaced = of_a;
	if (nearest.distance > enough) {
		*near = measure(pair, pose);
		return true;
	}
	/* Close enough already: the other point stays. */
	*near = (struct near_pair){
		.distance = nearest.distance,
		.on_a = of_a ? nearest.at : near->on_a,
		.on_b = of_a ? near->on_b : xform_apply(pose, nearest.at),
		.is_new = true,
	};
	return true;
}

/* The same for either triangle. The one that was replaced last is tried first: usually its body moves sideways. */
static bool replace_either(const struct body_pair *pair, const xform *pose, struct near_pair *near, double enough,
			   long *visits)
{
	const bool first = pair->coherence->points.a_replaced;
	const bool nearer = replace(pair, pose, first, near, enough, visits);

	return (near->distance > enough && replace(pair, pose, !first, near, enough, visits)) || nearer;
}

/* Measures the points again. False: they have hardly moved, or were just measured. */
static bool renew_points(const struct body_pair *pair, const xform *pose, struct near_pair *near)
{
	const struct near_pair before = *near;
	double moved2;

	if (before.measured)
		return false;
	*near = measure(pair, pose);
	moved2 = larger(vec3_norm2(vec3_sub(near->on_a, before.on_a)), vec3_norm2(vec3_sub(near->on_b, before.on_b)));
	return moved2 > MOVED_SHARE * MOVED_SHARE * near->distance * near->distance;
}

double near_pair_improve(const struct body_pair *pair, const xform *pose, double enough, long *visits)
{
	struct near_pair near = recall(pair, pose);

	for (int round = 0; round < ROUNDS && near.distance > enough; round++)
		if (!replace_either(pair, pose, &near, enough, visits) && !renew_points(pair, pose, &near))
			break;
	if (near.is_new)
		remember(pair, pose, &near);
	return near.distance;
}

double near_pair_improve_once(const struct body_pair *pair, const xform *pose, double enough, long *visits)
{
	const bool first = pair->coherence->points.a_replaced;
	struct near_pair near = recall(pair, pose);

	if (near.distance > enough && !replace(pair, pose, first, &near, enough, visits))
		replace(pair, pose, !first, &near, enough, visits);
	if (near.is_new)
		remember(pair, pose, &near);
	return near.distance;
}

vec3 near_pair_direction(const struct body_pair *pair, const xform *pose)
{
	const struct near_points *points = &pair->coherence->points;
	const vec3 between = vec3_sub(xform_apply(pose, points->on_b), points->on_a);

	return vec3_unit(mat3_apply(&pair->place_a.rotation, between));
}
