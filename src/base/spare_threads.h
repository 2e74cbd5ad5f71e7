/* spare_threads.h - counts the idle threads of a run, for work that could use more of them. */
#ifndef FIVECHECK_BASE_SPARE_THREADS_H
#define FIVECHECK_BASE_SPARE_THREADS_H

#include <stdatomic.h>
#include <stdbool.h>

/* Only a count: whoever takes one may start a thread and keep it as long as needed. All zero: there are none. */
struct spare_threads {
	atomic_int count;
};

/* From any thread. */
void spare_threads_give(struct spare_threads *spare, int count);

/* From any thread: takes one. False: there is none. NULL is fine. */
bool spare_threads_take(struct spare_threads *spare);

#endif
