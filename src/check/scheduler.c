#include "check/crew.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>

#include "base/mem.h"

/*
 * A runner that looked at more node pairs than this in a batch is worth
 * several threads in the next one; and starting threads is worth it at all.
 */
#define HEAVY 20000

/*
 * A heavy runner's batch is dealt out in parts of whole chunks, large ones first: each is this share of what is
 * left, so that all threads come to the end at about the same time and yet few parts begin without a past.
 */
#define PART_SHARE 4

bool crew_init(struct crew *crew, struct scene *scene, const struct check_options *options, bool measure,
	       struct diag *diag)
{
	*crew = (struct crew){.threads = options->threads > 1 ? options->threads : 1};
	crew->runners = mem_zalloc(scene->pair_count, sizeof(*crew->runners));
	crew->visits = mem_zalloc(scene->pair_count, sizeof(*crew->visits));
	crew->sweeps = mem_zalloc((size_t)crew->threads, sizeof(*crew->sweeps));
	for (int i = 0; i < crew->threads; i++)
		crew->sweeps[i].cancel = options->read.cancel;
	for (size_t i = 0; i < scene->pair_count; i++) {
		enum pair_status status = scene->pairs[i].status;

		if (status != PAIR_CHECKED && status != PAIR_OUT_OF_REACH)
			continue;
		if (!runner_init(&crew->runners[crew->count], scene, i, options, measure, diag))
			return false;
		crew->count++;
	}
	return true;
}

void crew_release(struct crew *crew)
{
	for (size_t i = 0; i < crew->count; i++)
		runner_release(&crew->runners[i]);
	for (int i = 0; i < crew->threads; i++)
		sweep_release(&crew->sweeps[i]);
	free(crew->runners);
	free(crew->visits);
	free(crew->sweeps);
	free(crew->tasks);
	free(crew->results);
	*crew = (struct crew){0};
}

void crew_change_tool(struct crew *crew)
{
	for (size_t i = 0; i < crew->count; i++)
		if (crew->runners[i].tool)
			follower_lose(&crew->runners[i].follower);
}

void crew_jump(struct crew *crew)
{
	for (size_t i = 0; i < crew->count; i++)
		runner_jump(&crew->runners[i]);
}

/* ------------------------------------------------------------------ tasks */

static void add_task(struct crew *crew, struct runner *runner, struct runner *copy, size_t from, size_t to)
{
	crew->tasks = mem_grow(crew->tasks, &crew->task_capacity, crew->task_count + 1, sizeof(*crew->tasks));
	crew->tasks[crew->task_count++] = (struct task){runner, copy, from, to};
}

/*
 * Parts of a batch know nothing of each other. That a pair has met matters to
 * what follows, so a runner that goes on behind a finding is not divided.
 */
static bool is_divisible(const struct crew *crew, const struct runner *runner, const struct check_options *options)
{
	return crew->visits[runner - crew->runners] > HEAVY && options->method == CHECK_CERTIFIED && !options->all &&
	       !runner->entangled && !runner->past_limits_only;
}

static size_t part_of(size_t left)
{
	size_t part = left / PART_SHARE / CHUNK_STEPS * CHUNK_STEPS;

	return part ? part : left < CHUNK_STEPS ? left : CHUNK_STEPS;
}

static void divide(struct crew *crew, struct runner *runner, const struct batch *batch)
{
	size_t count;

	for (size_t from = 0; from < batch->step_count; from += count) {
		struct runner *copy = mem_zalloc(1, sizeof(*copy));

		*copy = *runner;
		copy->results = NULL;
		copy->result_count = copy->result_capacity = 0;
		follower_fork(&runner->follower, &copy->follower);
		count = part_of(batch->step_count - from);
		add_task(crew, runner, copy, from, from + count);
	}
}

static void plan(struct crew *crew, const struct batch *batch, int tool, const struct check_options *options)
{
	crew->task_count = 0;
	for (size_t i = 0; i < crew->count; i++) {
		struct runner *runner = &crew->runners[i];

		runner->result_count = 0;
		if (!runner_is_active(runner, tool))
			continue;
		if (is_divisible(crew, runner, options))
			divide(crew, runner, batch);
		else
			add_task(crew, runner, NULL, 0, batch->step_count);
	}
}

/* ---------------------------------------------------------------- threads */

/* What the threads of one batch share. */
struct shift {
	struct crew *crew;
	const struct batch *batch;
	const struct check_options *options;
	atomic_size_t next;	/* task */
	atomic_long *visits;	/* of each runner */
	bool gauges;	/* the tasks' runners measure, and find nothing */
};

struct hand {
	struct shift *shift;
	struct sweep *sweep;
};

