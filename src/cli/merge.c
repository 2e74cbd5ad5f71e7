#include "cli/merge.h"

#include "cli/subcommand.h"
#include "report/output.h"
#include "report/shard_merge.h"

struct request {
	const char *output;	/* NULL: standard output */
};

const struct option_row merge_options[MERGE_OPTION_COUNT] = {
	{'o', "output", "FILE", .kind = VALUE_OUTPUT, .field = offsetof(struct request, output),
	 .help = "write to FILE, which is replaced when complete; - is standard output"},
	{'h', "help", NULL, .kind = VALUE_FLAG, .help = "print this help"},
};

static const struct subcommand subcommand = {
	.name = "merge",
	.usage = "Usage: fivecheck merge [OPTIONS] FILE...\n"
		 "Joins the results that all shards of a run wrote with --shard K/N\n"
		 "--format=ndjson=FILE into the result of one run. The exit status is that of the\n"
		 "whole run: it is 2 if a shard is missing or was cut short, or if the shards did\n"
		 "not read the same files with the same options.\n",
	.options = merge_options,
	.option_count = MERGE_OPTION_COUNT,
};

static enum run_status merge(const struct request *request, const struct operands *files, struct diag *diag)
{
	struct strbuf text = {0};
	struct output out;
	int status = RUN_INCOMPLETE;

	if (!shard_merge(&text, &status, files->items, files->count, diag) ||
	    !output_open(&out, request->output, diag)) {
		strbuf_release(&text);
		return RUN_INCOMPLETE;
	}
	output_text(&out, &text);
	strbuf_release(&text);
	return output_commit(&out, diag) ? (enum run_status)status : RUN_INCOMPLETE;
}

enum run_status merge_run(const struct command *all, int argc, char **argv, struct stderr_ui *ui)
{
	struct request request = {0};
	struct operands files = {0};
	enum run_status status = RUN_INCOMPLETE;

	(void)all;
	if (subcommand_read(&subcommand, &request, &files, argc, argv, &ui->diag, &status)) {
		if (files.count)
			status = merge(&request, &files, &ui->diag);
		else
			diag_error(&ui->diag, (struct srcloc){0}, "merge needs the NDJSON files of all shards");
	}
	operands_release(&files);
	return status;
}
