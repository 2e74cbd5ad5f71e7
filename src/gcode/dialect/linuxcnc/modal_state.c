#include "gcode/dialect/linuxcnc/modal_state.h"

#include "base/same_double.h"
#include "gcode/execute/motion_commands.h"

static bool refuse(struct interp *interp, int column, const char *what)
{
	return fault(&interp->at, column,
		     "M72 and the end of M73 restore %s only partly in LinuxCNC; restore it by its own code first",
		     what);
}

/*
 * LinuxCNC 2.9 restores modes by running their codes, and some codes have further effects: G43 applies the length of
 * the tool in the spindle whatever its H was, and G94 clears the feed. If this matters, the code is refused.
 */
static bool check_restorable(struct interp *interp, const struct modal_state *modal, int column)
{
	const struct state *state = &interp->state, *before = &modal->modes;

	if (interp->comp.side != modal->side)
		return refuse(interp, column, "cutter compensation");
	if (interp->comp.side != 0)
		return fault(&interp->at, column, "M72 or the end of M73 under cutter compensation; write G40 first");
	if (state->length_code != before->length_code || !same_double(state->length, before->length) ||
	    state->tcp != before->tcp)
		return refuse(interp, column, "the tool length");
	if (state->feed_mode != before->feed_mode)
		return refuse(interp, column, "the feed mode");
	return true;
}

static bool take_back(struct interp *interp, const struct modal_state *modal, int column)
{
	struct state *state = &interp->state;
	const struct state *before = &modal->modes;

	if (!check_restorable(interp, modal, column))
		return false;
	if (before->spindle == SPINDLE_STOPPED && !motion_commands_spindle_stops(interp))
		return false;
	state->spindle = before->spindle;
	state->speed = before->speed;
	state->speed_is_zero = before->speed_is_zero;
	state->feed_linear = before->feed_linear;
	state->feed_angular = before->feed_angular;
	state->plane = before->plane;
	state->scale = before->scale;
	state->incremental = before->incremental;
	state->arc_absolute = before->arc_absolute;
	state->retract = before->retract;
	state->blend = before->blend;
	state->blend_tolerance = before->blend_tolerance;
	if (state->system != before->system) {
		state->system = before->system;
		state->work_assigned = false;
	}
	state_update_offset(state);
	return true;
}

bool modal_state_run(struct interp *interp, struct modal_state *modal, int code, int column)
{
	if (code == 71) {
		modal->saved = modal->on_return = false;
		return true;
	}
	if (code == 72)
		return modal->saved ? take_back(interp, modal, column)
				    : fault(&interp->at, column, "M72 without M70 or M73 before it in this subprogram");
	modal->saved = true;
	modal->on_return = code == 73;
	modal->modes = interp->state;
	modal->side = interp->comp.side;
	return true;
}

bool modal_state_leave(struct interp *interp, struct modal_state *modal, int column)
{
	bool good = !modal->on_return || take_back(interp, modal, column);

	modal->saved = modal->on_return = false;
	return good;
}
