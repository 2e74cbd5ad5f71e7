/* waive.h - `fivecheck waive`: writes waivers for the findings of a run. */
#ifndef FIVECHECK_CLI_WAIVE_H
#define FIVECHECK_CLI_WAIVE_H

#include "cli/command.h"

enum { WAIVE_OPTION_COUNT = 4 };

extern const struct option_row waive_options[WAIVE_OPTION_COUNT];

enum run_status waive_run(const struct command *all, int argc, char **argv, struct stderr_ui *ui);

#endif
