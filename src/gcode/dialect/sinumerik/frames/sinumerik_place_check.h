/* sinumerik_place_check.h - are the offset, the frames, the plane and the edge of program coordinates certain? */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_FRAMES_SINUMERIK_PLACE_CHECK_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_FRAMES_SINUMERIK_PLACE_CHECK_H

#include <stdbool.h>
#include <stdint.h>

#include "gcode/dialect/sinumerik/state/sinumerik_state.h"

/* All functions return false if something is not certain; the report names what would make it certain. */

/* The active edge of the tool. */
bool sinumerik_place_check_edge(const struct interp *interp, int column);

/* The tool in the spindle: has T changed it, or does it wait for M6? */
bool sinumerik_place_check_tool(const struct interp *interp, int column);

/* The work offset, the frames and the plane, for the axes of these letters (letter_bit). */
bool sinumerik_place_check_frames(const struct interp *interp, uint32_t letters, int column);

/* All of them, for the program coordinate of this axis. */
bool sinumerik_place_check(const struct interp *interp, int slot, int column);

#endif
