#include "machine/value_check.h"

#include <math.h>

#include "base/math/math_functions.h"
#include "base/units.h"

/*
 * mm and degrees a minute: the rapids of real machines start at 600 and 1,800. A lower value may be in metres or turns
 * a minute.
 */
static const double LINEAR_LEAST = 100, ROTARY_LEAST = 60;
/* Degrees: a travel of two turns (-360 to 360), given in radians, looks like this number of degrees. */
static const double TWO_TURNS = 4 * PI;

static void check_rate(const struct axis *axis, int place, struct doubts *doubts)
{
	const double least = axis->rotary ? radians(ROTARY_LEAST) : LINEAR_LEAST;

	if (60 * axis->rate_max < least)
		doubts_add(doubts,
			   &(struct doubt){.kind = DOUBT_RATE_LOW, .axis = place, .value = 60 * axis->rate_max});
}

/* A travel of 0 belongs to an axis that is clamped. */
static void check_travel(const struct axis *axis, int place, struct doubts *doubts)
{
	const double travel = axis->limit_max - axis->limit_min;

	if (axis->rotary && travel > 0 && travel < radians(TWO_TURNS) * (1 + 1e-3))
		doubts_add(doubts, &(struct doubt){.kind = DOUBT_RADIANS, .axis = place, .value = travel});
}

/*
 * Degrees: directions are either exact, or belong to a slanted bed or a nutating axis. An angle between these limits is
 * given in radians with few digits (1.57 is 0.046 degrees off), or is a mistake.
 */
static const double TILT_LEAST = 0.03, TILT_MOST = 10;

/* The angle (degrees) between a direction and the nearest of X, Y and Z. */
static double tilt_of(vec3 v)
{
	const double along = fmax(fabs(v.x), fmax(fabs(v.y), fabs(v.z)));

	return degrees(math_atan2(sqrt(fmax(0, vec3_dot(v, v) - along * along)), along));
}

static bool is_tilted(vec3 direction)
{
	const double tilt = tilt_of(direction);

	return tilt > TILT_LEAST && tilt < TILT_MOST;
}

void value_check(const struct machine *machine, struct doubts *doubts)
{
	const struct spindle *spindle = &machine->spindle;

	for (size_t i = 0; i < machine->axis_count; i++) {
		const struct axis *axis = &machine->axes[i];

		if (axis->checked)
			continue;
		check_rate(axis, (int)i, doubts);
		check_travel(axis, (int)i, doubts);
		if (is_tilted(axis->direction))
			doubts_add(doubts, &(struct doubt){.kind = DOUBT_TILTED, .axis = (int)i,
							   .value = tilt_of(axis->direction)});
	}
	if (spindle->present && !spindle->checked && is_tilted(spindle->direction))
		doubts_add(doubts, &(struct doubt){.kind = DOUBT_SPINDLE_TILTED, .value = tilt_of(spindle->direction)});
}
