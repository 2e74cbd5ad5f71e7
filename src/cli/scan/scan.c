#include "cli/scan/scan.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "cli/argv_parser.h"
#include "cli/dialect_choice.h"
#include "cli/scan/scan_codes.h"
#include "cli/scan/scan_questions.h"
#include "gcode/dialect/dialects.h"
#include "report/output.h"

static const struct srcloc nowhere;

const struct option_row scan_options[SCAN_OPTION_COUNT] = {
	{'d', "dialect", "NAME", .kind = VALUE_CHOICE, .choices = dialect_choice_names,
	 .help = "%s; auto (the default):\nwhat the programs show for certain"},
	{'o', "output", "FILE", .kind = VALUE_TEXT,
	 .help = "write to FILE, which is replaced when complete; - is\nstandard output"},
	{'h', "help", NULL, .kind = VALUE_FLAG, .help = "print this help"},
};

struct request {
	char **programs;	/* owned array */
	size_t count, capacity;
	const char *dialect, *output;	/* NULL: not given */
	bool help;
};

static void take_operand(void *context, char *word)
{
	struct request *request = context;

	request->programs =
		mem_grow(request->programs, &request->capacity, request->count + 1, sizeof(*request->programs));
	request->programs[request->count++] = word;
}

static enum argv_result take_option(void *context, const struct option_row *row, const char *argument)
{
	struct request *request = context;

	switch (row->key) {
	case 'd':
		request->dialect = argument;
		break;
	case 'o':
		request->output = strcmp(argument, "-") ? argument : NULL;
		break;
	default:
		request->help = true;
		return ARGV_LAST;
	}
	return ARGV_NEXT;
}

static enum run_status print_help(struct diag *diag)
{
	struct strbuf text = {0};

	strbuf_addf(&text, "Usage: fivecheck scan [OPTIONS] PROGRAM...\n"
			   "Lists the codes that the programs use and what becomes of each, and what the machine file\n"
			   "must answer before they can be checked. No machine file is needed.\n\n");
	argv_parser_help(&text, scan_options, SCAN_OPTION_COUNT);
	return output_print(&text, diag) ? RUN_CLEAR : RUN_INCOMPLETE;
}

/* False: reported. */
static bool find_dialect(const struct request *request, struct diag *diag, const struct dialect **dialect)
{
	int row = 0;

	while (request->dialect && dialect_choice_names[row] &&
	       strcmp(dialect_choice_names[row], request->dialect) != 0)
		row++;
	if (!dialect_choice_names[row]) {
		diag_error(diag, nowhere, "--dialect: '%s' is no dialect; 'fivecheck scan --help' lists them",
			   request->dialect);
		return false;
	}
	if ((!request->dialect || dialect_choice_is_auto(row)) &&
	    !dialect_choice_find(request->programs, request->count, diag, &row))
		return false;
	*dialect = dialect_of_row(row);
	return true;
}

struct scan {
	struct scan_codes codes;
	struct scan_questions *questions;
	size_t read;	/* programs that can be read to their ends */
};

/* False: it could not be opened, or cannot be read to its end, which was reported. */
static bool scan_program(struct scan *scan, const char *name, struct diag *diag)
{
	FILE *in = fopen(name, "rb");
	bool good;

	if (!in) {
		diag_error(diag, (struct srcloc){name, 0, 0}, "cannot open the program: %s", strerror(errno));
		return false;
	}
	scan_codes_read(&scan->codes, in);
	good = scan_questions_read(scan->questions, in, name, diag);
	scan->read += good;
	fclose(in);
	return good;
}

static bool write_all(struct scan *scan, const struct request *request, struct diag *diag)
{
	struct strbuf text = {0};
	struct output out;
	bool good;

	scan_codes_add(&text, &scan->codes);
	strbuf_addf(&text, "\nin the machine file\tneeded first by\n");
	scan_questions_add(&text, scan->questions);
	strbuf_addf(&text,
		    "\n%zu of %zu programs can be read to their ends in the %s dialect, if these answers are given\n",
		    scan->read, request->count, scan->codes.dialect->name);
	good = output_open(&out, request->output, diag);
	if (good) {
		output_text(&out, &text);
		good = output_commit(&out, diag);
	}
	strbuf_release(&text);
	return good;
}

static bool scan_all(const struct request *request, struct diag *diag)
{
	struct scan scan = {.read = 0};
	const struct dialect *dialect;
	bool good = true;

	if (!find_dialect(request, diag, &dialect))
		return false;
	scan.codes.dialect = dialect;
	scan.questions = scan_questions_new(dialect);
	for (size_t i = 0; i < request->count; i++)
		good = scan_program(&scan, request->programs[i], diag) && good;
	good = write_all(&scan, request, diag) && good;
	scan_questions_free(scan.questions);
	scan_codes_release(&scan.codes);
	return good;
}

enum run_status scan_run(const struct command *all, int argc, char **argv, struct stderr_ui *ui)
{
	struct request request = {0};
	const struct argv_parser parser = {scan_options, SCAN_OPTION_COUNT, take_option, take_operand, &request};
	bool good = argv_parser_run(&parser, argc, argv, &ui->diag), helped = false;
	enum run_status status = RUN_INCOMPLETE;

	(void)all;
	if (good && request.help) {
		status = print_help(&ui->diag);
		helped = true;
	} else if (good && request.count == 0) {
		diag_error(&ui->diag, nowhere, "scan needs programs");
		good = false;
	}
	if (!good)
		diag_note(&ui->diag, nowhere, "'fivecheck scan --help' lists the options");
	if (good && !helped && scan_all(&request, &ui->diag))
		status = RUN_CLEAR;
	free(request.programs);
	return status;
}
