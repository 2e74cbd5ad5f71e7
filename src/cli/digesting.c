#include "cli/digesting.h"

#include "base/parallel_for.h"

static bool is_given_up(void *context)
{
	struct digesting *digesting = context;

	return atomic_load_explicit(&digesting->given_up, memory_order_relaxed);
}

static void take_files(struct digesting *digesting)
{
	const struct cancel cancel = {digesting, is_given_up};
	size_t i;

	while ((i = atomic_fetch_add(&digesting->next, 1)) < digesting->inputs->count)
		input_files_digest_one(digesting->inputs, i, &cancel);
}

static void *run(void *context)
{
	take_files(context);
	return NULL;
}

void digesting_begin(struct digesting *digesting, struct input_files *inputs, int threads)
{
	digesting->inputs = inputs;
	digesting->threads = threads;
	digesting->is_started = threads > 1 && !pthread_create(&digesting->thread, NULL, run, digesting);
}

static void join(struct digesting *digesting)
{
	if (digesting->is_started)
		pthread_join(digesting->thread, NULL);
	digesting->is_started = false;
}

static void help(void *context, int worker, size_t i)
{
	(void)worker;
	(void)i;
	take_files(context);
}

/* The number of threads that have work, including this one. */
static int useful_threads(const struct digesting *digesting)
{
	const size_t files = digesting->inputs->count;

	return files < (size_t)digesting->threads ? (int)files : digesting->threads;
}

void digesting_finish(struct digesting *digesting)
{
	int helpers;

	if (!digesting->inputs)
		return;
	helpers = useful_threads(digesting) - digesting->is_started;
	parallel_for((size_t)helpers, helpers, help, digesting);
	join(digesting);
}

void digesting_end(struct digesting *digesting)
{
	atomic_store(&digesting->given_up, true);
	join(digesting);
}
