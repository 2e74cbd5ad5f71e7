/* import_command.h - `fivecheck import`: converts files of other programs to a machine file, a setup and meshes. */
#ifndef FIVECHECK_CLI_IMPORT_IMPORT_COMMAND_H
#define FIVECHECK_CLI_IMPORT_IMPORT_COMMAND_H

#include "cli/command.h"

enum { IMPORT_OPTION_COUNT = 11 };

extern const struct option_row import_options[IMPORT_OPTION_COUNT];

enum run_status import_run(const struct command *all, int argc, char **argv, struct stderr_ui *ui);

#endif
