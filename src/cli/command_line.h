/* command_line.h - reads the command line of a check into options, and prints --help. */
#ifndef FIVECHECK_CLI_COMMAND_LINE_H
#define FIVECHECK_CLI_COMMAND_LINE_H

#include <stdbool.h>

#include "base/diag.h"
#include "base/strbuf.h"
#include "cli/command.h"
#include "cli/options.h"

/*
 * Options and operands may come in any order. False, reported: something is unknown, malformed or out of range, or
 * options contradict each other. Release the options in either case.
 */
bool command_line_parse(struct options *options, int argc, char **argv, struct diag *diag);

/* Appends the text of --help; `commands` is the table of subcommands. */
void command_line_help(struct strbuf *out, const struct command *commands);

#endif
