#include "check/check.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>

#include "check/at_rest.h"
#include "check/batch_run.h"
#include "check/checker.h"
#include "check/measure/path_record.h"
#include "gcode/interp.h"

/*
 * Steps in a batch. A batch is checked at the end of a block; a block of more than MID_BLOCK steps is checked in parts.
 */
#define BATCH_STEPS 1024
#define MID_BLOCK (8 * BATCH_STEPS)

/*
 * Chords of curved moves begin with this multiple of the tolerance. They are refined near contact; elsewhere fewer
 * chords cost less.
 */
#define FLATNESS 16

/* ----------------------------------------------------------------- events */

static void on_limit(struct checker *c, const struct motion_limit *limit)
{
	const struct block_finding finding = {
		.finding = {
			.kind = FINDING_LIMIT,
			.move = limit->move,
			.time = limit->time,
			.axes = limit->position,
			.tool = limit->tool,
			.stock_time = (double)c->program.next_step,
			.of.limit = limit->travel,
		},
		.block = c->program.block,
		.block_time = limit->block_time,
		.order = 2 * c->program.next_step + 1,
		.rank = -1,
	};

	if (checker_has_enough(c) || !checker_owns(c))
		return;
	block_log_add_finding(&c->log, &finding);
	c->program.last = (struct place){limit->file, limit->line};
	c->end.limit_found = true;
}

static void on_step(struct checker *c, const struct motion_step *step)
{
	if (!c->program.moved) {
		checker_settle(c);
		if (c->end.stopped)
			return;
		c->program.moved = true;
		c->program.position = step->span.q0;
		c->program.tool = step->tool;
		c->program.time = step->time;
		checker_at_rest(c, false, step->move);
	}
	if (c->stock.tool_count && !checker_has_enough(c))
		stock_check_log(&c->stock, step, c->program.next_step);
	if (!checker_has_enough(c) && c->options->method != CHECK_NOTHING && checker_owns(c)) {
		if (c->program.skipped) {
			checker_settle(c);
			if (c->end.stopped)
				return;
			scheduler_jump(&c->scheduler);
			stock_check_jump(&c->stock);
		}
		c->program.skipped = false;
		batch_add(&c->batch, step, c->program.block, c->program.next_step, c->program.share);
	}
	cutter_approach_step(&c->approach, step);
	c->program.last = (struct place){step->file, step->line};
	c->program.steps++;
	c->program.next_step++;
	if (c->options->record)
		path_record_step(c->options->record, step);
	c->program.position = step->span.q1;
	c->program.time = step->time + step->seconds;
	c->program.block_time = step->block_time + step->seconds;
	if (c->batch.step_count >= MID_BLOCK || c->end.broken_off)
		checker_process(c, NULL);
}

static void on_tool(struct checker *c, const struct motion_tool *change)
{
	checker_process(c, NULL);
	if (c->end.stopped)
		return;
	/*
	 * Before the first motion the new tool is checked later, with the start pose. The old tool is gone by then, so
	 * it is checked now.
	 */
	if (!c->program.moved && c->program.tool != change->tool)
		checker_at_rest(c, true, 0);
	c->program.tool = change->tool;
	c->program.position = change->position;
	scheduler_change_tool(&c->scheduler);
	stock_check_jump(&c->stock);
	if (c->program.moved)
		checker_at_rest(c, true, 0);
	if (c->end.broken_off)
		checker_process(c, NULL);
}

static void on_spindle_stop(struct checker *c, const struct motion_spindle_stop *stop)
{
	/* Before the first motion, the check of the start pose covers this. */
	if (!c->program.moved)
		return;
	checker_process(c, NULL);
	if (c->end.stopped)
		return;
	c->program.position = stop->position;
	c->program.time = stop->time;
	checker_spindle_stops(c, stop->move);
	if (c->end.broken_off)
		checker_process(c, NULL);
}

/* Begins the next block. */
static void start_block(struct checker *c)
{
	block_log_begin(&c->log, c->program.block);
	c->program.steps = 0;
	c->program.block_time = 0;
	c->timing.measuring = 0;
	if (c->options->times) {
		c->timing.check_before = c->stats->seconds_check;
		c->timing.read_from = checker_clock();
	}
}

/* If steps are only counted, the summary at the end of a block shows whether there were any. */
static void count_steps(struct checker *c, const struct motion_block *block)
{
	if (c->program.next_step == c->program.summary.spans)
		return;
	c->program.next_step = c->program.summary.spans;
	c->program.last = (struct place){block->file, block->line};
}

/* A block that passes no limit then has nothing to report and is not kept. */
static void pass_block(struct checker *c, const struct motion_block *block)
{
	c->stats->blocks_checked += checker_owns(c);
	checker_end_block(c, block->seconds);
	if (c->program.block % BATCH_STEPS == 0)
		checker_process(c, NULL);
	start_block(c);
}

