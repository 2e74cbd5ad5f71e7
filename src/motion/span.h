/* span.h - a piece of a move along which every axis position is linear, with a bound of the error. */
#ifndef FIVECHECK_MOTION_SPAN_H
#define FIVECHECK_MOTION_SPAN_H

#include <stdbool.h>
#include <stddef.h>

#include "base/axes.h"
#include "motion/path.h"

/*
 * For every s in [0,1] and every axis, the true position differs from
 * (1-s) q0 + s q1 by at most chord_error (mm, radians). A span borrows its path.
 */
struct span {
	axis_values q0, q1;
	axis_values chord_error;	/* of the chord from the true path; 0 for straight moves */
	const struct path *path;	/* the move that it is a piece of */
	double u0, u1;	/* the piece of the path, 0 to 1 */
};

/* A straight or curved part of a move: its path, and the span that is the whole of it. */
struct leg {
	struct path path;
	struct span span;
};

/* The whole path as one span. */
void span_init(struct span *whole, const struct path *path);

/* The end and the chord error of span_init. */
void span_init_curved(struct span *whole, const struct path *path);

/* The same if the position at its start is known and need not be computed again. Nearly all paths are straight. */
static inline void span_init_from(struct span *whole, const struct path *path, const axis_values *start)
{
	whole->q0 = *start;
	whole->path = path;
	whole->u0 = 0;
	whole->u1 = 1;
	if (!path_is_straight(path)) {
		span_init_curved(whole, path);
		return;
	}
	whole->q1 = path->end;
	whole->chord_error = (axis_values){{0}};
}

/* The earlier and the later half; the chord errors of a curved path shrink to about a quarter. */
void span_halve(const struct span *span, struct span *first, struct span *second);

/* True if no axis' chord deviates by more than `linear` mm. */
bool span_is_flat(const struct span *span, double linear);

/* The number of halvings of a whole path after which a span is not divided further, whatever its chord error. */
#define SPAN_DEPTH 48

bool span_is_shortest(const struct span *span);

/* Visits the flat pieces of a span, in the order of time. Plain data. */
struct span_walk {
	double linear;	/* mm */
	size_t count;
	struct span ahead[SPAN_DEPTH + 1];	/* the next on top */
};

/* Pieces deviate by at most `linear` mm, or by little more than the rounding of any piece. */
void span_walk_init(struct span_walk *walk, const struct span *whole, double linear);

/* The next piece; false at the end. */
bool span_walk_next(struct span_walk *walk, struct span *piece);

/* The number of such pieces. */
long span_count(const struct span *whole, double linear);

#endif
