#include "gcode/execute/program_position.h"

#include "gcode/execute/dynamic_work_offset.h"
#include "gcode/execute/probed_axes.h"
#include "gcode/execute/tool_length.h"

bool program_position_check(struct interp *interp, int slot, int column)
{
	if (interp->comp.side != 0)
		return fault(&interp->at, column, "the position under cutter compensation cannot be read");
	if (interp->state.polar_interpolation.on)
		return fault(&interp->at, column,
			     "the position under polar coordinate interpolation cannot be read; write G13.1 first");
	if (slot <= SLOT_Z && interp->state.pocket_milling.open[slot])
		return fault(&interp->at, column, "the position of %c in the G150 pocket is not known",
			     AXIS_LETTERS[slot]);
	/* After G28, G53 or M6 it depends on the control whether the length is still active. */
	if (tool_length_is_in_doubt(interp, slot, column))
		return false;
	if ((interp->state.unknown_modes & 1U << G_UNITS) && !slot_is_rotary(slot))
		return fault(&interp->at, column,
			     "a length is read before G20 or G21, and the unit at power-on is not known: set "
			     "power_on_units=\"mm\" or \"inch\" in the machine file's <controller>");
	if (!interp->state.frame.on && interp->state.unsure_code != CODE_NONE && interp->state.unsure[slot])
		return fault(&interp->at, column,
			     "the position of %c after G%g depends on the control until %c moves to an absolute "
			     "coordinate",
			     AXIS_LETTERS[slot], interp->state.unsure_code / 10.0, AXIS_LETTERS[slot]);
	if (!interp->state.frame.on)
		return dynamic_work_offset_check_read(interp, slot, column) &&
		       probed_axes_is_known(interp, slot, column);
	return fault(&interp->at, column,
		     "the position in a rotated coordinate system cannot be read; write G69 first");
}

double program_position_value(const struct state *state, int slot)
{
	double value = state->position.v[slot] - state->offset.v[slot];

	return slot_is_rotary(slot) ? value : value / state->scale;
}
