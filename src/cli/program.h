/* program.h - one NC program of a run: opens it, checks it, reports on it. */
#ifndef FIVECHECK_CLI_PROGRAM_H
#define FIVECHECK_CLI_PROGRAM_H

#include <stdbool.h>
#include <stdio.h>

#include "base/axes.h"
#include "cli/console.h"
#include "cli/options.h"
#include "cli/run.h"
#include "report/output.h"
#include "report/stats.h"
#include "scene/scene.h"

struct program_file {
	FILE *stream;
	const char *name;	/* for messages */
};

/* Opens a program, "-" being standard input. False: reported. */
bool program_open(struct program_file *file, const char *path, struct diag *diag);

/* False, and reported, if not all of it could be read. */
bool program_close(struct program_file *file, struct diag *diag);

/* What the programs of a run share. All but the last four are borrowed. */
struct program_run {
	const struct options *options;
	struct console *console;
	struct scene *scene;
	struct output *out;
	bool colour;	/* on out */
	struct run_stats stats;
	bool has_first;	/* something was found; then: */
	axis_values first_axes;	/* where the machine stood */
	int first_tool;	/* in the spindle */
};

/* Checks one program and writes its findings and its verdict. */
enum run_status program_check(struct program_run *run, const char *path);

#endif
