/* argv_parser.h - takes a command line apart by a table of options; what the words mean is the caller's. */
#ifndef FIVECHECK_CLI_ARGV_PARSER_H
#define FIVECHECK_CLI_ARGV_PARSER_H

#include <stdbool.h>
#include <stddef.h>

#include "base/diag.h"
#include "base/strbuf.h"
#include "cli/option_table.h"

enum word_result { WORD_NEXT, WORD_LAST, WORD_FAULT };

struct words {
	const struct option_row *table;	/* borrowed */
	size_t count;
	/* One option; WORD_LAST ends the reading, WORD_FAULT says that it has reported a fault. */
	enum word_result (*option)(void *context, const struct option_row *row, const char *argument);
	void (*operand)(void *context, char *word);
	void *context;
};

/*
 * Hands on options and operands in any order, in GNU's manner (getopt_long);
 * argv[0] is left out. What is unknown, ambiguous, or lacks its argument is
 * reported, and the result false. To be called once in a process.
 */
bool words_parse(const struct words *words, int argc, char **argv, struct diag *diag);

/* Appends what --help says of each option. */
void words_help(struct strbuf *out, const struct option_row *table, size_t count);

#endif
