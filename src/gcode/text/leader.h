/* leader.h - skips text before the '%' that starts a program, such as the header of a listing; controls ignore it. */
#ifndef FIVECHECK_GCODE_TEXT_LEADER_H
#define FIVECHECK_GCODE_TEXT_LEADER_H

#include "gcode/text/reader.h"

/*
 * Moves the reader to the first '%' line if only text precedes that line: no line that is a block or the number of a
 * program, or that moves axes. Otherwise that '%' may be the end of a program without a '%' at its start, and nothing
 * changes. Call it before the first line is read. Line numbers still count from the first line of the file.
 */
void leader_skip(struct reader *reader);

#endif
