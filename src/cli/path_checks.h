/* path_checks.h - keeps a slip of the command line from overwriting an input, and foreign files from naming just any file. */
#ifndef FIVECHECK_CLI_PATH_CHECKS_H
#define FIVECHECK_CLI_PATH_CHECKS_H

#include <stdbool.h>

#include "base/diag.h"
#include "cli/input_files.h"
#include "cli/options.h"
#include "machine/machine.h"
#include "machine/setup.h"

/* False, reported, if a file that is to be written is the machine, the setup, a program, or another one. */
bool path_checks_outputs(const struct options *options, struct diag *diag);

/* The same of the meshes of the machine and the setup, which may be NULL. */
bool path_checks_meshes(const struct options *options, const struct machine *machine, const struct setup *setup,
			struct diag *diag);

/* The same of all that was read: files of subprograms are known only when the programs have been checked. */
bool path_checks_inputs(const struct options *options, const struct input_files *inputs, struct diag *diag);

/*
 * Is every mesh that machine and setup name inside of --input-root, links followed? False: reported. The bodies
 * remember the root: what is read later is held to it, too.
 */
bool path_checks_root(const struct options *options, const struct machine *machine, const struct setup *setup,
		   struct diag *diag);

#endif
