/* run.h - the way from a command line to an exit status. */
#ifndef FIVECHECK_CLI_RUN_H
#define FIVECHECK_CLI_RUN_H

#include "cli/stderr_ui.h"
#include "cli/options.h"

/* In the order of their weight: the worst of a run is its exit status. */
enum run_status {
	RUN_CLEAR = 0,
	RUN_FOUND = 1,
	RUN_INCOMPLETE = 2,	/* usage, unreadable or unsupported input, output that could not be written */
	RUN_INTERNAL = 3
};

/* Does what the options say. */
enum run_status run_options(const struct options *options, struct stderr_ui *ui);

#endif
