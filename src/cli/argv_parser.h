/* argv_parser.h - splits a command line with a table of options; the caller decides what each option does. */
#ifndef FIVECHECK_CLI_ARGV_PARSER_H
#define FIVECHECK_CLI_ARGV_PARSER_H

#include <stdbool.h>
#include <stddef.h>

#include "base/diag.h"
#include "base/strbuf.h"
#include "cli/option_row.h"

enum argv_result { ARGV_NEXT, ARGV_LAST, ARGV_FAULT };

struct argv_parser {
	const struct option_row *table;	/* borrowed */
	size_t count;
	/* Receives one option. ARGV_LAST ends the parsing; ARGV_FAULT says that an error was reported. */
	enum argv_result (*option)(void *context, const struct option_row *row, const char *argument);
	void (*operand)(void *context, char *word);
	void *context;
};

/*
 * Passes on options and operands, which may come in any order, like GNU getopt_long; argv[0] is skipped. False,
 * reported: an option is unknown or ambiguous, or its argument is missing. getopt_long keeps global state: call this
 * once in a process.
 */
bool argv_parser_run(const struct argv_parser *parser, int argc, char **argv, struct diag *diag);

/* Appends the help of each option. */
void argv_parser_help(struct strbuf *out, const struct option_row *table, size_t count);

#endif
