/* decimal.h - decimal numbers of files and of the command line, fast. Those of NC programs are gcode/text/number.h. */
#ifndef FIVECHECK_BASE_DECIMAL_H
#define FIVECHECK_BASE_DECIMAL_H

#include <stdbool.h>
#include <stddef.h>

/*
 * Reads [+-]digits[.digits][e[+-]digits], with a digit before the exponent, independent of the locale, as the nearest
 * double; infinite if it is too large. White space or a NUL follows the word. False if it is anything else.
 */
bool decimal_read(const char *word, size_t length, double *value);

/* The same, and the nearest float, which is not always the one nearest to the nearest double. */
bool decimal_read_float(const char *word, size_t length, float *nearest, double *value);

#endif
