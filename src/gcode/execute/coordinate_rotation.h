/* coordinate_rotation.h - turns coordinates in the plane (G68) or in space (G68.2, G53.1), and back (G69). */
#ifndef FIVECHECK_GCODE_EXECUTE_COORDINATE_ROTATION_H
#define FIVECHECK_GCODE_EXECUTE_COORDINATE_ROTATION_H

#include <stdbool.h>

#include "gcode/state.h"

/* Call first for each block: carries out G69, and refuses codes that are not possible in turned coordinates. */
bool coordinate_rotation_start_block(struct interp *interp);

/* Carries out the block's G68 or G68.2, if it has one. */
bool coordinate_rotation_turn(struct interp *interp);

/*
 * Checks the block's axis words after G68 or G69, before endpoint.c uses them. The tool's position is then known, but
 * not always its program coordinates: a control may use the turned coordinates or the former ones. False: the words
 * depend on this, which was reported.
 */
bool coordinate_rotation_check_words(struct interp *interp, bool machine);

/* G53.1: turns the rotary axes so that the tool is perpendicular to the tilted plane. */
bool coordinate_rotation_orient_tool(struct interp *interp);

#endif
