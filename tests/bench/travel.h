/* travel.h - how far two bodies can move against each other while the axes go straight from one position to another. */
#ifndef BENCH_TRAVEL_H
#define BENCH_TRAVEL_H

#include "plain_scene.h"

/* Is the link carried by the axis, directly or not? */
static inline int carries(const struct scene *scene, int axis, int link)
{
	while (link > 0 && link - 1 != axis)
		link = scene->axes[link - 1].parent;
	return link > 0;
}

/*
 * A bound on the way of every point of a body under the axes that carry it but
 * not the other body. From the body down to the base: linear axes with no rotary one between shift
 * it together; a rotary one moves a point by no more than its turn times the distance from it, and
 * that is the one at the start, over the ball around the body, plus what the axes above add to it.
 */
static inline double way_of_body(const struct scene *scene, const pose *poses, int body, int other, const double *q0,
				 const double *q1)
{
	const struct solid *solid = &scene->solids[body];
	vec middle = apply(&poses[solid->link], solid->middle), shift = {0, 0, 0};
	double way = 0;

	for (int link = solid->link; link > 0; link = scene->axes[link - 1].parent) {
		const struct axis *axis = &scene->axes[link - 1];
		const pose *below = &poses[axis->parent];
		double dq = q1[link - 1] - q0[link - 1];
		vec from, along = turn(below, axis->direction);

		if (carries(scene, link - 1, scene->solids[other].link))
			break;
		if (!axis->rotary) {
			shift = add(shift, times(dq, along));
			continue;
		}
		way += norm(shift);
		shift = vec_of(0, 0, 0);
		from = sub(middle, apply(below, axis->location));
		way += fabs(dq) * 3.14159265358979323846 / 180 * (norm(cross(from, along)) + solid->radius + way);
	}
	return way + norm(shift);
}

/* mm, for the axes going from q0 to q1. */
static inline double travel_bound(const struct scene *scene, const struct solid_pair *pair, const double *q0,
				  const double *q1)
{
	pose poses[AXES_MAX + 1];

	link_poses(scene, q0, poses);
	return way_of_body(scene, poses, pair->a, pair->b, q0, q1) +
	       way_of_body(scene, poses, pair->b, pair->a, q0, q1);
}

/* b's coordinates to a's, both those of the zero pose. */
static inline pose relative_pose(const struct scene *scene, const struct solid_pair *pair, const double *q)
{
	pose poses[AXES_MAX + 1], back;

	link_poses(scene, q, poses);
	back = inverse(&poses[scene->solids[pair->a].link]);
	return after(&back, &poses[scene->solids[pair->b].link]);
}

static inline double farthest_corner(const struct solid *solid, const pose *from, const pose *to)
{
	size_t stride = solid->count / 128 + 1;
	double most = 0;

	for (size_t i = 0; i < solid->count; i += stride)
		for (int k = 0; k < 3; k++)
			most =
			    fmax(most,
				 norm(sub(apply(to, solid->triangles[i].p[k]), apply(from, solid->triangles[i].p[k]))));
	return most;
}

/*
 * How far the farthest corner of b gets, seen from a, or of a, seen from b: the lesser of both, as the distance
 * changes by no more. Some hundred corners are looked at, so this is never too much.
 */
static inline double travel_seen(const struct scene *scene, const struct solid_pair *pair, const double *q0,
				 const double *q1)
{
	pose from = relative_pose(scene, pair, q0), to = relative_pose(scene, pair, q1);
	pose back_from = inverse(&from), back_to = inverse(&to);

	return fmin(farthest_corner(&scene->solids[pair->b], &from, &to),
		    farthest_corner(&scene->solids[pair->a], &back_from, &back_to));
}

#endif
