#include "check/stock_check.h"

#include <math.h>
#include <stdlib.h>

#include "base/mem.h"
#include "base/minmax.h"
#include "check/step.h"
#include "check/stock_certainty.h"
#include "geom/tolerance.h"
#include "motion/path.h"
#include "stock/cutting.h"

/* Shares of the stock's tolerance: the edge of the smallest cells, and the chord error of logged paths. */
#define EDGE_SHARE 0.25
#define CUT_SHARE 0.0625

/* ------------------------------------------------------------------ start */

/* Why these options are not possible with stock; NULL: they are possible. */
static const char *unsupported(const struct check_options *options)
{
	if (options->method != CHECK_CERTIFIED)
		return "the sampled methods do not support stock; remove <stock>, or use --method=certified";
	return NULL;
}

static bool init_cells(struct stock_check *check, struct scene *scene, int stock, double tolerance, struct diag *diag)
{
	const struct body *body = scene->bodies[stock].body;
	const struct blank blank = {
		.bvh = scene_body_bvh(scene, stock),
		.topology = scene_body_topology(scene, stock),
		.uncertainty = body->uncertainty,
		.excess = body->excess,
	};
	vec3 half;

	if (topology_is_open(blank.topology)) {
		diag_error(diag, body->loc,
			   "the mesh of the stock '%s' is not closed, so its inside is undefined; close the mesh",
			   body->name);
		return false;
	}
	half = vec3_add(blank.bvh->half, (vec3){blank.uncertainty, blank.uncertainty, blank.uncertainty});
	check->low = vec3_sub(blank.bvh->origin, half);
	check->high = vec3_add(blank.bvh->origin, half);
	stock_cells_init(&check->cells, &blank, &check->log, EDGE_SHARE * tolerance);
	return true;
}

/* A cutter comes after the stock in the scene, so the stock is body a of their pair. */
static void add_tool(struct stock_check *check, struct scene *scene, const struct scene_pair *pair)
{
	const struct body *cutter = scene->bodies[pair->b].body;
	struct stock_tool *tool = &check->tools[check->tool_count];

	if (cutter->role != ROLE_CUTTER)
		return;
	tool->bodies = scene_pair_bodies(scene, pair);
	tool->tool = cutter->tool;
	tool->surely = cutter->profile && setup_tool(scene->setup, cutter->tool)->kind == TOOL_TURNS;
	if (tool->surely)
		cutter_init(&check->cutters[check->tool_count], cutter->profile);
	check->tool_count++;
}

static bool init_pairs(struct stock_check *check, struct scene *scene, const struct check_options *options,
		       const struct cancel *cancel, double tolerance, struct diag *diag)
{
	check->pairs = mem_zalloc(scene->pair_count, sizeof(*check->pairs));
	check->cutters = mem_zalloc(scene->body_count, sizeof(*check->cutters));
	if (options->block_clearances)
		check->clearances = mem_zalloc(scene->pair_count, sizeof(*check->clearances));
	check->tools = mem_zalloc(scene->body_count, sizeof(*check->tools));
	cut_log_init(&check->log, check->cutters);
	for (size_t i = 0; i < scene->pair_count; i++) {
		const struct scene_pair *pair = &scene->pairs[i];

		if (!pair->stock)
			continue;
		add_tool(check, scene, pair);
		if (!scene_pair_needs_check(pair))
			continue;
		if (!stock_pair_init(&check->pairs[check->pair_count], scene, i, &check->cells, tolerance, options,
				     cancel, diag))
			return false;
		if (check->clearances)
			stock_clearance_init(&check->clearances[check->pair_count], &check->pairs[check->pair_count],
					     options->block_clearance_cap);
		check->pair_count++;
	}
	return true;
}

bool stock_check_init(struct stock_check *check, struct scene *scene, const struct check_options *options,
		      const struct cancel *cancel, struct diag *diag)
{
	const double tolerance = options->stock_tolerance > 0 ? options->stock_tolerance : STOCK_TOLERANCE;
	const int stock = scene_stock(scene);
	const char *fault;

	*check = (struct stock_check){.chord_error = CUT_SHARE * tolerance};
	if (stock < 0 || options->method == CHECK_NOTHING)
		return true;
	fault = unsupported(options);
	if (fault) {
		diag_error(diag, scene->bodies[stock].body->loc, "%s", fault);
		return false;
	}
	return init_cells(check, scene, stock, tolerance, diag) &&
	       init_pairs(check, scene, options, cancel, tolerance, diag);
}

void stock_check_release(struct stock_check *check)
{
	for (size_t i = 0; i < check->pair_count; i++)
		stock_pair_release(&check->pairs[i]);
	for (size_t i = 0; check->clearances && i < check->pair_count; i++)
		stock_clearance_release(&check->clearances[i]);
	for (size_t i = 0; i < check->tool_count; i++)
		cutter_release(&check->cutters[i]);
	free(check->pairs);
	free(check->clearances);
	free(check->cutters);
	free(check->tools);
	pair_results_release(&check->results);
	cut_log_release(&check->log);
	stock_cells_release(&check->cells);
	*check = (struct stock_check){.pair_count = 0};
}

