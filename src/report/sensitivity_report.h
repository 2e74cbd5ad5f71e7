/* sensitivity_report.h - how far a setup may be off before the verdict turns (--sensitivity), for people and for programs. */
#ifndef FIVECHECK_REPORT_SENSITIVITY_REPORT_H
#define FIVECHECK_REPORT_SENSITIVITY_REPORT_H

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>

#include "base/strbuf.h"
#include "check/measure/sensitivity.h"

/* Appends a line for each answer, indented, below a heading; `clear` is the verdict that they are about. */
void sensitivity_report_text(struct strbuf *out, const struct sensitivity *answers, size_t count, bool clear);

/*
 * An array of objects, to be released by who takes it: quantity "x" "y" "z" "length", direction "+" "-",
 * range, result "no effect" "holds" "turns" "unknown"; proved, tried and turn as in struct sensitivity, turn null
 * where nothing turns; kind, line, a, b, axis of what is found there, and why, or null.
 */
json_t *sensitivity_report_json(const struct sensitivity *answers, size_t count);

#endif
