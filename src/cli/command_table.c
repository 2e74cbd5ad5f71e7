#include "cli/command_table.h"

#include <string.h>

#include "cli/completion/completion.h"
#include "cli/import/import_command.h"
#include "cli/init/init.h"
#include "cli/merge.h"
#include "cli/scan/scan.h"
#include "cli/waive.h"

const struct command command_table[] = {
    {"init", "FAMILY", machine_plan_families, "write a machine file as a start", init_options, INIT_OPTION_COUNT,
     init_run},
    {"import", "FILE", NULL, "convert the machine file of another program", import_options, IMPORT_OPTION_COUNT,
     import_run},
    {"merge", "FILE...", NULL, "join the NDJSON results of all shards", merge_options, MERGE_OPTION_COUNT,
     merge_run},
    {"waive", "FILE", NULL, "write waivers for the findings of a run", waive_options, WAIVE_OPTION_COUNT, waive_run},
    {"scan", "FILE...", NULL, "list the codes of programs", scan_options, SCAN_OPTION_COUNT,
     scan_run},
    {"completion", "SHELL", completion_shells, "write the completions of bash, zsh or fish", completion_table,
     COMPLETION_OPTION_COUNT, completion_run},
    {.name = NULL},
};

const struct command *command_table_find(const char *name)
{
	for (const struct command *command = command_table; command->name; command++) {
		if (!strcmp(command->name, name))
			return command;
	}
	return NULL;
}
