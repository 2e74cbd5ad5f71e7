/* decimal.h - decimal numbers in ASCII files, to the nearest float, fast. */
#ifndef FIVECHECK_GEOM_DECIMAL_H
#define FIVECHECK_GEOM_DECIMAL_H

#include <stdbool.h>
#include <stddef.h>

/*
 * Reads [+-]digits[.digits][e[+-]digits], with a digit before the exponent:
 * the float and the double nearest to it, infinite where it is too large. The
 * word is followed by a white space or a NUL. False when it is anything else.
 * The decimal point is the point as long as the thread's locale has it so.
 */
bool decimal_read(const char *word, size_t length, float *nearest, double *value);

#endif
