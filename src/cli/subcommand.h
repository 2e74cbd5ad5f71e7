/* subcommand.h - reads the arguments of a subcommand into its request, and prints its help. */
#ifndef FIVECHECK_CLI_SUBCOMMAND_H
#define FIVECHECK_CLI_SUBCOMMAND_H

#include <stdbool.h>
#include <stddef.h>

#include "base/diag.h"
#include "cli/option_row.h"
#include "cli/run_status.h"

/* The option with the letter h prints the help. */
struct subcommand {
	const char *name;
	const char *usage;	/* the help before the options */
	const char *examples;	/* the help after them, or NULL */
	const struct option_row *options;
	size_t option_count;
};

/* The words are borrowed from argv; the array is owned. All zero is an empty list. */
struct operands {
	char **items;
	size_t count, capacity;
};

/*
 * Sets the fields of *request that the options name and fills *operands; argv[0] is skipped. False: nothing is left to
 * do, and *status is the exit status: the help was printed, or an error was reported.
 */
bool subcommand_read(const struct subcommand *subcommand, void *request, struct operands *operands, int argc,
		     char **argv, struct diag *diag, enum run_status *status);

/* After an error about the options, prints a note with the option that lists them. */
enum run_status subcommand_refuse(const struct subcommand *subcommand, struct diag *diag);

void operands_release(struct operands *operands);

#endif
