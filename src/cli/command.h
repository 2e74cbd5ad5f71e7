/* command.h - a subcommand: the action of `fivecheck` if its first argument is the name of one. */
#ifndef FIVECHECK_CLI_COMMAND_H
#define FIVECHECK_CLI_COMMAND_H

#include <stddef.h>

#include "cli/option_row.h"
#include "cli/run_status.h"
#include "cli/stderr_ui.h"

struct command {
	const char *name;
	const char *operands;	/* their name in --help */
	const char *const *choices;	/* the possible operands, ends in NULL; NULL: operands are files */
	const char *summary;
	const struct option_row *options;
	size_t option_count;
	/* argv[0] is the name of the subcommand; `all` is the table of subcommands. */
	enum run_status (*run)(const struct command *all, int argc, char **argv, struct stderr_ui *ui);
};

#endif
