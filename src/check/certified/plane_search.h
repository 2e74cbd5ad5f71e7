/* plane_search.h - searches a travelling plane between a part of one body and a part of another. */
#ifndef FIVECHECK_CHECK_CERTIFIED_PLANE_SEARCH_H
#define FIVECHECK_CHECK_CERTIFIED_PLANE_SEARCH_H

#include <stdbool.h>
#include <stddef.h>

#include "check/certified/travelling_plane.h"

/* A part of a body. */
struct plane_part {
	int body;	/* 0: A, 1: B */
	struct mesh_part mesh;
	bool has_profile;
	struct profile profile;	/* about the joint next to the body */
	struct seen_corners seen;	/* of the mesh */
	size_t first_child, child_count;	/* parts; 0: not divided yet */
};

/* A plane between two parts. */
struct kept_plane {
	struct travelling_plane plane;
	bool rings[2];	/* A, B: the profile was measured instead of the part */
};

/* plane_search_init sets all but `ends` and `best`, which are large and may not be needed. Borrows everything. */
struct plane_search {
	const struct body_pair *bodies;
	const struct plane_motion *motion;
	double needed;	/* mm: the plane must leave a larger gap throughout the motion */
	long *visits;	/* counts the cost of the search in node pairs */
	struct plane_pose pose;	/* where planes are measured */
	struct plane_pose ends[2];	/* of a straight motion, computed when needed */
	bool has_end[2];
	double apart;	/* mm: about how much farther apart than needed the shapes are; 0: not known */
	struct kept_plane best;
	double life;	/* the number of motions like this one for which the best plane lasts; below 0: none */
	bool held;	/* the best plane's gaps at both ends prove the motion, even if its life is below 1 */
};

/* Planes are measured with the axes at q. */
void plane_search_init(struct plane_search *search, const struct body_pair *bodies, const axis_values *q,
		       const struct plane_motion *motion, double needed, long *visits);

/*
 * Does a plane prove the motion? It is search->best. False: if life is at least 0, that plane may prove a part of the
 * motion. `last`: a kept plane between the parts, which is tried first; NULL: none.
 */
bool plane_search_between(struct plane_search *search, struct plane_part *a, struct plane_part *b,
			  const struct kept_plane *last);

/*
 * Measures a kept plane again in the present position of its link, and nothing else: it becomes search->best. `along`:
 * another normal, a unit vector in the coordinates of A's link; NULL: the plane's own. The pose is an end of a straight
 * motion. Returns mm: the plane leaves a larger gap throughout the motion, if necessary by its gaps at both ends;
 * -INFINITY: it leaves none at the pose, and there is no best one.
 */
double plane_search_carry(struct plane_search *search, struct plane_part *a, struct plane_part *b,
			  const struct kept_plane *last, const vec3 *along);

#endif
