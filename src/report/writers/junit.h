/* junit.h - results as CI servers read those of unit tests: a testcase a program. */
#ifndef FIVECHECK_REPORT_WRITERS_JUNIT_H
#define FIVECHECK_REPORT_WRITERS_JUNIT_H

#include "report/report.h"

/*
 * One testsuite. A program with findings has a failure, an incomplete one an
 * error; both name the first place in the message and all in the text.
 */
extern const struct report_writer junit_writer;

#endif
