/* placed_box.h - the bounds of bodies where they are mounted, in machine coordinates. */
#ifndef FIVECHECK_SCENE_PLACED_BOX_H
#define FIVECHECK_SCENE_PLACED_BOX_H

#include "geom/vec3.h"
#include "scene/scene.h"

/* Bounds in machine coordinates at the zero pose. */
struct placed_box {
	vec3 least, greatest;
};

/* The bounds of the box around the body's mesh. If the body is turned they are larger than the body. */
struct placed_box placed_box_of(const struct scene *scene, int body);

struct placed_box placed_box_union(struct placed_box a, struct placed_box b);
struct placed_box placed_box_empty(void);

/* placed_box_size: the longest side. placed_box_distance: the distance to a point; 0 inside. */
double placed_box_size(struct placed_box box);
double placed_box_distance(struct placed_box box, vec3 point);

/*
 * How far two boxes overlap along the axis where they overlap least. Negative: the gap along the axis where the gap is
 * largest.
 */
double placed_box_overlap(struct placed_box a, struct placed_box b);

#endif
