#include "gcode/dialect/sinumerik/flow/sinumerik_save.h"

#include "base/same_double.h"
#include "gcode/dialect/sinumerik/frames/sinumerik_frame.h"

void sinumerik_save_modes(const struct interp *interp, struct sinumerik_saved *saved)
{
	const struct sinumerik *sinumerik = sinumerik_of(interp);
	const struct state *state = &interp->state;

	*saved = (struct sinumerik_saved){
		.motion = state->motion, .plane = state->plane, .system = state->system, .comp_side = interp->comp.side,
		.incremental = state->incremental, .unknown_modes = state->unknown_modes,
		.feed_mode = state->feed_mode, .tcp = state->tcp, .scale = state->scale,
		.feed_scale = sinumerik->feed_scale, .path = sinumerik->path, .orientation = sinumerik->orientation,
		.comp = sinumerik->comp, .frames = sinumerik->frames,
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

/*
 * Refuses changes that move axes or tools when they are restored, and those of which the manual does not say whether
 * SAVE restores them.
 */
static bool check_restored(struct interp *interp, const struct sinumerik_saved *saved, int column)
{
	const struct sinumerik *sinumerik = sinumerik_of(interp);

	if (saved->tcp != interp->state.tcp || saved->frames.tool_frame != sinumerik->frames.tool_frame ||
	    !same_frame(&saved->frames.swivel, &sinumerik->frames.swivel))
		return fault(&interp->at, column,
			     "a subprogram with SAVE that switches TRAORI or TOROT, or swivels, is not supported");
	if (saved->comp_side != interp->comp.side)
		return fault(&interp->at, column,
			     "a subprogram with SAVE that switches tool radius compensation is not supported; G40, G41 "
			     "or G42 as before its end");
	if (!same_double(saved->path.smoothing, sinumerik->path.smoothing) ||
	    !same_double(saved->path.rounding, sinumerik->path.rounding) ||
	    !same_double(saved->path.rapid_rounding, sinumerik->path.rapid_rounding) ||
	    !same_double(saved->path.rapid_factor, sinumerik->path.rapid_factor) ||
	    !same_double(saved->path.orientation_tolerance, sinumerik->path.orientation_tolerance))
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
	state->unknown_modes = saved->unknown_modes;
	sinumerik->feed_scale = saved->feed_scale;
	sinumerik->path = saved->path;
	sinumerik->orientation = saved->orientation;
	sinumerik->comp.approach = saved->comp.approach;
	sinumerik->comp.corner = saved->comp.corner;
	sinumerik->comp.turns_plane = saved->comp.turns_plane;
	sinumerik->comp.soft_side = saved->comp.soft_side;
	sinumerik->comp.soft_way = saved->comp.soft_way;
	sinumerik->frames.programmed = saved->frames.programmed;
	sinumerik->frames.programmed_unsure = saved->frames.programmed_unsure;
	return sinumerik_frame_changed(interp, column);
}
