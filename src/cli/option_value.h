/* option_value.h - reads the value of an option, strictly. */
#ifndef FIVECHECK_CLI_OPTION_VALUE_H
#define FIVECHECK_CLI_OPTION_VALUE_H

#include <stdbool.h>

#include "base/diag.h"
#include "cli/options.h"
#include "cli/option_table.h"

/*
 * Sets the field of *options that the row names; the row is of any kind but
 * VALUE_MODE. Numbers are plain decimals, with an exponent if need be, and
 * nothing else. False: reported, *options untouched.
 */
bool option_value_set(struct options *options, const struct option_row *row, const char *text, struct diag *diag);

/* A plain decimal number, finite; false: it is none, *out untouched. */
bool option_value_number(double *out, const char *text);

#endif
