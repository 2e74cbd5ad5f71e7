#include "cli/completion/completion.h"

#include <string.h>

#include "cli/argv_parser.h"
#include "cli/completion/completion_scripts.h"
#include "report/output.h"

static const struct srcloc nowhere;

const struct option_row completion_table[COMPLETION_OPTION_COUNT] = {
	{'h', "help", NULL, .kind = VALUE_FLAG, .help = "print this help"},
};

enum { SHELL_BASH, SHELL_ZSH, SHELL_FISH, SHELL_COUNT };

const char *const completion_shells[] = {
	[SHELL_BASH] = "bash", [SHELL_ZSH] = "zsh", [SHELL_FISH] = "fish", [SHELL_COUNT] = NULL,
};

struct request {
	const char *shell;	/* borrowed; NULL: none was named */
	size_t operands;
	bool help;
};

static void take_operand(void *context, char *word)
{
	struct request *request = context;

	request->shell = word;
	request->operands++;
}

static enum argv_result take_option(void *context, const struct option_row *row, const char *argument)
{
	struct request *request = context;

	(void)row;
	(void)argument;
	request->help = true;
	return ARGV_LAST;
}

static void add_help(struct strbuf *out)
{
	strbuf_addf(out, "Usage: fivecheck completion bash|zsh|fish\n"
			 "Prints the completions of a shell. 'make install' installs them. To try them in the\n"
			 "running shell:\n"
			 "    eval \"$(fivecheck completion bash)\"\n\n");
	argv_parser_help(out, completion_table, COMPLETION_OPTION_COUNT);
}

enum run_status completion_run(const struct command *all, int argc, char **argv, struct stderr_ui *ui)
{
	static void (*const writers[])(struct strbuf *, const struct command *) = {
	    [SHELL_BASH] = completion_scripts_bash,
	    [SHELL_ZSH] = completion_scripts_zsh,
	    [SHELL_FISH] = completion_scripts_fish,
	};
	struct request request = {0};
	struct argv_parser words = {completion_table, COMPLETION_OPTION_COUNT, take_option, take_operand, &request};
	struct strbuf text = {0};

	if (!argv_parser_run(&words, argc, argv, &ui->diag))
		return RUN_INCOMPLETE;
	if (request.help) {
		add_help(&text);
		return output_print(&text, &ui->diag) ? RUN_CLEAR : RUN_INCOMPLETE;
	}
	for (int i = 0; request.operands == 1 && i < SHELL_COUNT; i++) {
		if (strcmp(completion_shells[i], request.shell) != 0)
			continue;
		writers[i](&text, all);
		return output_print(&text, &ui->diag) ? RUN_CLEAR : RUN_INCOMPLETE;
	}
	diag_error(&ui->diag, nowhere, "completion takes the name of one shell: bash, zsh or fish");
	return RUN_INCOMPLETE;
}
