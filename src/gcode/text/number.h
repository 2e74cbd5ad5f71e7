/* number.h - decimal numbers as NC programs write them. */
#ifndef FIVECHECK_GCODE_TEXT_NUMBER_H
#define FIVECHECK_GCODE_TEXT_NUMBER_H

#include <stdbool.h>
#include <stddef.h>

/* Bytes of one number, sign and blanks apart; LinuxCNC takes lines of 255. */
#define NUMBER_LENGTH_MAX 255

enum number_status { NUMBER_OK, NUMBER_MISSING, NUMBER_TOO_LONG };

/*
 * Reads [+-] digits [.] digits, with blanks anywhere and no exponent, at
 * text[*position], and moves *position behind it. The value is the double
 * nearest to the decimal, whatever the locale; *point tells whether a decimal
 * point stood in it.
 */
enum number_status number_read(const char *text, size_t *position, double *value, bool *point);

/*
 * The usual number at `text` in one pass: no blanks but behind it, and not more digits than a double holds. Returns
 * what follows the number and its blanks. NULL: it is no such number, and nothing was set; number_read reads any.
 */
const char *number_read_usual(const char *text, double *value, bool *point);

/* The same for [+-] digits [, or .] digits without any blank. */
enum number_status number_read_with_comma(const char *text, size_t *position, double *value);

#endif
