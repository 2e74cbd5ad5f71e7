/* completion.h - `fivecheck completion`: prints the completions of a shell. */
#ifndef FIVECHECK_CLI_COMPLETION_COMPLETION_H
#define FIVECHECK_CLI_COMPLETION_COMPLETION_H

#include "cli/command.h"

enum { COMPLETION_OPTION_COUNT = 1 };

extern const struct option_row completion_table[COMPLETION_OPTION_COUNT];
extern const char *const completion_shells[];	/* ends in NULL */

/* Prints the completions of the shell that the operand names. */
enum run_status completion_run(const struct command *all, int argc, char **argv, struct stderr_ui *ui);

#endif
