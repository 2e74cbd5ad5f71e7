/* leader.h - text before the '%' that starts a program, such as the header of a listing; no control carries it out. */
#ifndef FIVECHECK_GCODE_TEXT_LEADER_H
#define FIVECHECK_GCODE_TEXT_LEADER_H

#include "gcode/text/reader.h"

/*
 * Goes to the first '%' line if what precedes it is text: no line of it is a block, the number of a program, or moves
 * axes. Else that '%' may end a program that none starts, and nothing changes. To be called before the first line is
 * read. Lines from 1 keep their numbers.
 */
void leader_skip(struct reader *reader);

#endif
