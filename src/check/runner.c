#include "check/runner.h"

#include <stdlib.h>

#include "base/ablation.h"
#include "base/mem.h"
#include "motion/path.h"
#include "motion/span.h"
#include "scene/static_query.h"

static int tool_of(const struct scene *scene, const struct scene_pair *pair)
{
	int a = scene->bodies[pair->a].body->tool, b = scene->bodies[pair->b].body->tool;

	return a ? a : b;
}

bool runner_init(struct runner *runner, struct scene *scene, size_t pair, const struct check_options *options,
		 bool measure, struct diag *diag)
{
	const struct scene_pair *p = &scene->pairs[pair];
	struct body_pair bodies;

	if (!scene_pair_bodies(scene, p, &bodies, diag))
		return false;
	*runner = (struct runner){
		.scene = scene,
		.pair = pair,
		.tool = tool_of(scene, p),
		.past_limits_only = p->status == PAIR_OUT_OF_REACH,
		.found_block = -1,
		.unknown_block = -1,
	};
	follower_init(&runner->follower, &bodies, p->clearance, options->tolerance, measure);
	if (measure && options->measure_cap > 0)
		follower_cap(&runner->follower, p->clearance + options->measure_cap);
	sampler_init(&runner->sampler, &bodies, p->clearance, options->method == CHECK_INTERPOLATED, options->step);
	gauge_init(&runner->gauge, &bodies, options->gauge_cap);
	return true;
}

void runner_release(struct runner *runner)
{
	sampler_release(&runner->sampler);
	free(runner->results);
	free(runner->rooms);
	runner->results = NULL;
	runner->rooms = NULL;
}

bool runner_is_active(const struct runner *runner, int tool)
{
	return !runner->tool || runner->tool == tool;
}

void runner_found(struct runner *runner, long block)
{
	runner->found_block = block;
	runner->entangled = runner->gauge.entangled = true;
	follower_lose(&runner->follower);
}

void runner_jump(struct runner *runner)
{
	runner->entangled = true;
	/* The samples of a program are the same whoever takes them: only its start has one of its own. */
	runner->sampler.started = true;
	follower_lose(&runner->follower);
}

static void add_result(struct runner *runner, size_t step, enum passage passage, const struct contact *contact)
{
	runner->results = mem_grow(runner->results, &runner->result_capacity, runner->result_count + 1,
				   sizeof(*runner->results));
	runner->results[runner->result_count++] = (struct runner_result){runner->pair, step, passage, *contact};
}

static enum passage pass(struct runner *runner, struct sweep *sweep, const struct motion_step *step,
			 const struct check_options *options, struct contact *contact)
{
	if (options->method == CHECK_CERTIFIED)
		return follower_step(&runner->follower, sweep, step, contact);
	return sampler_step(&runner->sampler, sweep, step, contact) ? PASSAGE_CONTACT : PASSAGE_CLEAR;
}

/* A step after a contact, which may start with one body wholly inside the other: the sweep sees surfaces only. */
static enum passage pass_entangled(struct runner *runner, struct sweep *sweep, const struct motion_step *step,
				   long block, const struct check_options *options, struct contact *contact)
{
	enum passage passage = pass(runner, sweep, step, options, contact);
	struct diag unheard = {0};	/* the meshes have been read: there is nothing to say */
	enum inside inside;
	vec3 point;

	if (passage == PASSAGE_UNDECIDED || (passage == PASSAGE_CONTACT && !(contact->s > 0)))
		return passage;
	runner->entangled = false;
	inside = static_query_contained(runner->scene, &runner->scene->pairs[runner->pair], &step->span.q0, &point, &unheard);
	if (inside == INSIDE_UNKNOWN && runner->unknown_block < 0)
		runner->unknown_block = block;
	if (inside != INSIDE_YES)
		return passage;
	*contact = (struct contact){0, step->span.q0, 0, point, 0};
	return PASSAGE_CONTACT;
}

/* Steps from i on that the pair passes as one chunk; 0: it must take them one by one. */
static size_t skip_chunk(struct runner *runner, const struct batch *batch, size_t i, size_t to,
			 const struct check_options *options)
{
	size_t count = to - i < CHUNK_STEPS ? to - i : CHUNK_STEPS;
	const struct batch_chunk *chunk = &batch->chunks[i / CHUNK_STEPS];

	if (i % CHUNK_STEPS)
		return 0;
	if (runner->past_limits_only && !chunk->beyond) {
		follower_lose(&runner->follower);
		return count;
	}
	if (!WITH_CHUNKS || options->method != CHECK_CERTIFIED || runner->entangled ||
	    !follower_skip(&runner->follower, &chunk->low, &chunk->high, &chunk->errors,
			   &batch->steps[i + count - 1].motion.span.q1, count))
		return 0;
	return count;
}

