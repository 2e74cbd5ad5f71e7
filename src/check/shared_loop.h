/* shared_loop.h - a loop of the checking thread; an idle thread helps with its iterations. */
#ifndef FIVECHECK_CHECK_SHARED_LOOP_H
#define FIVECHECK_CHECK_SHARED_LOOP_H

#include <pthread.h>
#include <stdbool.h>
#include <stddef.h>

#include "base/parallel_for.h"

/*
 * Two threads share it: the owner, which runs loops, and a helper. Both may also use the lock and the condition for
 * other signals; then neither may wait for the condition while the other one does.
 */
struct shared_loop {
	pthread_mutex_t lock;	/* guards everything below */
	pthread_cond_t changed;
	parallel_fn *body;
	void *context;
	size_t count, next;	/* number of iterations, and the next one to take; both 0: no loop runs */
	int threads;	/* of the owner */
	bool helped;	/* the helper is running an iteration */
};

void shared_loop_init(struct shared_loop *loop);
void shared_loop_release(struct shared_loop *loop);

/*
 * For the owner: like parallel_for, with `threads` threads of its own, numbered from 0. The helper has the number
 * `threads`.
 */
void shared_loop_run(struct shared_loop *loop, size_t count, int threads, parallel_fn *body, void *context);

/*
 * For the helper, which holds `lock`: runs one iteration that nobody has taken, without the lock. False: there is none.
 */
bool shared_loop_help(struct shared_loop *loop);

#endif
