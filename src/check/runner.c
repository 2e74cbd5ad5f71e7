#include "check/runner.h"

#include <math.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>

#include "base/ablation.h"
#include "base/mem.h"
#include "scene/overlap.h"
#include "scene/pairs.h"

static int tool_of(const struct scene *scene, const struct scene_pair *pair)
{
	int a = scene->bodies[pair->a].body->tool, b = scene->bodies[pair->b].body->tool;

	return a ? a : b;
}

static bool runner_init(struct runner *runner, struct scene *scene, size_t pair, const struct check_options *options,
			bool measure, struct diag *diag)
{
	const struct scene_pair *p = &scene->pairs[pair];
	struct body_pair bodies;

	if (!scene_pair_bodies(scene, p, &bodies, diag))
		return false;
	*runner = (struct runner){
		.pair = pair,
		.tool = tool_of(scene, p),
		.past_limits_only = p->status == PAIR_OUT_OF_REACH,
		.found_block = -1,
	};
	follower_init(&runner->follower, &bodies, p->clearance, measure);
	sampler_init(&runner->sampler, &bodies, p->clearance, options->method == CHECK_INTERPOLATED, options->step);
	return true;
}

bool runners_init(struct runners *runners, struct scene *scene, const struct check_options *options, bool measure,
		  struct diag *diag)
{
	*runners = (struct runners){.scene = scene, .threads = options->threads > 1 ? options->threads : 1};
	runners->runners = mem_zalloc(scene->pair_count, sizeof(*runners->runners));
	runners->sweeps = mem_zalloc((size_t)runners->threads, sizeof(*runners->sweeps));
	for (size_t i = 0; i < scene->pair_count; i++) {
		enum pair_status status = scene->pairs[i].status;

		if (status != PAIR_CHECKED && status != PAIR_OUT_OF_REACH)
			continue;
		if (!runner_init(&runners->runners[runners->count], scene, i, options, measure, diag))
			return false;
		runners->count++;
	}
	return true;
}

void runners_release(struct runners *runners)
{
	for (size_t i = 0; i < runners->count; i++) {
		sampler_release(&runners->runners[i].sampler);
		free(runners->runners[i].results);
	}
	for (int i = 0; i < runners->threads; i++)
		sweep_release(&runners->sweeps[i]);
	free(runners->runners);
	free(runners->sweeps);
	free(runners->results);
	*runners = (struct runners){0};
}

bool runner_is_active(const struct runner *runner, int tool)
{
	return !runner->tool || runner->tool == tool;
}

void runners_found(struct runners *runners, size_t i, long block)
{
	runners->runners[i].found_block = block;
	runners->runners[i].entangled = true;
	follower_lose(&runners->runners[i].follower);
}

void runners_change_tool(struct runners *runners)
{
	for (size_t i = 0; i < runners->count; i++)
		if (runners->runners[i].tool)
			follower_lose(&runners->runners[i].follower);
}

/* Past a limit, or where the control may go past one by its path tolerance, no pair is out of reach. */
static bool is_beyond_travel(const struct motion_step *step)
{
	for (int i = 0; i < SLOT_COUNT; i++)
		if (step->tolerance.v[i] > REACH_MARGIN)
			return true;
	return step->outside;
}

static void add_result(struct runner *runner, size_t step, enum passage passage, const struct contact *contact)
{
	runner->results = mem_grow(runner->results, &runner->result_capacity, runner->result_count + 1,
				   sizeof(*runner->results));
	runner->results[runner->result_count++] = (struct runner_result){runner->pair, step, passage, *contact};
}

/* What the threads of one batch share. */
struct crew {
	struct runners *runners;
	const struct batch *batch;
	const struct check_options *options;
	int tool;
	atomic_size_t next;
	pthread_mutex_t topology;	/* it is built when it is asked for */
};

static enum passage pass(struct runner *runner, struct sweep *sweep, const struct motion_step *step,
			 const struct check_options *options, struct contact *contact)
{
	if (options->method == CHECK_CERTIFIED)
		return follower_step(&runner->follower, sweep, step, options->tolerance, contact);
	return sampler_step(&runner->sampler, sweep, step, contact) ? PASSAGE_CONTACT : PASSAGE_CLEAR;
}

static bool is_contained(struct crew *crew, const struct runner *runner, const axis_values *q, vec3 *point)
{
	struct scene *scene = crew->runners->scene;
	struct diag nowhere = {0};	/* the meshes have been read: there is nothing to say */
	bool contained;

	pthread_mutex_lock(&crew->topology);
	contained = scene_contained(scene, &scene->pairs[runner->pair], q, point, &nowhere);
	pthread_mutex_unlock(&crew->topology);
	return contained;
}

