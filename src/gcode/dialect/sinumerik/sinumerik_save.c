#include "gcode/dialect/sinumerik/sinumerik_save.h"

#include "base/same_double.h"
#include "gcode/dialect/sinumerik/sinumerik_frame.h"

void sinumerik_save_modes(const struct interp *interp, struct sinumerik_saved *saved)
{
	const struct sinumerik *sinumerik = sinumerik_of(interp);
	const struct state *state = &interp->state;

	*saved = (struct sinumerik_saved){
		.motion = state->motion, .plane = state->plane, .system = state->system,
		.path_code = sinumerik->path_code, .incremental = state->incremental,
		.compresses = sinumerik->compresses, .feed_mode = state->feed_mode, .tcp = state->tcp,
		.scale = state->scale, .feed_scale = sinumerik->feed_scale, .smoothing = sinumerik->smoothing,
		.rounding = sinumerik->rounding, .rapid_rounding = sinumerik->rapid_rounding,
		.rapid_factor = sinumerik->rapid_factor, .orientation_tolerance = sinumerik->orientation_tolerance,
		.frame = sinumerik->frame, .swivel = sinumerik->swivel, .approach = sinumerik->approach,
		.corner = sinumerik->corner, .comp_side = interp->comp.side,
		.smooths_orientation = sinumerik->smooths_orientation,
		.machine_orientation = sinumerik->machine_orientation, .turns_plane = sinumerik->turns_plane,
		.tool_frame = sinumerik->tool_frame, .orientation = sinumerik->orientation,
		.unknown_modes = state->unknown_modes, .frame_unsure = sinumerik->frame_unsure,
		.orientation_angles = sinumerik->orientation_angles,
	};
}

static bool same_frame(const struct sinumerik_frame *a, const struct sinumerik_frame *b)
{
	bool same = !(vec3_norm2(vec3_sub(a->matrix.x, b->matrix.x)) > 0) &&
		    !(vec3_norm2(vec3_sub(a->matrix.y, b->matrix.y)) > 0) &&
		    !(vec3_norm2(vec3_sub(a->matrix.z, b->matrix.z)) > 0);

	for (int slot = 0; slot < SLOT_COUNT; slot++)
		same = same && same_double(a->shift.v[slot], b->shift.v[slot]);
	return same;
}

/* What the manual does not say of SAVE, and what moves axes or tools where it comes back. */
static bool check_restored(struct interp *interp, const struct sinumerik_saved *saved, int column)
{
	const struct sinumerik *sinumerik = sinumerik_of(interp);

	if (saved->tcp != interp->state.tcp || saved->tool_frame != sinumerik->tool_frame ||
	    !same_frame(&saved->swivel, &sinumerik->swivel))
		return fault(&interp->at, column,
			     "a subprogram with SAVE that switches TRAORI or TOROT, or swivels, is not supported yet");
	if (saved->comp_side != interp->comp.side)
		return fault(&interp->at, column,
			     "a subprogram with SAVE that switches tool radius compensation is not supported; G40, G41 "
			     "or G42 as before its end");
	if (!same_double(saved->smoothing, sinumerik->smoothing) ||
	    !same_double(saved->rounding, sinumerik->rounding) ||
	    !same_double(saved->rapid_rounding, sinumerik->rapid_rounding) ||
	    !same_double(saved->rapid_factor, sinumerik->rapid_factor) ||
	    !same_double(saved->orientation_tolerance, sinumerik->orientation_tolerance))
		return fault(&interp->at, column,
			     "a subprogram with SAVE that changes ADIS, CTOL, OTOL, STOLF or CYCLE832: whether SAVE "
			     "brings them back is not certain; give them as before its end");
	return true;
}

bool sinumerik_save_restore(struct interp *interp, const struct sinumerik_saved *saved, int column)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	struct state *state = &interp->state;

	if (!check_restored(interp, saved, column))
		return false;
	sinumerik_frame_place(interp);
	state->motion = saved->motion;
	state->plane = saved->plane;
	state->system = saved->system;
	state->incremental = saved->incremental;
	state->feed_mode = saved->feed_mode;
	state->scale = saved->scale;
	sinumerik->path_code = saved->path_code;
	sinumerik->compresses = saved->compresses;
	sinumerik->feed_scale = saved->feed_scale;
	sinumerik->approach = saved->approach;
	sinumerik->corner = saved->corner;
	sinumerik->turns_plane = saved->turns_plane;
	sinumerik->smooths_orientation = saved->smooths_orientation;
	sinumerik->machine_orientation = saved->machine_orientation;
	sinumerik->orientation = saved->orientation;
	sinumerik->orientation_angles = saved->orientation_angles;
	state->unknown_modes = saved->unknown_modes;
	sinumerik->frame = saved->frame;
	sinumerik->frame_unsure = saved->frame_unsure;
	return sinumerik_frame_changed(interp, column);
}
