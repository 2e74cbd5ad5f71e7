#include "check/background.h"

static bool has_work(const struct background *background)
{
	return background->done < background->given && (!background->holds || background->taken == background->done);
}

/* Does the next piece of work, without the lock. */
static void do_next(struct background *background)
{
	bool goes_on;

	pthread_mutex_unlock(&background->loop.lock);
	goes_on = background->work(background->context, background->done);
	pthread_mutex_lock(&background->loop.lock);
	background->holds = !goes_on;
	background->done++;
	pthread_cond_signal(&background->loop.changed);
}

static void *run(void *context)
{
	struct background *background = context;

	pthread_mutex_lock(&background->loop.lock);
	while (!background->ends) {
		if (has_work(background))
			do_next(background);
		else
			pthread_cond_wait(&background->loop.changed, &background->loop.lock);
	}
	pthread_mutex_unlock(&background->loop.lock);
	return NULL;
}

void background_start(struct background *background, background_fn *work, void *context, size_t first)
{
	*background = (struct background){.work = work, .context = context, .given = first, .done = first,
					  .taken = first};
	shared_loop_init(&background->loop);
	background->is_started = !pthread_create(&background->thread, NULL, run, background);
}

void background_end(struct background *background)
{
	pthread_mutex_lock(&background->loop.lock);
	background->ends = true;
	pthread_cond_signal(&background->loop.changed);
	pthread_mutex_unlock(&background->loop.lock);
	if (background->is_started)
		pthread_join(background->thread, NULL);
	shared_loop_release(&background->loop);
}

void background_give(struct background *background)
{
	pthread_mutex_lock(&background->loop.lock);
	background->given++;
	pthread_mutex_unlock(&background->loop.lock);
	pthread_cond_signal(&background->loop.changed);
}

size_t background_done(struct background *background)
{
	size_t done;

	pthread_mutex_lock(&background->loop.lock);
	done = background->done;
	pthread_mutex_unlock(&background->loop.lock);
	return done;
}

void background_wait(struct background *background, size_t count)
{
	struct shared_loop *loop = &background->loop;

	pthread_mutex_lock(&loop->lock);
	while (background->done < count) {
		if (!background->is_started)
			do_next(background);
		else if (!shared_loop_help(loop))
			pthread_cond_wait(&loop->changed, &loop->lock);
	}
	pthread_mutex_unlock(&loop->lock);
}

void background_take(struct background *background, size_t count)
{
	bool held;

	pthread_mutex_lock(&background->loop.lock);
	background->taken = count;
	held = background->holds;
	pthread_mutex_unlock(&background->loop.lock);
	if (held)
		pthread_cond_signal(&background->loop.changed);
}
