/* sinumerik_tool_frame.h - TOROT and TOFRAME: a frame whose Z points along the tool. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_TOOL_FRAME_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_TOOL_FRAME_H

#include "gcode/dialect/sinumerik/sinumerik_block.h"

/* Carries out TOROT, TOROTOF and the like of the block. False: reported. */
bool sinumerik_tool_frame_select(struct interp *interp, const struct sinumerik_block *block);

/* While such a frame is in force: does the block need its X or Y, which are not known? False: reported. */
bool sinumerik_tool_frame_check(struct interp *interp, const struct sinumerik_block *block, bool arc);

#endif
