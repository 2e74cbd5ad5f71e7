#include "machine/value_check.h"

#include "base/units.h"

/*
 * mm and degrees a minute: the rapids of real machines start at 600 and 1,800. What is slower may be meant in metres a
 * minute or in turns a minute.
 */
static const double LINEAR_LEAST = 100, ROTARY_LEAST = 60;
/* Degrees: two turns (-360 to 360), given in radians, are a travel of so many degrees. */
static const double TWO_TURNS = 4 * PI;

static void check_rate(const struct axis *axis, int place, struct doubts *doubts)
{
	const double least = axis->rotary ? radians(ROTARY_LEAST) : LINEAR_LEAST;

	if (60 * axis->rate_max < least)
		doubts_add(doubts,
			   &(struct doubt){.kind = DOUBT_RATE_LOW, .axis = place, .value = 60 * axis->rate_max});
}

/* A travel of 0 is that of an axis which is clamped. */
static void check_travel(const struct axis *axis, int place, struct doubts *doubts)
{
	const double travel = axis->limit_max - axis->limit_min;

	if (axis->rotary && travel > 0 && travel < radians(TWO_TURNS) * (1 + 1e-3))
		doubts_add(doubts, &(struct doubt){.kind = DOUBT_RADIANS, .axis = place, .value = travel});
}

void value_check(const struct machine *machine, struct doubts *doubts)
{
	for (size_t i = 0; i < machine->axis_count; i++) {
		const struct axis *axis = &machine->axes[i];

		if (axis->checked)
			continue;
		check_rate(axis, (int)i, doubts);
		check_travel(axis, (int)i, doubts);
	}
}
