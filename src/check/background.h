/* background.h - a second thread that does pieces of work one by one, while the thread that gives them goes on. */
#ifndef FIVECHECK_CHECK_BACKGROUND_H
#define FIVECHECK_CHECK_BACKGROUND_H

#include <pthread.h>
#include <stdbool.h>
#include <stddef.h>

#include "check/shared_loop.h"

/* Does the piece of work with this number. False: the next one must wait until this one's result is taken. */
typedef bool background_fn(void *context, size_t number);

struct background {
	background_fn *work;
	void *context;
	struct shared_loop loop;	/* the second thread may run it; its lock is for the next four */
	size_t given, done, taken;	/* pieces of work in all */
	bool holds;	/* nothing more is done until all that is done is taken */
	bool ends;
	bool is_started;	/* without a thread the giver does the work */
	pthread_t thread;
};

/*
 * Starts the second thread, which waits for work. The first piece has the number `first`: those before it count as done
 * and taken. Not to be moved afterwards.
 */
void background_start(struct background *background, background_fn *work, void *context, size_t first);

/* Ends the thread when it has done what it is doing. What was given besides is left undone. */
void background_end(struct background *background);

/* Gives the next piece of work: the second thread sees all that the caller has written so far. */
void background_give(struct background *background);

/* How many pieces of work are done; the caller sees what was written for them. */
size_t background_done(struct background *background);

/*
 * Returns when so many pieces of work are done. Meanwhile the caller helps with the shared loop that the second thread
 * runs. The results of those that were done before must be taken.
 */
void background_wait(struct background *background, size_t count);

/* The results of so many pieces of work are taken. */
void background_take(struct background *background, size_t count);

#endif
