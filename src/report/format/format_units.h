/* format_units.h - prints numbers, axes, durations and names in the same way in every report. */
#ifndef FIVECHECK_REPORT_FORMAT_FORMAT_UNITS_H
#define FIVECHECK_REPORT_FORMAT_FORMAT_UNITS_H

#include <stddef.h>

#include "base/axes.h"
#include "base/strbuf.h"
#include "machine/machine.h"

/* The value of an axis in mm or degrees; never a negative zero. */
double format_units_value(int slot, double value);

/* "mm" or "deg" */
const char *format_units_unit(int slot);

/* Four digits after the point: a tenth of a micrometre is visible. */
void format_units_add(struct strbuf *out, double value);

/* "12.500 s"; from a minute on "1 h 02 min 03.500 s". */
void format_units_add_duration(struct strbuf *out, double seconds);

/* The axes of the machine in the order X Y Z A B C U V W: "X 1.0000 mm, A -30.0000 deg". */
void format_units_add_axes(struct strbuf *out, const struct machine *machine, const axis_values *axes);

/*
 * Text from a file on one line: control characters become spaces, and spaces at both ends are removed. A block can
 * neither forge a line of the report nor control a terminal.
 */
void format_units_add_plain(struct strbuf *out, const char *text);

/* The form of the noun for the number. */
const char *format_units_noun(size_t count, const char *one, const char *several);

/* "1 pair", "2 pairs" */
void format_units_add_count(struct strbuf *out, size_t count, const char *noun);

#endif
