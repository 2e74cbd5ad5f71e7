/* program_queue.h - which program is checked next, when several are checked at a time. */
#ifndef FIVECHECK_CLI_PROGRAM_QUEUE_H
#define FIVECHECK_CLI_PROGRAM_QUEUE_H

#include <pthread.h>
#include <stdbool.h>
#include <stddef.h>

struct program_queue {
	pthread_mutex_t lock;	/* for all that follows */
	size_t count;
	double *sizes;	/* bytes */
	bool *taken;
	size_t *by_size;	/* all programs, the largest first */
	size_t next, largest;	/* before these, of the programs and of by_size, all are taken */
	double left;	/* the sum of the sizes of those that are not taken */
	int threads;
};

/* sizes: bytes of each program, 0 where that is not known. */
void program_queue_init(struct program_queue *queue, const double *sizes, size_t count, int threads);
void program_queue_release(struct program_queue *queue);

/*
 * Takes a program; false: all are taken. They are taken in their order, because results are printed in that order;
 * except that a program with more than a thread's share of all that is left is taken at once: else the other threads
 * would have nothing to do in the end, when one still checks it.
 */
bool program_queue_take(struct program_queue *queue, size_t *program);

#endif
