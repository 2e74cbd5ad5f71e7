#include "scene/near_pair.h"

#include <stdbool.h>

#include "geom/moved_tri.h"
#include "geom/point_distance.h"
#include "scene/coherence.h"

/* Measured: the first two rounds find nearly all that more would find. */
enum { ROUNDS = 4 };

/* A round that brings less than this share of the distance is the last one. */
#define ROUND_SHARE 0.01

/* Two triangles, and where they are nearest to each other, in a's mesh coordinates. */
struct near_pair {
	double distance;	/* mm */
	vec3 on_a, on_b;
};

static struct near_pair measure(const struct body_pair *pair, const xform *pose)
{
	const struct coherence *coherence = pair->coherence;
	tri a = tri_of(&pair->a->mesh, coherence->near_a), b = tri_of(&pair->b->mesh, coherence->near_b);
	struct near_pair near;

	b = tri_transform(&b, pose);
	near.distance = tri_distance(&a, &b, &near.on_a, &near.on_b);
	return near;
}

double near_pair_distance(const struct body_pair *pair, const axis_values *q)
{
	const xform pose = body_pair_pose(pair, q);

	return measure(pair, &pose).distance;
}

/* Replaces one of the triangles by the one that is nearest to the other's nearest point. False: none is nearer. */
static bool replace(const struct body_pair *pair, const xform *pose, bool of_a, struct near_pair *near, long *visits)
{
	const struct bvh *bvh = of_a ? pair->a : pair->b;
	const vec3 point = of_a ? near->on_b : mat3_apply_transposed(&pose->rotation, vec3_sub(near->on_a, pose->translation));
	struct nearest_triangle nearest;

	if (!mesh_nearest_triangle(bvh, point, (1 - ROUND_SHARE) * near->distance, &nearest, visits))
		return false;
	*(of_a ? &pair->coherence->near_a : &pair->coherence->near_b) = nearest.triangle;
	*near = measure(pair, pose);
	return true;
}

double near_pair_improve(const struct body_pair *pair, const axis_values *q, double enough, long *visits)
{
	const xform pose = body_pair_pose(pair, q);
	struct near_pair near = measure(pair, &pose);

	for (int round = 0; round < ROUNDS && near.distance > enough; round++) {
		bool nearer = replace(pair, &pose, false, &near, visits);

		if (!(near.distance > enough) || (!replace(pair, &pose, true, &near, visits) && !nearer))
			break;
	}
	return near.distance;
}
