#include "cli/completion/completion.h"

#include <string.h>

#include "cli/completion/completion_scripts.h"
#include "cli/subcommand.h"
#include "report/output.h"

static const struct srcloc nowhere;

const struct option_row completion_table[COMPLETION_OPTION_COUNT] = {
	{'h', "help", NULL, .kind = VALUE_FLAG, .help = "print this help"},
};

static const struct subcommand subcommand = {
	.name = "completion",
	.usage = "Usage: fivecheck completion bash|zsh|fish\n"
		 "Prints the completions of a shell. 'make install' installs them. To try them in\n"
		 "the running shell:\n"
		 "    eval \"$(fivecheck completion bash)\"\n",
	.options = completion_table,
	.option_count = COMPLETION_OPTION_COUNT,
};

enum { SHELL_BASH, SHELL_ZSH, SHELL_FISH, SHELL_COUNT };

const char *const completion_shells[] = {
	[SHELL_BASH] = "bash", [SHELL_ZSH] = "zsh", [SHELL_FISH] = "fish", [SHELL_COUNT] = NULL,
};

static void (*const writers[])(struct strbuf *, const struct command *) = {
	[SHELL_BASH] = completion_scripts_bash,
	[SHELL_ZSH] = completion_scripts_zsh,
	[SHELL_FISH] = completion_scripts_fish,
};

static enum run_status print_scripts(const struct command *all, const struct operands *shells, struct diag *diag)
{
	struct strbuf text = {0};

	for (int i = 0; shells->count == 1 && i < SHELL_COUNT; i++) {
		if (strcmp(completion_shells[i], shells->items[0]) != 0)
			continue;
		writers[i](&text, all);
		return output_print(&text, diag) ? RUN_CLEAR : RUN_INCOMPLETE;
	}
	diag_error(diag, nowhere, "completion takes the name of one shell: bash, zsh or fish");
	return RUN_INCOMPLETE;
}

enum run_status completion_run(const struct command *all, int argc, char **argv, struct stderr_ui *ui)
{
	struct operands shells = {0};
	enum run_status status;

	if (subcommand_read(&subcommand, NULL, &shells, argc, argv, &ui->diag, &status))
		status = print_scripts(all, &shells, &ui->diag);
	operands_release(&shells);
	return status;
}
