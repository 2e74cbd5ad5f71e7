/* baseline.h - findings of an earlier run, as NDJSON, that are accepted. */
#ifndef FIVECHECK_REPORT_BASELINE_H
#define FIVECHECK_REPORT_BASELINE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/diag.h"
#include "check/finding.h"
#include "machine/machine.h"

struct baseline;

/* Reads the NDJSON results of a run. NULL, reported: the file is something else or was cut short. */
struct baseline *baseline_load(const char *path, struct diag *diag);
void baseline_free(struct baseline *baseline);

/* The number of findings. */
size_t baseline_count(const struct baseline *baseline);

/*
 * Is the finding in the baseline? Program, file, kind, and the bodies (or the axis and its limit) must be equal, and
 * every axis must be within `tolerance` (mm and degrees); the line number may differ. Each finding of the baseline
 * accepts one finding: used[baseline_count] marks those that have. The caller clears it before each program.
 */
bool baseline_knows(const struct baseline *baseline, bool *used, const struct machine *machine, const char *program,
		    const struct finding *finding, double tolerance);

#endif
