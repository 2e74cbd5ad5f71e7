/* program.h - one NC program of a run: opens it, checks it, reports on it. */
#ifndef FIVECHECK_CLI_PROGRAM_H
#define FIVECHECK_CLI_PROGRAM_H

#include <stdbool.h>
#include <stdio.h>

#include "base/axes.h"
#include "cli/options.h"
#include "cli/ordered_output.h"
#include "cli/run_status.h"
#include "report/baseline.h"
#include "report/sink.h"
#include "report/tables/block_tables.h"
#include "scene/scene.h"

struct program_file {
	FILE *stream;
	const char *name;	/* for messages */
};

/* Opens a program, "-" being standard input. False: reported. */
bool program_open(struct program_file *file, const char *path, struct diag *diag);

/* False, and reported, if not all of it could be read. */
bool program_close(struct program_file *file, struct diag *diag);

/* What the programs of a run share; borrowed, and not changed by them. */
struct program_context {
	const struct options *options;
	struct check_options check;	/* the options', with the threads that one program may use */
	struct scene *scene;
	struct report_run run;
	const struct baseline *baseline;	/* or NULL */
	const struct sinks *sinks;	/* where it is reported */
	struct block_tables *tables;	/* or NULL: nothing is measured, and several programs may be checked at once */
};

/* What became of one program. */
struct program_outcome {
	enum run_status status;
	enum check_result result;
	struct check_stats stats;
	long waived;	/* findings */
	bool accepted;	/* what was found does not fail the run */
	bool has_first;	/* something was found; then: */
	axis_values first_axes;	/* where the machine stood */
	int first_tool;	/* in the spindle */
};

/* Checks one program and says its findings and its verdict. */
void program_check(const struct program_context *context, const char *path, struct program_output *output,
		   struct program_outcome *outcome);

#endif
