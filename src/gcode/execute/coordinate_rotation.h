/* coordinate_rotation.h - coordinates turned in the plane (G68), in space (G68.2, G53.1), and back (G69). */
#ifndef FIVECHECK_GCODE_EXECUTE_COORDINATE_ROTATION_H
#define FIVECHECK_GCODE_EXECUTE_COORDINATE_ROTATION_H

#include <stdbool.h>

#include "gcode/state.h"

/* Call before anything else of the block: carries out G69, and refuses what cannot be done in turned coordinates. */
bool coordinate_rotation_start_block(struct interp *interp);

/* Carries out the block's G68 or G68.2, if it has one. */
bool coordinate_rotation_turn(struct interp *interp);

/*
 * Checks the block's axis words after G68 or G69, before endpoint.c uses them.
 * The tool's position is known then, but not always its program coordinates:
 * a control may count from the turned coordinates or from those before. False:
 * the words depend on that, which was reported.
 */
bool coordinate_rotation_check_words(struct interp *interp, bool machine);

/* G53.1: turns the rotary axes so that the tool stands on the tilted plane. */
bool coordinate_rotation_orient_tool(struct interp *interp);

#endif
