/* spare_threads.h - how many threads of a run have nothing left to do, for work that could use more of them. */
#ifndef FIVECHECK_BASE_SPARE_THREADS_H
#define FIVECHECK_BASE_SPARE_THREADS_H

#include <stdatomic.h>
#include <stdbool.h>

/* A count only: who takes one may start a thread, which is there as long as it pleases. All zero: there are none. */
struct spare_threads {
	atomic_int count;
};

/* From any thread. */
void spare_threads_give(struct spare_threads *spare, int count);

/* From any thread: takes one. False: there is none. NULL is fine. */
bool spare_threads_take(struct spare_threads *spare);

#endif
