/* sinumerik_tool_frame.h - TOROT and TOFRAME: a frame whose Z points along the tool. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_PATH_SINUMERIK_TOOL_FRAME_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_PATH_SINUMERIK_TOOL_FRAME_H

#include "gcode/dialect/sinumerik/block/sinumerik_block.h"

/* Executes TOROT, TOROTOF and the like of the block. False: reported. */
bool sinumerik_tool_frame_select(struct interp *interp, const struct sinumerik_block *block);

/* Does the block need X or Y of such an active frame, which are not known? False: it does, which was reported. */
bool sinumerik_tool_frame_check(struct interp *interp, const struct sinumerik_block *block, bool arc);

#endif
