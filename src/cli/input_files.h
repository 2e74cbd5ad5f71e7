/* input_files.h - the files that a run reads, their digests, and the make rule that names them. */
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

struct file_stamp;

/* Digests of files that a session has loaded and assumes to be unchanged. All zero: none. */
struct known_digests {
	struct report_file *items;	/* their paths are owned */
	size_t count, capacity;
};

void known_digests_release(struct known_digests *known);

struct input_files {
	struct file_opened opened;	/* pass it to the check: it adds the files of subprograms */
	pthread_mutex_t lock;
	struct timespec started;
	struct report_file *items;	/* their paths are owned */
	size_t count, capacity;
	struct file_stamp *stamps;	/* the state of each file when it was added; in the order of adding */
	size_t stamp_count, stamp_capacity;
};

/*
 * Records the time: later changes of a file are detected. When a file is added, its size, inode and times are also
 * recorded and compared later, so that a clock that was set back hides no change. Do not move the struct afterwards:
 * `opened` points back to it.
 */
void input_files_init(struct input_files *inputs);
void input_files_release(struct input_files *inputs);

/* Adds machine, setup, waivers, programs other than standard input, and with `meshes` also the meshes. */
void input_files_add_files(struct input_files *inputs, const struct options *options, const struct machine *machine,
			   const struct setup *setup, bool meshes);

/* Sorts by kind and name. Call it after the check, when all subprograms are known. */
void input_files_sort(struct input_files *inputs);

/* Copies the digests of the machine, the setup, tool libraries and meshes from `known`. */
void input_files_take_known(struct input_files *inputs, const struct known_digests *known);

/* Adds the digests of these files to `known`. */
void input_files_remember(const struct input_files *inputs, struct known_digests *known);

/*
 * Computes the SHA-256 of file i, if it has none yet. A pipe, a file that cannot be read, and one for which `cancel`
 * (or NULL) requested a stop keep the digest "". Several threads may do this for different files while none is added.
 */
void input_files_digest_one(struct input_files *inputs, size_t i, const struct cancel *cancel);

/* The same for all files. */
void input_files_digest(struct input_files *inputs);

/*
 * False, reported: a file has changed since input_files_init, so it is unknown what was checked; or, with `strict`, a
 * file has no digest. Call it after input_files_digest.
 */
bool input_files_verify(const struct input_files *inputs, bool strict, struct diag *diag);

/* Writes the file of --depfile if there is one. False: reported. */
bool input_files_write_depfile(const struct input_files *inputs, const struct options *options, struct diag *diag);

#endif
