/* run.h - carries out a command line that has no subcommand: a check, or a table about the machine or the path. */
#ifndef FIVECHECK_CLI_RUN_H
#define FIVECHECK_CLI_RUN_H

#include "cli/options.h"
#include "cli/run_status.h"
#include "cli/stderr_ui.h"

/* Runs any mode that reads a machine file: not RUN_EXPLAIN, RUN_HELP and RUN_VERSION. */
enum run_status run_options(const struct options *options, struct stderr_ui *ui);

#endif
