/* init_options.h - the table of the options of `fivecheck init`, and their values. */
#ifndef FIVECHECK_CLI_INIT_INIT_OPTIONS_H
#define FIVECHECK_CLI_INIT_INIT_OPTIONS_H

#include "cli/init/machine_plan.h"
#include "cli/option_row.h"
#include "cli/options.h"

enum { INIT_OPTION_COUNT = 22 };

/* The values of the options: the arguments of each key but PLAN_HELP and PLAN_OUTPUT, in their order. */
struct init_request {
	struct text_list given[PLAN_KEY_END - PLAN_FAMILY];
	const char *output;	/* borrowed; NULL: standard output */
};

extern const struct option_row init_options[INIT_OPTION_COUNT];

/* The row of a key. PLAN_FAMILY is an operand; its row is not in the table. */
const struct option_row *init_options_row(enum machine_plan_key key);

#endif
