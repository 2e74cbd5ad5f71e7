/*
 * comp_lookahead.h - cutter compensation of controls that look at the next block before they start and round corners.
 */
#ifndef FIVECHECK_GCODE_EXECUTE_CUTTER_COMP_COMP_LOOKAHEAD_H
#define FIVECHECK_GCODE_EXECUTE_CUTTER_COMP_COMP_LOOKAHEAD_H

#include <stdbool.h>

#include "gcode/state.h"

/*
 * Fanuc 16-C operator's manual (B-62764EN), 15.4 and 15.5; Haas mill operator's
 * manual, "Cutter Compensation". The first block leads straight to the point
 * beside the start of the next one (type A), or round an outside corner (type
 * B); the block of G40 does the same the other way. At inside corners the paths
 * end where they cross. Outside corners are drawn out to where they cross, if
 * the path turns by at most 90 degrees, else by the radius on both sides; or
 * rounded. Where the machine file does not say which, canon_move.spread covers
 * all of these ways.
 */

/*
 * Switches compensation on: the next move in the plane is the first. The caller sets comp.start_type and
 * comp.corner_form.
 */
void comp_lookahead_begin(struct cutter_comp *comp, int side, double radius);

/*
 * Each is called in place of what its name says of cutter_comp.h, while
 * comp.looks_ahead.
 */
bool comp_lookahead_line(struct interp *interp, const slot_values *target, struct canon_move *move);
bool comp_lookahead_arc(struct interp *interp, const slot_values *target, struct plane_point centre, int turns,
			struct canon_move *move);

/* G40 without a move in the plane, as comp_lookahead_leaves says. */
bool comp_lookahead_stop(struct interp *interp);

/* Does the block, which has G40, move in the plane? Then comp_lookahead_line makes its way out. */
bool comp_lookahead_leaves(const struct interp *interp);

#endif
