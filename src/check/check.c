#include "check/check.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "base/held.h"
#include "base/mem.h"
#include "check/batch.h"
#include "check/course.h"
#include "check/crew.h"
#include "check/journal.h"
#include "check/ledger.h"
#include "check/relay.h"
#include "check/step.h"
#include "scene/static_query.h"

/* Steps that are checked at a time, at the end of a block; a block of more than MID_BLOCK is checked in parts. */
#define BATCH_STEPS 1024
#define MID_BLOCK (8 * BATCH_STEPS)

/*
 * How much coarser than the tolerance the chords of curved moves may be to
 * begin with: near contact they are refined, elsewhere fewer of them cost less.
 */
#define FLATNESS 16

struct checker {
	struct scene *scene;
	const struct check_options *options;
	const struct check_sink *sink;
	struct diag *diag;
	struct check_stats *stats;
	struct held held;
	struct crew crew;
	struct batch batch;
	struct ledger ledger;
	struct sweep sweep;	/* for poses that stand still */
	bool measures;	/* the smallest clearance of each pair */
	const char *file;
	long block;	/* number of the block that is being read */
	int tool;
	bool moved;
	bool failed;	/* something could not be decided: reported */
	bool found;	/* two bodies; without `all`, nothing later needs to be looked at */
	bool limit_found;
	bool stopped;	/* by us or by the sink */
	bool broken_off;	/* since the last batch that was checked whole */
	bool skipped;	/* blocks of other shards since the last step of ours */
	axis_values position;
	double time, block_time;	/* where the last step ended */
	long line, checked_line;	/* of the last step's block, and of the last one that was checked */
	struct strbuf line_file;	/* of `line` */
	struct motion_summary summary;	/* of what was read so far */
	struct journal journal;
	long last_block;	/* the check ends with it */
	long steps;	/* of the block that is being read */
	double read_from, read_check, gauging;	/* where reading it began; seconds_check then; s spent on gauges since */
};

