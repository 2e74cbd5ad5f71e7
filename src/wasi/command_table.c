/*
 * command_table.c - replaces src/cli/command_table.c: the page makes machines with init; all other commands need a
 * shell.
 */
#include "cli/command_table.h"

#include <string.h>

#include "cli/init/init.h"

const struct command command_table[] = {
    {"init", "FAMILY", machine_plan_families, "write a machine file to begin with", init_options, INIT_OPTION_COUNT,
     init_run},
    {.name = NULL},
};

const struct command *command_table_find(const char *name)
{
	return strcmp(name, command_table[0].name) ? NULL : command_table;
}
