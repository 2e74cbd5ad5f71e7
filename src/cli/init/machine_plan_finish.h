/* machine_plan_finish.h - completes the machine plan: joins the chains of axes and fills in the defaults. */
#ifndef FIVECHECK_CLI_INIT_MACHINE_PLAN_FINISH_H
#define FIVECHECK_CLI_INIT_MACHINE_PLAN_FINISH_H

#include <stdbool.h>

#include "base/diag.h"
#include "cli/init/machine_plan.h"

/* False: what the options and answers say does not fit together, reported. */
bool machine_plan_finish(struct machine_plan *plan, struct diag *diag);

#endif
