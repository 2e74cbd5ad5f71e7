/* g10_tool_table.h - G10 L1, L10 and L11 of LinuxCNC, which write the tool table. */
#ifndef FIVECHECK_GCODE_EXECUTE_G10_TOOL_TABLE_H
#define FIVECHECK_GCODE_EXECUTE_G10_TOOL_TABLE_H

#include <stdbool.h>

#include "gcode/state.h"

/*
 * Writes the block's words into the entry of tool P, which the setup must define. L1: the words are the offsets; L10:
 * the offsets are such that the present position has the words as its coordinates; L11: the same in G59.3 without G52
 * and G92. R is the radius. An active length stays until the next G43, an active radius until the next G41 or G42; the
 * tool's bodies never change. Faults: offsets of other axes than Z, words of lathe tools, and L10 and L11 under TCP or
 * if a probe may have stopped an axis. False: reported, nothing written.
 */
bool g10_tool_table_write(struct interp *interp, int mode);

#endif
