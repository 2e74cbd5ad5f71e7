/* machine_plan_finish.h - completes the machine plan: joins the chains of axes and fills in the defaults. */
#ifndef FIVECHECK_CLI_INIT_MACHINE_PLAN_FINISH_H
#define FIVECHECK_CLI_INIT_MACHINE_PLAN_FINISH_H

#include <stdbool.h>

#include "base/diag.h"
#include "cli/init/machine_plan.h"

/* False, reported: the options and answers contradict each other. */
bool machine_plan_finish(struct machine_plan *plan, struct diag *diag);

#endif
