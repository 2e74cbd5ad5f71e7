/* profile.h - rings about a rotary axis that contain a part of a body at every angle of the axis. */
#ifndef FIVECHECK_SCENE_PROFILE_H
#define FIVECHECK_SCENE_PROFILE_H

#include "geom/xform.h"
#include "scene/bvh_pair.h"

enum { PROFILE_RINGS = 64 };

/*
 * The convex hull of the rings contains the part. Ring i is a piece of a cylinder: rho[i] mm from the axis, from low[i]
 * to high[i] mm along it, measured from the location of the axis.
 */
struct profile {
	int count;
	double low[PROFILE_RINGS], high[PROFILE_RINGS], rho[PROFILE_RINGS];
};

/*
 * The triangles below `leaf` of the tree, at `place`, about the axis through `location` along the unit vector `axis`.
 * Adds the nodes examined to *visits.
 *
 * A small branch is replaced by its box, so the number of nodes depends on the shape of the part and not on the number
 * of its triangles. The rings still contain the part: each corner of a triangle is in the range of a ring, or inside
 * the box of a node, and then the corners of the box are. A body of revolution about the axis is convex if its half
 * plane is, so the hull of rings that contain the corners of a box contains the whole box, and the same holds for a
 * triangle. Boxes are rounded outward (bvh.h); the values computed here in double have no larger errors than the same
 * sums for a triangle's corner, up to one sum (POSE_ROUNDING).
 */
void profile_init(struct profile *profile, const struct bvh *bvh, struct leaf leaf, const xform *place, vec3 location,
		  vec3 axis, long *visits);

#endif
