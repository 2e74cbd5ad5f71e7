/* files.h - keeps a slip of the command line from overwriting an input. */
#ifndef FIVECHECK_CLI_FILES_H
#define FIVECHECK_CLI_FILES_H

#include <stdbool.h>

#include "base/diag.h"
#include "cli/options.h"

/* False, reported, if --output or --pose names the machine, the setup, a program, or each other. */
bool files_differ(const struct options *options, struct diag *diag);

#endif
