/* sinumerik_soft_path.h - the line, quadrant or semicircle between a contour and the tool's way to and from it. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_PATH_SINUMERIK_SOFT_PATH_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_PATH_SINUMERIK_SOFT_PATH_H

#include "gcode/dialect/sinumerik/state/sinumerik_state.h"

/* All in straight coordinates (rotated_frame.h), in mm, as if programmed: compensation moves the tool beside them. */
struct sinumerik_soft_path {
	struct plane_point end;	/* P3, the end that is away from the contour */
	bool is_arc;
	struct plane_point centre;
	bool clockwise;
};

/*
 * The path that touches the contour at `contour` (P4), where the contour has the direction `along` (a unit vector).
 * `outside` is the programmed end P0 of the whole motion, or NULL: G143 finds its side by it. False: reported.
 */
bool sinumerik_soft_path_find(struct interp *interp, const struct sinumerik_soft_words *words,
			      struct plane_point contour, struct plane_point along, const struct plane_point *outside,
			      struct sinumerik_soft_path *path);

/* Is the code one that leaves a contour? */
bool sinumerik_soft_path_departs(int code);

#endif
