/* box_query.h - proves two bodies at rest apart by boxes alone. */
#ifndef FIVECHECK_SCENE_BOX_QUERY_H
#define FIVECHECK_SCENE_BOX_QUERY_H

#include <stdbool.h>

#include "geom/boxes.h"
#include "geom/bvh.h"
#include "geom/xform.h"

/* Two bodies at one pose. Borrows the trees. */
struct box_query {
	const struct bvh *bodies[2];
	struct box_motion boxes;
};

/* pose: b's mesh coordinates in a's. */
void box_query_init(struct box_query *query, const struct bvh *a, const struct bvh *b, const xform *pose);

/* Is the box around one body proved apart from the box around the other? */
bool box_query_parts_boxes(const struct box_query *query);

/*
 * Is the surface of bodies[side] proved apart from the whole box around the other body? Then the whole box is on one
 * side of the surface. Also false if the boxes of a few triangles meet the box.
 */
bool box_query_parts_surface(const struct box_query *query, int side);

#endif
