/* baseline.h - findings that are known and accepted: the NDJSON of an earlier run. */
#ifndef FIVECHECK_REPORT_BASELINE_H
#define FIVECHECK_REPORT_BASELINE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/diag.h"
#include "check/finding.h"
#include "machine/machine.h"

struct baseline;

/* Reads the whole results of a run (ndjson.h). What is cut short or no such file is reported, and NULL. */
struct baseline *baseline_load(const char *path, struct diag *diag);
void baseline_free(struct baseline *baseline);

/* How many findings it has. */
size_t baseline_count(const struct baseline *baseline);

/*
 * Is the finding known: of the same program and file and of the same kind, the same bodies (or axis and limit) with
 * every axis within `tolerance` (mm and degrees) of where it was? Line numbers do not count. A known finding is known
 * once: used[baseline_count], all false for a program's first finding, keeps what was matched.
 */
bool baseline_knows(const struct baseline *baseline, bool *used, const struct machine *machine, const char *program,
		    const struct finding *finding, double tolerance);

#endif
