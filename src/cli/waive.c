#include "cli/waive.h"

#include <string.h>

#include "cli/report_date.h"
#include "cli/subcommand.h"
#include "machine/waivers.h"
#include "report/ndjson_run.h"
#include "report/output.h"
#include "report/waiver_writer.h"

static const struct srcloc nowhere;

enum { KEY_REASON = 256, KEY_UNTIL };

struct request {
	const char *reason, *until, *output;	/* NULL: not given; no output: standard output */
};

#define FIELD(member) .field = offsetof(struct request, member)

const struct option_row waive_options[WAIVE_OPTION_COUNT] = {
	{KEY_REASON, "reason", "TEXT", .kind = VALUE_TEXT, FIELD(reason),
	 .help = "why the findings are accepted; required"},
	{KEY_UNTIL, "until", "DATE", .kind = VALUE_TEXT, FIELD(until),
	 .help = "the last day, like 2026-12-31; required"},
	{'o', "output", "FILE", .kind = VALUE_OUTPUT, FIELD(output),
	 .help = "write to FILE, which is replaced when complete; - is standard output"},
	{'h', "help", NULL, .kind = VALUE_FLAG, .help = "print this help"},
};

static const struct subcommand subcommand = {
	.name = "waive",
	.usage = "Usage: fivecheck waive --reason=TEXT --until=DATE [OPTIONS] FILE\n"
		 "Writes a file for --waivers. It accepts every finding that failed the run with\n"
		 "the results FILE. Make FILE with --all --format=ndjson=FILE. The waivers hold\n"
		 "only for this machine file and this setup.\n",
	.options = waive_options,
	.option_count = WAIVE_OPTION_COUNT,
};

/* False: reported. An expired waiver would accept nothing. */
static bool is_to_come(const char *until, struct diag *diag)
{
	char today[DATE_SIZE];

	if (!report_date_get(today, diag))
		return false;
	if (strcmp(until, today) >= 0)
		return true;
	diag_error(diag, nowhere, "--until: %s has passed (today is %s in UTC)", until, today);
	return false;
}

/* False: reported. */
static bool check_request(const struct request *request, const struct operands *operands, struct diag *diag)
{
	if (operands->count != 1)
		diag_error(diag, nowhere, "waive needs the NDJSON results of one run");
	else if (!request->reason || !request->reason[strspn(request->reason, " \t\r\n")])
		diag_error(diag, nowhere, "waive needs a reason: --reason=TEXT");
	else if (!request->until)
		diag_error(diag, nowhere, "waive needs a last day: --until=2026-12-31");
	else if (!waivers_is_date(request->until))
		diag_error(diag, nowhere, "--until: '%s' is not a day like 2026-12-31", request->until);
	else
		return is_to_come(request->until, diag);
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

static enum run_status waive(const struct request *request, const char *results, struct diag *diag)
{
	struct ndjson_run run = {0};
	struct strbuf text = {0};
	long findings = -1;
	bool good;

	if (ndjson_run_load(&run, results, diag))
		findings = waiver_writer_add(&text, &run, request->reason, request->until, diag);
	good = findings >= 0 && write_waivers(request, &text, findings, diag);
	ndjson_run_release(&run);
	strbuf_release(&text);
	return good ? RUN_CLEAR : RUN_INCOMPLETE;
}

enum run_status waive_run(const struct command *all, int argc, char **argv, struct stderr_ui *ui)
{
	struct request request = {0};
	struct operands operands = {0};
	enum run_status status;

	(void)all;
	if (subcommand_read(&subcommand, &request, &operands, argc, argv, &ui->diag, &status))
		status = check_request(&request, &operands, &ui->diag) ? waive(&request, operands.items[0], &ui->diag)
							       : subcommand_refuse(&subcommand, &ui->diag);
	operands_release(&operands);
	return status;
}