/* A step after a contact, which may start with one body wholly inside the other: the sweep sees surfaces only. */
static enum passage pass_entangled(struct crew *crew, struct runner *runner, struct sweep *sweep,
				   const struct motion_step *step, struct contact *contact)
{
	enum passage passage = pass(runner, sweep, step, crew->options, contact);
	vec3 point;

	if (passage == PASSAGE_UNDECIDED || (passage == PASSAGE_CONTACT && !(contact->s > 0)))
		return passage;
	runner->entangled = false;
	if (!is_contained(crew, runner, &step->span.q0, &point))
		return passage;
	*contact = (struct contact){0, step->span.q0, 0, point};
	return PASSAGE_CONTACT;
}

/* Steps from i on that the pair passes as one chunk; 0: it must take them one by one. */
static size_t skip_chunk(struct runner *runner, const struct batch *batch, size_t i,
			 const struct check_options *options)
{
	size_t count = batch->step_count - i < CHUNK_STEPS ? batch->step_count - i : CHUNK_STEPS;
	const struct batch_chunk *chunk = &batch->chunks[i / CHUNK_STEPS];

	if (!WITH_CHUNKS || options->method != CHECK_CERTIFIED || runner->entangled || i % CHUNK_STEPS ||
	    !follower_skip(&runner->follower, &chunk->low, &chunk->high, &batch->steps[i + count - 1].motion.span.q1,
			   count))
		return 0;
	return count;
}

static void run_one(struct crew *crew, struct runner *runner, struct sweep *sweep)
{
	const struct check_options *options = crew->options;
	const struct batch *batch = crew->batch;
	size_t skipped;

	for (size_t i = 0; i < batch->step_count; i += skipped ? skipped : 1) {
		const struct batch_step *step = &batch->steps[i];
		struct contact contact = {0};
		enum passage passage;

		skipped = skip_chunk(runner, batch, i, options);
		if (skipped)
			continue;

		if (step->block == runner->found_block ||
		    (runner->past_limits_only && !is_beyond_travel(&step->motion))) {
			follower_lose(&runner->follower);
			continue;
		}
		passage = runner->entangled && options->method == CHECK_CERTIFIED
				  ? pass_entangled(crew, runner, sweep, &step->motion, &contact)
				  : pass(runner, sweep, &step->motion, options, &contact);
		if (passage == PASSAGE_CLEAR)
			continue;
		add_result(runner, i, passage, &contact);
		follower_lose(&runner->follower);
		if (!options->all || passage == PASSAGE_UNDECIDED)
			return;
		runner->found_block = step->block;
		runner->entangled = true;
	}
}

struct hand {
	struct crew *crew;
	struct sweep *sweep;
};

static void *work(void *context)
{
	struct hand *hand = context;
	struct crew *crew = hand->crew;
	size_t i;

	while ((i = atomic_fetch_add(&crew->next, 1)) < crew->runners->count) {
		struct runner *runner = &crew->runners->runners[i];

		runner->result_count = 0;
		if (runner_is_active(runner, crew->tool))
			run_one(crew, runner, hand->sweep);
	}
	return NULL;
}

void runners_run(struct runners *runners, const struct batch *batch, int tool, const struct check_options *options)
{
	struct crew crew = {.runners = runners,
			    .batch = batch,
			    .options = options,
			    .tool = tool,
			    .topology = PTHREAD_MUTEX_INITIALIZER};
	pthread_t *threads = mem_zalloc((size_t)runners->threads, sizeof(*threads));
	struct hand *hands = mem_zalloc((size_t)runners->threads, sizeof(*hands));
	int started = 0;

	for (int i = 0; i < runners->threads; i++)
		hands[i] = (struct hand){&crew, &runners->sweeps[i]};
	/* A thread that cannot start is no loss: the others do its share. */
	while (started < runners->threads - 1 &&
	       !pthread_create(&threads[started], NULL, work, &hands[started + 1]))
		started++;
	work(&hands[0]);
	for (int i = 0; i < started; i++)
		pthread_join(threads[i], NULL);
	pthread_mutex_destroy(&crew.topology);
	free(threads);
	free(hands);
	runners->result_count = 0;
	for (size_t i = 0; i < runners->count; i++) {
		const struct runner *runner = &runners->runners[i];

		for (size_t k = 0; k < runner->result_count; k++) {
			runners->results = mem_grow(runners->results, &runners->result_capacity,
						    runners->result_count + 1, sizeof(*runners->results));
			runners->results[runners->result_count++] = runner->results[k];
		}
	}
}

void runners_collect(const struct runners *runners, struct check_stats *stats, double *proven)
{
	for (int i = 0; i < runners->threads; i++) {
		stats->certificates += runners->sweeps[i].certificates;
		stats->bisections += runners->sweeps[i].bisections;
	}
	for (size_t i = 0; i < runners->count; i++) {
		const struct runner *runner = &runners->runners[i];

		stats->budgets += runner->follower.budgets;
		stats->queries += runner->follower.queries;
		stats->samples += runner->sampler.samples;
		if (proven)
			proven[runner->pair] = follower_proven(&runner->follower);
	}
}
