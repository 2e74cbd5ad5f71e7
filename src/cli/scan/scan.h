/*
 * scan.h - `fivecheck scan`: which codes programs use, and what the machine file must answer before they can be
 * checked.
 */
#ifndef FIVECHECK_CLI_SCAN_SCAN_H
#define FIVECHECK_CLI_SCAN_SCAN_H

#include "cli/command.h"

enum { SCAN_OPTION_COUNT = 4 };

extern const struct option_row scan_options[SCAN_OPTION_COUNT];

/* RUN_CLEAR: with the answers that are listed, all programs can be read to their ends. */
enum run_status scan_run(const struct command *all, int argc, char **argv, struct stderr_ui *ui);

#endif
