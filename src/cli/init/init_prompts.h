/* init_prompts.h - what `fivecheck init` has to know and was not told: asked on a terminal, else an error each. */
#ifndef FIVECHECK_CLI_INIT_INIT_PROMPTS_H
#define FIVECHECK_CLI_INIT_INIT_PROMPTS_H

#include <stdbool.h>
#include <stdio.h>

#include "base/diag.h"
#include "cli/init/machine_plan.h"

/* Is anything missing that has to be told? */
bool init_prompts_are_missing(const struct machine_plan *plan);

/* Reports everything that is missing, with the option that tells it; true if nothing is. */
bool init_prompts_report(const struct machine_plan *plan, struct diag *diag);

/*
 * Asks for what is missing, on standard error, until every answer makes sense; `in` has the answers, a line each.
 * False, reported, if they end before.
 */
bool init_prompts_ask(struct machine_plan *plan, FILE *in, struct diag *diag);

#endif
