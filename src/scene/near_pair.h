/* near_pair.h - two triangles that are near each other: an upper bound of the distance of two bodies. */
#ifndef FIVECHECK_SCENE_NEAR_PAIR_H
#define FIVECHECK_SCENE_NEAR_PAIR_H

#include "scene/motion_interval.h"

/*
 * mm: the distance of the two remembered triangles (struct coherence) at the pose (body_pair_pose); if they have turned
 * since they were measured, an upper bound of it.
 */
double near_pair_distance(const struct body_pair *pair, const xform *pose);

/*
 * The same after a search for nearer triangles, which are remembered: on either side in turn, the triangle nearest to
 * the nearest point of the other one. The search ends when the two are within `enough` mm, or when it finds none
 * nearer, or after some rounds. Others may still be nearer, but of two convex bodies usually nearly the nearest are
 * found at little cost. Adds the boxes that it examines to *visits.
 */
double near_pair_improve(const struct body_pair *pair, const xform *pose, double enough, long *visits);

/* The same with a single replacement, of either side. */
double near_pair_improve_once(const struct body_pair *pair, const xform *pose, double enough, long *visits);

/*
 * The direction from the nearest point of one triangle to that of the other, from the last measurement, with the bodies
 * at the present pose: a unit vector in the coordinates of A's link; 0: they touch.
 */
vec3 near_pair_direction(const struct body_pair *pair, const xform *pose);

#endif
