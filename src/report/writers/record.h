/* record.h - what was checked, with which files and options, and what came of it: for an audit. */
#ifndef FIVECHECK_REPORT_WRITERS_RECORD_H
#define FIVECHECK_REPORT_WRITERS_RECORD_H

#include "report/report.h"

/*
 * One JSON object: version, options, every file that was read with its SHA-256, every program's verdict. It names no
 * time, computer or number of threads: the same inputs give the same bytes.
 */
extern const struct report_writer record_writer;

#endif
