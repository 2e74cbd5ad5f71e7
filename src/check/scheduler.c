#include "check/scheduler.h"

#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "base/parallel_for.h"

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

bool scheduler_init(struct scheduler *scheduler, struct scene *scene, const struct check_options *options, bool measure,
	       struct diag *diag)
{
	*scheduler = (struct scheduler){.threads = options->threads > 1 ? options->threads : 1};
	scheduler->runners = mem_zalloc(scene->pair_count, sizeof(*scheduler->runners));
	scheduler->visits = mem_zalloc(scene->pair_count, sizeof(*scheduler->visits));
	scheduler->sweeps = mem_zalloc((size_t)scheduler->threads, sizeof(*scheduler->sweeps));
	for (int i = 0; i < scheduler->threads; i++)
		scheduler->sweeps[i].cancel = options->read.cancel;
	for (size_t i = 0; i < scene->pair_count; i++) {
		enum pair_status status = scene->pairs[i].status;

		if (status != PAIR_CHECKED && status != PAIR_OUT_OF_REACH)
			continue;
		if (!runner_init(&scheduler->runners[scheduler->count], scene, i, options, measure, diag))
			return false;
		scheduler->count++;
	}
	return true;
}

void scheduler_release(struct scheduler *scheduler)
{
	for (size_t i = 0; i < scheduler->count; i++)
		runner_release(&scheduler->runners[i]);
	for (int i = 0; i < scheduler->threads; i++)
		sweep_release(&scheduler->sweeps[i]);
	free(scheduler->runners);
	free(scheduler->visits);
	free(scheduler->sweeps);
	free(scheduler->jobs);
	free(scheduler->results);
	*scheduler = (struct scheduler){0};
}

void scheduler_change_tool(struct scheduler *scheduler)
{
	for (size_t i = 0; i < scheduler->count; i++)
		if (scheduler->runners[i].tool)
			follower_lose(&scheduler->runners[i].follower);
}

void scheduler_jump(struct scheduler *scheduler)
{
	for (size_t i = 0; i < scheduler->count; i++)
		runner_jump(&scheduler->runners[i]);
}

/* ------------------------------------------------------------------ jobs */

static void add_job(struct scheduler *scheduler, struct runner *runner, struct runner *copy, size_t from, size_t to)
{
	scheduler->jobs = mem_grow(scheduler->jobs, &scheduler->job_capacity, scheduler->job_count + 1, sizeof(*scheduler->jobs));
	scheduler->jobs[scheduler->job_count++] = (struct job){runner, copy, from, to, 0};
}

/*
 * Parts of a batch know nothing of each other. That a pair has met matters to
 * what follows, so a runner that goes on behind a finding is not divided.
 */
static bool is_divisible(const struct scheduler *scheduler, const struct runner *runner, const struct check_options *options)
{
	return scheduler->visits[runner - scheduler->runners] > HEAVY && options->method == CHECK_CERTIFIED && !options->all &&
	       !runner->entangled && !runner->past_limits_only;
}

static size_t part_of(size_t left)
{
	size_t part = left / PART_SHARE / CHUNK_STEPS * CHUNK_STEPS;

	return part ? part : left < CHUNK_STEPS ? left : CHUNK_STEPS;
}

static void divide(struct scheduler *scheduler, struct runner *runner, const struct batch *batch)
{
	size_t count;

	for (size_t from = 0; from < batch->step_count; from += count) {
		struct runner *copy = mem_zalloc(1, sizeof(*copy));

		*copy = *runner;
		copy->results = NULL;
		copy->result_count = copy->result_capacity = 0;
		follower_fork(&runner->follower, &copy->follower);
		count = part_of(batch->step_count - from);
		add_job(scheduler, runner, copy, from, from + count);
	}
}

static void plan(struct scheduler *scheduler, const struct batch *batch, int tool, const struct check_options *options)
{
	scheduler->job_count = 0;
	for (size_t i = 0; i < scheduler->count; i++) {
		struct runner *runner = &scheduler->runners[i];

		runner->result_count = 0;
		if (!runner_is_active(runner, tool))
			continue;
		if (is_divisible(scheduler, runner, options))
			divide(scheduler, runner, batch);
		else
			add_job(scheduler, runner, NULL, 0, batch->step_count);
	}
}