static void on_block(struct checker *c, const struct motion_block *block)
{
	const struct block_record complete = {.block = c->program.block, .file = block->file, .line = block->line,
					      .text = block->text, .seconds = block->seconds, .moves = block->moves,
					      .callers = block->callers, .caller_count = block->caller_count,
					      .measured = true, .steps = c->program.steps};
	struct block_record *record = block_log_complete(&c->log, &complete);
	const bool ours = checker_owns(c);

	if (c->options->record)
		path_record_block(c->options->record, block->line, c->program.tool, &c->program.position);
	c->stats->blocks_checked += ours;
	c->program.skipped |= !ours;
	/* Blocks without steps are collected too. Each step of a batch begins where the one before it ends. */
	if (checker_has_enough(c) || (c->end.limit_found && !c->options->all) || c->options->times)
		checker_process(c, c->options->times ? record : NULL);
	else if (c->batch.step_count >= BATCH_STEPS || c->log.open.block_count >= BATCH_STEPS ||
		 (ours && c->options->shards > 1 && checker_ends_share(c, block->seconds)))
		checker_begin(c);
	checker_end_block(c, block->seconds);
	start_block(c);
}

static bool on_event(void *context, const struct motion_event *event)
{
	struct checker *c = context;

	if (c->options->watch && c->background)
		event_copies_add(&c->heard, event);
	else if (c->options->watch)
		c->options->watch->event(c->options->watch->context, event);
	switch (event->kind) {
	case MOTION_STEP:
		on_step(c, &event->of.step);
		break;
	case MOTION_LIMIT:
		on_limit(c, &event->of.limit);
		break;
	case MOTION_TOOL:
		on_tool(c, &event->of.tool);
		break;
	case MOTION_SPINDLE_STOP:
		on_spindle_stop(c, &event->of.spindle_stop);
		break;
	case MOTION_MODES:
		/* Only for the watcher. */
		break;
	case MOTION_BLOCK:
		if (c->counts_steps)
			count_steps(c, &event->of.block);
		if (c->counts_steps && !c->end.limit_found)
			pass_block(c, &event->of.block);
		else
			on_block(c, &event->of.block);
		break;
	}
	return !c->end.stopped;
}

static void on_opened(void *context, const char *path)
{
	struct checker *c = context;

	/* The check may end with an earlier batch. */
	if (c->pending.settled < c->pending.begun)
		file_names_keep(&c->opened, path);
	else
		c->options->read.opened->call(c->options->read.opened->context, path);
}

/* Called for lines that cause no event. */
static bool stops_reading(void *context)
{
	struct checker *c = context;

	return !checker_goes_on(c) || cancel_asked(c->options->read.cancel);
}

/* No further line has arrived: checks and reports everything before asking whether to wait. */
static bool stops_waiting(void *context)
{
	struct checker *c = context;

	checker_process(c, NULL);
	return c->end.stopped || cancel_asked(c->options->read.cancel);
}

/* -------------------------------------------------------------------- run */

/* A program may move nothing on purpose. A file without a block is a mistake of its writer, and must pass no gate. */
static void say_no_motion(const struct checker *c)
{
	const struct srcloc place = {c->file, 0, 0};

	if (!c->program.summary.blocks)
		diag_error(c->diag, place, INTERP_NO_BLOCK);
	else
		diag_warning(c->diag, place, "the program moves no axis%s",
			     c->options->method == CHECK_NOTHING ? "" : "; only the start position was checked");
}

/* Checks the remaining steps when the program has ended or has stopped at a fault within a block. */
static void finish(struct checker *c, bool complete)
{
	/* A block with a fault is checked up to the fault, and measured if it moves anything. */
	const struct program_state *program = &c->program;
	const struct block_record rest = {.block = program->block,
					  .file = program->last.file ? program->last.file : c->file,
					  .line = program->last.line ? program->last.line : 1, .text = "", .moves = 1,
					  .seconds = program->block_time, .measured = program->steps > 0,
					  .steps = program->steps};
	struct block_record *record;

	if (c->end.stopped)
		return;
	if (!c->program.summary.spans && complete) {
		say_no_motion(c);
		checker_at_rest(c, false, 0);
	}
	record = block_log_complete(&c->log, &rest);
	checker_process(c, c->options->times ? record : NULL);
}

/* Like motion_run; afterwards everything in the background is settled. */
static bool read_program(struct checker *c, const struct motion_options *options, FILE *in)
{
	const struct motion_sink sink = {c, on_event};
	bool complete;

	checker_start_threads(c);
	complete = motion_run(c->scene->machine, c->scene->setup, options, in, c->file, &sink, &c->log.diags.diag,
			      &c->program.summary);
	checker_settle(c);
	checker_end_threads(c);
	return complete;
}

