/* init.h - `fivecheck init`: writes a commented machine file as a start, from options or answers. */
#ifndef FIVECHECK_CLI_INIT_INIT_H
#define FIVECHECK_CLI_INIT_INIT_H

#include "cli/command.h"
#include "cli/init/init_options.h"

/*
 * Asks for missing values if standard input is a terminal; otherwise a missing value is an error. Never overwrites a
 * file.
 */
enum run_status init_run(const struct command *all, int argc, char **argv, struct stderr_ui *ui);

#endif
