#include "motion/span.h"

#include <math.h>

void span_init(struct span *whole, const struct path *path)
{
	const axis_values start = path_position(path, 0);

	span_init_from(whole, path, &start);
}

void span_init_curved(struct span *whole, const struct path *path)
{
	whole->q1 = path_position(path, 1);
	whole->chord_error = path_chord_error(path, 0, 1);
}

void span_halve(const struct span *span, struct span *first, struct span *second)
{
	const struct path *path = span->path;
	struct span early = *span, late = *span;
	double middle = 0.5 * (span->u0 + span->u1);
	axis_values q;

	if (path_is_straight(path)) {
		for (int slot = 0; slot < SLOT_COUNT; slot++)
			q.v[slot] = 0.5 * (span->q0.v[slot] + span->q1.v[slot]);
	} else {
		q = path_position(path, middle);
		early.chord_error = path_chord_error(path, span->u0, middle);
		late.chord_error = path_chord_error(path, middle, span->u1);
	}
	early.u1 = late.u0 = middle;
	early.q1 = late.q0 = q;
	*first = early;
	*second = late;
}

bool span_is_flat(const struct span *span, double linear)
{
	for (int slot = 0; slot < SLOT_COUNT && !path_is_straight(span->path); slot++)
		if (!slot_is_rotary(slot) && !(span->chord_error.v[slot] <= linear))
			return false;
	return true;
}

bool span_is_shortest(const struct span *span)
{
	return span->u1 - span->u0 <= ldexp(1, -SPAN_DEPTH);
}

/* The largest chord error that halving cannot reduce. */
static double rounding_floor(const struct path *path)
{
	axis_values rounding = path_chord_error(path, 0, 0);
	double most = 0;

	for (int slot = 0; slot < SLOT_COUNT; slot++)
		if (!slot_is_rotary(slot))
			most = fmax(most, rounding.v[slot]);
	return most;
}

void span_walk_init(struct span_walk *walk, const struct span *whole, double linear)
{
	walk->ahead[0] = *whole;
	walk->count = 1;
	walk->linear = linear;
	if (!span_is_flat(whole, linear))
		walk->linear += 2 * rounding_floor(whole->path);
}

bool span_walk_next(struct span_walk *walk, struct span *piece)
{
	if (!walk->count)
		return false;
	*piece = walk->ahead[--walk->count];
	/* The waiting spans are the later halves of each halving: at most SPAN_DEPTH of them. */
	while (!span_is_flat(piece, walk->linear) && !span_is_shortest(piece)) {
		struct span whole = *piece;

		span_halve(&whole, piece, &walk->ahead[walk->count++]);
	}
	return true;
}

long span_count(const struct span *whole, double linear)
{
	struct span_walk walk;
	struct span piece;
	long count = 0;

	if (span_is_flat(whole, linear))
		return 1;
	for (span_walk_init(&walk, whole, linear); span_walk_next(&walk, &piece);)
		count++;
	return count;
}
