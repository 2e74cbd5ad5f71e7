/* offsets.h - work offsets (G54 to G59.3, G10) and the shifts of G52 and G92. */
#ifndef FIVECHECK_GCODE_EXECUTE_OFFSETS_H
#define FIVECHECK_GCODE_EXECUTE_OFFSETS_H

#include <stdbool.h>

#include "gcode/state.h"

/* Selects the block's work offset, if it has one. */
bool offsets_select(struct interp *interp);

/* Carries out G10 L2 and L20; g10_tool_table.h writes the tool table. */
bool offsets_set(struct interp *interp);

/* Carries out G52, G92, G92.1, G92.2 and G92.3. */
bool offsets_shift(struct interp *interp);

#endif
