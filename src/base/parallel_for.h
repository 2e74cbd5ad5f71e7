/* parallel_for.h - a loop whose iterations several threads share. */
#ifndef FIVECHECK_BASE_PARALLEL_FOR_H
#define FIVECHECK_BASE_PARALLEL_FOR_H

#include <stddef.h>

/* One iteration: `i` of the loop, run by the thread with the number `worker`, from 0. */
typedef void parallel_fn(void *context, int worker, size_t i);

/*
 * Calls body for each i below count, on up to `threads` threads including the caller, and returns when all are done. A
 * thread takes the lowest i that nobody has taken. If a thread cannot be started, the others do its share.
 */
void parallel_for(size_t count, int threads, parallel_fn *body, void *context);

#endif
