#include "check/stock_pair.h"

#include <math.h>

#include "base/minmax.h"
#include "check/step.h"
#include "motion/path.h"

/* Shares of the stock's tolerance: the motion that counts as one instant, and the least distance worth a budget. */
#define LEAST_WAY_SHARE 0.0625
#define MARGIN_SHARE 0.0625

/* The cost of a cell in node pairs, the unit of check_options.effort. */
#define CELL_EFFORT 8

/* mm: larger distances are treated alike. */
#define FAR 1e6

/* A budget that covers less than half of the rest of a step is not used: a sweep does this better. */
#define SHARE_HALVINGS 2

/* Cells reach beyond the blank, and the blank beyond its mesh: bounds of motion count these points, too. */
static void enlarge_stock(struct body_pair *bodies, bool stock_is_a, double by)
{
	struct ball *ball = stock_is_a ? &bodies->ball_a : &bodies->ball_b;

	ball->radius += by;
}

static bool init_obstacle(struct stock_pair *check, struct scene *scene, int body, struct diag *diag)
{
	const struct body *it = scene->bodies[body].body;

	check->obstacle = (struct obstacle){
		.bvh = scene_body_bvh(scene, body),
		.inset = scene->pairs[check->pair].inset,
	};
	if (it->profile) {
		revolved_init(&check->revolved, it->profile);
		check->obstacle.revolved = &check->revolved;
		return true;
	}
	check->obstacle.topology = scene_body_topology(scene, body);
	check->open = topology_is_open(check->obstacle.topology);
	/* The surface of an open body has no depth. */
	if (check->open && check->obstacle.inset > 0) {
		diag_error(diag, it->loc,
			   "the mesh of '%s' is not closed, so its depth in the stock is undefined; close the mesh, or "
			   "give sections",
			   it->name);
		return false;
	}
	return true;
}

bool stock_pair_init(struct stock_pair *check, struct scene *scene, size_t pair, struct stock_cells *cells,
		     double tolerance, const struct check_options *options, const struct cancel *cancel,
		     struct diag *diag)
{
	const struct scene_pair *p = &scene->pairs[pair];
	const bool stock_is_a = scene->bodies[p->a].body->role == ROLE_STOCK;
	const int body = stock_is_a ? p->b : p->a;

	*check = (struct stock_pair){
		.pair = pair,
		.watch = {.tool = scene->bodies[body].body->tool,
			  .steps = p->steps,
			  .past_limits_only = p->status == PAIR_OUT_OF_REACH,
			  .left_block = -1},
		.feeds_too = (p->steps & STEP_FEED_TURNING) && scene->bodies[body].body->role == ROLE_CUTTER,
		.unknown_block = -1,
		.margin = MARGIN_SHARE * tolerance,
		.effort = (options->effort ? options->effort : CHECK_EFFORT) / CELL_EFFORT,
	};
	check->bodies = scene_pair_bodies(scene, p);
	if (!init_obstacle(check, scene, body, diag))
		return false;
	enlarge_stock(&check->bodies, stock_is_a, cells->blank.uncertainty + 2 * stock_cells_radius(cells));
	check->sweep = (struct stock_sweep){
		.cells = cells,
		.bodies = &check->bodies,
		.stock_is_a = stock_is_a,
		.obstacle = &check->obstacle,
		.clearance = p->clearance,
		.least_way = LEAST_WAY_SHARE * tolerance,
		.effort = check->effort,
		.cancel = cancel,
	};
	motion_budget_init(&check->budget, &p->chain);
	return true;
}

void stock_pair_release(struct stock_pair *check)
{
	revolved_release(&check->revolved);
	pair_results_release(&check->results);
}

void stock_pair_leave_block(struct stock_pair *check, long block)
{
	check->watch.left_block = block;
	check->clear_at_end = false;
}

