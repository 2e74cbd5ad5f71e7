/* digesting.h - computes the digests of a run's files in another thread, while this one reads the bodies. */
#ifndef FIVECHECK_CLI_DIGESTING_H
#define FIVECHECK_CLI_DIGESTING_H

#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>

#include "cli/input_files.h"

/* All zero: there is nothing to compute. Do not move the struct after digesting_begin. */
struct digesting {
	struct input_files *inputs;	/* borrowed */
	int threads;	/* number of threads for digesting_finish */
	atomic_size_t next;	/* the first file that no thread has taken */
	atomic_bool given_up;
	bool is_started;	/* the thread */
	pthread_t thread;
};

/* Begins with the files added so far. With one thread, digesting_finish does all the work. */
void digesting_begin(struct digesting *digesting, struct input_files *inputs, int threads);

/* Returns when each file has its digest (see input_files_digest_one). */
void digesting_finish(struct digesting *digesting);

/* Ends the thread at once, without the missing digests. After digesting_finish none is missing. */
void digesting_end(struct digesting *digesting);

#endif
