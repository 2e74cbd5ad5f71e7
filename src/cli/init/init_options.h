/* init_options.h - the table of the options of `fivecheck init`. */
#ifndef FIVECHECK_CLI_INIT_INIT_OPTIONS_H
#define FIVECHECK_CLI_INIT_INIT_OPTIONS_H

#include "cli/init/machine_plan.h"
#include "cli/option_row.h"

enum { INIT_OPTION_COUNT = 19 };

extern const struct option_row init_options[INIT_OPTION_COUNT];

/* The row of a key. PLAN_FAMILY is an operand; its row is not in the table. */
const struct option_row *init_options_row(enum machine_plan_key key);

#endif
