/* coordinate_rotation.h - coordinates turned in the plane (G68), in space (G68.2, G53.1), and back (G69). */
#ifndef FIVECHECK_GCODE_EXECUTE_COORDINATE_ROTATION_H
#define FIVECHECK_GCODE_EXECUTE_COORDINATE_ROTATION_H

#include <stdbool.h>

#include "gcode/state.h"

/* Before anything else of the block: G69, and what cannot be done while coordinates are turned. */
bool coordinate_rotation_start_block(struct interp *interp);

/* G68 and G68.2 of the block; nothing without one. */
bool coordinate_rotation_turn(struct interp *interp);

/*
 * The block's axis words after G68 or G69, before endpoint.c makes a target of
 * them. Where the tool stands is known, but not always what the control takes
 * its program coordinates for: the turned ones, or those of before. False:
 * reported.
 */
bool coordinate_rotation_check_words(struct interp *interp, bool machine);

/* G53.1: turns the rotary axes so that the tool stands on the tilted plane. */
bool coordinate_rotation_orient_tool(struct interp *interp);

#endif
