#include "check/batch_run.h"

#include <string.h>

#include "base/spare_threads.h"

/* From the first block to the last. */
static void add_clearance(struct checker *c, long block, long last, size_t pair, double clearance, bool so_far)
{
	const struct pair_clearance least = {pair, clearance, clearance >= c->options->block_clearance_cap, so_far};

	if (!least.capped || !c->options->least_clearances)
		block_log_add_expected(&c->log, block, last, least);
}

/* Logs the results of scheduler_measure and stock_check_measure. */
static void take_clearances(struct checker *c)
{
	for (size_t i = 0; i < c->scheduler.count; i++) {
		const struct pair_check *check = &c->scheduler.checks[i];

		block_log_expect_clearances(&c->log, check->clearance_count);
		for (size_t k = 0; k < check->clearance_count; k++)
			add_clearance(c, check->clearances[k].block, check->clearances[k].last, check->pair,
				      check->clearances[k].clearance, check->clearances[k].so_far);
	}
	for (size_t i = 0; i < c->stock.pair_count; i++) {
		const struct stock_clearance *measured = &c->stock.clearances[i];

		block_log_expect_clearances(&c->log, measured->block_count);
		for (size_t k = 0; k < measured->block_count; k++)
			add_clearance(c, measured->blocks[k].block, measured->blocks[k].block,
				      c->stock.pairs[i].pair, measured->blocks[k].clearance, false);
	}
}

/* False: interrupted. */
static bool measure_stock(struct checker *c)
{
	const double start = checker_clock();
	const bool complete = stock_check_measure(&c->stock, &c->pending.settling->batch, c->pending.settling->tool);

	c->timing.measuring += checker_clock() - start;
	return complete;
}

/* If cuts are missing, a motion that is clear would cause findings. */
static void stop_at_log_fault(struct checker *c)
{
	const struct pending_batch *settling = c->pending.settling;

	if (!stock_check_fault(&c->stock) || c->end.stopped)
		return;
	diag_error(c->diag, (struct srcloc){c->file, 0, 0},
		   "the log of cuts (stock) could not be written to a temporary file: %s; the check stops here",
		   strerror(stock_check_fault(&c->stock)));
	c->end.failed = c->end.broken_off = c->end.stopped = true;
	c->end.last_block = (settling->batch.step_count ? settling->batch.steps[0].block : settling->block) - 1;
}

static struct pending_batch *pending_of(struct checker *c, size_t number)
{
	/*
	 * A batch that is settled at once uses the same memory as the one before, which is still in the processor's
	 * cache.
	 */
	return &c->pending.items[c->background ? number % PENDING : 0];
}

/*
 * Are clearances measured before the batch is checked? Then what the measurement proves need not be checked again. If
 * only the least clearances are measured, the check comes first: its results show which blocks to measure.
 */
static bool measures_first(const struct check_options *options)
{
	return options->block_clearances && !options->least_clearances;
}

/* Measures clearances. False: interrupted. */
static bool measure_clearances(struct checker *c, struct pending_batch *pending)
{
	const double start = checker_clock();
	const bool complete = scheduler_measure(&c->scheduler, &pending->batch, pending->tool, c->options);

	pending->measuring = checker_clock() - start;
	return complete;
}

/* A background_fn. */
static bool run_batch(void *context, size_t number)
{
	struct checker *c = context;
	struct pending_batch *pending = pending_of(c, number);
	const double start = checker_clock();

	if (!pending->runs)
		return true;
	batch_close(&pending->batch);
	pending->complete = !measures_first(c->options) || measure_clearances(c, pending);
	if (pending->complete) {
		pending->complete = scheduler_run(&c->scheduler, &pending->batch, pending->tool, c->options);
		pending_batch_keep_results(pending, &c->scheduler);
	}
	if (pending->complete && c->options->block_clearances && !measures_first(c->options))
		pending->complete = measure_clearances(c, pending);
	pending->seconds = checker_clock() - start;
	return pending->complete && !pending->results.count && !c->options->block_clearances;
}

/* Takes the results of the batch, and checks it against the stock. */
static void take_pending(struct checker *c)
{
	struct pending_batch *pending = c->pending.settling;
	size_t last = pending->batch.step_count - 1;

	c->end.broken_off = !pending->complete;
	c->timing.measuring += pending->measuring;
	if (!c->end.broken_off) {
		last = checker_last_step(c, &pending->results, last);
		c->end.broken_off = !stock_check_run(&c->stock, &pending->batch, last, pending->tool, c->options);
	}
	if (!c->end.broken_off) {
		last = checker_last_step(c, &c->stock.results, last);
		checker_take_results(c, &pending->results, last);
		checker_take_results(c, &c->stock.results, last);
		c->end.broken_off = c->options->block_clearances && !measure_stock(c);
	}
	if (!c->end.broken_off && c->options->block_clearances)
		take_clearances(c);
	if (c->end.broken_off)
		c->end.last_block = pending->batch.steps[0].block - 1;
}

/* Reports progress, or the reason why the check ends here. */
static void tell_progress(struct checker *c)
{
	if (c->end.exhausted && !c->end.stopped)
		c->end.stopped = true;
	if (c->end.stopped || (!c->end.broken_off && checker_goes_on(c)))
		return;
	diag_error(c->diag, (struct srcloc){c->checked.file ? c->checked.file : c->file, 0, 0},
		   "interrupted after line %ld: the rest was not checked", c->checked.line);
	c->end.stopped = c->end.failed = true;
}

static void tell_opened(const struct checker *c, struct file_names *files)
{
	const struct file_opened *opened = c->options->read.opened;

	for (size_t i = 0; i < files->count; i++)
		opened->call(opened->context, files->items[i]);
	file_names_release(files);
}

