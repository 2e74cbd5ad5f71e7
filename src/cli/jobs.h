/* jobs.h - runs a command line whose operand is a job file: one check after the other. */
#ifndef FIVECHECK_CLI_JOBS_H
#define FIVECHECK_CLI_JOBS_H

#include "cli/options.h"
#include "cli/run_status.h"
#include "cli/stderr_ui.h"

/*
 * options->machine is the job file. Each job is run with these options; in the names of output files, % is replaced by
 * the name of the job. Returns the worst exit status.
 */
enum run_status jobs_run(const struct options *options, struct stderr_ui *ui);

#endif
