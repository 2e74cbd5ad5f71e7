/*
 * scan.h - `fivecheck scan`: lists the codes of programs, and the attributes that the machine file needs before they
 * can be checked.
 */
#ifndef FIVECHECK_CLI_SCAN_SCAN_H
#define FIVECHECK_CLI_SCAN_SCAN_H

#include "cli/command.h"

enum { SCAN_OPTION_COUNT = 4 };

extern const struct option_row scan_options[SCAN_OPTION_COUNT];

/* RUN_CLEAR: with the listed answers, all programs can be read to the end. */
enum run_status scan_run(const struct command *all, int argc, char **argv, struct stderr_ui *ui);

#endif