static void swap_batches(struct batch *a, struct batch *b)
{
	const struct batch batch = *a;

	*a = *b;
	*b = batch;
}

/* Takes the results of the next batch, whose check is complete, and reports everything about its blocks. */
static void settle_next(struct checker *c, struct block_record *timed)
{
	struct pending_batch *pending = c->pending.settling = pending_of(c, c->pending.settled++);
	const double start = checker_clock() - (pending->runs ? pending->seconds : 0);

	tell_opened(c, &pending->opened);
	if (c->options->watch)
		event_copies_tell(&pending->heard, c->options->watch);
	block_log_show(&c->log, &pending->page);
	if (pending->runs)
		take_pending(c);
	stop_at_log_fault(c);
	batch_clear(&pending->batch);
	/* In an interrupted batch it is unknown which finding comes first. */
	if (!c->end.broken_off) {
		checker_hand_on_findings(c);
		c->checked = pending->last;
		c->checked_line = pending->last.line;
	}
	c->stats->seconds_check += checker_clock() - start;
	if (timed) {
		const double check = c->stats->seconds_check - c->timing.check_before;

		timed->interpret = checker_clock() - c->timing.read_from - check;
		timed->check = check - c->timing.measuring;
	}
	if (c->sink->block)
		block_log_measured(&c->log, c->end.last_block, c->sink);
	block_log_forget(&c->log);
	tell_progress(c);
	if (c->end.stopped) {
		c->stats->motion = pending->summary;
		c->stats->blocks_checked = pending->blocks_checked;
	}
}

/* Settles batches until `count` are settled, or the check stops. */
static void settle(struct checker *c, size_t count, struct block_record *timed)
{
	while (c->pending.settled < count && !c->end.stopped) {
		if (c->background)
			background_wait(c->background, c->pending.settled + 1);
		settle_next(c, timed);
		if (c->background && !c->end.stopped)
			background_take(c->background, c->pending.settled);
	}
}

/* Begins to check the collected steps. */
static void begin_batch(struct checker *c)
{
	struct pending_batch *pending = pending_of(c, c->pending.begun);
	const struct file_names opened = c->opened;
	const struct event_copies heard = c->heard;

	swap_batches(&c->batch, &pending->batch);
	block_log_turn(&c->log, &pending->page);
	c->opened = pending->opened;
	pending->opened = opened;
	c->heard = pending->heard;
	pending->heard = heard;
	pending->block = c->program.block;
	pending->tool = c->program.tool;
	pending->last = c->program.last;
	pending->summary = c->program.summary;
	pending->blocks_checked = c->stats->blocks_checked;
	pending->runs = !checker_has_enough(c) && !c->end.broken_off && pending->batch.step_count;
	pending->results.count = 0;
	pending->measuring = 0;
	c->pending.begun++;
	if (c->background)
		background_give(c->background);
	else
		run_batch(c, c->pending.begun - 1);
}

/*
 * Can batches be checked in the background? Not if this thread needs the results of a batch before it goes on: the time
 * of reading a block can be measured only without other work, the cuts of the stock are logged for the batch that is
 * being checked, and the record of the path must end with the batch that ends the check.
 */
static bool can_check_in_background(const struct checker *c)
{
	const struct check_options *options = c->options;

	return options->method != CHECK_NOTHING && !options->times && !options->record && !c->stock.pair_count &&
	       !c->stock.tool_count;
}

/* All begun batches must be settled. */
static void start_background(struct checker *c)
{
	if (c->background || !can_check_in_background(c))
		return;
	background_start(&c->second, run_batch, c, c->pending.begun);
	c->background = &c->second;
	c->scheduler.loop = &c->second.loop;
}

/* Would one more thread have work? Without a background it would share heavy batches. */
static bool can_use_thread(const struct checker *c)
{
	if (c->options->method == CHECK_NOTHING)
		return false;
	return c->background || can_check_in_background(c) || c->options->block_clearances ||
	       scheduler_is_heavy(&c->scheduler);
}

/* From now on the thread of a program that is complete helps. */
static void take_spare_thread(struct checker *c)
{
	if (!can_use_thread(c) || !spare_threads_take(c->options->spare))
		return;
	c->borrowed++;
	checker_settle(c);
	/* Batches after the one that ended the check are not settled: the background may still work on them. */
	if (c->end.stopped)
		return;
	scheduler_add_thread(&c->scheduler);
	start_background(c);
}

void checker_start_threads(struct checker *c)
{
	if (c->options->threads > 1)
		start_background(c);
}

void checker_end_threads(struct checker *c)
{
	if (c->background)
		background_end(c->background);
	c->background = NULL;
	c->scheduler.loop = NULL;
	if (c->borrowed)
		spare_threads_give(c->options->spare, c->borrowed);
	c->borrowed = 0;
}

void checker_begin(struct checker *c)
{
	take_spare_thread(c);
	if (!c->background) {
		checker_process(c, NULL);
		return;
	}
	settle(c, background_done(c->background), NULL);
	if (c->pending.begun - c->pending.settled == PENDING)
		settle(c, c->pending.settled + 1, NULL);
	if (!c->end.stopped)
		begin_batch(c);
}

void checker_settle(struct checker *c)
{
	settle(c, c->pending.begun, NULL);
}

void checker_process(struct checker *c, struct block_record *timed)
{
	checker_settle(c);
	if (c->end.stopped)
		return;
	begin_batch(c);
	settle(c, c->pending.begun, timed);
	if (!c->background)
		swap_batches(&c->batch, &c->pending.settling->batch);
}

void checker_release_pending(struct checker *c)
{
	for (size_t i = 0; i < PENDING; i++)
		pending_batch_release(&c->pending.items[i]);
}
