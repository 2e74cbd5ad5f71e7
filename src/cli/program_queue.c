#include "cli/program_queue.h"

#include <stdlib.h>

#include "base/mem.h"

struct sized {
	size_t program;
	double size;
};

static int by_size(const void *a, const void *b)
{
	const struct sized *x = a, *y = b;

	if (x->size < y->size || x->size > y->size)
		return x->size > y->size ? -1 : 1;
	return x->program < y->program ? -1 : x->program > y->program;
}

static void sort(struct program_queue *queue)
{
	struct sized *programs = mem_zalloc(queue->count + 1, sizeof(*programs));

	for (size_t i = 0; i < queue->count; i++)
		programs[i] = (struct sized){i, queue->sizes[i]};
	qsort(programs, queue->count, sizeof(*programs), by_size);
	for (size_t i = 0; i < queue->count; i++)
		queue->by_size[i] = programs[i].program;
	free(programs);
}

void program_queue_init(struct program_queue *queue, const double *sizes, size_t count, int threads)
{
	*queue = (struct program_queue){.count = count, .threads = threads};
	pthread_mutex_init(&queue->lock, NULL);
	queue->sizes = mem_zalloc(count + 1, sizeof(*queue->sizes));
	queue->taken = mem_zalloc(count + 1, sizeof(*queue->taken));
	queue->by_size = mem_zalloc(count + 1, sizeof(*queue->by_size));
	for (size_t i = 0; i < count; i++) {
		queue->sizes[i] = sizes[i];
		queue->left += sizes[i];
	}
	sort(queue);
}

void program_queue_release(struct program_queue *queue)
{
	pthread_mutex_destroy(&queue->lock);
	free(queue->sizes);
	free(queue->taken);
	free(queue->by_size);
}

/* The caller holds the lock, and not all are taken. */
static size_t choose(struct program_queue *queue)
{
	size_t large;

	while (queue->taken[queue->by_size[queue->largest]])
		queue->largest++;
	large = queue->by_size[queue->largest];
	return queue->sizes[large] * queue->threads > queue->left ? large : queue->next;
}

bool program_queue_take(struct program_queue *queue, size_t *program)
{
	bool found;

	pthread_mutex_lock(&queue->lock);
	while (queue->next < queue->count && queue->taken[queue->next])
		queue->next++;
	found = queue->next < queue->count;
	if (found) {
		*program = choose(queue);
		queue->taken[*program] = true;
		queue->left -= queue->sizes[*program];
	}
	pthread_mutex_unlock(&queue->lock);
	return found;
}
