/* main.c - prepares the process, runs the command line, and returns the exit status. */
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <unistd.h>

#include "base/mem.h"
#include "base/spelling.h"
#include "cli/command_line.h"
#include "cli/command_table.h"
#include "cli/explain.h"
#include "cli/jobs.h"
#include "cli/run.h"
#include "cli/stderr_ui.h"
#include "geom/simd_level.h"
#include "report/format/json.h"
#include "report/output.h"

/* assert() has failed: a mistake of fivecheck itself, which has its own exit status. */
static void on_abort(int signal_number)
{
	(void)signal_number;
	_exit(RUN_INTERNAL);
}

/*
 * If the shell closed standard input, output or error, the next file that is opened would get its number and receive
 * the report. /dev/null takes the number instead, opened so that every use of it fails.
 */
static void hold_standard_files(void)
{
	for (int fd = STDIN_FILENO; fd <= STDERR_FILENO; fd++) {
		if (fcntl(fd, F_GETFD) == -1)
			open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY);
	}
}

static enum run_status print(struct strbuf *text, struct diag *diag)
{
	return output_print(text, diag) ? RUN_CLEAR : RUN_INCOMPLETE;
}

/* Is the SIMD level in the environment available? */
static bool has_simd_level(struct diag *diag)
{
	const char *wanted = getenv(SIMD_LEVEL_VARIABLE);
	int level;

	if (!wanted || !*wanted || simd_level_of(wanted, &level))
		return true;
	diag_error(diag, (struct srcloc){0},
		   SIMD_LEVEL_VARIABLE ": this processor has no '%s'; give scalar, sse2 or avx2, or remove the "
				       "variable for the best of them",
		   wanted);
	return false;
}

/* Runs a command line without a subcommand. */
static enum run_status run_check(int argc, char **argv, struct stderr_ui *ui)
{
	struct options options;
	enum run_status status = RUN_INCOMPLETE;
	struct strbuf text = {0};

	if (!command_line_parse(&options, argc, argv, &ui->diag)) {
		diag_note(&ui->diag, (struct srcloc){0}, "'fivecheck --help' lists the options");
	} else if (options.mode == RUN_HELP) {
		command_line_help(&text, command_table);
		status = print(&text, &ui->diag);
	} else if (options.mode == RUN_VERSION) {
		strbuf_addf(&text, "fivecheck %s\n", FIVECHECK_VERSION);
		status = print(&text, &ui->diag);
	} else if (options.mode == RUN_EXPLAIN) {
		if (explain_add(&text, &options, &ui->diag))
			status = print(&text, &ui->diag);
	} else if (has_simd_level(&ui->diag)) {
		status = options.jobs ? jobs_run(&options, ui) : run_options(&options, ui);
	}
	options_release(&options);
	return status;
}

/* A word that is not a file and nearly the name of a command was probably meant to be one. */
static void note_command(const char *word, struct diag *diag)
{
	struct spelling nearest;

	spelling_init(&nearest, word);
	for (const struct command *command = command_table; command->name; command++)
		spelling_offer(&nearest, command->name);
	if (nearest.best && access(word, F_OK) != 0)
		diag_note(diag, (struct srcloc){0},
			  "'%s' is neither a file nor a command; did you mean 'fivecheck %s'?",
			  word, nearest.best);
}

int main(int argc, char **argv)
{
	const struct command *command = argc > 1 ? command_table_find(argv[1]) : NULL;
	struct stderr_ui ui;

	mem_keep_freed();
	hold_standard_files();
	/* A closed pipe or a file at its size limit makes the write fail; it does not end the process. */
	signal(SIGPIPE, SIG_IGN);
	signal(SIGXFSZ, SIG_IGN);
	signal(SIGABRT, on_abort);
	json_init();
	stderr_ui_init(&ui);
	if (!command && argc > 1)
		note_command(argv[1], &ui.diag);
	return (int)(command ? command->run(command_table, argc - 1, argv + 1, &ui) : run_check(argc, argv, &ui));
}
