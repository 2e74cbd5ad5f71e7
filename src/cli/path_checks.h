/* path_checks.h - refuses to overwrite inputs, and refuses input files outside --input-root. */
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
 * The same for a file whose name is derived from that of an option, as for --report with several programs; `files` are
 * further input files.
 */
bool path_checks_derived(const struct options *options, const char *option, const char *path,
			 const struct report_file *files, size_t file_count, struct diag *diag);

/* False, reported: the file of the option, which may be NULL, is this input file. */
bool path_checks_differ(const char *option, const char *path, const char *input, struct diag *diag);

/* False, reported: an output is a mesh of the machine or of the setup, which may be NULL. */
bool path_checks_meshes(const struct options *options, const struct machine *machine, const struct setup *setup,
			struct diag *diag);

/*
 * False, reported: an output is an input file. The files of subprograms are known only after the check, so call this
 * before outputs replace files.
 */
bool path_checks_inputs(const struct options *options, const struct input_files *inputs, struct diag *diag);

/* False, reported: a file that was read is the stock of another job of this run, from before the run. */
bool path_checks_stocks(const struct options *options, const struct input_files *inputs, struct diag *diag);

/* False, reported: --input-root, or one of --include, is not a folder. */
bool path_checks_folders(const struct options *options, struct diag *diag);

/*
 * False, reported: the machine or the setup has a mesh outside --input-root, after symbolic links are followed. The
 * bodies remember the root, so that it also applies to meshes that are read later. Tool libraries were tested when they
 * were read (machine_load_within).
 */
bool path_checks_within(const struct options *options, const struct machine *machine, const struct setup *setup,
			struct diag *diag);

#endif
