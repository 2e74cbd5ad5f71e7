/* merge.h - `fivecheck merge`: joins the NDJSON results of the shards of a run. */
#ifndef FIVECHECK_CLI_MERGE_H
#define FIVECHECK_CLI_MERGE_H

#include "cli/command.h"

enum { MERGE_OPTION_COUNT = 2 };

extern const struct option_row merge_options[MERGE_OPTION_COUNT];

/* Returns the exit status of the whole run; RUN_INCOMPLETE, reported, if the files are not all shards of one run. */
enum run_status merge_run(const struct command *all, int argc, char **argv, struct stderr_ui *ui);

#endif
