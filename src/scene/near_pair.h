/* near_pair.h - two triangles that are near each other: they show how far apart two bodies are at most. */
#ifndef FIVECHECK_SCENE_NEAR_PAIR_H
#define FIVECHECK_SCENE_NEAR_PAIR_H

#include "scene/motion_interval.h"

/*
 * mm: the two triangles that the pair remembers (struct coherence) are this close at the pose (body_pair_pose), or
 * nearer if they have turned since they were measured.
 */
double near_pair_distance(const struct body_pair *pair, const xform *pose);

/*
 * The same after a search for nearer triangles, which are remembered: the one that is nearest to the point where the
 * other was nearest to the first, on either side in turn. The search ends where two are within `enough` mm, or where it
 * finds none nearer. Then others may still be nearer, but between convex surfaces the nearest are found at little cost.
 * Adds the boxes that it looks at to *visits.
 */
double near_pair_improve(const struct body_pair *pair, const xform *pose, double enough, long *visits);

/* The same with one round of the search: each side is replaced once at most. */
double near_pair_improve_once(const struct body_pair *pair, const xform *pose, double enough, long *visits);

/*
 * From the one triangle's nearest point to the other's, as they were measured last, with the bodies at the pose now: a
 * unit vector in the coordinates of A's link; 0: they touch.
 */
vec3 near_pair_direction(const struct body_pair *pair, const xform *pose);

#endif
