/* writers.h - the list of all output formats. A new format needs a file in this folder and a line in this list. */
#ifndef FIVECHECK_REPORT_WRITERS_WRITERS_H
#define FIVECHECK_REPORT_WRITERS_WRITERS_H

#include "report/report.h"

/*
 * FORMAT_<first> is written by <second>_writer. The first format is the default; --format offers all of these, and
 * json.
 */
#define WRITERS(X) \
	X(TEXT, text) \
	X(NDJSON, ndjson) \
	X(JUNIT, junit) \
	X(SARIF, sarif) \
	X(GITHUB, github)

/* Written by --record, which is a separate option. */
#define RECORD_WRITERS(X) X(RECORD, record)

#define WRITER_FORMAT(upper, lower) FORMAT_##upper,
enum report_format {
	WRITERS(WRITER_FORMAT)
	FORMAT_JSON,	/* of the tables that --check-machine and --list-pairs print: no writer */
	FORMAT_CHOICES,
	FORMAT_RECORD = FORMAT_CHOICES,
	FORMAT_COUNT
};
#undef WRITER_FORMAT

#define WRITER_DECLARATION(upper, lower) extern const struct report_writer lower##_writer;
WRITERS(WRITER_DECLARATION)
RECORD_WRITERS(WRITER_DECLARATION)
#undef WRITER_DECLARATION

/* Indexed by enum report_format. */
extern const struct report_writer *const report_writers[FORMAT_COUNT];

/* The values that --format accepts; ends in NULL. */
extern const char *const writer_names[];

#endif
