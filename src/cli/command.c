#include "cli/command.h"

#include <string.h>

#include "cli/completion/completion.h"
#include "cli/init/init.h"
#include "report/output.h"

const struct command command_table[COMMAND_COUNT] = {
	{"init", "FAMILY", machine_plan_families, "write a machine file to begin with", init_table, INIT_OPTION_COUNT,
	 init_run},
	{"completion", "SHELL", completion_shells, "write the completions of bash, zsh or fish", completion_table,
	 COMPLETION_OPTION_COUNT, completion_run},
};

const struct command *command_of(const char *word)
{
	for (int i = 0; i < COMMAND_COUNT; i++) {
		if (!strcmp(command_table[i].name, word))
			return &command_table[i];
	}
	return NULL;
}

enum run_status command_print(struct strbuf *text, struct diag *diag)
{
	struct output out;
	bool good = output_open(&out, NULL, diag);

	output_text(&out, text);
	good = output_commit(&out, diag) && good;
	strbuf_release(text);
	return good ? RUN_CLEAR : RUN_INCOMPLETE;
}
