/* offsets.h - work offsets (G54 to G59.3, G10) and the shifts of G52 and G92. */
#ifndef FIVECHECK_GCODE_EXECUTE_OFFSETS_H
#define FIVECHECK_GCODE_EXECUTE_OFFSETS_H

#include <stdbool.h>

#include "gcode/state.h"

/* G54 to G59.3 of the block; nothing without one. */
bool offsets_select(struct interp *interp);

/* G10: L2 and L20; the tool table's forms are g10_tool_table.h. */
bool offsets_set(struct interp *interp);

/* G52, G92, G92.1, G92.2, G92.3. */
bool offsets_shift(struct interp *interp);

#endif
