/* line_shape.h - rough classification of lines for all controls, for text that is not carried out. */
#ifndef FIVECHECK_GCODE_TEXT_LINE_SHAPE_H
#define FIVECHECK_GCODE_TEXT_LINE_SHAPE_H

#include <stdbool.h>

/* Bytes of a squeezed line, including the NUL. */
#define LINE_SHAPE_MAX 256

/* Writes the line without comments and blanks, in upper case, and cut off at LINE_SHAPE_MAX. */
void line_shape_squeeze(const char *line, char out[LINE_SHAPE_MAX]);

/* The same with its blanks. */
void line_shape_fold(const char *line, char out[LINE_SHAPE_MAX]);

/* Has the line, squeezed or not, an axis letter with a value and no letter before it, such as X10, Y-.5 or Z#1? */
bool line_shape_moves_axes(const char *line);

/* The following functions take squeezed lines. */

/* Has the line at least one word, and only words of a letter and a plain number? */
bool line_shape_is_block(const char *block);

/* Has the line a letter with a value after it? */
bool line_shape_has_word(const char *block);

/* Is the line only the number of a program, "O1234" or ":1234"? */
bool line_shape_is_program_number(const char *block);

#endif