static void *work(void *context)
{
	struct hand *hand = context;
	struct shift *shift = hand->shift;
	struct crew *crew = shift->crew;
	/* On a stack of its own: counters of two threads in one cache line would cost half of what a thread gains. */
	struct sweep sweep = *hand->sweep;
	size_t i;

	while ((i = atomic_fetch_add(&shift->next, 1)) < crew->task_count) {
		const struct task *task = &crew->tasks[i];
		long before = sweep.visits;

		if (shift->gauges)
			runner_gauge(task->runner, &sweep, shift->batch, shift->options);
		else
			runner_run(task->copy ? task->copy : task->runner, &sweep, shift->batch, task->from, task->to,
				   shift->options);
		atomic_fetch_add(&shift->visits[task->runner - crew->runners], sweep.visits - before);
	}
	*hand->sweep = sweep;
	return NULL;
}

/* A thread that cannot start is no loss: the others do its share. */
static void work_together(struct shift *shift, int wanted)
{
	struct crew *crew = shift->crew;
	int started = 0;
	pthread_t *threads = mem_zalloc((size_t)wanted, sizeof(*threads));
	struct hand *hands = mem_zalloc((size_t)wanted, sizeof(*hands));

	for (int i = 0; i < wanted; i++)
		hands[i] = (struct hand){shift, &crew->sweeps[i]};
	while (started < wanted - 1 && !pthread_create(&threads[started], NULL, work, &hands[started + 1]))
		started++;
	work(&hands[0]);
	for (int i = 0; i < started; i++)
		pthread_join(threads[i], NULL);
	free(threads);
	free(hands);
}

/* ---------------------------------------------------------------- results */

static void add_results(struct crew *crew, const struct runner *runner)
{
	crew->results = mem_grow(crew->results, &crew->result_capacity, crew->result_count + runner->result_count,
				 sizeof(*crew->results));
	for (size_t i = 0; i < runner->result_count; i++)
		crew->results[crew->result_count++] = runner->results[i];
}

/* Of a divided runner the first part that met with something counts, and the state after the last goes on. */
static void gather(struct crew *crew)
{
	const struct runner *met = NULL;

	crew->result_count = 0;
	for (size_t i = 0; i < crew->task_count; i++) {
		const struct task *task = &crew->tasks[i];
		const struct runner *ran = task->copy ? task->copy : task->runner;

		if (ran->result_count && met != task->runner) {
			add_results(crew, ran);
			met = task->runner;
		}
		if (!task->copy)
			continue;
		follower_join(&task->runner->follower, &task->copy->follower);
		free(task->copy->results);
		free(task->copy);
	}
}

static bool is_complete(const struct crew *crew)
{
	for (int i = 0; i < crew->threads; i++)
		if (crew->sweeps[i].broken_off)
			return false;
	return true;
}

bool crew_run(struct crew *crew, const struct batch *batch, int tool, const struct check_options *options)
{
	struct shift shift = {.crew = crew, .batch = batch, .options = options};

	shift.visits = mem_zalloc(crew->count + 1, sizeof(*shift.visits));
	plan(crew, batch, tool, options);
	work_together(&shift, crew->work > HEAVY ? crew->threads : 1);
	gather(crew);
	crew->work = 0;
	for (size_t i = 0; i < crew->count; i++) {
		crew->visits[i] = shift.visits[i];
		crew->work += crew->visits[i];
	}
	free(shift.visits);
	return is_complete(crew);
}

bool crew_gauge(struct crew *crew, const struct batch *batch, int tool, const struct check_options *options)
{
	struct shift shift = {.crew = crew, .batch = batch, .options = options, .gauges = true};

	shift.visits = mem_zalloc(crew->count + 1, sizeof(*shift.visits));
	crew->task_count = 0;
	for (size_t i = 0; i < crew->count; i++) {
		crew->runners[i].room_count = 0;
		if (runner_is_active(&crew->runners[i], tool))
			add_task(crew, &crew->runners[i], NULL, 0, batch->step_count);
	}
	work_together(&shift, crew->threads);
	free(shift.visits);
	return is_complete(crew);
}

void crew_collect(const struct crew *crew, long last_block, struct check_stats *stats, double *proven)
{
	for (int i = 0; i < crew->threads; i++) {
		stats->certificates += crew->sweeps[i].certificates;
		stats->bisections += crew->sweeps[i].bisections;
	}
	for (size_t i = 0; i < crew->count; i++) {
		const struct runner *runner = &crew->runners[i];

		stats->budgets += runner->follower.covered_steps;
		stats->queries += runner->follower.queries;
		stats->samples += runner->sampler.samples;
		if (runner->unknown_block >= 0 && runner->unknown_block <= last_block) {
			if (!stats->pairs_unknown)
				stats->first_unknown = runner->pair;
			stats->pairs_unknown++;
		}
		if (proven)
			proven[runner->pair] = follower_proven(&runner->follower);
	}
}
