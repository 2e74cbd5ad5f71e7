#include "cli/subcommand.h"

#include <stdlib.h>

#include "base/mem.h"
#include "cli/argv_parser.h"
#include "cli/option_value.h"
#include "cli/path_checks.h"
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

/* An operand is a file that is read. False: reported. */
static bool spares_operands(const struct subcommand *subcommand, const void *request, const struct operands *operands,
			    struct diag *diag)
{
	bool good = true;

	for (size_t i = 0; i < subcommand->option_count; i++) {
		const struct option_row *row = &subcommand->options[i];

		if (row->kind != VALUE_OUTPUT)
			continue;
		for (size_t k = 0; good && k < operands->count; k++)
			good = path_checks_differ(row->name, *(const char *const *)((const char *)request + row->field),
						  operands->items[k], diag);
	}
	return good;
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
	else if (!spares_operands(subcommand, request, operands, diag))
		*status = RUN_INCOMPLETE;
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