enum query_answer stock_pair_sweep(struct stock_pair *check, struct stock_sweep *sweep, const struct motion_step *step,
				   long number, struct contact *contact)
{
	const struct span *span = &step->span;
	struct chord chord = {span->q0, span->q1, span->chord_error, NULL, NULL, span->u0, span->u1, NULL};
	axis_values low, high;

	check->asked = true;
	if (step_is_box(step)) {
		step_box(step, &low, &high);
		for (int i = 0; i < SLOT_COUNT; i++) {
			low.v[i] -= step->tolerance.v[i];
			high.v[i] += step->tolerance.v[i];
		}
		return query_answer_of(stock_sweep_box(sweep, &low, &high, (double)number, contact));
	}
	if (step_may_leave_path(check->bodies.chain, step))
		chord.tolerance = &step->tolerance;
	if (span->path->kind != PATH_STRAIGHT) {
		chord.curve = span->path;
		chord.halve = clearance_query_halve;
	}
	return query_answer_of(stock_sweep_chord(sweep, &chord, (double)number, contact));
}

/* The part of a motion that a budget has to cover: from `low` to `high`. */
struct coverage {
	axis_values low, high;
	const struct position_errors *errors;
};

/* mm: the room that a budget beginning at the state needs for this part. */
static double room_for(struct stock_pair *check, const axis_values *q, const struct chain_state *state,
		       const struct coverage *coverage)
{
	struct motion_budget budget = check->budget;

	motion_budget_set(&budget, q, state, FAR);
	return FAR - motion_budget_rest(&budget, &coverage->low, &coverage->high, coverage->errors);
}

/*
 * Proves a distance at q, at this time, and begins a budget with it. False: the distance is too small for the coverage.
 */
static bool start_budget(struct stock_pair *check, const axis_values *q, double time, const struct coverage *coverage)
{
	const struct body_pair *bodies = &check->bodies;
	const struct placed_obstacle placed = stock_sweep_place(&check->sweep, q);
	const double needed = check->sweep.clearance + check->sweep.least_way + check->margin +
			      body_pair_rounding(bodies, q, placed.to_obstacle.translation);
	struct distance_query query = {.enough = FAR, .share = 1};
	struct chain_state state;
	double room;

	check->queries++;
	check->asked = true;
	chain_state_init(&state, bodies->chain, q, &bodies->ball_a, &bodies->ball_b);
	query.least = needed + larger(check->margin, room_for(check, q, &state, coverage));
	room = stock_cells_distance(check->sweep.cells, &placed, time, &query) - needed;
	if (!(room > query.least - needed))
		return false;
	motion_budget_set(&check->budget, q, &state, room);
	return true;
}

/* The least part of a step, from s on, that a budget has to cover. */
static struct coverage least_part(const struct motion_step *step, const struct position_errors *errors, double s)
{
	const double end = s + (1 - s) / (1 << (SHARE_HALVINGS - 1));
	struct motion_step part = *step;
	struct coverage coverage = {.errors = errors};

	part.span.q0 = axis_values_between(&step->span.q0, &step->span.q1, s);
	part.span.q1 = axis_values_between(&step->span.q0, &step->span.q1, end);
	step_box(&part, &coverage.low, &coverage.high);
	return coverage;
}

/* Advances from s as far along the step as the budget covers. False: not far enough to matter. */
static bool go_on(struct stock_pair *check, const struct span *span, const struct position_errors *errors, double *s)
{
	double length = 1 - *s;

	for (int i = 0; i < SHARE_HALVINGS; i++) {
		const axis_values q = axis_values_between(&span->q0, &span->q1, *s + length);

		if (motion_budget_covers(&check->budget, &q, errors)) {
			*s += length;
			return true;
		}
		length /= 2;
	}
	return false;
}

/* Does the current budget cover the step? */
static bool advance_by_budget(struct stock_pair *check, const struct motion_step *step)
{
	const struct position_errors errors = step_errors(check->bodies.chain, step);

	motion_budget_resume(&check->budget, &step->span.q0);
	return motion_budget_covers(&check->budget, &step->span.q1, &errors);
}

