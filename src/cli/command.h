/* command.h - what the first word of a command line may be in place of a check's options: a command of its own. */
#ifndef FIVECHECK_CLI_COMMAND_H
#define FIVECHECK_CLI_COMMAND_H

#include <stddef.h>

#include "cli/stderr_ui.h"
#include "cli/run.h"
#include "cli/option_table.h"

struct command {
	const char *name;
	const char *operands;	/* as --help calls them */
	const char *const *choices;	/* what an operand may be, ends in NULL; NULL: files */
	const char *summary;
	const struct option_row *options;
	size_t option_count;
	/* argv[0] is the command's name. */
	enum run_status (*run)(int argc, char **argv, struct stderr_ui *ui);
};

enum { COMMAND_COUNT = 2 };

extern const struct command command_table[COMMAND_COUNT];

/* The command of a word, or NULL. A file of that name is written with its folder: ./init */
const struct command *command_of(const char *word);

/* Prints a text on standard output, and empties it. */
enum run_status command_print(struct strbuf *text, struct diag *diag);

#endif
