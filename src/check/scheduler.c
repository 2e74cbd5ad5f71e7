#include "check/scheduler.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "base/parallel_for.h"

/*
 * A check with more node pairs than this in the last batch is divided among several threads. If the whole batch has
 * fewer, starting threads does not pay.
 */
#define HEAVY 20000

/*
 * A heavy check's batch is divided into parts of whole chunks. Each part is 1/PART_SHARE of the rest, so large parts
 * come first, all threads finish at about the same time, and there are few parts. Few, because each part begins without
 * what the steps before it have shown.
 */
#define PART_SHARE 4

/* The cost of examining a box or a single step, besides the node pairs: as much as this number of node pairs. */
#define EXAMINED_COST 10

void scheduler_init(struct scheduler *scheduler, struct scene *scene, const struct check_options *options,
		    const struct cancel *cancel, struct pair_measuring measuring)
{
	const long effort = options->effort ? options->effort : CHECK_EFFORT;

	*scheduler = (struct scheduler){.threads = options->threads > 1 ? options->threads : 1};
	measured_blocks_init(&scheduler->blocks);
	scheduler->checks = mem_zalloc(scene->pair_count, sizeof(*scheduler->checks));
	scheduler->visits = mem_zalloc(scene->pair_count, sizeof(*scheduler->visits));
	scheduler->costs = mem_zalloc(scene->pair_count, sizeof(*scheduler->costs));
	scheduler->sweeps = mem_zalloc((size_t)scheduler->threads, sizeof(*scheduler->sweeps));
	for (int i = 0; i < scheduler->threads; i++)
		scheduler->sweeps[i] = (struct sweep){.cancel = cancel, .effort = effort};
	for (size_t i = 0; i < scene->pair_count; i++) {
		if (!scene_pair_needs_check(&scene->pairs[i]) || scene->pairs[i].stock)
			continue;
		pair_check_init(&scheduler->checks[scheduler->count++], scene, i, measuring);
	}
}

void scheduler_release(struct scheduler *scheduler)
{
	for (size_t i = 0; i < scheduler->count; i++)
		pair_check_release(&scheduler->checks[i]);
	for (int i = 0; i < scheduler->threads; i++)
		sweep_release(&scheduler->sweeps[i]);
	free(scheduler->checks);
	free(scheduler->visits);
	free(scheduler->costs);
	free(scheduler->sweeps);
	free(scheduler->tasks);
	free(scheduler->turns);
	pair_results_release(&scheduler->results);
	free(scheduler->most);
	measured_blocks_release(&scheduler->blocks);
	free(scheduler->order);
	*scheduler = (struct scheduler){0};
}

void scheduler_add_thread(struct scheduler *scheduler)
{
	const struct sweep *first = scheduler->sweeps;
	const struct sweep more = {.cancel = first->cancel, .effort = first->effort};

	scheduler->sweeps =
	    mem_realloc(scheduler->sweeps, (size_t)scheduler->threads + 1, sizeof(*scheduler->sweeps));
	scheduler->sweeps[scheduler->threads++] = more;
}

void scheduler_change_tool(struct scheduler *scheduler)
{
	for (size_t i = 0; i < scheduler->count; i++)
		if (scheduler->checks[i].watch.tool)
			pair_check_change_tool(&scheduler->checks[i]);
}

void scheduler_jump(struct scheduler *scheduler)
{
	for (size_t i = 0; i < scheduler->count; i++)
		pair_check_jump(&scheduler->checks[i]);
}

/* ------------------------------------------------------------------ tasks */

static void add_task(struct scheduler *scheduler, struct pair_check *check, struct pair_check *copy, size_t from,
		     size_t to)
{
	scheduler->tasks = mem_grow(scheduler->tasks, &scheduler->task_capacity, scheduler->task_count + 1,
				   sizeof(*scheduler->tasks));
	scheduler->tasks[scheduler->task_count++] = (struct task){check, copy, from, to, 0, 0};
}

/*
 * The parts of a divided batch are checked independently. With options->all a check cannot be divided, because later
 * steps depend on whether the pair has met before. A check that leaves out steps cannot be divided either, because a
 * part does not know whether one body is inside the other at its start.
 */
static bool is_divisible(const struct scheduler *scheduler, const struct pair_check *check,
			 const struct check_options *options)
{
	return scheduler->visits[check - scheduler->checks] > HEAVY && options->method == CHECK_CERTIFIED &&
	       !options->all && check->watch.steps == STEP_ANY && !check->watch.past_limits_only &&
	       !check->maybe_inside;
}

