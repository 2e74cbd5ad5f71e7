/* static_query.h - two bodies that stand still: apart, too close, or one in the other. */
#ifndef FIVECHECK_SCENE_STATIC_QUERY_H
#define FIVECHECK_SCENE_STATIC_QUERY_H

#include <stdbool.h>

#include "geom/inside.h"
#include "scene/scene.h"

enum pose_state {
	POSE_CLEAR,	/* farther apart than the clearance */
	POSE_NEAR,	/* apart, but within the clearance */
	POSE_UNKNOWN,	/* as CLEAR, but one body may be inside the other: a mesh is open, or has no known outside */
	POSE_OVERLAP,	/* the surfaces meet, or one solid is inside the other */
	POSE_FAILED	/* a mesh could not be read, or rounding exceeds the tolerance: reported */
};

/*
 * How the pair stands when the axes are at q; tolerance (mm) as in sweep_chord.
 * contact is filled for NEAR and OVERLAP; its distance is 0 for OVERLAP, its
 * point is in a's mesh coordinates.
 */
enum pose_state static_query_pose(struct scene *scene, struct sweep *sweep, const struct scene_pair *pair,
			 const axis_values *q, double tolerance, struct contact *contact, struct diag *diag);

/*
 * Is a component of one body inside the other, surfaces apart? *point is filled for INSIDE_YES. Faulty meshes
 * are reported and count as INSIDE_NO.
 */
enum inside static_query_contained(struct scene *scene, const struct scene_pair *pair, const axis_values *q, vec3 *point,
			    struct diag *diag);

/* Reports that rounding alone exceeds the tolerance for this pair. */
void static_query_report_undecided(const struct scene *scene, const struct scene_pair *pair, double tolerance,
				   struct diag *diag);

/*
 * Do two bodies overlap when the axes stand at q: do their surfaces meet, or
 * is one inside the other? Touching within `tolerance` mm counts. *point is in
 * a's mesh coordinates.
 */
bool static_query_overlaps(struct scene *scene, const struct scene_pair *pair, const axis_values *q, double tolerance,
		   vec3 *point, struct diag *diag);

#endif
