#include "motion/table_point.h"

#include "motion/tcp.h"

/* If the head does not move and the length is 0, TCP keeps the gauge point fixed to the workpiece. */
bool table_point_find(const struct machine *machine, struct srcloc loc, struct diag *diag, axis_values *place)
{
	const struct kinematics_tcp state = {.on = true};
	axis_values carried;
	struct tcp tcp;

	if (!tcp_init(&tcp, machine, &state, loc, diag))
		return false;
	if (tcp.head.count) {
		diag_error(diag, loc,
			   "G254 works only if the rotary axes turn the table; on this machine %c turns the spindle",
			   AXIS_LETTERS[tcp.head.joints[0].slot]);
		return false;
	}
	carried = tcp_to_machine(&tcp, place);
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++)
		place->v[slot] = carried.v[slot];
	return true;
}