/* Advances by new budgets only: conservative advancement. False: nothing is proved. */
static bool advance(struct stock_pair *check, const struct motion_step *step, long number)
{
	const struct position_errors errors = step_errors(check->bodies.chain, step);
	double s = 0;

	while (s < 1) {
		const axis_values q = axis_values_between(&step->span.q0, &step->span.q1, s);
		const struct coverage coverage = least_part(step, &errors, s);

		if (check->sweep.broken_off || !start_budget(check, &q, (double)number + s, &coverage) ||
		    !go_on(check, &step->span, &errors, &s))
			return false;
	}
	return true;
}

static bool advance_box(struct stock_pair *check, const struct motion_step *step, long number)
{
	const struct position_errors errors = step_errors(check->bodies.chain, step);
	struct coverage box = {.errors = &errors};

	step_box(step, &box.low, &box.high);
	return motion_budget_covers_box(&check->budget, &box.low, &box.high, &step->span.q1, &errors) ||
	       (start_budget(check, &step->span.q0, (double)number, &box) &&
		motion_budget_covers_box(&check->budget, &box.low, &box.high, &step->span.q1, &errors));
}

static enum query_answer pass_step(struct stock_pair *check, const struct motion_step *step, long number,
				   struct contact *contact)
{
	const struct chain *chain = check->bodies.chain;
	enum query_answer answer = QUERY_CLEAR;

	if (check->clear_at_end && !step_moves(chain, step) && !step_may_leave_path(chain, step))
		return QUERY_CLEAR;
	if (step_is_box(step) ? advance_box(check, step, number)
			      : advance_by_budget(check, step) || advance(check, step, number))
		check->covered_steps++;
	else
		answer = stock_pair_sweep(check, &check->sweep, step, number, contact);
	check->clear_at_end = answer == QUERY_CLEAR;
	return answer;
}

/* The number of steps from i on that need no check; 0: step i needs one. */
static size_t skip_chunk(struct stock_pair *check, const struct batch *batch, size_t i, size_t to)
{
	const size_t count = to - i < CHUNK_STEPS ? to - i : CHUNK_STEPS;
	const struct batch_chunk *chunk = &batch->chunks[i / CHUNK_STEPS];

	if (i % CHUNK_STEPS)
		return 0;
	if (!pair_watch_has_any(&check->watch, chunk)) {
		check->clear_at_end = false;
		return count;
	}
	if (!motion_budget_covers_box(&check->budget, &chunk->low, &chunk->high,
				      &batch->steps[i + count - 1].motion.span.q1, &chunk->errors))
		return 0;
	check->clear_at_end = true;
	check->covered_steps += (long)count;
	return count;
}

void stock_pair_run(struct stock_pair *check, const struct batch *batch, size_t to,
		    const struct check_options *options)
{
	size_t skipped;

	check->results.count = 0;
	for (size_t i = 0; i < to; i += skipped ? skipped : 1) {
		const struct batch_step *step = &batch->steps[i];
		struct contact contact = {0};
		enum query_answer answer;
		struct pair_result result;

		skipped = skip_chunk(check, batch, i, to);
		if (skipped)
			continue;
		if (step->block == check->watch.left_block || !pair_watch_has(&check->watch, step)) {
			check->clear_at_end = false;
			continue;
		}
		check->sweep.exhausted = false;
		check->sweep.effort = check->effort;
		if (step_is_box(&step->motion))
			check->sweep.effort >>= open_boxes_count(&check->open_boxes, step->share);
		answer = pass_step(check, &step->motion, step->number, &contact);
		if (check->open && check->asked && check->unknown_block < 0)
			check->unknown_block = step->block;
		if (answer == QUERY_CLEAR)
			continue;
		result = (struct pair_result){check->pair, i, answer, check->sweep.exhausted, contact, false};
		pair_results_add(&check->results, &result);
		stock_pair_leave_block(check, step->block);
		open_boxes_add(&check->open_boxes, &result, step);
		if (pair_result_ends(&result, batch, options))
			return;
	}
}

enum query_answer stock_pair_stand(struct stock_pair *check, const axis_values *q, long number,
				   struct contact *contact)
{
	const struct chord still = {.q0 = *q, .q1 = *q};

	check->asked = true;
	check->sweep.exhausted = false;
	return query_answer_of(stock_sweep_chord(&check->sweep, &still, (double)number, contact));
}
