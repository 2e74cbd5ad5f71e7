#include "check/shared_loop.h"

void shared_loop_init(struct shared_loop *loop)
{
	*loop = (struct shared_loop){0};
	pthread_mutex_init(&loop->lock, NULL);
	pthread_cond_init(&loop->changed, NULL);
}

void shared_loop_release(struct shared_loop *loop)
{
	pthread_cond_destroy(&loop->changed);
	pthread_mutex_destroy(&loop->lock);
}

/* Runs the next iteration in this thread, without the lock. */
static void take_round(struct shared_loop *loop, int number)
{
	const size_t round = loop->next++;

	pthread_mutex_unlock(&loop->lock);
	loop->body(loop->context, number, round);
	pthread_mutex_lock(&loop->lock);
}

static void take_rounds(void *context, int worker, size_t i)
{
	struct shared_loop *loop = context;

	(void)i;
	pthread_mutex_lock(&loop->lock);
	while (loop->next < loop->count)
		take_round(loop, worker);
	pthread_mutex_unlock(&loop->lock);
}

void shared_loop_run(struct shared_loop *loop, size_t count, int threads, parallel_fn *body, void *context)
{
	pthread_mutex_lock(&loop->lock);
	loop->body = body;
	loop->context = context;
	loop->count = count;
	loop->next = 0;
	loop->threads = threads;
	pthread_cond_signal(&loop->changed);
	pthread_mutex_unlock(&loop->lock);
	parallel_for((size_t)threads, threads, take_rounds, loop);
	pthread_mutex_lock(&loop->lock);
	while (loop->helped)
		pthread_cond_wait(&loop->changed, &loop->lock);
	loop->count = loop->next = 0;
	pthread_mutex_unlock(&loop->lock);
}

bool shared_loop_help(struct shared_loop *loop)
{
	if (loop->next >= loop->count)
		return false;
	loop->helped = true;
	take_round(loop, loop->threads);
	loop->helped = false;
	if (loop->next >= loop->count)
		pthread_cond_signal(&loop->changed);
	return true;
}
