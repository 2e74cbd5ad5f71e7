/* option_value.h - reads the argument of an option. */
#ifndef FIVECHECK_CLI_OPTION_VALUE_H
#define FIVECHECK_CLI_OPTION_VALUE_H

#include <stdbool.h>

#include "base/diag.h"
#include "cli/option_row.h"
#include "cli/options.h"

/*
 * Sets the field of *record that the row names. Numbers are plain decimals, with or without an exponent. False,
 * reported: *record is unchanged.
 */
bool option_value_set(void *record, const struct option_row *row, const char *text, struct diag *diag);

/* Reads a finite plain decimal number. False: the text is not one, and *out is not changed. */
bool option_value_number(double *out, const char *text);

#endif