/* False: a fault was reported. */
static bool run_program(struct checker *c, FILE *in)
{
	struct motion_options options = {
		.flatness = FLATNESS * c->options->tolerance,
		.read = c->options->read,
		.names = &c->names,
		.change = c->options->change,
		.modes = c->options->watch != NULL,
		.counts_steps = c->counts_steps,
	};
	const struct file_opened opened = {c, on_opened};
	const struct cancel cancel = {c, stops_reading}, waiting = {c, stops_waiting};
	bool complete;

	options.read.all_faults = c->options->method == CHECK_NOTHING && c->options->all;
	options.read.opened = options.read.opened ? &opened : NULL;
	options.read.cancel = &cancel;
	options.read.waiting = &waiting;
	complete = read_program(c, &options, in);
	if (!c->end.stopped)
		c->stats->motion = c->program.summary;
	return complete || c->end.stopped;
}

static void release(struct checker *c)
{
	scheduler_release(&c->scheduler);
	stock_check_release(&c->stock);
	cutter_approach_release(&c->approach);
	free(c->undecided);
	batch_release(&c->batch);
	block_log_release(&c->log);
	file_names_release(&c->names);
	file_names_release(&c->opened);
	event_copies_release(&c->heard);
	checker_release_pending(c);
	pthread_mutex_destroy(&c->telling);
	sweep_release(&c->sweep);
}

static struct pair_measuring measuring_of(const struct check_options *options, const double *proven)
{
	if (proven)
		return (struct pair_measuring){options->measure_cap > 0 ? options->measure_cap : INFINITY, false};
	if (options->block_clearances && options->least_clearances)
		return (struct pair_measuring){options->block_clearance_cap, true};
	return (struct pair_measuring){0};
}

enum check_result check_run(struct scene *scene, const struct check_options *options, FILE *in, const char *name,
			    const struct check_sink *sink, struct diag *diag, struct check_stats *stats,
			    double *proven)
{
	struct checker c = {.scene = scene, .options = options, .sink = sink, .diag = diag, .stats = stats,
			    .measures = proven && options->method == CHECK_CERTIFIED, .file = name};
	const size_t errors = diag->errors;
	double start = checker_clock();
	bool complete = false;

	*stats = (struct check_stats){0};
	for (size_t i = 0; proven && i < scene->pair_count; i++)
		proven[i] = INFINITY;
	stats->pairs_required = scene_count_pairs(scene, PAIR_CHECKED);
	stats->pairs_excused = scene_count_pairs(scene, PAIR_ADJACENT);
	stats->pairs_skipped = scene->pair_count - stats->pairs_required - stats->pairs_excused;
	c.counts_steps = options->method == CHECK_NOTHING && !options->record && !options->watch && !sink->block;
	block_log_init(&c.log);
	pthread_mutex_init(&c.telling, NULL);
	c.sweep.cancel = &c.asked;
	c.asked = (struct cancel){&c, checker_asks};
	c.program.position = machine_home(scene->machine);
	c.program.tool = scene->setup ? scene->setup->initial_tool : 0;
	c.end.last_block = LONG_MAX;
	start_block(&c);
	cutter_approach_init(&c.approach, options->method == CHECK_NOTHING ? NULL : scene, name);
	if (options->method != CHECK_NOTHING)
		scheduler_init(&c.scheduler, scene, options, &c.asked, measuring_of(options, proven));
	if (options->method == CHECK_NOTHING || stock_check_init(&c.stock, scene, options, &c.asked, diag)) {
		complete = run_program(&c, in);
		finish(&c, complete);
		if (complete && !c.end.stopped && !c.end.failed && diag->errors == errors)
			stats->far_cutters = cutter_approach_result(&c.approach);
		/* After a first finding, nothing more was logged. */
		if (options->remainder && complete && !c.end.stopped && !checker_has_enough(&c))
			stock_check_remainder(&c.stock, c.program.next_step, options->remainder);
		if (options->stock_view)
			stock_check_view(&c.stock, c.program.next_step, options->stock_view);
		scheduler_collect(&c.scheduler, options, c.end.last_block, stats, proven);
		stock_check_collect(&c.stock, scene, c.end.last_block, stats, proven);
	}
	stats->certificates += c.sweep.certificates;
	stats->bisections += c.sweep.bisections;
	stats->seconds_interpret = checker_clock() - start - stats->seconds_check;
	release(&c);
	if (c.end.failed || diag->errors > errors || (!complete && !stats->findings))
		return CHECK_INCOMPLETE;
	return stats->findings ? CHECK_FOUND : CHECK_CLEAR;
}
