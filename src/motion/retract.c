#include "motion/retract.h"

#include <math.h>

#include "geom/tolerance.h"
#include "motion/tcp.h"

/* How far the axes can move until the first one is at its limit; INFINITY: there is none. */
static double way_to_limit(const struct machine *machine, const axis_values *position, const double rate[3])
{
	double way = INFINITY;

	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		const struct axis *axis = machine_axis(machine, slot);
		double limit = rate[slot] > 0 ? axis->limit_max : axis->limit_min;

		/* Skip axes along which the direction has a component by rounding only. */
		if (fabs(rate[slot]) > PARALLEL_SINE)
			way = fmin(way, fmax(0, (limit - position->v[slot]) / rate[slot]));
	}
	return way;
}

bool retract_along_tool(const struct machine *machine, struct srcloc loc, struct diag *diag,
			struct kinematics_retract *retract)
{
	const struct kinematics_tcp state = {.on = true};
	double rate[3], way = retract->distance;
	struct tcp tcp;
	vec3 direction;
	xform head;

	if (!tcp_init(&tcp, machine, &state, loc, diag))
		return false;
	head = chain_pose(&tcp.head, &retract->position);
	direction = mat3_apply(&head.rotation, vec3_scale(-1, machine->spindle.direction));
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++)
		rate[slot] = vec3_dot(tcp.rows[slot], direction);
	if (retract->to_limit)
		way = way_to_limit(machine, &retract->position, rate);
	if (!isfinite(way)) {
		diag_error(diag, loc,
			   "the retract moves to the end of travel, but the machine file has no limit for its axes");
		return false;
	}
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++)
		retract->position.v[slot] += way * rate[slot];
	return true;
}
