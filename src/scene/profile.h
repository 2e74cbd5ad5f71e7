/* profile.h - rings about a rotary axis that hold a part of a body wherever a turn about the axis takes it. */
#ifndef FIVECHECK_SCENE_PROFILE_H
#define FIVECHECK_SCENE_PROFILE_H

#include "geom/xform.h"
#include "scene/bvh_pair.h"

enum { PROFILE_RINGS = 64 };

/*
 * The convex hull of the rings holds the part. Ring i is a piece of a cylinder: rho[i] mm from the axis, from low[i] to
 * high[i] mm along it, counted from the axis' location.
 */
struct profile {
	int count;
	double low[PROFILE_RINGS], high[PROFILE_RINGS], rho[PROFILE_RINGS];
};

/*
 * The triangles below `leaf` of the tree, at `place`, about the axis through `location` along the unit vector `axis`.
 * Adds the nodes looked at to *visits.
 *
 * What is small against the part stands for its triangles with its box, so that the nodes to look at depend on the
 * part's shape and not on the number of its triangles. The rings hold the part all the same: each corner of a triangle
 * is in the range of a ring, or within the box of a node, and then the box' corners are. A body of revolution about the
 * axis is convex if its half plane is, so with the corners of a box the hull of the rings holds the whole box, and with
 * the corners of a triangle the triangle. Boxes are rounded outward (bvh.h); what is computed here in double is off by
 * no more than what the same sums are for a triangle's corner, to within a sum (POSE_ROUNDING).
 */
void profile_init(struct profile *profile, const struct bvh *bvh, struct leaf leaf, const xform *place, vec3 location,
		  vec3 axis, long *visits);

#endif
