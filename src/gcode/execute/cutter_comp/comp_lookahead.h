/*
 * comp_lookahead.h - cutter compensation of controls that read the next block before they start and at corners.
 */
#ifndef FIVECHECK_GCODE_EXECUTE_CUTTER_COMP_COMP_LOOKAHEAD_H
#define FIVECHECK_GCODE_EXECUTE_CUTTER_COMP_COMP_LOOKAHEAD_H

#include <stdbool.h>

#include "gcode/state.h"

/*
 * Fanuc 16-C operator's manual (B-62764EN), 15.4 and 15.5; Haas mill operator's manual, "Cutter Compensation". The
 * first block moves straight to the point beside the start of the next block (type A), or around an outside corner
 * (type B); the block of G40 does the reverse. At inside corners the paths end at their intersection. At outside
 * corners the paths are extended to their intersection, if the path turns by at most 90 degrees, else by the radius on
 * both sides; or the corner is rounded. If the machine file does not say which, canon_move.spread covers all of these
 * paths.
 */

/*
 * Switches compensation on; the next move in the plane is the first one. The caller sets comp.start_type and
 * comp.corner_form.
 */
void comp_lookahead_begin(struct cutter_comp *comp, int side, double radius);

/* These replace the functions of the same names in cutter_comp.h while comp.looks_ahead. */
bool comp_lookahead_line(struct interp *interp, const slot_values *target, struct canon_move *move);
bool comp_lookahead_arc(struct interp *interp, const slot_values *target, struct plane_point centre, int turns,
			struct canon_move *move);

/* Carries out G40 without a move in the plane (comp_lookahead_leaves is false). */
bool comp_lookahead_stop(struct interp *interp);

/* Does the block, which has G40, move in the plane? Then comp_lookahead_line makes the exit move. */
bool comp_lookahead_leaves(const struct interp *interp);

#endif
