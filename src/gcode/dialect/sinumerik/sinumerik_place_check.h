/* sinumerik_place_check.h - is it certain which offset, frames, plane and edge program coordinates depend on? */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_PLACE_CHECK_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_PLACE_CHECK_H

#include <stdbool.h>
#include <stdint.h>

#include "gcode/dialect/sinumerik/sinumerik_state.h"

/* All of these are false where it is not certain, which was reported with what says it. */

/* The edge of the tool. */
bool sinumerik_place_check_edge(const struct interp *interp, int column);

/* The tool: has T changed it, or does it wait for M6? */
bool sinumerik_place_check_tool(const struct interp *interp, int column);

/* Work offset, frames and plane, for the axes of these letters (letter_bit). */
bool sinumerik_place_check_frames(const struct interp *interp, uint32_t letters, int column);

/* All of them, for the program coordinate at which this axis stands. */
bool sinumerik_place_check(const struct interp *interp, int slot, int column);

#endif
