/* line_shape.h - what a line looks like at a rough glance, whatever the control: for text that is not carried out. */
#ifndef FIVECHECK_GCODE_TEXT_LINE_SHAPE_H
#define FIVECHECK_GCODE_TEXT_LINE_SHAPE_H

#include <stdbool.h>

/* Bytes of a squeezed line, its NUL included. */
#define LINE_SHAPE_MAX 256

/* The line without comments and blanks, in upper case; what is longer than a block can sensibly be is cut off. */
void line_shape_squeeze(const char *line, char out[LINE_SHAPE_MAX]);

/* Is there an axis letter with a value and no letter before it, such as X10, Y-.5 or Z#1? Of any line. */
bool line_shape_moves_axes(const char *line);

/* These look at squeezed lines. */

/* Are there words only, a letter and a plain number each, and one at least? */
bool line_shape_is_block(const char *block);

/* Is there any letter with a value behind it? */
bool line_shape_has_word(const char *block);

/* "O1234" or ":1234" and no more: the number of a program. */
bool line_shape_is_program_number(const char *block);

#endif