/* -------------------------------------------------------------------- log */

static void log_piece(struct stock_check *check, size_t tool, const struct motion_step *step, const struct span *piece,
		      double from, double to)
{
	const struct cutting cutting = {
		.bodies = &check->tools[tool].bodies,
		.cutter = (int)tool,
		.chord = {.q0 = piece->q0, .q1 = piece->q1, .chord_error = piece->chord_error,
			  .tolerance = &step->tolerance},
		.from = from,
		.to = to,
		.chord_error = check->chord_error,
		.low = check->low,
		.high = check->high,
	};

	if (check->tools[tool].surely && !step->bounded && !step_is_box(step))
		cutting_log(&cutting, &check->log);
	else
		cutting_log_region(&cutting, &check->log);
}

void stock_check_log(struct stock_check *check, const struct motion_step *step, long number)
{
	const double length = step->span.u1 - step->span.u0;
	struct span_walk walk;
	struct span piece;
	size_t tool = 0;

	while (tool < check->tool_count && check->tools[tool].tool != step->tool)
		tool++;
	if (tool == check->tool_count || step->step_class != STEP_FEED_TURNING)
		return;
	if (step->span.path->kind == PATH_STRAIGHT || step->bounded || step_is_box(step) || !(length > 0)) {
		log_piece(check, tool, step, &step->span, (double)number, (double)number + 1);
		return;
	}
	/* Far from all bodies, the steps of curved moves are coarse. */
	span_walk_init(&walk, &step->span, check->chord_error);
	while (span_walk_next(&walk, &piece))
		log_piece(check, tool, step, &piece, (double)number + (piece.u0 - step->span.u0) / length,
			  (double)number + (piece.u1 - step->span.u0) / length);
}

int stock_check_fault(const struct stock_check *check)
{
	return cut_log_fault(&check->log);
}

/* ------------------------------------------------------------------ check */

void stock_check_jump(struct stock_check *check)
{
	for (size_t i = 0; i < check->pair_count; i++)
		check->pairs[i].clear_at_end = false;
}

static void add_results(struct stock_check *check, struct stock_pair *pair, const struct batch *batch)
{
	const size_t before = check->results.count;

	pair_results_append(&check->results, &pair->results);
	for (size_t i = before; i < check->results.count; i++) {
		struct pair_result *result = &check->results.items[i];

		result->certain = result->answer == QUERY_CONTACT &&
				  stock_certainty_from(pair, batch, result->step, result->contact.s);
	}
}

bool stock_check_run(struct stock_check *check, const struct batch *batch, size_t last, int tool,
		     const struct check_options *options)
{
	check->results.count = 0;
	for (size_t i = 0; i < check->pair_count; i++) {
		struct stock_pair *pair = &check->pairs[i];

		if (!pair_watch_is_active(&pair->watch, tool))
			continue;
		stock_pair_run(pair, batch, last + 1, options);
		if (pair->sweep.broken_off)
			return false;
		add_results(check, pair, batch);
		/* Nothing after a result that ends the check matters. */
		if (pair->results.count &&
		    pair_result_ends(&pair->results.items[pair->results.count - 1], batch, options))
			last = pair->results.items[pair->results.count - 1].step;
	}
	return true;
}

bool stock_check_measure(struct stock_check *check, const struct batch *batch, int tool)
{
	bool complete = true;

	for (size_t i = 0; i < check->pair_count && complete; i++) {
		check->clearances[i].block_count = 0;
		if (pair_watch_is_active(&check->pairs[i].watch, tool))
			complete = stock_clearance_measure(&check->clearances[i], batch);
	}
	return complete;
}

void stock_check_collect(const struct stock_check *check, const struct scene *scene, long last_block,
			 struct check_stats *stats, double *proven)
{
	for (size_t i = 0; i < check->pair_count; i++) {
		const struct stock_pair *pair = &check->pairs[i];

		stats->budgets += pair->covered_steps;
		stats->queries += pair->queries;
		if (pair->unknown_block >= 0 && pair->unknown_block <= last_block) {
			if (!stats->pairs_unknown)
				stats->first_unknown = pair->pair;
			stats->pairs_unknown++;
		}
		if (proven && pair->asked)
			proven[pair->pair] = scene->pairs[pair->pair].clearance;
	}
}

/* The largest number of chunks of the log examined for one cube size of --stock-out: some seconds. */
#define REMAINDER_EFFORT 1000000

void stock_check_remainder(struct stock_check *check, long number, struct stock_remainder *remainder)
{
	if (!check->cells.group_count)
		return;
	stock_remainder_build(&check->cells, (double)number, REMAINDER_EFFORT, remainder);
	remainder->known = !stock_check_fault(check);
}

void stock_check_view(struct stock_check *check, long number, struct stock_view *view)
{
	if (!view->most || !check->cells.group_count)
		return;
	view->time = smaller(view->time, (double)number);
	stock_view_build(&check->cells, view);
	if (!stock_check_fault(check))
		return;
	/* Cuts are missing. */
	mesh_release(&view->mesh);
	view->cut = false;
}
