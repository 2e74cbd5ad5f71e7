#include "check/batch.h"

#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "scene/pairs.h"

void batch_release(struct batch *batch)
{
	free(batch->steps);
	free(batch->paths);
	free(batch->path_tcp);
	free(batch->tcps);
	free(batch->chunks);
	*batch = (struct batch){0};
}

void batch_clear(struct batch *batch)
{
	batch->step_count = batch->path_count = batch->tcp_count = 0;
}

static void add_path(struct batch *batch, const struct path *path)
{
	batch->paths = mem_grow(batch->paths, &batch->path_capacity, batch->path_count + 1, sizeof(*batch->paths));
	batch->path_tcp = mem_grow(batch->path_tcp, &batch->path_tcp_capacity, batch->path_count + 1,
				   sizeof(*batch->path_tcp));
	/* NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): of two that differ in padding alone both are kept. */
	if (path->tcp && (!batch->tcp_count || memcmp(&batch->tcps[batch->tcp_count - 1], path->tcp, sizeof(*path->tcp)))) {
		batch->tcps = mem_grow(batch->tcps, &batch->tcp_capacity, batch->tcp_count + 1, sizeof(*batch->tcps));
		memcpy(&batch->tcps[batch->tcp_count++], path->tcp, sizeof(*path->tcp));
	}
	batch->path_tcp[batch->path_count] = batch->tcp_count ? batch->tcp_count - 1 : 0;
	batch->paths[batch->path_count++] = *path;
}

void batch_add(struct batch *batch, const struct motion_step *step, long block)
{
	struct batch_step *copy;
	bool same_path = step->span.u0 > 0 && batch->step_count > 0;

	if (!same_path)
		add_path(batch, step->span.path);
	batch->steps = mem_grow(batch->steps, &batch->step_capacity, batch->step_count + 1, sizeof(*batch->steps));
	copy = &batch->steps[batch->step_count++];
	copy->motion = *step;
	copy->path = batch->path_count - 1;
	copy->block = block;
}

static void widen(struct batch_chunk *chunk, const struct motion_step *step)
{
	const struct span *span = &step->span;

	for (int i = 0; i < SLOT_COUNT; i++) {
		double off = span->deviation.v[i];
		double least = span->q0.v[i] < span->q1.v[i] ? span->q0.v[i] : span->q1.v[i];
		double most = span->q0.v[i] < span->q1.v[i] ? span->q1.v[i] : span->q0.v[i];

		if (least - off < chunk->low.v[i])
			chunk->low.v[i] = least - off;
		if (most + off > chunk->high.v[i])
			chunk->high.v[i] = most + off;
		if (step->tolerance.v[i] > chunk->errors.path.v[i]) {
			chunk->errors.path.v[i] = step->tolerance.v[i];
			chunk->errors.any = true;
		}
	}
}

static bool is_beyond_travel(const struct motion_step *step)
{
	for (int i = 0; i < SLOT_COUNT; i++)
		if (step->tolerance.v[i] > REACH_MARGIN)
			return true;
	return step->outside;
}

static void sum_up_chunks(struct batch *batch)
{
	size_t count = (batch->step_count + CHUNK_STEPS - 1) / CHUNK_STEPS;

	batch->chunks = mem_grow(batch->chunks, &batch->chunk_capacity, count, sizeof(*batch->chunks));
	for (size_t i = 0; i < batch->step_count; i++) {
		struct batch_chunk *chunk = &batch->chunks[i / CHUNK_STEPS];
		struct batch_step *step = &batch->steps[i];

		if (i % CHUNK_STEPS == 0)
			*chunk = (struct batch_chunk){.low = step->motion.span.q0, .high = step->motion.span.q0};
		widen(chunk, &step->motion);
		step->beyond = is_beyond_travel(&step->motion);
		chunk->beyond |= step->beyond;
	}
}

void batch_settle(struct batch *batch)
{
	for (size_t i = 0; i < batch->path_count; i++)
		if (batch->paths[i].tcp)
			batch->paths[i].tcp = &batch->tcps[batch->path_tcp[i]];
	for (size_t i = 0; i < batch->step_count; i++)
		batch->steps[i].motion.span.path = &batch->paths[batch->steps[i].path];
}

void batch_close(struct batch *batch)
{
	sum_up_chunks(batch);
	batch_settle(batch);
}
