#include "check/checker.h"

#include <string.h>
#include <time.h>

#include "check/step.h"
#include "check/stock_certainty.h"
#include "scene/static_query.h"

double checker_clock(void)
{
	struct timespec t;

	clock_gettime(CLOCK_MONOTONIC, &t);
	return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

bool checker_asks(void *context)
{
	struct checker *c = context;
	const struct check_sink *sink = c->sink;

	/* The result of sink->progress is ignored here: only the caller's cancel function can stop a batch. */
	if (sink->progress && !atomic_flag_test_and_set(&c->telling)) {
		sink->progress(sink->context, c->checked.line);
		atomic_flag_clear(&c->telling);
	}
	return cancel_asked(c->options->read.cancel);
}

bool checker_has_enough(const struct checker *c)
{
	return c->found && !c->options->all;
}

bool checker_owns(const struct checker *c, long block)
{
	const struct check_options *options = c->options;

	return options->shards < 2 || (block / SHARE_BLOCKS) % options->shards == options->shard - 1;
}

/* --------------------------------------------------------------- findings */

/*
 * The contact with its distance measured, if a clearance is required or if the control may leave the path by
 * `tolerance` (NULL: it may not).
 */
static struct contact measured(struct checker *c, const struct scene_pair *pair, const struct contact *found,
			       const axis_values *tolerance)
{
	struct contact contact = *found;
	struct body_pair bodies;

	if (pair->stock || (!tolerance && !(pair->clearance > 0)) || !(contact.distance > 0))
		return contact;
	bodies = scene_pair_bodies(c->scene, pair);
	sweep_nearest(&c->sweep, &bodies, &contact);
	if (tolerance)
		contact.path_displacement = body_pair_path_displacement(&bodies, &contact.q, tolerance);
	return contact;
}

/* The kind of a finding of this pair; `kind` is that of an ordinary pair, which must always stay apart. */
static enum finding_kind kind_of(const struct scene_pair *pair, enum finding_kind kind)
{
	switch (pair->fault) {
	case PAIR_RAPID_CONTACT:
		return FINDING_RAPID_CONTACT;
	case PAIR_GOUGE:
		return FINDING_GOUGE;
	case PAIR_COLLISION:
		break;
	}
	return kind;
}

/*
 * Adds a finding in the move with this number, in a step of this class (0: the axes stand). `tolerance` as in
 * measured().
 */
static void add_finding(struct checker *c, const struct block_finding *at, enum finding_kind kind, int move,
			int step_class, const struct contact *found, const axis_values *tolerance)
{
	const struct scene_pair *pair = &c->scene->pairs[at->rank];
	const struct contact contact = measured(c, pair, found, tolerance);
	struct block_finding finding = *at;

	finding.finding = finding_of_pair(c->scene, pair, kind_of(pair, kind), &contact, c->tool);
	finding.finding.step_class = step_class;
	finding.finding.move = move;
	finding.finding.time = at->finding.time;
	finding.finding.stock_time = at->finding.stock_time;
	finding.finding.certain = at->finding.certain;
	block_log_add_finding(&c->log, &finding);
	c->found = true;
}

static void add_contact(struct checker *c, const struct pair_check_result *result)
{
	const struct scene_pair *pair = &c->scene->pairs[result->pair];
	const struct batch_step *step = &c->batch.steps[result->step];
	const struct motion_step *motion = &step->motion;
	const double since = result->contact.s * motion->seconds;
	const struct block_finding at = {.finding.time = motion->time + since, .finding.certain = result->certain,
					 .finding.stock_time = (double)step->number + result->contact.s,
					 .block = step->block, .block_time = motion->block_time + since,
					 .rank = (int)result->pair};

	add_finding(c, &at, pair->clearance > 0 ? FINDING_CLEARANCE : FINDING_COLLISION, motion->move,
		    (int)motion->step_class, &result->contact,
		    step_may_leave_path(&pair->chain, motion) && !step_is_box(motion) ? &motion->tolerance : NULL);
}

static void report_undecided(struct checker *c, const struct pair_check_result *result)
{
	const struct motion_step *motion = &c->batch.steps[result->step].motion;
	const struct scene_pair *pair = &c->scene->pairs[result->pair];

	c->failed = true;
	if (motion->span.path->kind != PATH_BOX && result->exhausted) {
		c->exhausted = true;
		diag_error(
		    c->diag, (struct srcloc){motion->file, motion->line, 1},
		    "'%s' and '%s' cannot be decided with reasonable effort: they stay too close to each other for "
		    "too long. The check stops here; give a larger --tolerance, or split the move",
		    c->scene->bodies[pair->a].body->name, c->scene->bodies[pair->b].body->name);
		return;
	}
	if (motion->span.path->kind != PATH_BOX) {
		static_query_report_undecided(c->scene, pair, c->options->tolerance, c->diag);
		return;
	}
	diag_error(
	    c->diag, (struct srcloc){motion->file, motion->line, 1},
	    "'%s' and '%s' cannot be decided with reasonable effort: too many axes move at once in this rapid, "
	    "whose way is not known (rapid=\"any\"); give the control's rapid in the machine file, or move fewer "
	    "axes at once",
	    c->scene->bodies[pair->a].body->name, c->scene->bodies[pair->b].body->name);
}

/* Logs contacts. Without `all`, *last becomes the first step with a contact: what comes later does not matter. */
static void take_results(struct checker *c, const struct pair_check_result *results, size_t count, size_t *last)
{
	for (size_t i = 0; i < count; i++) {
		if (results[i].answer != QUERY_CONTACT)
			continue;
		add_contact(c, &results[i]);
		if (!c->options->all && results[i].step < *last)
			*last = results[i].step;
	}
}

static void take_undecided(struct checker *c, const struct pair_check_result *results, size_t count, size_t last)
{
	for (size_t i = 0; i < count; i++)
		if (results[i].answer == QUERY_UNDECIDED && results[i].step <= last)
			report_undecided(c, &results[i]);
}

/* Reports the findings whose blocks are complete, and the diagnostics that came before them. */
static void hand_on_findings(struct checker *c)
{
	struct block_log *log = &c->log;
	size_t done = 0;
	struct finding finding;

	block_log_sort(log);
	while (!c->stopped && done < log->finding_count && block_log_finding(log, done, &finding)) {
		const long block = log->findings[done].block;

		diag_queue_deliver(&log->diags, c->diag, c->options->all ? c->block : block);
		c->stats->findings++;
		done++;
		if (!c->sink->finding(c->sink->context, &finding) || !c->options->all) {
			c->stopped = true;
			c->last_block = block;
		}
	}
	block_log_drop_findings(log, done);
	if (!c->found || c->options->all)
		diag_queue_deliver(&log->diags, c->diag, c->block);
}

/* ---------------------------------------------------------------- batches */

static void add_clearance(struct checker *c, long block, size_t pair, double clearance, bool so_far)
{
	const struct pair_clearance least = {pair, clearance, clearance >= c->options->block_clearance_cap, so_far};

	if (!least.capped || !c->options->least_clearances)
		block_log_add_clearance(&c->log, block, &least);
}

/* False: broken off. */
static bool measure_blocks(struct checker *c)
{
	double start = checker_clock();
	bool complete = scheduler_measure(&c->scheduler, &c->batch, c->tool, c->options) &&
			stock_check_measure(&c->stock, &c->batch, c->tool);

	for (size_t i = 0; i < c->scheduler.count && complete; i++) {
		const struct pair_check *check = &c->scheduler.checks[i];

		for (size_t k = 0; k < check->clearance_count; k++)
			add_clearance(c, check->clearances[k].block, check->pair, check->clearances[k].clearance,
				      check->clearances[k].so_far);
	}
	for (size_t i = 0; i < c->stock.pair_count && complete; i++) {
		const struct stock_clearance *measured = &c->stock.clearances[i];

		for (size_t k = 0; k < measured->block_count; k++)
			add_clearance(c, measured->blocks[k].block, c->stock.pairs[i].pair,
				      measured->blocks[k].clearance, false);
	}
	c->measuring += checker_clock() - start;
	return complete;
}

/* With cuts missing, what is clear would become a finding. */
static void stop_at_log_fault(struct checker *c)
{
	if (!stock_check_fault(&c->stock) || c->stopped)
		return;
	diag_error(c->diag, (struct srcloc){c->file, 0, 0},
		   "the cuts of the stock could not be kept in a temporary file: %s; the check stops here",
		   strerror(stock_check_fault(&c->stock)));
	c->failed = c->broken_off = c->stopped = true;
	c->last_block = (c->batch.step_count ? c->batch.steps[0].block : c->block) - 1;
}

static void check_batch(struct checker *c)
{
	size_t last = c->batch.step_count - 1;

	batch_close(&c->batch);
	c->broken_off = !scheduler_run(&c->scheduler, &c->batch, c->tool, c->options);
	if (!c->broken_off) {
		take_results(c, c->scheduler.results, c->scheduler.result_count, &last);
		c->broken_off = !stock_check_run(&c->stock, &c->batch, last, c->tool, c->options);
	}
	if (!c->broken_off) {
		take_results(c, c->stock.results, c->stock.result_count, &last);
		take_undecided(c, c->scheduler.results, c->scheduler.result_count, last);
		take_undecided(c, c->stock.results, c->stock.result_count, last);
		c->broken_off = c->options->block_clearances && !measure_blocks(c);
	}
	if (c->broken_off)
		c->last_block = c->batch.steps[0].block - 1;
}

/* Reports progress, or why the check ends here. */
static void tell_progress(struct checker *c)
{
	const struct check_sink *sink = c->sink;

	if (c->exhausted && !c->stopped)
		c->stopped = true;
	if (c->stopped || (!c->broken_off && (!sink->progress || sink->progress(sink->context, c->checked.line))))
		return;
	diag_error(c->diag, (struct srcloc){c->checked.file ? c->checked.file : c->file, 0, 0},
		   "interrupted after line %ld: the rest was not checked", c->checked.line);
	c->stopped = c->failed = true;
}

void checker_process(struct checker *c, struct block_record *timed)
{
	double start = checker_clock();

	if (!checker_has_enough(c) && !c->broken_off && c->batch.step_count)
		check_batch(c);
	stop_at_log_fault(c);
	batch_clear(&c->batch);
	/* In a batch that was interrupted, it is unknown which finding comes first. */
	if (!c->broken_off) {
		hand_on_findings(c);
		c->checked = c->last;
	}
	c->stats->seconds_check += checker_clock() - start;
	if (timed) {
		const double check = c->stats->seconds_check - c->read_check;

		timed->interpret = checker_clock() - c->read_from - check;
		timed->check = check - c->measuring;
	}
	if (c->sink->block)
		block_log_measured(&c->log, c->last_block, c->sink);
	block_log_forget(&c->log);
	tell_progress(c);
	if (c->stopped)
		c->stats->motion = c->summary;
}

/* ------------------------------------------------------------------ poses */

/* Is an axis past a limit, where pairs that are out of reach may meet? */
static bool is_past_a_limit(const struct checker *c)
{
	const struct machine *machine = c->scene->machine;

	for (size_t i = 0; i < machine->axis_count; i++) {
		const struct axis *axis = &machine->axes[i];
		double at = c->position.v[axis->slot];

		if (at < axis->limit_min || at > axis->limit_max)
			return true;
	}
	return false;
}

/* Checks a pair at the current position; step_class: 0, or the class that this standstill counts as. */
static void check_pair_at_rest(struct checker *c, struct pair_check *check, int move, int step_class)
{
	const struct scene_pair *pair = &c->scene->pairs[check->pair];
	const struct block_finding at = {.finding.time = c->time, .finding.stock_time = (double)c->number,
					 .block = c->block, .block_time = c->block_time,
					 .rank = (int)check->pair};
	struct contact contact;
	enum pose_state state;

	pair_check_prepare(check, c->options);
	state = static_query_pose(c->scene, &c->sweep, pair, &c->position, c->options->tolerance,
						  &contact, &c->log.diags.diag);

	c->broken_off = c->sweep.broken_off || cancel_asked(c->options->read.cancel);
	if (c->broken_off)
		return;
	c->failed |= state == POSE_FAILED;
	if (state == POSE_UNKNOWN && check->unknown_block < 0)
		check->unknown_block = c->block;
	if ((state == POSE_CLEAR || state == POSE_UNKNOWN) && c->measures)
		pair_check_stand(check, &c->sweep, &c->position);
	if (state != POSE_NEAR && state != POSE_OVERLAP)
		return;
	add_finding(c, &at, state == POSE_OVERLAP ? FINDING_START_OVERLAP : FINDING_CLEARANCE, move, step_class,
		    &contact, NULL);
	if (c->options->block_clearances && state == POSE_OVERLAP)
		block_log_add_clearance(&c->log, c->block, &(struct pair_clearance){.pair = check->pair});
	pair_check_found(check, c->block);
}

/* Likewise of a body and the stock. */
static void check_stock_at_rest(struct checker *c, struct stock_pair *check, int move, int step_class)
{
	const struct scene_pair *pair = &c->scene->pairs[check->pair];
	struct block_finding at = {.finding.time = c->time, .finding.stock_time = (double)c->number,
					 .block = c->block, .block_time = c->block_time,
					 .rank = (int)check->pair};
	struct contact contact;
	enum query_answer answer = stock_pair_stand(check, &c->position, c->number, &contact);

	c->broken_off = check->sweep.broken_off;
	if (c->broken_off || answer == QUERY_CLEAR)
		return;
	if (answer == QUERY_UNDECIDED) {
		c->failed = true;
		static_query_report_undecided(c->scene, pair, c->options->tolerance, &c->log.diags.diag);
		return;
	}
	at.finding.certain = stock_certainty_at(check, &c->position, (double)c->number);
	add_finding(c, &at, contact.distance > 0 ? FINDING_CLEARANCE : FINDING_START_OVERLAP, move, step_class,
		    &contact, NULL);
	if (c->options->block_clearances && check->steps == STEP_ANY && !(contact.distance > 0))
		block_log_add_clearance(&c->log, c->block, &(struct pair_clearance){.pair = check->pair});
	stock_pair_found(check, c->block);
}

void checker_at_rest(struct checker *c, bool tool_only, int move)
{
	bool past_a_limit = is_past_a_limit(c);
	double start = checker_clock();

	if (!checker_owns(c, c->block))
		return;
	for (size_t i = 0; i < c->scheduler.count && !checker_has_enough(c) && !c->broken_off; i++) {
		struct pair_check *check = &c->scheduler.checks[i];

		if ((!check->past_limits_only || past_a_limit) && pair_check_is_active(check, c->tool) &&
		    pair_check_watches(check, STEP_RAPID) && (!tool_only || check->tool))
			check_pair_at_rest(c, check, move, 0);
	}
	for (size_t i = 0; i < c->stock.pair_count && !checker_has_enough(c) && !c->broken_off; i++) {
		struct stock_pair *check = &c->stock.pairs[i];

		if ((!check->past_limits_only || past_a_limit) && stock_pair_is_active(check, c->tool) &&
		    stock_pair_watches(check, STEP_RAPID) && (!tool_only || check->tool))
			check_stock_at_rest(c, check, move, 0);
	}
	c->stats->seconds_check += checker_clock() - start;
}

void checker_spindle_stops(struct checker *c, int move)
{
	double start = checker_clock();

	if (!checker_owns(c, c->block))
		return;
	for (size_t i = 0; i < c->scheduler.count && !checker_has_enough(c) && !c->broken_off; i++) {
		struct pair_check *check = &c->scheduler.checks[i];

		/* What has to stay apart while the spindle turns has just been looked at. */
		if (pair_check_is_active(check, c->tool) && pair_check_watches(check, STEP_FEED_STANDING) &&
		    !pair_check_watches(check, STEP_FEED_TURNING) && check->found_block != c->block)
			check_pair_at_rest(c, check, move, STEP_FEED_STANDING);
	}
	for (size_t i = 0; i < c->stock.pair_count && !checker_has_enough(c) && !c->broken_off; i++) {
		struct stock_pair *check = &c->stock.pairs[i];

		if (stock_pair_is_active(check, c->tool) && stock_pair_watches(check, STEP_FEED_STANDING) &&
		    !stock_pair_watches(check, STEP_FEED_TURNING) && check->found_block != c->block)
			check_stock_at_rest(c, check, move, STEP_FEED_STANDING);
	}
	c->stats->seconds_check += checker_clock() - start;
}
