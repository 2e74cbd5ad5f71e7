/* path_checks.h - refuses to overwrite inputs, and refuses input files outside of --input-root. */
#ifndef FIVECHECK_CLI_PATH_CHECKS_H
#define FIVECHECK_CLI_PATH_CHECKS_H

#include <stdbool.h>

#include "base/diag.h"
#include "cli/input_files.h"
#include "cli/options.h"
#include "machine/machine.h"
#include "machine/setup.h"
#include "report/report.h"

/*
 * False, reported: an output is the machine file, the setup, a program or another file of the command line, or two
 * outputs are the same file.
 */
bool path_checks_outputs(const struct options *options, struct diag *diag);

/*
 * The same for a file whose name is made from that of an option, as --report does for each of several programs;
 * `files`, too, were read.
 */
bool path_checks_derived(const struct options *options, const char *option, const char *path,
			 const struct report_file *files, size_t file_count, struct diag *diag);

/* False, reported: an output is a mesh of the machine or of the setup, which may be NULL. */
bool path_checks_meshes(const struct options *options, const struct machine *machine, const struct setup *setup,
			struct diag *diag);

/*
 * False, reported: an output is a file that was read. The files of subprograms are known only after the check, so this
 * runs before outputs take their names.
 */
bool path_checks_inputs(const struct options *options, const struct input_files *inputs, struct diag *diag);

/* False, reported: --input-root is no folder. */
bool path_checks_root(const struct options *options, struct diag *diag);

/*
 * False, reported: the machine or the setup names a mesh outside of --input-root, symbolic links followed. The bodies
 * remember the root, so that meshes which are read later obey it, too. Tool libraries obeyed it when they were read
 * (machine_load_within).
 */
bool path_checks_within(const struct options *options, const struct machine *machine, const struct setup *setup,
			struct diag *diag);

#endif
