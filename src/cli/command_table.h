/* command_table.h - the one table of subcommands. */
#ifndef FIVECHECK_CLI_COMMAND_TABLE_H
#define FIVECHECK_CLI_COMMAND_TABLE_H

#include "cli/command.h"

/* Ends in a row without a name. */
extern const struct command command_table[];

/* The subcommand of that name, or NULL. A file with the name of a subcommand is written with its folder: ./init */
const struct command *command_table_find(const char *name);

#endif
