/* static_query.h - checks two bodies at rest: apart, too close, or one inside the other. */
#ifndef FIVECHECK_SCENE_STATIC_QUERY_H
#define FIVECHECK_SCENE_STATIC_QUERY_H

#include <stdbool.h>

#include "geom/inside.h"
#include "scene/scene.h"

enum pose_state {
	POSE_CLEAR,	/* farther apart than the clearance */
	POSE_NEAR,	/* apart, but within the clearance */
	POSE_UNKNOWN,	/* as CLEAR, but one body may be inside the other: a mesh is open, or has no outside */
	POSE_OVERLAP,	/* the surfaces meet, or one solid is inside the other */
	POSE_FAILED	/* rounding exceeds the tolerance */
};

/*
 * The state of the pair at the axis positions q; tolerance (mm) as in sweep_chord. For NEAR and OVERLAP *contact is
 * filled in, with the point in a's mesh coordinates and, for OVERLAP, distance 0. FAILED is reported to diag, unless
 * that is NULL.
 */
enum pose_state static_query_pose(struct scene *scene, struct sweep *sweep, const struct scene_pair *pair,
				  const axis_values *q, double tolerance, struct contact *contact, struct diag *diag);

/* Is a component of one body inside the other, with the surfaces apart? For INSIDE_YES *point is filled in. */
enum inside static_query_contained(struct scene *scene, const struct scene_pair *pair, const axis_values *q,
				   vec3 *point);

/*
 * Is neither the pair's first body inside `shell`, one surface around its second body, nor the shell inside the first
 * body? Their surfaces are apart. False: one is inside, or may be.
 */
bool static_query_is_outside(struct scene *scene, const struct scene_pair *pair, const struct bvh *shell,
			     const axis_values *q);

/* Reports that the pair cannot be decided, because rounding alone exceeds the tolerance. */
void static_query_report_undecided(const struct scene *scene, const struct scene_pair *pair, double tolerance,
				   struct diag *diag);

/*
 * Do two bodies overlap at the axis positions q: do their surfaces meet, or is one inside the other? Touching within
 * `tolerance` mm counts. *point is in machine coordinates.
 */
bool static_query_overlaps(struct scene *scene, const struct scene_pair *pair, const axis_values *q, double tolerance,
			   vec3 *point, struct diag *diag);

#endif
