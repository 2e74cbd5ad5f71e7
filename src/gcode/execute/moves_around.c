#include "gcode/execute/moves_around.h"

#include <math.h>

#include "gcode/execute/motion_commands.h"
#include "gcode/execute/probed_axes.h"
#include "gcode/execute/rotated_frame.h"

bool moves_around_go(struct interp *interp, const double around[3], int column)
{
	const struct state *state = &interp->state;
	struct canon_move move = {.kind = CANON_RAPID};
	slot_values here = rotated_frame_straight(state), low = here, high = here;
	double size = 0;
	int along = SLOT_X;

	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		if (!probed_axes_is_known(interp, slot, column))
			return false;
		size += around[slot] * around[slot];
		along = around[slot] > around[along] ? slot : along;
	}
	low.v[along] -= around[along];
	high.v[along] += around[along];
	/* In turned coordinates the box may have any direction; scaling also applies to the builder's moves. */
	size = sqrt(size) * (state->frame.distorts ? state->frame.growth : 1);
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++)
		move.spread[slot] = state->frame.on ? size : slot == along ? 0 : around[slot];
	return motion_commands_go(interp, &low, &move) && motion_commands_go(interp, &high, &move) &&
	       motion_commands_go(interp, &here, &move);
}
