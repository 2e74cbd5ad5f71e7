/* command_table.h - the table of subcommands. */
#ifndef FIVECHECK_CLI_COMMAND_TABLE_H
#define FIVECHECK_CLI_COMMAND_TABLE_H

#include "cli/command.h"

/* Ends in a row without a name. */
extern const struct command command_table[];

/* The subcommand with this name, or NULL. To check a file with the name of a subcommand, write its folder: ./init */
const struct command *command_table_find(const char *name);

#endif
