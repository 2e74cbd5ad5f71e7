#include "cli/subcommand.h"

#include <stdlib.h>

#include "base/mem.h"
#include "cli/argv_parser.h"
#include "cli/option_value.h"
#include "report/output.h"

static const struct srcloc nowhere;

struct reading {
	void *request;
	struct operands *operands;
	struct diag *diag;
	bool help;
};

static void take_operand(void *context, char *word)
{
	struct operands *operands = ((struct reading *)context)->operands;

	operands->items = mem_grow(operands->items, &operands->capacity, operands->count + 1, sizeof(*operands->items));
	operands->items[operands->count++] = word;
}

static enum argv_result take_option(void *context, const struct option_row *row, const char *argument)
{
	struct reading *reading = context;

	reading->help = row->key == 'h';
	if (reading->help)
		return ARGV_LAST;
	return option_value_set(reading->request, row, argument, reading->diag) ? ARGV_NEXT : ARGV_FAULT;
}

static enum run_status print_help(const struct subcommand *subcommand, struct diag *diag)
{
	struct strbuf text = {0};

	strbuf_addf(&text, "%s\n", subcommand->usage);
	argv_parser_help(&text, subcommand->options, subcommand->option_count);
	if (subcommand->examples)
		strbuf_addf(&text, "\n%s", subcommand->examples);
	return output_print(&text, diag) ? RUN_CLEAR : RUN_INCOMPLETE;
}

bool subcommand_read(const struct subcommand *subcommand, void *request, struct operands *operands, int argc,
		     char **argv, struct diag *diag, enum run_status *status)
{
	struct reading reading = {request, operands, diag, false};
	const struct argv_parser parser = {subcommand->options, subcommand->option_count, take_option, take_operand,
					   &reading};

	if (!argv_parser_run(&parser, argc, argv, diag))
		*status = subcommand_refuse(subcommand, diag);
	else if (reading.help)
		*status = print_help(subcommand, diag);
	else
		return true;
	return false;
}

enum run_status subcommand_refuse(const struct subcommand *subcommand, struct diag *diag)
{
	diag_note(diag, nowhere, "'fivecheck %s --help' lists the options", subcommand->name);
	return RUN_INCOMPLETE;
}

void operands_release(struct operands *operands)
{
	free(operands->items);
	*operands = (struct operands){0};
}
