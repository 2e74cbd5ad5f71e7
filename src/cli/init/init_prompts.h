/* init_prompts.h - asks on a terminal for the values that `fivecheck init` still needs, or reports them as errors. */
#ifndef FIVECHECK_CLI_INIT_INIT_PROMPTS_H
#define FIVECHECK_CLI_INIT_INIT_PROMPTS_H

#include <stdbool.h>
#include <stdio.h>

#include "base/diag.h"
#include "cli/init/machine_plan.h"

/* Is a value without a default missing? */
bool init_prompts_are_missing(const struct machine_plan *plan);

/* Reports every missing value without a default, with its option. True: nothing is missing. */
bool init_prompts_report(const struct machine_plan *plan, struct diag *diag);

/*
 * Asks on standard error for missing values and reads answers from `in`, one per line, until each is valid. False,
 * reported: the input ended too early.
 */
bool init_prompts_ask(struct machine_plan *plan, FILE *in, struct diag *diag);

#endif
