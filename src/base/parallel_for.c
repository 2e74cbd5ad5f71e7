#include "base/parallel_for.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>

#include "base/mem.h"

struct loop {
	size_t count;
	atomic_size_t next;
	parallel_fn *body;
	void *context;
};

struct worker {
	struct loop *loop;
	int number;
	pthread_t thread;
};

static void *work(void *context)
{
	const struct worker *worker = context;
	struct loop *loop = worker->loop;
	size_t i;

	while ((i = atomic_fetch_add(&loop->next, 1)) < loop->count)
		loop->body(loop->context, worker->number, i);
	return NULL;
}

void parallel_for(size_t count, int threads, parallel_fn *body, void *context)
{
	struct loop loop = {.count = count, .body = body, .context = context};
	struct worker *workers = mem_zalloc((size_t)(threads > 1 ? threads : 1), sizeof(*workers));
	int started = 1;

	workers[0].loop = &loop;
	for (; started < threads; started++) {
		workers[started] = (struct worker){.loop = &loop, .number = started};
		if (pthread_create(&workers[started].thread, NULL, work, &workers[started]))
			break;
	}
	work(&workers[0]);
	while (--started > 0)
		pthread_join(workers[started].thread, NULL);
	free(workers);
}