/* Steps from i on that nothing has to be asked of one by one. */
static size_t skip(struct runner *runner, struct sweep *sweep, const struct batch *batch, size_t i, size_t to,
		   const struct check_options *options)
{
	size_t skipped = skip_chunk(runner, batch, i, to, options);

	if (skipped || options->method != CHECK_CERTIFIED || runner->entangled || runner->past_limits_only ||
	    batch->steps[i].block == runner->found_block)
		return skipped;
	return follower_leap(&runner->follower, sweep, &batch->steps[i], to - i);
}

void runner_run(struct runner *runner, struct sweep *sweep, const struct batch *batch, size_t from, size_t to,
		const struct check_options *options)
{
	size_t skipped;

	runner->result_count = 0;
	for (size_t i = from; i < to; i += skipped ? skipped : 1) {
		const struct batch_step *step = &batch->steps[i];
		struct contact contact = {0};
		enum passage passage;

		skipped = skip(runner, sweep, batch, i, to, options);
		if (skipped)
			continue;

		if (step->block == runner->found_block ||
		    (runner->past_limits_only && !step->beyond)) {
			follower_lose(&runner->follower);
			continue;
		}
		passage = runner->entangled && options->method == CHECK_CERTIFIED
				  ? pass_entangled(runner, sweep, &step->motion, step->block, options, &contact)
				  : pass(runner, sweep, &step->motion, options, &contact);
		if (passage == PASSAGE_CLEAR)
			continue;
		add_result(runner, i, passage, &contact);
		if (!options->all || passage == PASSAGE_UNDECIDED) {
			follower_lose(&runner->follower);
			return;
		}
		runner_found(runner, step->block);
	}
}

void runner_stand(struct runner *runner, struct sweep *sweep, const axis_values *at)
{
	const struct path path = {.kind = PATH_STRAIGHT, .start = *at, .end = *at};
	struct motion_step still = {.line = 1};
	struct contact contact;

	span_init(&still.span, &path);
	/* Clear or not: it was looked at before, more exactly. */
	follower_step(&runner->follower, sweep, &still, &contact);
	follower_lose(&runner->follower);
}

/* The gauge's room for the step's block. */
static void start_room(struct runner *runner, long block)
{
	if (runner->room_count && runner->rooms[runner->room_count - 1].block == block)
		return;
	runner->rooms = mem_grow(runner->rooms, &runner->room_capacity, runner->room_count + 1, sizeof(*runner->rooms));
	runner->rooms[runner->room_count++] = (struct runner_room){block, runner->gauge.cap};
	gauge_start(&runner->gauge);
}

/* The gauge sees surfaces only: as long as one body may be wholly inside the other, it has to be looked at. */
static void gauge_entangled(struct runner *runner, const struct motion_step *step)
{
	struct gauge *gauge = &runner->gauge;
	struct diag unheard = {0};	/* the meshes have been read: there is nothing to say */
	vec3 point;

	gauge->entangled = !(gauge->bound > 0);
	if (!gauge->entangled && static_query_contained(runner->scene, &runner->scene->pairs[runner->pair], &step->span.q0,
						 &point, &unheard) == INSIDE_YES) {
		gauge->bound = 0;
		gauge->entangled = true;
	}
}

void runner_gauge(struct runner *runner, struct sweep *sweep, const struct batch *batch,
		  const struct check_options *options)
{
	struct gauge *gauge = &runner->gauge;
	bool clears = false;

	runner->room_count = 0;
	for (size_t i = 0; i < batch->step_count; i++) {
		const struct batch_step *step = &batch->steps[i];
		const struct batch_chunk *chunk = &batch->chunks[i / CHUNK_STEPS];

		if (i % CHUNK_STEPS == 0)
			clears = gauge_clears(gauge, &chunk->low, &chunk->high, &chunk->errors);
		if (runner->past_limits_only && !step->beyond)
			continue;
		start_room(runner, step->block);
		if (!clears)
			gauge_step(gauge, sweep, &step->motion, options->tolerance);
		if (gauge->entangled || !(gauge->bound > 0))
			gauge_entangled(runner, &step->motion);
		runner->rooms[runner->room_count - 1].clearance = gauge->bound;
	}
}
