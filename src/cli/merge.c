#include "cli/merge.h"

#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "cli/argv_parser.h"
#include "report/output.h"
#include "report/shard_merge.h"

const struct option_row merge_options[MERGE_OPTION_COUNT] = {
	{'o', "output", "FILE", .kind = VALUE_TEXT,
	 .help = "write to FILE, which is replaced when complete; - is\nstandard output"},
	{'h', "help", NULL, .kind = VALUE_FLAG, .help = "print this help"},
};

struct request {
	char **files;	/* owned */
	size_t count, capacity;
	const char *output;	/* NULL: standard output */
	bool help;
};

static void take_operand(void *context, char *word)
{
	struct request *request = context;

	request->files = mem_grow(request->files, &request->capacity, request->count + 1, sizeof(*request->files));
	request->files[request->count++] = word;
}

static enum argv_result take_option(void *context, const struct option_row *row, const char *argument)
{
	struct request *request = context;

	if (row->key == 'h') {
		request->help = true;
		return ARGV_LAST;
	}
	request->output = strcmp(argument, "-") ? argument : NULL;
	return ARGV_NEXT;
}

static enum run_status print_help(struct diag *diag)
{
	struct strbuf text = {0};

	strbuf_addf(&text,
		    "Usage: fivecheck merge [OPTIONS] FILE...\n"
		    "Joins what all shards of a run wrote with --shard K/N --format=ndjson=FILE into the result\n"
		    "of one run. The exit status is that of the whole run: it is 2 if a shard is missing or was\n"
		    "cut short, or if the shards did not read the same files with the same options.\n\n");
	argv_parser_help(&text, merge_options, MERGE_OPTION_COUNT);
	return output_print(&text, diag) ? RUN_CLEAR : RUN_INCOMPLETE;
}

/* The file takes its name only when it is complete, so it may be one of the inputs. */
static enum run_status merge(const struct request *request, struct diag *diag)
{
	struct strbuf text = {0};
	struct output out;
	int status = RUN_INCOMPLETE;

	if (!shard_merge(&text, &status, request->files, request->count, diag) ||
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
	const struct argv_parser parser = {merge_options, MERGE_OPTION_COUNT, take_option, take_operand, &request};
	enum run_status status = RUN_INCOMPLETE;

	(void)all;
	if (!argv_parser_run(&parser, argc, argv, &ui->diag))
		diag_note(&ui->diag, (struct srcloc){0}, "'fivecheck merge --help' lists the options");
	else if (request.help)
		status = print_help(&ui->diag);
	else if (!request.count)
		diag_error(&ui->diag, (struct srcloc){0}, "merge needs the NDJSON files of all shards");
	else
		status = merge(&request, &ui->diag);
	free(request.files);
	return status;
}
