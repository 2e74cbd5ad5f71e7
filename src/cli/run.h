/* run.h - runs a command line without a subcommand: a check, or a table about the machine or the path. */
#ifndef FIVECHECK_CLI_RUN_H
#define FIVECHECK_CLI_RUN_H

#include "check/model.h"
#include "cli/input_files.h"
#include "cli/options.h"
#include "cli/run_status.h"
#include "cli/stderr_ui.h"

/* Runs any mode that reads a machine file: not RUN_EXPLAIN, RUN_HELP and RUN_VERSION. */
enum run_status run_options(const struct options *options, struct stderr_ui *ui);

/*
 * The same with a model that was loaded from the files in the options, and prepared; for RUN_CHECK. `known` has the
 * digests of these files from earlier checks with the model, and receives those of this one. NULL and NULL: like
 * run_options.
 */
enum run_status run_options_on(const struct options *options, struct model *model, struct known_digests *known,
			       struct stderr_ui *ui);

#endif