static size_t part_of(size_t left)
{
	size_t part = left / PART_SHARE / CHUNK_STEPS * CHUNK_STEPS;

	return part ? part : left < CHUNK_STEPS ? left : CHUNK_STEPS;
}

static void divide(struct scheduler *scheduler, struct pair_check *check, const struct batch *batch)
{
	size_t count;

	for (size_t from = 0; from < batch->step_count; from += count) {
		struct pair_check *copy = mem_zalloc(1, sizeof(*copy));

		*copy = *check;
		copy->methods = mem_zalloc(1, sizeof(*copy->methods));
		copy->results = (struct pair_results){0};
		strategy_fork(&check->methods->strategy, &copy->methods->strategy);
		count = part_of(batch->step_count - from);
		add_task(scheduler, check, copy, from, from + count);
	}
}

static void plan(struct scheduler *scheduler, const struct batch *batch, int tool, const struct check_options *options)
{
	scheduler->task_count = 0;
	for (size_t i = 0; i < scheduler->count; i++) {
		struct pair_check *check = &scheduler->checks[i];

		check->results.count = 0;
		check->nearest_block = -1;
		if (!pair_watch_is_active(&check->watch, tool))
			continue;
		pair_check_prepare(check, options);
		if (is_divisible(scheduler, check, options))
			divide(scheduler, check, batch);
		else
			add_task(scheduler, check, NULL, 0, batch->step_count);
	}
}

/* ---------------------------------------------------------------- threads */

/* Shared by the threads of one batch. */
struct work {
	struct scheduler *scheduler;
	const struct batch *batch;
	const struct check_options *options;
	const struct measure_plan *plan;	/* measure block clearances instead of looking for contacts; or NULL */
};

static void do_task(void *context, int worker, size_t i)
{
	const struct work *work = context;
	struct task *task = &work->scheduler->tasks[work->scheduler->turns[i]];
	/*
	 * The sweep is on the thread's own stack: if counters of two threads shared a cache line, half of the gain
	 * would be lost.
	 */
	struct sweep sweep = work->scheduler->sweeps[worker];
	long before = sweep.visits;

	if (work->plan) {
		task->visits = pair_measure(task->check, &sweep, work->batch, work->plan, work->options);
	} else {
		task->examined = pair_check_run(task->copy ? task->copy : task->check, &sweep, work->batch, task->from,
						task->to, work->options);
		task->visits = sweep.visits - before;
	}
	work->scheduler->sweeps[worker] = sweep;
}

static long expected_cost(const struct scheduler *scheduler, size_t task)
{
	return scheduler->costs[scheduler->tasks[task].check - scheduler->checks];
}

/* If threads share the tasks, the longest ones come first: then no thread is left with a long one at the end. */
static void put_in_turn(struct scheduler *scheduler, bool shared)
{
	scheduler->turns = mem_grow(scheduler->turns, &scheduler->turn_capacity, scheduler->task_count,
				    sizeof(*scheduler->turns));
	for (size_t i = 0; i < scheduler->task_count; i++) {
		size_t turn = i;

		for (; shared && turn > 0; turn--) {
			if (expected_cost(scheduler, scheduler->turns[turn - 1]) >= expected_cost(scheduler, i))
				break;
			scheduler->turns[turn] = scheduler->turns[turn - 1];
		}
		scheduler->turns[turn] = i;
	}
}

/* Runs the tasks on up to `threads` threads. */
static void do_tasks(struct scheduler *scheduler, int threads, struct work *work)
{
	put_in_turn(scheduler, scheduler->loop || threads > 1);
	if (!scheduler->loop)
		parallel_for(scheduler->task_count, threads, do_task, work);
	else
		shared_loop_run(scheduler->loop, scheduler->task_count, threads > 1 ? threads - 1 : 1, do_task, work);
}

/* ---------------------------------------------------------------- results */

/*
 * A part of a divided check left out the rest of a block that it could not decide. The parts after it do not know this,
 * nor that one body may be inside the other since then: checks the whole batch in one piece.
 */
