#include "check/batch.h"

#include <stdlib.h>

#include "base/mem.h"
#include "base/minmax.h"
#include "base/prefetch.h"
#include "geom/tolerance.h"

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

/* Plain loops over all slots, which compilers turn into instructions for several slots at once. */
static void widen(struct batch_chunk *piece, const struct motion_step *step)
{
	const struct span *span = &step->span;

	for (int i = 0; i < SLOT_COUNT; i++) {
		const double off = span->chord_error.v[i], from = span->q0.v[i], to = span->q1.v[i];

		piece->low.v[i] = smaller(piece->low.v[i], smaller(from, to) - off);
		piece->high.v[i] = larger(piece->high.v[i], larger(from, to) + off);
		piece->errors.path.v[i] = larger(piece->errors.path.v[i], step->tolerance.v[i]);
	}
	piece->beyond |= step->outside;
	piece->classes |= step->step_class;
}

static double largest(const axis_values *tolerance)
{
	double most = 0;

	for (int i = 0; i < SLOT_COUNT; i++)
		most = larger(most, tolerance->v[i]);
	return most;
}

/* The path tolerance may take a step past a limit. */
static void mark_beyond(struct batch_step *steps, size_t count, struct batch_chunk *piece)
{
	const double most = largest(&piece->errors.path);

	piece->errors.any = most > 0;
	for (size_t i = 0; i < count && most > REACH_PATH_TOLERANCE; i++)
		steps[i].beyond |= largest(&steps[i].motion.tolerance) > REACH_PATH_TOLERANCE;
	piece->beyond |= most > REACH_PATH_TOLERANCE;
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

static void fill_pieces(struct batch *batch)
{
	batch->pieces = mem_grow(batch->pieces, &batch->piece_capacity, count_of(batch, PIECE_STEPS),
				 sizeof(*batch->pieces));
	for (size_t first = 0; first < batch->step_count; first += PIECE_STEPS) {
		struct batch_chunk *piece = &batch->pieces[first / PIECE_STEPS];
		struct batch_step *steps = &batch->steps[first];
		const size_t left = batch->step_count - first, count = left < PIECE_STEPS ? left : PIECE_STEPS;

		*piece = (struct batch_chunk){.low = steps->motion.span.q0, .high = steps->motion.span.q0};
		for (size_t i = 0; i < count; i++) {
			widen(piece, &steps[i].motion);
			steps[i].beyond = steps[i].motion.outside;
		}
		mark_beyond(steps, count, piece);
	}
}

void batch_close(struct batch *batch)
{
	enum { PIECES = CHUNK_STEPS / PIECE_STEPS };

	fill_pieces(batch);
	batch->chunks = mem_grow(batch->chunks, &batch->chunk_capacity, count_of(batch, CHUNK_STEPS),
				 sizeof(*batch->chunks));
	for (size_t i = 0; i < count_of(batch, PIECE_STEPS); i++) {
		if (i % PIECES == 0)
			batch->chunks[i / PIECES] = batch->pieces[i];
		else
			widen_chunk(&batch->chunks[i / PIECES], &batch->pieces[i]);
	}
}
