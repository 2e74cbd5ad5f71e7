#include "motion/dogleg.h"

#include <math.h>

#include "geom/tolerance.h"

/* The time at which each axis of a dogleg arrives, and the next arrival after `time`; INFINITY: there is none. */
static double next_arrival(const struct machine *machine, const struct path *path, double time,
			   double arrivals[SLOT_COUNT])
{
	double next = INFINITY;

	for (size_t i = 0; i < machine->axis_count; i++) {
		const struct axis *axis = &machine->axes[i];
		double at = fabs(path->end.v[axis->slot] - path->start.v[axis->slot]) / axis->rate_max;

		arrivals[axis->slot] = at;
		/* Arrivals that differ by rounding only count as one. */
		if (at > time * (1 + ARRIVAL_ROUNDING))
			next = fmin(next, at);
	}
	return next;
}

size_t dogleg_split(const struct machine *machine, const struct path *path, struct path parts[SLOT_COUNT])
{
	double arrivals[SLOT_COUNT] = {0}, time = 0, next;
	axis_values at = path->start;
	size_t count = 0;

	while ((next = next_arrival(machine, path, time, arrivals)) < INFINITY) {
		struct path *part = &parts[count++];

		*part = *path;
		part->start = at;
		for (int slot = 0; slot < SLOT_COUNT; slot++) {
			double way = path->end.v[slot] - path->start.v[slot];

			at.v[slot] = path->end.v[slot];
			if (arrivals[slot] > next * (1 + ARRIVAL_ROUNDING))
				at.v[slot] = path->start.v[slot] + way * (next / arrivals[slot]);
		}
		part->end = at;
		part->seconds = next - time;
		time = next;
	}
	return count;
}