static void run_undivided(struct scheduler *scheduler, struct pair_check *check, const struct batch *batch,
			  const struct check_options *options)
{
	const long before = scheduler->sweeps[0].visits;

	strategy_forget_position(&check->methods->strategy);
	pair_check_run(check, &scheduler->sweeps[0], batch, 0, batch->step_count, options);
	scheduler->work += scheduler->sweeps[0].visits - before;
	pair_results_append(&scheduler->results, &check->results);
}

/*
 * Collects the results and visits of all tasks. For a divided check, the results of the first part that has any are
 * used, and the state after the last part is kept.
 */
static void gather(struct scheduler *scheduler, const struct batch *batch, const struct check_options *options)
{
	bool met = false, again = false;

	scheduler->results.count = 0;
	scheduler->work = 0;
	memset(scheduler->visits, 0, scheduler->count * sizeof(*scheduler->visits));
	memset(scheduler->costs, 0, scheduler->count * sizeof(*scheduler->costs));
	for (size_t i = 0; i < scheduler->task_count; i++) {
		const struct task *task = &scheduler->tasks[i];
		const struct pair_check *ran = task->copy ? task->copy : task->check;

		/* The first part of a check: its parts follow one another. */
		if (task->from == 0)
			met = again = false;
		scheduler->visits[task->check - scheduler->checks] += task->visits;
		scheduler->costs[task->check - scheduler->checks] += task->visits + EXAMINED_COST * task->examined;
		scheduler->work += task->visits;
		if (ran->results.count && !met) {
			met = true;
			again = task->copy && !pair_result_ends(&ran->results.items[0], batch, options);
			if (!again)
				pair_results_append(&scheduler->results, &ran->results);
		}
		if (!task->copy)
			continue;
		if (strategy_proven(&task->copy->methods->strategy) < strategy_proven(&task->check->methods->strategy))
			task->check->nearest_block = task->copy->nearest_block;
		strategy_join(&task->check->methods->strategy, &task->copy->methods->strategy);
		free(task->copy->methods);
		pair_results_release(&task->copy->results);
		free(task->copy);
		/* Once its last part is gathered. */
		if (again && task->to == batch->step_count)
			run_undivided(scheduler, task->check, batch, options);
	}
}

static bool is_complete(const struct scheduler *scheduler)
{
	for (int i = 0; i < scheduler->threads; i++)
		if (scheduler->sweeps[i].broken_off)
			return false;
	return true;
}

bool scheduler_is_heavy(const struct scheduler *scheduler)
{
	return scheduler->work > HEAVY;
}

bool scheduler_run(struct scheduler *scheduler, const struct batch *batch, int tool,
		   const struct check_options *options)
{
	struct work work = {.scheduler = scheduler, .batch = batch, .options = options};

	plan(scheduler, batch, tool, options);
	do_tasks(scheduler, scheduler_is_heavy(scheduler) ? scheduler->threads : 1, &work);
	gather(scheduler, batch, options);
	return is_complete(scheduler);
}

/* ------------------------------------------------------------- clearances */

/* mm: the approximate distance of the bodies of a check. */
struct nearness {
	struct pair_check *check;
	double distance;
};

static int by_distance(const void *a, const void *b)
{
	const struct nearness *x = a, *y = b;

	if (x->distance < y->distance || x->distance > y->distance)
		return x->distance < y->distance ? -1 : 1;
	return x->check < y->check ? -1 : x->check > y->check;
}

/*
 * Lists the checks that are measured and returns their number. If only least clearances are measured, they are sorted
 * by the distance of the bodies in the middle of the batch, nearest first.
 */
static size_t put_in_order(struct scheduler *scheduler, const struct batch *batch, int tool,
			   const struct check_options *options)
{
	const axis_values *middle = &batch->steps[batch->step_count / 2].motion.span.q1;
	size_t count = 0;

	if (!scheduler->order)
		scheduler->order = mem_zalloc(scheduler->count, sizeof(*scheduler->order));
	for (size_t i = 0; i < scheduler->count; i++) {
		struct pair_check *check = &scheduler->checks[i];

		check->clearance_count = 0;
		if (!pair_watch_is_active(&check->watch, tool) || !pair_measure_applies(check))
			continue;
		pair_check_prepare(check, options);
		scheduler->order[count++].check = check;
	}
	for (size_t i = 0; i < count && options->least_clearances; i++)
		scheduler->order[i].distance = block_clearance_look(&scheduler->order[i].check->methods->block,
								    scheduler->sweeps, middle);
	if (options->least_clearances)
		qsort(scheduler->order, count, sizeof(*scheduler->order), by_distance);
	return count;
}

