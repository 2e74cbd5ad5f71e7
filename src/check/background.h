/* background.h - a second thread that does pieces of work one by one, while the first thread continues. */
#ifndef FIVECHECK_CHECK_BACKGROUND_H
#define FIVECHECK_CHECK_BACKGROUND_H

#include <pthread.h>
#include <stdbool.h>
#include <stddef.h>

#include "check/shared_loop.h"

/* Does the piece of work with this number. False: the next piece must wait until the result of this one is taken. */
typedef bool background_fn(void *context, size_t number);

struct background {
	background_fn *work;
	void *context;
	struct shared_loop loop;	/* the second thread may run it; its lock guards the next five members */
	size_t given, done, taken;	/* numbers of pieces */
	bool holds;	/* no more work until everything done is taken */
	bool ends;
	bool is_started;	/* false: the giver does the work itself */
	pthread_t thread;
};

/*
 * Starts the second thread, which waits for work. The first piece has the number `first`; earlier ones count as done
 * and taken. *background must not be moved afterwards.
 */
void background_start(struct background *background, background_fn *work, void *context, size_t first);

/* Ends the thread after its current piece. Other pieces are not done. */
void background_end(struct background *background);

/* Gives the next piece of work: the second thread sees everything that the caller has written so far. */
void background_give(struct background *background);

/* The number of pieces done; the caller sees everything that was written for them. */
size_t background_done(struct background *background);

/*
 * Waits until `count` pieces of work are done. Meanwhile the caller helps with the shared loop of the second thread.
 * The results of the earlier pieces must be taken.
 */
void background_wait(struct background *background, size_t count);

/* The results of `count` pieces of work are taken. */
void background_take(struct background *background, size_t count);

#endif
