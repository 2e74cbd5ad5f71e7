#include "cli/scan/scan.h"

#include <string.h>
#include <sys/stat.h>

#include "base/open_file.h"
#include "cli/dialect_choice.h"
#include "cli/path_checks.h"
#include "cli/scan/scan_codes.h"
#include "cli/scan/scan_questions.h"
#include "cli/scan/scan_setup.h"
#include "cli/subcommand.h"
#include "gcode/dialect/dialects.h"
#include "report/format/format_units.h"
#include "report/output.h"

static const struct srcloc nowhere;

struct request {
	int dialect;	/* index of dialect_choice_names; -1: not given */
	const char *output;	/* NULL: standard output */
	int max_blocks;	/* 0: not given */
};

const struct option_row scan_options[SCAN_OPTION_COUNT] = {
	{'d', "dialect", "NAME", .kind = VALUE_CHOICE, .field = offsetof(struct request, dialect),
	 .choices = dialect_choice_names,
	 .help = "%s; auto (the default): find the dialect from codes that only some controls have"},
	{256, "max-blocks", "N", .kind = VALUE_COUNT, .field = offsetof(struct request, max_blocks), .least = 1,
	 .greatest = 2e9, .help = "give up after N blocks in loops and subprograms (3000000)"},
	{'o', "output", "FILE", .kind = VALUE_OUTPUT, .field = offsetof(struct request, output),
	 .help = "write to FILE, which is replaced when complete; - is standard output"},
	{'h', "help", NULL, .kind = VALUE_FLAG, .help = "print this help"},
};

static const struct subcommand subcommand = {
	.name = "scan",
	.usage = "Usage: fivecheck scan [OPTIONS] PROGRAM...\n"
		 "Lists the codes of the programs and what fivecheck does with each, and the\n"
		 "attributes that the machine file needs for them. scan needs no machine file.\n",
	.options = scan_options,
	.option_count = SCAN_OPTION_COUNT,
};

/* False: reported. */
static bool find_dialect(const struct request *request, const struct operands *programs, struct diag *diag,
			 const struct dialect **dialect)
{
	int row = request->dialect;

	if ((row < 0 || dialect_choice_is_auto(row)) &&
	    !dialect_choice_find(programs->items, programs->count, diag, &row))
		return false;
	*dialect = dialect_of_row(row);
	return true;
}

struct scan {
	struct scan_codes codes;
	struct scan_questions *questions;
	struct scan_setup setup;
	size_t read;	/* programs that can be read to their ends */
	const char *output;	/* or NULL */
	bool overwrites;	/* the output is a subprogram, which was reported */
	struct diag *diag;
};

/* Is the file of a subprogram that of --output? */
static void on_opened(void *context, const char *path)
{
	struct scan *scan = context;

	scan->overwrites = scan->overwrites || !path_checks_differ("output", scan->output, path, scan->diag);
}

/* A program is read several times. False, reported: it is a pipe or standard input. */
static bool can_repeat(const char *name, struct diag *diag)
{
	const bool standard = !strcmp(name, "-");
	struct stat status;

	if (!standard && (stat(name, &status) || S_ISREG(status.st_mode) || S_ISDIR(status.st_mode)))
		return true;
	diag_error(diag, nowhere,
		   "scan reads a program several times, but %s cannot be read twice: give a regular file",
		   standard ? "standard input" : name);
	return false;
}

/* False, reported: the program could not be opened, or cannot be read to its end. */
static bool scan_program(struct scan *scan, const char *name)
{
	FILE *in = open_file(name, scan->diag);
	bool good;

	if (!in)
		return false;
	scan_codes_read(&scan->codes, in);
	good = scan_questions_read(scan->questions, in, name, scan->diag);
	scan->read += good;
	scan_setup_read(&scan->setup, scan_questions_config(scan->questions), in, name);
	fclose(in);
	return good;
}

static bool write_all(struct scan *scan, size_t programs)
{
	struct strbuf text = {0};
	struct output out;
	bool good;

	scan_codes_add(&text, &scan->codes);
	strbuf_addf(&text, "\nneeded in the machine file\tfirst needed by\n");
	scan_questions_add(&text, scan->questions);
	strbuf_addf(&text, "\nneeded in the setup\tfirst needed by\n");
	scan_setup_add(&text, &scan->setup);
	strbuf_addf(&text,
		    "\n%zu of %zu %s can be read to the end in the %s dialect, with these answers\n",
		    scan->read, programs, format_units_noun(programs, "program", "programs"),
		    scan->codes.dialect->name);
	good = output_open(&out, scan->output, scan->diag);
	if (good) {
		output_text(&out, &text);
		good = output_commit(&out, scan->diag);
	}
	strbuf_release(&text);
	return good;
}

static bool scan_all(const struct request *request, const struct operands *programs, struct diag *diag)
{
	struct scan scan = {.output = request->output, .diag = diag};
	const struct file_opened opened = {&scan, on_opened};
	const struct dialect *dialect;
	bool good = true;

	for (size_t i = 0; i < programs->count; i++)
		good = good && can_repeat(programs->items[i], diag);
	if (!good || !find_dialect(request, programs, diag, &dialect))
		return false;
	scan.codes.dialect = dialect;
	scan.questions = scan_questions_new(dialect, request->max_blocks, &opened);
	for (size_t i = 0; i < programs->count; i++)
		good = scan_program(&scan, programs->items[i]) && good;
	good = !scan.overwrites && write_all(&scan, programs->count) && good;
	scan_questions_free(scan.questions);
	scan_setup_release(&scan.setup);
	scan_codes_release(&scan.codes);
	return good;
}

enum run_status scan_run(const struct command *all, int argc, char **argv, struct stderr_ui *ui)
{
	struct request request = {.dialect = -1};
	struct operands programs = {0};
	enum run_status status;

	(void)all;
	if (subcommand_read(&subcommand, &request, &programs, argc, argv, &ui->diag, &status)) {
		if (programs.count) {
			status = scan_all(&request, &programs, &ui->diag) ? RUN_CLEAR : RUN_INCOMPLETE;
		} else {
			diag_error(&ui->diag, nowhere, "scan needs programs");
			status = subcommand_refuse(&subcommand, &ui->diag);
		}
	}
	operands_release(&programs);
	return status;
}
