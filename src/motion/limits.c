#include "motion/limits.h"

#include <math.h>

#include "base/minmax.h"
#include "base/units.h"
#include "geom/tolerance.h"

/* The share of the tolerance below which a chord error is ignored. */
#define BELIEVED 0.01

/* mm or degrees: the accuracy of the reported distance of an axis past its limit. */
#define EXCESS_EXACT 1e-4

/* One limit of one axis; the sign makes `outside` point upward. */
struct side {
	int slot;
	double sign;
	double bound;
	double tolerance;
	double believed;	/* chord error */
};

static double height(const struct side *side, const axis_values *q)
{
	return side->sign * q->v[side->slot] - side->bound;
}

static bool stays_inside(const struct side *side, const struct span *span)
{
	double most = larger(height(side, &span->q0), height(side, &span->q1));

	return most + span->chord_error.v[side->slot] <= side->tolerance;
}

/* Where the span passes the limit. The span was not proved inside, and is so short that its chord can be used. */
static double passes_at(const struct side *side, const struct span *span)
{
	double h0 = height(side, &span->q0), h1 = height(side, &span->q1);

	if (h0 >= 0 || h1 <= h0)
		return span->u0;
	return span->u0 + smaller(1, -h0 / (h1 - h0)) * (span->u1 - span->u0);
}

/* The earliest instant past the limit. Halves of the span are searched only if they may cross the limit. */
static bool first_past(const struct side *side, const struct span *whole, double *u)
{
	struct span ahead[SPAN_DEPTH + 1];
	size_t count = 1;

	ahead[0] = *whole;
	while (count) {
		struct span span = ahead[--count];

		if (stays_inside(side, &span))
			continue;
		if (height(side, &span.q0) > side->tolerance || span.chord_error.v[side->slot] <= side->believed ||
		    span_is_shortest(&span)) {
			*u = passes_at(side, &span);
			return true;
		}
		span_halve(&span, &ahead[count + 1], &ahead[count]);
		count += 2;
	}
	return false;
}

static bool axis_crosses(const struct axis *axis, const struct span *whole, double room,
			 struct limit_crossing *crossing)
{
	double tolerance = axis->rotary ? radians(LIMIT_TOLERANCE) : LIMIT_TOLERANCE;
	/* Near the rounding error halving no longer helps, and the chord must be used. */
	double rounding = path_chord_error(whole->path, 0, 0).v[axis->slot];
	double believed = larger(BELIEVED * tolerance, 2 * rounding), u;
	bool found = false;

	for (int i = 0; i < 2; i++) {
		double limit = i ? axis->limit_max : axis->limit_min, sign = i ? 1 : -1;
		struct side side = {axis->slot, sign, sign * limit - room, tolerance, believed};

		if (!first_past(&side, whole, &u) || (found && crossing->u <= u))
			continue;
		*crossing = (struct limit_crossing){
		    .slot = axis->slot, .bound = limit, .below = !i, .room = room, .u = u};
		found = true;
	}
	return found;
}

/* How far the leg takes the axis past the crossing's limit; negative: how far inside it stays. */
static double excess_of(const struct limit_crossing *crossing, const struct span *whole)
{
	const double sign = crossing->below ? -1 : 1;
	const struct side side = {
	    .slot = crossing->slot, .sign = sign, .bound = sign * crossing->bound - crossing->room};
	const double rounding = path_chord_error(whole->path, 0, 0).v[side.slot];
	const double exact = larger(slot_is_rotary(side.slot) ? radians(EXCESS_EXACT) : EXCESS_EXACT, 2 * rounding);
	double most = larger(height(&side, &whole->q0), height(&side, &whole->q1));
	struct span ahead[SPAN_DEPTH + 1];
	size_t count = 1;

	ahead[0] = *whole;
	while (count) {
		struct span span = ahead[--count];
		double higher = larger(height(&side, &span.q0), height(&side, &span.q1));

		most = larger(most, higher);
		/* The box of a rapid stays between its ends. */
		if (whole->path->kind == PATH_BOX || higher + span.chord_error.v[side.slot] <= most + exact ||
		    span_is_shortest(&span))
			continue;
		span_halve(&span, &ahead[count + 1], &ahead[count]);
		count += 2;
	}
	return most;
}

bool limits_kept(const struct axis_table *axes, const struct leg *legs, size_t leg_count, const axis_values *room)
{
	static const axis_values none;

	if (!room)
		room = &none;
	for (size_t i = 0; i < leg_count; i++) {
		const struct span *whole = &legs[i].span;

		for (size_t k = 0; k < axes->count; k++) {
			const struct axis_row *axis = &axes->rows[k];
			double a = whole->q0.v[axis->slot], b = whole->q1.v[axis->slot];
			double beside = whole->chord_error.v[axis->slot] + room->v[axis->slot];

			if (!(smaller(a, b) - beside >= axis->limit_min && larger(a, b) + beside <= axis->limit_max))
				return false;
		}
	}
	return true;
}

/* True: neither side needs a search. */
static bool is_inside(const struct axis *axis, const struct span *whole, double room)
{
	double a = whole->q0.v[axis->slot], b = whole->q1.v[axis->slot];
	double beside = whole->chord_error.v[axis->slot] + room;

	return smaller(a, b) - beside >= axis->limit_min && larger(a, b) + beside <= axis->limit_max;
}

static bool all_inside(const struct axis *axis, const struct leg *legs, size_t leg_count, double room)
{
	for (size_t i = 0; i < leg_count; i++) {
		if (!is_inside(axis, &legs[i].span, room))
			return false;
	}
	return true;
}

/* The axis' first crossing in the move. */
static bool find_crossing(const struct axis *axis, const struct leg *legs, size_t leg_count, double room,
			  struct limit_crossing *crossing)
{
	bool found = false;

	for (size_t i = 0; i < leg_count && !found; i++) {
		found = !is_inside(axis, &legs[i].span, room) && axis_crosses(axis, &legs[i].span, room, crossing);
		crossing->leg = i;
	}
	for (size_t i = 0; i < leg_count && found; i++)
		crossing->excess = larger(crossing->excess, excess_of(crossing, &legs[i].span));
	return found;
}

static bool comes_before(const struct limit_crossing *a, const struct limit_crossing *b)
{
	if ((a->room > 0) != (b->room > 0))
		return b->room > 0;
	if (a->leg != b->leg)
		return a->leg < b->leg;
	return a->u < b->u || (a->u <= b->u && a->slot < b->slot);
}

size_t limits_crossed(const struct machine *machine, const struct leg *legs, size_t leg_count,
		      const axis_values *room, struct limit_crossing crossings[SLOT_COUNT])
{
	size_t count = 0;

	for (size_t i = 0; i < machine->axis_count; i++) {
		const struct axis *axis = &machine->axes[i];
		struct limit_crossing crossing;
		size_t at = count;

		/* An axis that stays inside with its room stays inside without it. */
		if (all_inside(axis, legs, leg_count, room ? room->v[axis->slot] : 0))
			continue;
		if (!find_crossing(axis, legs, leg_count, 0, &crossing) &&
		    !(room && find_crossing(axis, legs, leg_count, room->v[axis->slot], &crossing)))
			continue;
		for (; at > 0 && comes_before(&crossing, &crossings[at - 1]); at--)
			crossings[at] = crossings[at - 1];
		crossings[at] = crossing;
		count++;
	}
	return count;
}
