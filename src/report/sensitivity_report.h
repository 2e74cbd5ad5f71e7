/* sensitivity_report.h - prints by how much a setup may be wrong before the verdict changes (--sensitivity). */
#ifndef FIVECHECK_REPORT_SENSITIVITY_REPORT_H
#define FIVECHECK_REPORT_SENSITIVITY_REPORT_H

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>

#include "base/strbuf.h"
#include "check/measure/sensitivity.h"

/* Appends a heading and an indented line for each answer. `clear`: the verdict without changes is clear. */
void sensitivity_report_text(struct strbuf *out, const struct sensitivity *answers, size_t count, bool clear);

/*
 * Returns an array of objects, which the caller releases: quantity "x" "y" "z" "length"; direction "+" "-"; range;
 * result "no effect" "holds" "turns" "unknown"; proved, tried and turn as in struct sensitivity (turn is null if the
 * verdict does not change); kind, line, a, b, axis of the finding there, or null; why, or null.
 */
json_t *sensitivity_report_json(const struct sensitivity *answers, size_t count);

#endif
