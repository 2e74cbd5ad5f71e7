/* init.h - `fivecheck init`: writes a commented machine file to begin with, from options or answers. */
#ifndef FIVECHECK_CLI_INIT_INIT_H
#define FIVECHECK_CLI_INIT_INIT_H

#include "cli/stderr_ui.h"
#include "cli/init/machine_plan.h"
#include "cli/run.h"
#include "cli/option_table.h"

enum { INIT_OPTION_COUNT = 19 };

extern const struct option_row init_table[INIT_OPTION_COUNT];

/* The row of an option of the table, or that of the family, which is an operand. */
const struct option_row *init_row(enum machine_plan_key key);

/*
 * What is missing is asked for if standard input is a terminal; else it is an
 * error. An existing file is never overwritten. argv[0] is the command's name.
 */
enum run_status init_run(int argc, char **argv, struct stderr_ui *ui);

#endif
