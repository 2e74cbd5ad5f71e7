/* digesting.h - the digests of a run's files, which another thread computes while this one reads the bodies. */
#ifndef FIVECHECK_CLI_DIGESTING_H
#define FIVECHECK_CLI_DIGESTING_H

#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>

#include "cli/input_files.h"

/* All zero: there is nothing to compute. Not to be moved after digesting_begin. */
struct digesting {
	struct input_files *inputs;	/* borrowed */
	int threads;	/* that digesting_finish may use */
	atomic_size_t next;	/* the first file that no thread has taken */
	atomic_bool given_up;
	bool is_started;	/* the thread */
	pthread_t thread;
};

/* Begins with the files that were added so far. With one thread all is left to digesting_finish. */
void digesting_begin(struct digesting *digesting, struct input_files *inputs, int threads);

/* Returns when each file has its digest (see input_files_digest_one). */
void digesting_finish(struct digesting *digesting);

/* Ends the thread, at once and without the digests that are missing. After digesting_finish there are none. */
void digesting_end(struct digesting *digesting);

#endif
