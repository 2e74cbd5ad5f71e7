/* completion.h - `fivecheck completion`: completions for shells, made from the tables of options. */
#ifndef FIVECHECK_CLI_COMPLETION_COMPLETION_H
#define FIVECHECK_CLI_COMPLETION_COMPLETION_H

#include "cli/stderr_ui.h"
#include "cli/run.h"
#include "cli/option_table.h"

enum { COMPLETION_OPTION_COUNT = 1 };

extern const struct option_row completion_table[COMPLETION_OPTION_COUNT];
extern const char *const completion_shells[];	/* ends in NULL */

/* Prints the completions for the shell that is named. argv[0] is the command's name. */
enum run_status completion_run(int argc, char **argv, struct stderr_ui *ui);

#endif
