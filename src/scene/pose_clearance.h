/* pose_clearance.h - how near the bodies of a scene are to each other with the axes at rest. */
#ifndef FIVECHECK_SCENE_POSE_CLEARANCE_H
#define FIVECHECK_SCENE_POSE_CLEARANCE_H

#include "scene/static_query.h"

struct pose_clearance {
	size_t pair;	/* the nearest of the pairs that are apart */
	double distance;	/* mm, between its nearest triangles; INFINITY: no pair is apart or has to be */
	vec3 on_a, on_b;	/* two points with this distance, in machine coordinates */
	size_t counts[POSE_FAILED + 1];	/* pairs by their state */
};

/* Must the bodies of the pair stay apart while the axes are within their limits, with this tool in the spindle? */
bool pose_clearance_counts(const struct scene *scene, const struct scene_pair *pair, int tool);

/*
 * Checks all pairs that count at the axis positions q, except those with the stock; states[i] becomes the state of pair
 * i, POSE_CLEAR if it does not count. `tolerance` (mm) as in static_query_pose.
 */
void pose_clearance_find(struct scene *scene, struct sweep *sweep, const axis_values *q, int tool, double tolerance,
			 struct pose_clearance *out, enum pose_state *states, struct diag *diag);

#endif