/* ---------------------------------------------------------------- threads */

/* What the threads of one batch share. */
struct work {
	struct scheduler *scheduler;
	const struct batch *batch;
	const struct check_options *options;
	bool gauges;	/* the jobs' runners measure, and find nothing */
};

static void do_job(void *context, int worker, size_t i)
{
	const struct work *work = context;
	struct job *job = &work->scheduler->jobs[i];
	/* On the thread's own stack: counters of two threads in one cache line would cost half of what a thread gains. */
	struct sweep sweep = work->scheduler->sweeps[worker];
	long before = sweep.visits;

	if (work->gauges)
		runner_gauge(job->runner, &sweep, work->batch, work->options);
	else
		runner_run(job->copy ? job->copy : job->runner, &sweep, work->batch, job->from, job->to, work->options);
	job->visits = sweep.visits - before;
	work->scheduler->sweeps[worker] = sweep;
}

/* ---------------------------------------------------------------- results */

static void add_results(struct scheduler *scheduler, const struct runner *runner)
{
	scheduler->results = mem_grow(scheduler->results, &scheduler->result_capacity, scheduler->result_count + runner->result_count,
				 sizeof(*scheduler->results));
	for (size_t i = 0; i < runner->result_count; i++)
		scheduler->results[scheduler->result_count++] = runner->results[i];
}

/*
 * Results and visits of all jobs. Of a divided runner the first part that met with something counts, and the state
 * after the last part goes on.
 */
static void gather(struct scheduler *scheduler)
{
	const struct runner *met = NULL;

	scheduler->result_count = 0;
	scheduler->work = 0;
	memset(scheduler->visits, 0, scheduler->count * sizeof(*scheduler->visits));
	for (size_t i = 0; i < scheduler->job_count; i++) {
		const struct job *job = &scheduler->jobs[i];
		const struct runner *ran = job->copy ? job->copy : job->runner;

		scheduler->visits[job->runner - scheduler->runners] += job->visits;
		scheduler->work += job->visits;
		if (ran->result_count && met != job->runner) {
			add_results(scheduler, ran);
			met = job->runner;
		}
		if (!job->copy)
			continue;
		follower_join(&job->runner->follower, &job->copy->follower);
		free(job->copy->results);
		free(job->copy);
	}
}

static bool is_complete(const struct scheduler *scheduler)
{
	for (int i = 0; i < scheduler->threads; i++)
		if (scheduler->sweeps[i].broken_off)
			return false;
	return true;
}

bool scheduler_run(struct scheduler *scheduler, const struct batch *batch, int tool,
		   const struct check_options *options)
{
	struct work work = {.scheduler = scheduler, .batch = batch, .options = options};

	plan(scheduler, batch, tool, options);
	parallel_for(scheduler->job_count, scheduler->work > HEAVY ? scheduler->threads : 1, do_job, &work);
	gather(scheduler);
	return is_complete(scheduler);
}

bool scheduler_gauge(struct scheduler *scheduler, const struct batch *batch, int tool,
		     const struct check_options *options)
{
	struct work work = {.scheduler = scheduler, .batch = batch, .options = options, .gauges = true};

	scheduler->job_count = 0;
	for (size_t i = 0; i < scheduler->count; i++) {
		scheduler->runners[i].room_count = 0;
		if (runner_is_active(&scheduler->runners[i], tool))
			add_job(scheduler, &scheduler->runners[i], NULL, 0, batch->step_count);
	}
	parallel_for(scheduler->job_count, scheduler->threads, do_job, &work);
	return is_complete(scheduler);
}

void scheduler_collect(const struct scheduler *scheduler, long last_block, struct check_stats *stats, double *proven)
{
	for (int i = 0; i < scheduler->threads; i++) {
		stats->certificates += scheduler->sweeps[i].certificates;
		stats->bisections += scheduler->sweeps[i].bisections;
	}
	for (size_t i = 0; i < scheduler->count; i++) {
		const struct runner *runner = &scheduler->runners[i];

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
