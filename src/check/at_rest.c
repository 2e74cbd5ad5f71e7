#include "check/at_rest.h"

#include "check/stock_certainty.h"
#include "scene/static_query.h"

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
	checker_add_finding(c, &at, state == POSE_OVERLAP ? FINDING_START_OVERLAP : FINDING_CLEARANCE, move, step_class,
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
	checker_add_finding(c, &at, contact.distance > 0 ? FINDING_CLEARANCE : FINDING_START_OVERLAP, move, step_class,
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
