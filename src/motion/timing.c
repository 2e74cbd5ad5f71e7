#include "motion/timing.h"

#include <math.h>

#include "base/apart.h"
#include "base/minmax.h"

static double way(const struct path *path, int first, int last)
{
	double sum = 0;

	for (int slot = first; slot <= last; slot++) {
		double d = path->end.v[slot] - path->start.v[slot];

		sum += d * d;
	}
	return sqrt(sum);
}

double timing_programmed(const struct path *path, const struct canon_feed *feed)
{
	double length;

	if (feed->inverse_time)
		return feed->seconds;
	length = path_length(path);
	if (!(length > 0))
		length = way(path, SLOT_U, SLOT_W);
	if (length > 0)
		return length / feed->linear;
	return way(path, SLOT_A, SLOT_C) / feed->angular;
}

/*
 * Seconds that the axes need for the whole path at the speed of the chord of `span`, which is `part` of the path.
 * `extra` is added to the way of the axes (NULL: none).
 */
static inline double needed(const struct axis_table *axes, const struct span *span, double part,
			    const axis_values *extra)
{
	double most = 0;

	for (size_t i = 0; i < axes->count; i++) {
		const struct axis_row *axis = &axes->rows[i];
		double d = fabs(span->q1.v[axis->slot] - span->q0.v[axis->slot]);

		if (extra)
			d += extra->v[axis->slot];
		most = larger(most, d / (axis->rate_max * part));
	}
	return most;
}

/* The axes keep to their rates on the chord of the whole, but may need longer for pieces of it. */
static APART double held_in_pieces(const struct axis_table *axes, const struct span *whole, double flatness,
				   double seconds)
{
	axis_values second_derivative;
	struct span_walk walk;
	struct span piece;

	/* By the mean value theorem, no velocity differs from the chord's by more than half the second derivative. */
	second_derivative = path_second_derivative(whole->path, 0, 1);
	for (int slot = 0; slot < SLOT_COUNT; slot++)
		second_derivative.v[slot] *= 0.5;
	if (needed(axes, whole, 1, &second_derivative) <= seconds)
		return seconds;
	span_walk_init(&walk, whole, flatness);
	while (span_walk_next(&walk, &piece))
		seconds = larger(seconds, needed(axes, &piece, piece.u1 - piece.u0, NULL));
	return seconds;
}

double timing_held(const struct axis_table *axes, const struct span *whole, double flatness, double seconds)
{
	/* The time for the whole chord is a lower bound, because no axis is slower on every piece than on the whole. */
	seconds = larger(seconds, needed(axes, whole, 1, NULL));
	return span_is_flat(whole, flatness) ? seconds : held_in_pieces(axes, whole, flatness, seconds);
}
