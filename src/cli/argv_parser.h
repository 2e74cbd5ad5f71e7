/* argv_parser.h - takes a command line apart by a table of options; what the words mean is the caller's. */
#ifndef FIVECHECK_CLI_ARGV_PARSER_H
#define FIVECHECK_CLI_ARGV_PARSER_H

#include <stdbool.h>
#include <stddef.h>

#include "base/diag.h"
#include "base/strbuf.h"
#include "cli/option_table.h"

enum argv_result { ARGV_NEXT, ARGV_LAST, ARGV_FAULT };

struct argv_parser {
	const struct option_row *table;	/* borrowed */
	size_t count;
	/* One option; WORD_LAST ends the reading, WORD_FAULT says that it has reported a fault. */
	enum argv_result (*option)(void *context, const struct option_row *row, const char *argument);
	void (*operand)(void *context, char *word);
	void *context;
};

/*
 * Hands on options and operands in any order, in GNU's manner (getopt_long);
 * argv[0] is left out. What is unknown, ambiguous, or lacks its argument is
 * reported, and the result false. To be called once in a process.
 */
bool argv_parser_run(const struct argv_parser *words, int argc, char **argv, struct diag *diag);

/* Appends what --help says of each option. */
void argv_parser_help(struct strbuf *out, const struct option_row *table, size_t count);

#endif