/*
 * From now on, clearances above those that this check has measured do not matter. If the bodies touch, the check must
 * still find out whether other bodies touch, too: from then on one of them may be inside the other.
 */
static void lower_most(struct scheduler *scheduler, const struct batch *batch, struct pair_check *check,
		       const struct check_options *options)
{
	const double least = 2 * options->tolerance;
	size_t step = 0;

	for (size_t k = 0; k < check->clearance_count; k++) {
		struct pair_check_clearance *it = &check->clearances[k];

		while (batch->steps[step].block < it->block)
			step++;
		if (!(it->clearance < it->most) || !(it->clearance < scheduler->most[step])) {
			it->clearance = options->block_clearance_cap;
			continue;
		}
		for (; step < batch->step_count && batch->steps[step].block == it->block; step++)
			scheduler->most[step] = fmin(scheduler->most[step], fmax(it->clearance, least));
	}
}

/* Selects the blocks to measure if only least clearances are measured. */
static void select_blocks(struct scheduler *scheduler, const struct batch *batch)
{
	measured_blocks_select(&scheduler->blocks, batch, scheduler->work);
	for (size_t k = 0; k < scheduler->count; k++)
		measured_blocks_add_nearest(&scheduler->blocks, batch, scheduler->checks[k].nearest_block);
	measured_blocks_count(&scheduler->blocks, batch);
}

bool scheduler_measure(struct scheduler *scheduler, const struct batch *batch, int tool,
		       const struct check_options *options)
{
	const size_t count = put_in_order(scheduler, batch, tool, options);
	size_t together = options->least_clearances ? 1 : count;
	struct measure_plan measure = {0};
	struct work work = {.scheduler = scheduler, .batch = batch, .options = options, .plan = &measure};

	select_blocks(scheduler, batch);
	scheduler->most =
	    mem_grow(scheduler->most, &scheduler->most_capacity, batch->step_count, sizeof(*scheduler->most));
	for (size_t i = 0; i < batch->step_count; i++)
		scheduler->most[i] = options->block_clearance_cap;
	measure.most = scheduler->most;
	measure.largest = options->block_clearance_cap;
	measure.wishes = scheduler->blocks.wishes;
	/*
	 * The number of checks measured together does not depend on the number of threads, so the clearances do not,
	 * either.
	 */
	for (size_t from = 0; from < count && is_complete(scheduler); from += together, together *= 2) {
		const size_t to = from + together < count ? from + together : count;

		scheduler->task_count = 0;
		for (size_t i = from; i < to; i++)
			add_task(scheduler, scheduler->order[i].check, NULL, 0, batch->step_count);
		measure.effort = scheduler->blocks.spare_effort / (long)(to - from);
		do_tasks(scheduler, scheduler->threads, &work);
		for (size_t i = 0; i < scheduler->task_count; i++)
			scheduler->blocks.spare_effort -= scheduler->tasks[i].visits;
		for (size_t i = from; i < to && options->least_clearances; i++)
			lower_most(scheduler, batch, scheduler->order[i].check, options);
	}
	measured_blocks_done(&scheduler->blocks);
	return is_complete(scheduler);
}

void scheduler_collect(struct scheduler *scheduler, const struct check_options *options, long last_block,
		       struct check_stats *stats, double *proven)
{
	for (int i = 0; i < scheduler->threads; i++) {
		stats->certificates += scheduler->sweeps[i].certificates;
		stats->bisections += scheduler->sweeps[i].bisections;
	}
	for (size_t i = 0; i < scheduler->count; i++) {
		struct pair_check *check = &scheduler->checks[i];

		/* For a pair that was never checked, measuring begins here. */
		if (proven)
			pair_check_prepare(check, options);
		if (!check->methods)
			continue;
		stats->budgets += check->methods->strategy.covered_steps;
		stats->planes += check->methods->strategy.plane_steps;
		stats->measured += check->measured_steps;
		stats->queries += check->methods->strategy.queries;
		stats->samples += check->methods->sampler.samples;
		if (check->unknown_block >= 0 && check->unknown_block <= last_block) {
			if (!stats->pairs_unknown)
				stats->first_unknown = check->pair;
			stats->pairs_unknown++;
		}
		if (proven)
			proven[check->pair] = strategy_proven(&check->methods->strategy);
	}
}
