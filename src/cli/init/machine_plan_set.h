/* machine_plan_set.h - stores the argument of an option of `fivecheck init`, or an answer, in the machine plan. */
#ifndef FIVECHECK_CLI_INIT_MACHINE_PLAN_SET_H
#define FIVECHECK_CLI_INIT_MACHINE_PLAN_SET_H

#include <stdbool.h>

#include "base/diag.h"
#include "cli/init/machine_plan.h"
#include "cli/option_row.h"

/* The row may be any but those of PLAN_OUTPUT and PLAN_HELP. False: the text does not fit the row, reported. */
bool machine_plan_set(struct machine_plan *plan, const struct option_row *row, const char *text, struct diag *diag);

#endif
