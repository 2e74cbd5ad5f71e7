#include "check/batch.h"

#include <stdlib.h>

#include "base/mem.h"
#include "base/minmax.h"
#include "base/prefetch.h"
#include "geom/tolerance.h"
#include "scene/pairs.h"

void batch_release(struct batch *batch)
{
	free(batch->steps);
	path_copies_release(&batch->paths);
	free(batch->chunks);
	free(batch->pieces);
	*batch = (struct batch){0};
}

void batch_clear(struct batch *batch)
{
	batch->step_count = 0;
	path_copies_clear(&batch->paths);
}

void batch_add(struct batch *batch, const struct motion_step *step, long block, long number,
	       long share)
{
	struct batch_step *copy;

	if (batch->step_count == batch->step_capacity)
		batch->steps = mem_grow(batch->steps, &batch->step_capacity, batch->step_count + 1,
					sizeof(*batch->steps));
	copy = &batch->steps[batch->step_count++];
	copy->motion = *step;
	copy->motion.span.path = path_copies_add(&batch->paths, &step->span);
	copy->block = block;
	copy->number = number;
	copy->share = share;
	/* A later step. Another thread has read its memory, in an earlier batch. */
	if (batch->step_count + 1 < batch->step_capacity)
		prefetch_for_writing(copy + 2, sizeof(*copy));
}

/* Slots without an axis keep the values of the first step. */
static void widen(struct batch_chunk *chunk, const struct motion_step *step, const struct machine *machine)
{
	const struct span *span = &step->span;

	for (size_t i = 0; i < machine->axis_count; i++) {
		const int slot = machine->axes[i].slot;
		const double off = span->chord_error.v[slot], from = span->q0.v[slot], to = span->q1.v[slot];

		chunk->low.v[slot] = smaller(smaller(from, to) - off, chunk->low.v[slot]);
		chunk->high.v[slot] = larger(larger(from, to) + off, chunk->high.v[slot]);
		if (step->tolerance.v[slot] > chunk->errors.path.v[slot]) {
			chunk->errors.path.v[slot] = step->tolerance.v[slot];
			chunk->errors.any = true;
		}
	}
}

static bool is_beyond_travel(const struct motion_step *step, const struct machine *machine)
{
	for (size_t i = 0; i < machine->axis_count; i++)
		if (step->tolerance.v[machine->axes[i].slot] > REACH_PATH_TOLERANCE)
			return true;
	return step->outside;
}

static void widen_chunk(struct batch_chunk *chunk, const struct batch_chunk *piece)
{
	for (int i = 0; i < SLOT_COUNT; i++) {
		chunk->low.v[i] = smaller(chunk->low.v[i], piece->low.v[i]);
		chunk->high.v[i] = larger(chunk->high.v[i], piece->high.v[i]);
		chunk->errors.path.v[i] = larger(chunk->errors.path.v[i], piece->errors.path.v[i]);
	}
	chunk->errors.any |= piece->errors.any;
	chunk->beyond |= piece->beyond;
	chunk->classes |= piece->classes;
}

static size_t count_of(const struct batch *batch, size_t steps)
{
	return (batch->step_count + steps - 1) / steps;
}

static void fill_pieces(struct batch *batch, const struct machine *machine)
{
	batch->pieces = mem_grow(batch->pieces, &batch->piece_capacity, count_of(batch, PIECE_STEPS),
				 sizeof(*batch->pieces));
	for (size_t i = 0; i < batch->step_count; i++) {
		struct batch_chunk *piece = &batch->pieces[i / PIECE_STEPS];
		struct batch_step *step = &batch->steps[i];

		if (i % PIECE_STEPS == 0)
			*piece = (struct batch_chunk){.low = step->motion.span.q0, .high = step->motion.span.q0};
		widen(piece, &step->motion, machine);
		step->beyond = is_beyond_travel(&step->motion, machine);
		piece->beyond |= step->beyond;
		piece->classes |= step->motion.step_class;
	}
}

void batch_close(struct batch *batch, const struct machine *machine)
{
	enum { PIECES = CHUNK_STEPS / PIECE_STEPS };

	fill_pieces(batch, machine);
	batch->chunks = mem_grow(batch->chunks, &batch->chunk_capacity, count_of(batch, CHUNK_STEPS),
				 sizeof(*batch->chunks));
	for (size_t i = 0; i < count_of(batch, PIECE_STEPS); i++) {
		if (i % PIECES == 0)
			batch->chunks[i / PIECES] = batch->pieces[i];
		else
			widen_chunk(&batch->chunks[i / PIECES], &batch->pieces[i]);
	}
}
