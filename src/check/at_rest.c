#include "check/at_rest.h"

#include "check/stock_certainty.h"
#include "scene/static_query.h"

/* Is an axis past a limit, where pairs that are out of reach may meet? */
static bool is_past_a_limit(const struct checker *c)
{
	const struct machine *machine = c->scene->machine;

	for (size_t i = 0; i < machine->axis_count; i++) {
		const struct axis *axis = &machine->axes[i];
		double at = c->program.position.v[axis->slot];

		if (at < axis->limit_min || at > axis->limit_max)
			return true;
	}
	return false;
}

static void say_undecided(struct checker *c, size_t pair)
{
	c->end.failed = true;
	checker_say_undecided(c, pair, c->program.block, 2 * c->program.next_step);
}

/* The place and the time of a finding of this pair at the current position. */
static struct block_finding finding_at_rest(const struct program_state *program, size_t pair)
{
	return (struct block_finding){.finding.time = program->time, .finding.stock_time = (double)program->next_step,
				      .block = program->block, .block_time = program->block_time,
				      .order = 2 * program->next_step, .rank = (int)pair};
}

/* Checks a pair at the current position. step_class: the class of steps that this position counts as; 0: none. */
static void check_pair_at_rest(struct checker *c, struct pair_check *check, int move, int step_class)
{
	const struct scene_pair *pair = &c->scene->pairs[check->pair];
	const struct block_finding at = finding_at_rest(&c->program, check->pair);
	struct contact contact;
	enum pose_state state;

	pair_check_prepare(check, c->options);
	state = static_query_pose(c->scene, &c->sweep, pair, &c->program.position, c->options->tolerance, &contact,
				  NULL);

	c->end.broken_off = c->sweep.broken_off || cancel_asked(c->options->read.cancel);
	if (c->end.broken_off)
		return;
	if (state == POSE_FAILED)
		say_undecided(c, check->pair);
	if (state == POSE_UNKNOWN && check->unknown_block < 0)
		check->unknown_block = c->program.block;
	if ((state == POSE_CLEAR || state == POSE_UNKNOWN) && c->measures)
		pair_check_stand(check, &c->sweep, &c->program.position);
	if (state != POSE_NEAR && state != POSE_OVERLAP)
		return;
	checker_add_finding(c, &at, state == POSE_OVERLAP ? FINDING_START_OVERLAP : FINDING_CLEARANCE, move, step_class,
			    &contact, NULL);
	if (c->options->block_clearances && state == POSE_OVERLAP)
		block_log_add_clearance(&c->log, c->program.block, &(struct pair_clearance){.pair = check->pair});
	pair_check_leave_block(check, c->program.block);
}

/* The same for a body and the stock. */
static void check_stock_at_rest(struct checker *c, struct stock_pair *check, int move, int step_class)
{
	struct block_finding at = finding_at_rest(&c->program, check->pair);
	struct contact contact;
	enum query_answer answer = stock_pair_stand(check, &c->program.position, c->program.next_step, &contact);

	c->end.broken_off = check->sweep.broken_off;
	if (c->end.broken_off || answer == QUERY_CLEAR)
		return;
	if (answer == QUERY_UNDECIDED) {
		say_undecided(c, check->pair);
		return;
	}
	at.finding.of.pair.certain = stock_certainty_at(check, &c->program.position, (double)c->program.next_step);
	checker_add_finding(c, &at, contact.distance > 0 ? FINDING_CLEARANCE : FINDING_START_OVERLAP, move, step_class,
			    &contact, NULL);
	if (c->options->block_clearances && check->watch.steps == STEP_ANY && !(contact.distance > 0))
		block_log_add_clearance(&c->log, c->program.block, &(struct pair_clearance){.pair = check->pair});
	stock_pair_leave_block(check, c->program.block);
}

/* The pairs to check at the current position. */
struct rest_query {
	int move;
	bool tool_only;	/* only the pairs of the tool */
	bool spindle_stops;	/* only cutters that must stay apart once the spindle has stopped */
	bool past_a_limit;
};

static bool is_looked_at(const struct checker *c, const struct rest_query *query, const struct pair_watch *watch)
{
	if (!pair_watch_is_active(watch, c->program.tool) || watch->left_block == c->program.block)
		return false;
	/* Pairs that must stay apart while the spindle turns have just been checked. */
	if (query->spindle_stops)
		return (watch->steps & STEP_FEED_STANDING) && !(watch->steps & STEP_FEED_TURNING);
	return (watch->steps & STEP_RAPID) && (!watch->past_limits_only || query->past_a_limit) &&
	       (!query->tool_only || watch->tool);
}

static void look_at_pair(struct checker *c, const struct rest_query *query, struct pair_check *check)
{
	if (is_looked_at(c, query, &check->watch))
		check_pair_at_rest(c, check, query->move, query->spindle_stops ? STEP_FEED_STANDING : 0);
}

static void look_at_stock(struct checker *c, const struct rest_query *query, struct stock_pair *check)
{
	if (is_looked_at(c, query, &check->watch))
		check_stock_at_rest(c, check, query->move, query->spindle_stops ? STEP_FEED_STANDING : 0);
}

/* Checks all pairs in the order in which their findings are reported: a check may end with the first. */
static void look_at_all(struct checker *c, const struct rest_query *query)
{
	const double start = checker_clock();
	size_t i = 0, k = 0;

	while ((i < c->scheduler.count || k < c->stock.pair_count) && !checker_has_enough(c) && !c->end.broken_off) {
		if (k == c->stock.pair_count ||
		    (i < c->scheduler.count && c->scheduler.checks[i].pair < c->stock.pairs[k].pair))
			look_at_pair(c, query, &c->scheduler.checks[i++]);
		else
			look_at_stock(c, query, &c->stock.pairs[k++]);
	}
	c->stats->seconds_check += checker_clock() - start;
}

void checker_at_rest(struct checker *c, bool tool_only, int move)
{
	const struct rest_query query = {
		.move = move, .tool_only = tool_only, .past_a_limit = is_past_a_limit(c)};

	if (checker_owns(c))
		look_at_all(c, &query);
}

void checker_spindle_stops(struct checker *c, int move)
{
	const struct rest_query query = {.move = move, .spindle_stops = true};

	if (checker_owns(c))
		look_at_all(c, &query);
}
