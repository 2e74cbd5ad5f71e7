/* sarif.h - results as SARIF 2.1.0, which code hosts show beside the lines of a change. */
#ifndef FIVECHECK_REPORT_WRITERS_SARIF_H
#define FIVECHECK_REPORT_WRITERS_SARIF_H

#include "report/report.h"

/*
 * One run. Rules are the kinds of findings, and "incomplete" for what could
 * not be checked. Locations are relative to the current folder where they can
 * be, and columns count UTF-16 code units. Source: OASIS, "Static Analysis
 * Results Interchange Format (SARIF) Version 2.1.0".
 */
extern const struct report_writer sarif_writer;

#endif
