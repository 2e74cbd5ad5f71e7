/* hal_values.h - the values that LinuxCNC's HAL files and HALCMD entries give to pins before the machine runs. */
#ifndef FIVECHECK_IMPORT_HAL_VALUES_H
#define FIVECHECK_IMPORT_HAL_VALUES_H

#include <stdbool.h>
#include <stddef.h>

#include "import/ini_file.h"

struct hal_command;

struct hal_values {
	const struct ini_file *ini;
	struct diag *diag;
	struct arena arena;
	struct hal_command *commands;	/* owned */
	size_t count, capacity;
	bool scripts;	/* some of the files are scripts (Tcl), which were not read */
};

/*
 * Reads the commands of [HAL]HALCMD and of the files of [HAL]HALFILE beside the ini file. Files of LIB: belong to the
 * control and do not describe the machine: they are left out. False, reported: a file cannot be read. Release it in
 * either case.
 */
bool hal_values_read(struct hal_values *hal, const struct ini_file *ini, struct diag *diag);
void hal_values_release(struct hal_values *hal);

enum hal_found {
	HAL_DEFAULT,	/* nothing sets the pin */
	HAL_SET,
	HAL_SIGNAL,	/* a signal sets it while the machine runs */
	HAL_FAULT	/* reported: its value is no number */
};

/*
 * The value that setp gives to the pin, or sets to its signal. *value is not changed unless the result is HAL_SET. For
 * a bit, the value may also be TRUE (1) or FALSE (0).
 */
enum hal_found hal_values_find(const struct hal_values *hal, const char *pin, bool bit, double *value);

#endif
