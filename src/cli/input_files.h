/* input_files.h - which files a run depends on. */
#ifndef FIVECHECK_CLI_INPUT_FILES_H
#define FIVECHECK_CLI_INPUT_FILES_H

#include <pthread.h>
#include <stdbool.h>
#include <stddef.h>
#include <time.h>

#include "base/callbacks.h"
#include "cli/options.h"
#include "machine/machine.h"
#include "machine/setup.h"
#include "report/report.h"

struct input_files {
	struct file_opened opened;	/* for programs: their subprograms */
	pthread_mutex_t lock;
	struct timespec started;
	struct report_file *items;	/* their paths are owned */
	size_t count, capacity;
};

/* Not to be moved afterwards: its callback points back at it. */
void input_files_init(struct input_files *inputs);
void input_files_release(struct input_files *inputs);

/* Machine, setup (the file's, not the machine's own), meshes if they are read, programs but standard input. */
void input_files_add_files(struct input_files *inputs, const struct options *options, const struct machine *machine,
		      const struct setup *setup, bool meshes);

/* Sorts by kind and name. Call it when the programs have been read. */
void input_files_sort(struct input_files *inputs);

/*
 * Takes the digests of all. A file that has changed since inputs_init, is no regular one, or
 * cannot be read, is reported, and the result false: nobody could say what was checked.
 */
bool input_files_digest(struct input_files *inputs, struct diag *diag);

/* Writes --depfile, if that was asked for; false: reported. */
bool input_files_write_depfile(const struct input_files *inputs, const struct options *options, struct diag *diag);

#endif
