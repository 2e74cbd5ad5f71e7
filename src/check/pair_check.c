#include "check/pair_check.h"

#include <math.h>
#include <stdlib.h>

#include "base/ablation.h"
#include "base/mem.h"
#include "base/minmax.h"
#include "motion/path.h"
#include "motion/span.h"
#include "scene/static_query.h"

static int tool_of(const struct scene *scene, const struct scene_pair *pair)
{
	int a = scene->bodies[pair->a].body->tool, b = scene->bodies[pair->b].body->tool;

	return a ? a : b;
}

/* At the start of a program or a tool change, only pairs that must stay apart at rapid are examined. */
static bool starts_unseen(unsigned steps)
{
	return !(steps & STEP_RAPID);
}

void pair_check_init(struct pair_check *check, struct scene *scene, size_t pair, struct pair_measuring measuring)
{
	const struct scene_pair *p = &scene->pairs[pair];

	check->scene = scene;
	check->pair = pair;
	check->watch = (struct pair_watch){.tool = tool_of(scene, p),
					   .steps = p->steps,
					   .past_limits_only = p->status == PAIR_OUT_OF_REACH,
					   .left_block = -1};
	check->unknown_block = check->nearest_block = -1;
	check->maybe_inside = starts_unseen(p->steps);
	/* The clearance of a cutter's core is not reported. */
	if (p->status != PAIR_CUTTING)
		check->measuring = measuring;
}

void pair_check_prepare(struct pair_check *check, const struct check_options *options)
{
	const struct scene_pair *p = &check->scene->pairs[check->pair];
	const struct pair_measuring *measuring = &check->measuring;
	struct body_pair bodies;

	if (check->methods)
		return;
	bodies = scene_pair_bodies(check->scene, p);
	check->methods = mem_zalloc(1, sizeof(*check->methods));
	strategy_init(&check->methods->strategy, &bodies, p->clearance, options->tolerance,
		      !(measuring->up_to > 0) ? STRATEGY_PROVES
		      : measuring->coarsely   ? STRATEGY_MEASURES_COARSELY
					      : STRATEGY_MEASURES);
	if (measuring->up_to > 0 && measuring->up_to < INFINITY)
		strategy_cap(&check->methods->strategy, p->clearance + measuring->up_to);
	sampler_init(&check->methods->sampler, &bodies, p->clearance, options->method == CHECK_INTERPOLATED,
		     options->step);
	check->methods->sampler.started = check->has_started;
	block_clearance_init(&check->methods->block, &bodies);
}

void pair_check_release(struct pair_check *check)
{
	if (check->methods) {
		strategy_release(&check->methods->strategy);
		block_clearance_release(&check->methods->block);
		sampler_release(&check->methods->sampler);
		free(check->methods);
	}
	pair_results_release(&check->results);
	free(check->clearances);
	free(check->open);
	check->methods = NULL;
	check->open = NULL;
	check->clearances = NULL;
}

void pair_check_leave_block(struct pair_check *check, long block)
{
	check->watch.left_block = block;
	check->maybe_inside = check->methods->block.maybe_inside = true;
	/* The strategy does not know of a finding at rest. */
	strategy_cap(&check->methods->strategy, check->scene->pairs[check->pair].clearance);
	strategy_forget_position(&check->methods->strategy);
}

void pair_check_change_tool(struct pair_check *check)
{
	check->maybe_inside |= starts_unseen(check->watch.steps);
	if (check->methods)
		strategy_forget_position(&check->methods->strategy);
}

void pair_check_jump(struct pair_check *check)
{
	check->maybe_inside = true;
	/* Only the first step of a program samples its start, so that the division into shards does not matter. */
	check->has_started = true;
	if (!check->methods)
		return;
	check->methods->sampler.started = true;
	strategy_forget_position(&check->methods->strategy);
}

static enum query_answer pass_step(struct pair_check *check, struct sweep *sweep, const struct motion_step *step,
				   const struct check_options *options, struct contact *contact)
{
	if (options->method == CHECK_CERTIFIED)
		return strategy_advance_step(&check->methods->strategy, sweep, step, contact);
	return sampler_step(&check->methods->sampler, sweep, step, contact) ? QUERY_CONTACT : QUERY_CLEAR;
}

/*
 * Checks a step after a contact. At its start one body may be wholly inside the other. The sweep cannot detect this,
 * because it uses only surfaces.
 */
static enum query_answer check_maybe_inside(struct pair_check *check, struct sweep *sweep,
					    const struct motion_step *step, long block,
					    const struct check_options *options, struct contact *contact)
{
	const enum query_answer answer = pass_step(check, sweep, step, options, contact);
	const bool at_start = answer == QUERY_CONTACT && !(contact->s > 0);
	enum inside inside;
	vec3 point;

	/* Surfaces near each other at the start may be those of a body inside the other: the distance is then 0. */
	if (answer == QUERY_UNDECIDED || (at_start && !(contact->distance > 0)))
		return answer;
	check->maybe_inside = at_start;
	inside = static_query_contained(check->scene, &check->scene->pairs[check->pair], &step->span.q0, &point);
	if (inside == INSIDE_UNKNOWN && !at_start && check->unknown_block < 0)
		check->unknown_block = block;
	if (inside != INSIDE_YES)
		return answer;
	*contact = (struct contact){0, step->span.q0, 0, point, 0};
	return QUERY_CONTACT;
}