static double now(void)
{
	struct timespec t;

	clock_gettime(CLOCK_MONOTONIC, &t);
	return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static bool enough(const struct checker *c)
{
	return c->found && !c->options->all;
}

/* Is the block that is being read one to check? */
static bool is_ours(const struct checker *c, long block)
{
	const struct check_options *options = c->options;

	return options->shards < 2 || (block / SHARE_BLOCKS) % options->shards == options->shard - 1;
}

/*
 * What is reported beside a required clearance is the distance itself, and so it is
 * where the control may leave the path by `tolerance` (NULL: it may not).
 */
static struct contact measured(struct checker *c, const struct scene_pair *pair, const struct contact *found,
			       const axis_values *tolerance)
{
	struct contact contact = *found;
	struct body_pair bodies;

	if ((!tolerance && !(pair->clearance > 0)) || !(contact.distance > 0) ||
	    !scene_pair_bodies(c->scene, pair, &bodies, &c->held.diag))
		return contact;
	sweep_nearest(&c->sweep, &bodies, &contact);
	if (tolerance)
		contact.path_displacement = body_pair_path_displacement(&bodies, &contact.q, tolerance);
	return contact;
}

static struct finding pair_finding(struct checker *c, const struct scene_pair *pair, enum finding_kind kind,
				   const struct contact *found, const axis_values *tolerance)
{
	const struct contact contact = measured(c, pair, found, tolerance);

	return finding_of_pair(c->scene, pair, kind, &contact, c->tool);
}

static void add_passage(struct checker *c, const struct runner_result *result)
{
	const struct scene_pair *pair = &c->scene->pairs[result->pair];
	const struct batch_step *step = &c->batch.steps[result->step];
	const struct motion_step *motion = &step->motion;
	struct ledger_entry entry = {.block = step->block, .rank = (int)result->pair};

	entry.finding = pair_finding(c, pair, pair->clearance > 0 ? FINDING_CLEARANCE : FINDING_COLLISION,
				     &result->contact,
				     step_may_stray(&pair->chain, motion) && !step_is_box(motion) ? &motion->tolerance
												  : NULL);
	entry.finding.move = motion->move;
	entry.finding.time = motion->time + result->contact.s * motion->seconds;
	entry.block_time = motion->block_time + result->contact.s * motion->seconds;
	ledger_add(&c->ledger, &entry);
	c->found = true;
}

/* Hands on the findings whose blocks are complete. */
static void emit(struct checker *c)
{
	size_t done = 0;
	struct finding finding;

	ledger_sort(&c->ledger);
	while (!c->stopped && done < c->ledger.entry_count && ledger_finding(&c->ledger, done, &finding)) {
		held_deliver(&c->held, c->diag, c->options->all ? c->block : c->ledger.entries[done].block);
		c->stats->findings++;
		done++;
		if (!c->sink->finding(c->sink->context, &finding) || !c->options->all) {
			c->stopped = true;
			c->last_block = c->ledger.entries[done - 1].block;
		}
	}
	ledger_drop(&c->ledger, done);
	if (!c->found || c->options->all)
		held_deliver(&c->held, c->diag, c->block);
}

static void report_undecided(struct checker *c, const struct runner_result *result)
{
	const struct motion_step *motion = &c->batch.steps[result->step].motion;
	const struct scene_pair *pair = &c->scene->pairs[result->pair];

	c->failed = true;
	if (motion->span.path->kind != PATH_BOX) {
		static_query_report_undecided(c->scene, pair, c->options->tolerance, c->diag);
		return;
	}
	diag_error(c->diag, (struct srcloc){c->file, motion->line, 1},
		   "'%s' and '%s' cannot be decided with reasonable effort: too many axes move at once in this rapid, "
		   "whose way is not known (rapid=\"any\"); if it is, say so, or move fewer axes at once",
		   c->scene->bodies[pair->a].body->name, c->scene->bodies[pair->b].body->name);
}

/* The contacts go to the ledger; what is undecided behind the first of them does not matter without `all`. */
static void take_results(struct checker *c)
{
	size_t first_contact = c->batch.step_count;

	for (size_t i = 0; i < c->crew.result_count; i++) {
		const struct runner_result *result = &c->crew.results[i];

		if (result->passage != PASSAGE_CONTACT)
			continue;
		add_passage(c, result);
		if (!c->options->all && result->step < first_contact)
			first_contact = result->step;
	}
	for (size_t i = 0; i < c->crew.result_count; i++) {
		const struct runner_result *result = &c->crew.results[i];

		if (result->passage != PASSAGE_UNDECIDED || result->step > first_contact)
			continue;
		report_undecided(c, result);
	}
}

/* False: broken off. */
static bool gauge(struct checker *c)
{
	double start = now();
	bool complete = crew_gauge(&c->crew, &c->batch, c->tool, c->options);

	for (size_t i = 0; i < c->crew.count && complete; i++) {
		const struct runner *runner = &c->crew.runners[i];

		for (size_t k = 0; k < runner->room_count; k++) {
			double clearance = runner->rooms[k].clearance;

			journal_add_room(&c->journal, runner->rooms[k].block,
					 &(struct check_room){runner->pair, clearance, clearance >= c->options->gauge_cap});
		}
	}
	c->gauging += now() - start;
	return complete;
}

/* Checks what has gathered. */
static void process(struct checker *c)
{
	double start = now();

	if (!enough(c) && !c->broken_off && c->batch.step_count) {
		batch_close(&c->batch);
		c->broken_off = !crew_run(&c->crew, &c->batch, c->tool, c->options);
		if (!c->broken_off) {
			take_results(c);
			c->broken_off = c->options->gauges && !gauge(c);
		}
		if (c->broken_off)
			c->last_block = c->batch.steps[0].block - 1;
	}
	batch_clear(&c->batch);
	/* Of a batch that is not checked whole nobody knows what comes first. */
	if (!c->broken_off) {
		emit(c);
		c->checked_line = c->line;
	}
	c->stats->seconds_check += now() - start;
	if (!c->stopped &&
	    (c->broken_off || (c->sink->progress && !c->sink->progress(c->sink->context, c->checked_line)))) {
		diag_error(c->diag, (struct srcloc){c->file, 0, 0},
			   "interrupted after line %ld: what follows was not checked", c->checked_line);
		c->stopped = c->failed = true;
	}
	if (c->stopped)
		c->stats->motion = c->summary;
}

/* Do the axes stand where nothing is out of reach? */
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

/* Looks at the pairs, those of the tool only if `tool_only`, as they stand at the current position. */
static void check_stance(struct checker *c, bool tool_only, int move)
{
	bool past_a_limit = is_past_a_limit(c);
	double start = now();

	for (size_t i = 0; i < c->crew.count && !enough(c) && !c->broken_off && is_ours(c, c->block); i++) {
		struct runner *runner = &c->crew.runners[i];
		const struct scene_pair *pair = &c->scene->pairs[runner->pair];
		struct ledger_entry entry = {.block = c->block, .rank = (int)runner->pair};
		struct contact contact;
		enum pose_state stance;

		if ((runner->past_limits_only && !past_a_limit) || !runner_is_active(runner, c->tool) ||
		    (tool_only && !runner->tool))
			continue;
		stance = static_query_pose(c->scene, &c->sweep, pair, &c->position, c->options->tolerance, &contact,
				      &c->held.diag);
		c->broken_off = c->sweep.broken_off || cancel_asked(c->options->read.cancel);
		if (c->broken_off)
			break;
		c->failed |= stance == POSE_FAILED;
		if (stance == POSE_UNKNOWN && runner->unknown_block < 0)
			runner->unknown_block = c->block;
		if ((stance == POSE_CLEAR || stance == POSE_UNKNOWN) && c->measures)
			runner_stand(runner, &c->sweep, &c->position);
		if (stance != POSE_NEAR && stance != POSE_OVERLAP)
			continue;
		entry.finding = pair_finding(c, pair,
					     stance == POSE_OVERLAP ? FINDING_START_OVERLAP : FINDING_CLEARANCE,
					     &contact, NULL);
		entry.finding.move = move;
		entry.finding.time = c->time;
		entry.block_time = c->block_time;
		ledger_add(&c->ledger, &entry);
		c->found = true;
		if (c->options->gauges && stance == POSE_OVERLAP)
			journal_add_room(&c->journal, c->block, &(struct check_room){.pair = runner->pair});
		runner_found(runner, c->block);
	}
	c->stats->seconds_check += now() - start;
}

static bool on_limit(void *context, const struct motion_limit *limit)
{
	struct checker *c = context;
	struct ledger_entry entry = {.block = c->block, .rank = -1};

	if (enough(c) || !is_ours(c, c->block))
		return !c->stopped;
	entry.finding = (struct finding){
		.kind = FINDING_LIMIT,
		.move = limit->move,
		.time = limit->time,
		.axes = limit->position,
		.tool = limit->tool,
		.slot = limit->slot,
		.bound = limit->bound,
	};
	entry.block_time = limit->block_time;
	ledger_add(&c->ledger, &entry);
	c->limit_found = true;
	return !c->stopped;
}

static bool on_step(void *context, const struct motion_step *step)
{
	struct checker *c = context;

	if (!c->moved) {
		c->moved = true;
		c->position = step->span.q0;
		c->tool = step->tool;
		c->time = step->time;
		check_stance(c, false, step->move);
	}
	if (!enough(c) && c->options->method != CHECK_NOTHING && is_ours(c, c->block)) {
		if (c->skipped)
			crew_jump(&c->crew);
		c->skipped = false;
		batch_add(&c->batch, step, c->block);
	}
	c->line = step->line;
	if (strcmp(strbuf_text(&c->line_file), step->file)) {
		strbuf_clear(&c->line_file);
		strbuf_add(&c->line_file, step->file, strlen(step->file));
	}
	c->steps++;
	if (c->options->course)
		course_step(c->options->course, step);
	c->position = step->span.q1;
	c->time = step->time + step->seconds;
	c->block_time = step->block_time + step->seconds;
	if (c->batch.step_count >= MID_BLOCK || c->broken_off)
		process(c);
	return !c->stopped;
}

static bool on_tool(void *context, int tool, const axis_values *position)
{
	struct checker *c = context;

	process(c);
	/* Before anything moves, a new tool waits for the check of the start pose; the old one is gone by then. */
	if (!c->moved && c->tool != tool)
		check_stance(c, true, 0);
	c->tool = tool;
	c->position = *position;
	crew_change_tool(&c->crew);
	if (c->moved)
		check_stance(c, true, 0);
	if (c->broken_off)
		process(c);
	return !c->stopped;
}

/* What was measured of a block that is complete, and checked if it was timed. */
static void record_block(struct checker *c, const char *file, long line, double seconds)
{
	double check = c->stats->seconds_check - c->read_check;
	const struct journal_block block = {
		.block = c->block, .line = line, .steps = c->steps, .seconds = seconds,
		.interpret = now() - c->read_from - check, .check = check - c->gauging,
	};

	journal_close_block(&c->journal, &block, file);
}

/* Reading the next block begins. */
static void start_block(struct checker *c)
{
	c->steps = 0;
	c->gauging = 0;
	c->read_check = c->stats->seconds_check;
	c->read_from = now();
}

static bool on_block(void *context, const char *file, long line, const char *text, double seconds, int moves)
{
	struct checker *c = context;
	bool ours = is_ours(c, c->block);
	/* Blocks without steps gather too. The steps of a batch follow on each other. */
	bool due = c->batch.step_count >= BATCH_STEPS || c->ledger.block_count + 1 >= BATCH_STEPS || enough(c) ||
		   c->limit_found || c->options->times || (ours && !is_ours(c, c->block + 1));

	if (c->options->course)
		course_block(c->options->course, line, c->tool, &c->position);
	ledger_close_block(&c->ledger, c->block, file, line, text, seconds, moves);
	c->block_time = 0;
	c->stats->blocks_checked += ours;
	c->skipped |= !ours;
	if (due)
		process(c);
	if (c->sink->block) {
		record_block(c, file, line, seconds);
		if (due)
			journal_emit(&c->journal, c->last_block, c->sink);
		start_block(c);
	}
	c->block++;
	c->held.block = c->block;
	return !c->stopped;
}

/* What is left when the program has ended, or stopped at a fault in the middle of a block. */
static void finish(struct checker *c, bool complete)
{
	/* Such a block has been checked as far as it goes. */
	bool broken_off = !c->stopped && c->steps;

	if (!c->moved && !c->stopped && complete) {
		diag_warning(c->diag, (struct srcloc){c->file, 0, 0},
			     c->options->method == CHECK_NOTHING
				     ? "the program moves no axis"
				     : "the program moves no axis; only the start pose was checked");
		check_stance(c, false, 0);
	}
	if (!c->stopped) {
		ledger_close_block(&c->ledger, c->block, c->line ? strbuf_text(&c->line_file) : c->file,
				   c->line ? c->line : 1, "", c->block_time, 1);
		process(c);
	}
	if (c->sink->block) {
		if (broken_off)
			record_block(c, c->line ? strbuf_text(&c->line_file) : c->file, c->line, c->block_time);
		journal_emit(&c->journal, c->last_block, c->sink);
	}
}

/* False: a fault was reported. */
static bool run_program(struct checker *c, FILE *in)
{
	const struct motion_options options = {
		.flatness = FLATNESS * c->options->tolerance,
		.read = c->options->read,
		.change = c->options->change,
	};
	const struct motion_sink sink = {c, on_limit, on_step, on_tool, on_block};
	/* What reading a block takes is not to be had while it is read ahead. */
	bool ahead = c->options->threads > 1 && !c->options->times;
	bool complete = (ahead ? relay_run : motion_run)(c->scene->machine, c->scene->setup, &options, in, c->file,
							 &sink, &c->held.diag, &c->summary);

	if (!c->stopped)
		c->stats->motion = c->summary;
	return complete || c->stopped;
}

enum check_result check_run(struct scene *scene, const struct check_options *options, FILE *in, const char *name,
			    const struct check_sink *sink, struct diag *diag, struct check_stats *stats,
			    double *proven)
{
	struct checker c = {.scene = scene, .options = options, .sink = sink, .diag = diag, .stats = stats,
			    .measures = proven && options->method == CHECK_CERTIFIED, .file = name};
	const size_t errors = diag->errors;
	double start = now();
	bool complete = false;

	*stats = (struct check_stats){0};
	for (size_t i = 0; proven && i < scene->pair_count; i++)
		proven[i] = INFINITY;
	stats->pairs_required = scene_count_pairs(scene, PAIR_CHECKED);
	stats->pairs_excused = scene_count_pairs(scene, PAIR_ADJACENT);
	stats->pairs_skipped = scene->pair_count - stats->pairs_required - stats->pairs_excused;
	held_init(&c.held);
	c.sweep.cancel = options->read.cancel;
	c.position = machine_home(scene->machine);
	c.tool = scene->setup ? scene->setup->initial_tool : 0;
	c.last_block = LONG_MAX;
	start_block(&c);
	if (options->method == CHECK_NOTHING || crew_init(&c.crew, scene, options, proven != NULL, diag)) {
		complete = run_program(&c, in);
		finish(&c, complete);
		crew_collect(&c.crew, c.last_block, stats, proven);
	}
	stats->certificates += c.sweep.certificates;
	stats->bisections += c.sweep.bisections;
	stats->seconds_interpret = now() - start - stats->seconds_check;
	crew_release(&c.crew);
	batch_release(&c.batch);
	ledger_release(&c.ledger);
	journal_release(&c.journal);
	held_release(&c.held);
	strbuf_release(&c.line_file);
	sweep_release(&c.sweep);
	if (c.failed || diag->errors > errors || (!complete && !stats->findings))
		return CHECK_INCOMPLETE;
	return stats->findings ? CHECK_FOUND : CHECK_CLEAR;
}
