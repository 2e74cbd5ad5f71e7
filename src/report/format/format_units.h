/* format_units.h - how numbers, names and places read in every report: units of the files, the same digits everywhere. */
#ifndef FIVECHECK_REPORT_FORMAT_FORMAT_UNITS_H
#define FIVECHECK_REPORT_FORMAT_FORMAT_UNITS_H

#include <stddef.h>

#include "base/axes.h"
#include "base/strbuf.h"
#include "machine/machine.h"

/* mm stay mm, radians become degrees; never a negative zero. */
double format_units_value(int slot, double value);

/* "mm" or "deg" */
const char *format_units_unit(int slot);

/* Four digits after the point, at which a tenth of a micrometre shows. */
void format_units_add(struct strbuf *out, double value);

/* "12.5 s", or "1 h 02 min 03.5 s" where that is easier to read. */
void format_units_add_duration(struct strbuf *out, double seconds);

/* The machine's axes in the order X Y Z A B C U V W: "X 1.0000 mm, A -30.0000 deg". */
void format_units_add_axes(struct strbuf *out, const struct machine *machine, const axis_values *axes);

/*
 * Text from a file on one line: control characters become spaces, those at
 * either end go. A block cannot forge a line of the report or steer a terminal.
 */
void format_units_add_plain(struct strbuf *out, const char *text);

/* "1 pair", "2 pairs" */
void format_units_add_count(struct strbuf *out, size_t count, const char *noun);

#endif
