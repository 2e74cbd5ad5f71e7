/* report_date.h - which day it is, or shall be. */
#ifndef FIVECHECK_CLI_REPORT_DATE_H
#define FIVECHECK_CLI_REPORT_DATE_H

#include <stdbool.h>

#include "base/diag.h"
#include "machine/waivers.h"

/*
 * The day in UTC: of SOURCE_DATE_EPOCH (reproducible-builds.org: seconds since 1970) where the environment has it, so
 * that a run can be repeated, else of the clock. False: SOURCE_DATE_EPOCH is no such number, reported.
 */
bool report_date_get(char out[DATE_SIZE], struct diag *diag);

#endif
