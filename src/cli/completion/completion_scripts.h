/* completion_scripts.h - writes the completions of three shells from the tables of options and subcommands. */
#ifndef FIVECHECK_CLI_COMPLETION_COMPLETION_SCRIPTS_H
#define FIVECHECK_CLI_COMPLETION_COMPLETION_SCRIPTS_H

#include "base/strbuf.h"
#include "cli/command.h"

/* Each appends the whole script; `commands` is the table of subcommands. */
void completion_scripts_bash(struct strbuf *out, const struct command *commands);
void completion_scripts_zsh(struct strbuf *out, const struct command *commands);
void completion_scripts_fish(struct strbuf *out, const struct command *commands);

#endif
