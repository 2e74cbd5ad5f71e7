/* programs.h - checks the NC programs of a run, several at a time, and combines their results. */
#ifndef FIVECHECK_CLI_PROGRAMS_H
#define FIVECHECK_CLI_PROGRAMS_H

#include "check/model.h"
#include "cli/diag_tee.h"
#include "cli/input_files.h"
#include "cli/options.h"
#include "cli/ordered_output.h"
#include "report/sink.h"
#include "report/tables/block_tables.h"

/* One run. All pointers are borrowed. */
struct programs_run {
	const struct options *options;
	struct model *model;
	double seconds;	/* duration of loading */
	struct stderr_ui *ui;
	struct diag_tee *tee;	/* of ui->diag: receives the errors before the first program */
	struct sinks *sinks;
	struct input_files *inputs;	/* those read so far; the files of subprograms are added */
	const struct waiver_match *waiving;
	struct block_tables *tables;	/* or NULL; with tables, programs are checked one after the other */
};

/*
 * Checks the programs in the options, with as many threads as the options permit, and reports them in the order of the
 * command line. Sorts the inputs. If an output turns out to be an input, reports that and discards the sinks. If a file
 * beside the results cannot be written, no program is checked, and the sinks are closed with a report that says so.
 */
enum run_status programs_check(const struct programs_run *run);

#endif
