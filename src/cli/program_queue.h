/* program_queue.h - decides which program is checked next, if several are checked at the same time. */
#ifndef FIVECHECK_CLI_PROGRAM_QUEUE_H
#define FIVECHECK_CLI_PROGRAM_QUEUE_H

#include <pthread.h>
#include <stdbool.h>
#include <stddef.h>

struct program_queue {
	pthread_mutex_t lock;	/* guards everything below */
	size_t count;
	double *sizes;	/* bytes */
	bool *taken;
	size_t *by_size;	/* all programs, the largest first */
	size_t next, largest;	/* all programs before these, in order and in by_size, are taken */
	double left;	/* the sum of the sizes of the others */
	int threads;
};

/* sizes: bytes of each program, 0 if unknown. */
void program_queue_init(struct program_queue *queue, const double *sizes, size_t count, int threads);
void program_queue_release(struct program_queue *queue);

/*
 * Takes a program; false: all are taken. They are taken in their order, because results are printed in that order. But
 * a program with more than one thread's share of the remaining work is taken at once: otherwise the other threads would
 * be idle at the end, while one still checks it.
 */
bool program_queue_take(struct program_queue *queue, size_t *program);

#endif
