/* sinumerik_tool.h - tools by number and by name, their edges (D), and M6. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_BLOCK_SINUMERIK_TOOL_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_BLOCK_SINUMERIK_TOOL_H

#include "gcode/dialect/sinumerik/block/sinumerik_block.h"

/* Executes T, M6 and D of the block, in this order. False: reported, or the sink wants no more. */
bool sinumerik_tool_run(struct interp *interp, const struct sinumerik_block *block);

/* The radius of the active edge, mm; 0 if it is not known, and for D0. */
double sinumerik_tool_radius(const struct interp *interp);

#endif
