/* completion_scripts.h - the completions of three shells, written from tables of options. */
#ifndef FIVECHECK_CLI_COMPLETION_COMPLETION_SCRIPTS_H
#define FIVECHECK_CLI_COMPLETION_COMPLETION_SCRIPTS_H

#include <stddef.h>

#include "base/strbuf.h"
#include "cli/command.h"
#include "cli/option_table.h"

/* What an option's argument is. */
enum completion_value { COMPLETE_NOTHING, COMPLETE_WORDS, COMPLETE_FILE, COMPLETE_FOLDER, COMPLETE_OTHER };

/* Options that mean something together: those of a command, or of a check. */
struct completion_scope {
	const struct command *command;	/* NULL: a check */
	const struct option_row *options;
	size_t count;
};

/* The i-th of 1 + COMMAND_COUNT; 0 is the check. */
struct completion_scope completion_scope(int i);

/* What the option takes; if words, they are appended, separated by blanks. */
enum completion_value completion_value(struct strbuf *words, const struct option_row *row);

/* The whole of what the shell has to read. */
void completion_scripts_bash(struct strbuf *out);
void completion_scripts_zsh(struct strbuf *out);
void completion_scripts_fish(struct strbuf *out);

#endif
