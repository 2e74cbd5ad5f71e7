/* program.h - opens, checks and reports one NC program of a run. */
#ifndef FIVECHECK_CLI_PROGRAM_H
#define FIVECHECK_CLI_PROGRAM_H

#include <stdbool.h>
#include <stdio.h>

#include "base/axes.h"
#include "check/model.h"
#include "cli/options.h"
#include "cli/ordered_output.h"
#include "cli/program_reports.h"
#include "cli/run_status.h"
#include "report/sink.h"
#include "report/tables/block_tables.h"

struct program_file {
	FILE *stream;
	const char *name;	/* for messages */
};

/* Opens a program; "-" is standard input. False: reported. */
bool program_open(struct program_file *file, const char *path, struct diag *diag);

/* False, reported: not all of the program could be read. */
bool program_close(struct program_file *file, struct diag *diag);

/* The common data of the programs of a run. All pointers are borrowed. */
struct program_context {
	const struct options *options;
	struct check_options check;	/* from the options, with the threads for one program */
	struct model *model;
	struct scene *scene;	/* the model's */
	struct report_run run;
	const struct sinks *sinks;
	struct program_reports *reports;	/* or NULL */
	struct block_tables *tables;	/* or NULL; with tables, only one program may be checked at a time */
};

/* The result of one program. */
struct program_outcome {
	enum run_status status;
	enum check_result result;
	struct check_stats stats;
	long waived;	/* findings */
	bool accepted;	/* there are findings, and none of them fails the run */
	bool has_first;	/* a finding fails the run; then: */
	axis_values first_axes;	/* the axis positions there */
	int first_tool;	/* in the spindle */
};

/* Checks one program and reports its findings and its verdict. */
void program_check(const struct program_context *context, const char *path, struct program_output *output,
		   struct program_outcome *outcome);

#endif