/* Leaves out steps in which the bodies may meet. */
static void leave_out(struct pair_check *check)
{
	check->maybe_inside |= check->watch.steps != STEP_ANY;
	strategy_forget_position(&check->methods->strategy);
}

/* The number of steps from i on that are checked at once, as the box of this size; 0: check smaller parts. */
static size_t skip_box(struct pair_check *check, const struct batch *batch, size_t i, size_t to, enum batch_box size,
		       const struct check_options *options)
{
	const struct batch_chunk *box = batch_box_from(batch, size, i);
	const size_t steps = batch_box_steps(size), count = to - i < steps ? to - i : steps;

	if (!box)
		return 0;
	if (!pair_watch_has_any(&check->watch, box)) {
		leave_out(check);
		return count;
	}
	if (!WITH_CHUNKS || options->method != CHECK_CERTIFIED || check->maybe_inside ||
	    !strategy_advance_box(&check->methods->strategy, &box->low, &box->high, &box->errors,
				  &batch->steps[i + count - 1].motion.span.q1, count, size == BOX_CHUNK))
		return 0;
	return count;
}

/* The number of successive steps from i on that apply to the pair. */
static size_t count_alike(const struct pair_check *check, const struct batch *batch, size_t i, size_t to)
{
	size_t end = i;

	if (check->watch.steps == STEP_ANY)
		return to - i;
	while (end < to && pair_watch_has(&check->watch, &batch->steps[end]))
		end++;
	return end - i;
}

/* The number of steps from i on that were measured as clear. *next: the first of check->open that may come after i. */
static size_t skip_measured(struct pair_check *check, size_t i, size_t to, size_t *next)
{
	size_t end;

	if (!check->measured_first || check->maybe_inside)
		return 0;
	while (*next < check->open_count && check->open[*next] < i)
		++*next;
	end = *next < check->open_count && check->open[*next] < to ? check->open[*next] : to;
	if (end > i)
		strategy_forget_position(&check->methods->strategy);
	return end - i;
}

/* The number of steps from i on that need no check of their own. */
static size_t skip(struct pair_check *check, struct sweep *sweep, const struct batch *batch, size_t i, size_t to,
		   const struct check_options *options)
{
	size_t skipped = skip_box(check, batch, i, to, BOX_CHUNK, options);

	if (!skipped)
		skipped = skip_box(check, batch, i, to, BOX_PIECE, options);
	if (skipped || options->method != CHECK_CERTIFIED || check->maybe_inside || check->watch.past_limits_only ||
	    batch->steps[i].block == check->watch.left_block)
		return skipped;
	return strategy_advance_chord(&check->methods->strategy, sweep, &batch->steps[i],
				      count_alike(check, batch, i, to));
}

long pair_check_run(struct pair_check *check, struct sweep *sweep, const struct batch *batch, size_t from, size_t to,
		    const struct check_options *options)
{
	double proved = strategy_proven(&check->methods->strategy);
	size_t skipped, next_open = 0;
	long examined = 0;

	check->results.count = 0;
	check->nearest_block = -1;
	for (size_t i = from; i < to; i += skipped ? skipped : 1, examined++) {
		const struct batch_step *step = &batch->steps[i];
		struct contact contact = {0};
		enum query_answer answer;
		struct pair_result result;

		skipped = skip_measured(check, i, to, &next_open);
		if (!skipped)
			skipped = skip(check, sweep, batch, i, to, options);
		if (skipped)
			continue;

		if (step->block == check->watch.left_block || !pair_watch_has(&check->watch, step)) {
			leave_out(check);
			continue;
		}
		sweep->exhausted = false;
		if (step_is_box(&step->motion))
			strategy_limit_boxes(&check->methods->strategy,
					     open_boxes_count(&check->open_boxes, step->share));
		answer = check->maybe_inside && options->method == CHECK_CERTIFIED
				  ? check_maybe_inside(check, sweep, &step->motion, step->block, options, &contact)
				  : pass_step(check, sweep, &step->motion, options, &contact);
		if (strategy_proven(&check->methods->strategy) < proved) {
			proved = strategy_proven(&check->methods->strategy);
			check->nearest_block = step->block;
		}
		if (answer == QUERY_CLEAR)
			continue;
		result = (struct pair_result){check->pair, i, answer, sweep->exhausted, contact, false};
		pair_results_add(&check->results, &result);
		pair_check_leave_block(check, step->block);
		open_boxes_add(&check->open_boxes, &result, step);
		if (pair_result_ends(&result, batch, options))
			break;
	}
	return examined;
}

void pair_check_stand(struct pair_check *check, struct sweep *sweep, const axis_values *at)
{
	const struct path path = {.kind = PATH_STRAIGHT, .start = *at, .end = *at};
	struct motion_step still = {.line = 1};
	struct contact contact;

	span_init(&still.span, &path);
	/* The answer does not matter: the pose was already checked more exactly. */
	strategy_advance_step(&check->methods->strategy, sweep, &still, &contact);
	strategy_forget_position(&check->methods->strategy);
}
