/* waiver_writer.h - writes a waivers file for the findings of an earlier run. */
#ifndef FIVECHECK_REPORT_WAIVER_WRITER_H
#define FIVECHECK_REPORT_WAIVER_WRITER_H

#include <stdbool.h>

#include "base/strbuf.h"
#include "report/ndjson_run.h"

/*
 * Appends the file: a waiver with the reason and the last day for each finding that failed the run. Equal findings
 * share a waiver. The file contains the digests of machine and setup. Returns the number of findings; -1, reported: the
 * run does not contain the digest of its machine or setup.
 */
long waiver_writer_add(struct strbuf *out, const struct ndjson_run *run, const char *reason, const char *expires,
		       struct diag *diag);

#endif
