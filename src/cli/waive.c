#include "cli/waive.h"

#include <string.h>

#include "cli/argv_parser.h"
#include "machine/waivers.h"
#include "report/ndjson_run.h"
#include "report/output.h"
#include "report/waiver_writer.h"

static const struct srcloc nowhere;

enum { KEY_REASON = 256, KEY_UNTIL };

const struct option_row waive_options[WAIVE_OPTION_COUNT] = {
	{KEY_REASON, "reason", "TEXT", .kind = VALUE_TEXT, .help = "why the findings are accepted; required"},
	{KEY_UNTIL, "until", "DATE", .kind = VALUE_TEXT, .help = "the last day, like 2026-12-31; required"},
	{'o', "output", "FILE", .kind = VALUE_TEXT,
	 .help = "write to FILE, which is replaced when complete; - is\nstandard output"},
	{'h', "help", NULL, .kind = VALUE_FLAG, .help = "print this help"},
};

struct request {
	const char *file, *reason, *until, *output;	/* NULL: not given; no output: standard output */
	size_t operands;
	bool help;
};

static void take_operand(void *context, char *word)
{
	struct request *request = context;

	request->file = word;
	request->operands++;
}

static enum argv_result take_option(void *context, const struct option_row *row, const char *argument)
{
	struct request *request = context;

	switch (row->key) {
	case KEY_REASON:
		request->reason = argument;
		break;
	case KEY_UNTIL:
		request->until = argument;
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

	strbuf_addf(&text,
		    "Usage: fivecheck waive --reason=TEXT --until=DATE [OPTIONS] FILE\n"
		    "Writes a file for --waivers that accepts every finding that failed the run whose results\n"
		    "are FILE, made with --all --format=ndjson=FILE. The waivers hold for this machine file and\n"
		    "this setup only.\n\n");
	argv_parser_help(&text, waive_options, WAIVE_OPTION_COUNT);
	return output_print(&text, diag) ? RUN_CLEAR : RUN_INCOMPLETE;
}

/* False: reported. */
static bool check(const struct request *request, struct diag *diag)
{
	if (request->operands != 1)
		diag_error(diag, nowhere, "waive needs the NDJSON results of one run");
	else if (!request->reason || !request->reason[strspn(request->reason, " \t\r\n")])
		diag_error(diag, nowhere, "waive needs a reason: --reason=TEXT");
	else if (!request->until)
		diag_error(diag, nowhere, "waive needs a last day: --until=2026-12-31");
	else if (!waivers_is_date(request->until))
		diag_error(diag, nowhere, "--until: '%s' is not a day like 2026-12-31", request->until);
	else
		return true;
	return false;
}

static bool write_waivers(const struct request *request, struct strbuf *text, long findings, struct diag *diag)
{
	struct output out;

	if (!output_open(&out, request->output, diag))
		return false;
	output_text(&out, text);
	if (!output_commit(&out, diag))
		return false;
	diag_note(diag, nowhere, "%ld %s waived until %s", findings, findings == 1 ? "finding is" : "findings are",
		  request->until);
	return true;
}

enum run_status waive_run(const struct command *all, int argc, char **argv, struct stderr_ui *ui)
{
	struct request request = {0};
	const struct argv_parser parser = {waive_options, WAIVE_OPTION_COUNT, take_option, take_operand, &request};
	struct ndjson_run run = {0};
	struct strbuf text = {0};
	long findings = -1;
	bool good = argv_parser_run(&parser, argc, argv, &ui->diag);

	(void)all;
	if (good && request.help)
		return print_help(&ui->diag);
	if (!good || !check(&request, &ui->diag)) {
		diag_note(&ui->diag, nowhere, "'fivecheck waive --help' lists the options");
		return RUN_INCOMPLETE;
	}
	if (ndjson_run_load(&run, request.file, &ui->diag))
		findings = waiver_writer_add(&text, &run, request.reason, request.until, &ui->diag);
	good = findings >= 0 && write_waivers(&request, &text, findings, &ui->diag);
	ndjson_run_release(&run);
	strbuf_release(&text);
	return good ? RUN_CLEAR : RUN_INCOMPLETE;
}
