/* report_date.h - the day that is compared with the dates of waivers. */
#ifndef FIVECHECK_CLI_REPORT_DATE_H
#define FIVECHECK_CLI_REPORT_DATE_H

#include <stdbool.h>

#include "base/diag.h"
#include "machine/waivers.h"

/*
 * Today in UTC, or the day of SOURCE_DATE_EPOCH (seconds since 1970; reproducible-builds.org) if the environment has
 * it, so that a run can be repeated. False, reported: SOURCE_DATE_EPOCH is not such a number.
 */
bool report_date_get(char out[DATE_SIZE], struct diag *diag);

#endif
