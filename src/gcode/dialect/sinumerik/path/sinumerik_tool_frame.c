#include "gcode/dialect/sinumerik/path/sinumerik_tool_frame.h"

#include <math.h>
#include <string.h>

#include "base/apart.h"
#include "base/same_double.h"
#include "gcode/dialect/sinumerik/frames/sinumerik_frame.h"
#include "gcode/execute/tool_length.h"

/* A tool that deviates from Y by less than this defines no X perpendicular to both. */
#define ALONG_Y 1e-6

static bool has_frame(const struct sinumerik *sinumerik)
{
	const struct sinumerik_frame *frame = &sinumerik->frames.programmed;
	const mat3 one = mat3_identity();
	bool none = same_double(vec3_norm2(vec3_sub(frame->matrix.x, one.x)), 0) &&
		    same_double(vec3_norm2(vec3_sub(frame->matrix.y, one.y)), 0) &&
		    same_double(vec3_norm2(vec3_sub(frame->matrix.z, one.z)), 0);

	for (int slot = SLOT_X; slot <= SLOT_Z; slot++)
		none = none && same_double(frame->shift.v[slot], 0);
	return !none;
}

/*
 * Z is along the tool. Of X and Y it is only known that they are perpendicular to it: MD21110 and SD42980 define
 * their directions, and a move of Z alone does not depend on them.
 */
static mat3 frame_of(vec3 tool)
{
	const vec3 across = vec3_cross((vec3){0, 1, 0}, tool);
	const vec3 x = vec3_norm(across) > ALONG_Y ? vec3_unit(across) : (vec3){1, 0, 0};

	return (mat3){x, vec3_cross(tool, x), tool};
}

static bool change(struct interp *interp, int column, const struct sinumerik_frame *frame, bool on)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	bool shifted[SLOT_COUNT];

	sinumerik_frame_place(interp);
	memcpy(shifted, sinumerik->place.shifted, sizeof(shifted));
	sinumerik->frames.swivel = *frame;
	sinumerik->frames.tool_frame = on;
	if (!sinumerik_frame_changed(interp, column))
		return false;
	/* An increment of Z is relative to the present position: this is the retraction for which TOROT exists. */
	if (on)
		memcpy(sinumerik->place.shifted, shifted, sizeof(shifted));
	/* The coordinates of X, Y and Z in the frame are not known. */
	for (int slot = SLOT_X; slot <= SLOT_Z && !on; slot++) {
		sinumerik->place.shifted[slot] = true;
		sinumerik->place.programmed.v[slot] = NAN;
	}
	return true;
}

/*
 * Function manual K2, "Frame rotation in tool direction": TOFRAME makes the programmable frame a pure rotation; TOROT
 * replaces only its rotation, by the same one. Without a frame before, both are the same.
 */
static APART bool select_frame(struct interp *interp, const struct sinumerik_block *block)
{
	const int code = block->code[SINUMERIK_TOOL_FRAME], column = block->code_column[SINUMERIK_TOOL_FRAME];
	const struct sinumerik *sinumerik = sinumerik_of(interp);
	const struct kinematics *kinematics = interp->kinematics;
	const axis_values zero = tool_length_rotary_zero(interp);
	struct sinumerik_frame frame = sinumerik_frame_none();
	vec3 tool;

	if (code == SINUMERIK_TOROTOF && !sinumerik->frames.tool_frame)
		return true;
	if (code == SINUMERIK_TOROTOF)
		return change(interp, column, &frame, false);
	if (interp->state.tcp != TCP_BY_LENGTH)
		return fault(&interp->at, column,
			     "TOROT and TOFRAME without TRAORI are not supported; CYCLE800 gives a plane");
	if (interp->state.plane != G17)
		return fault(&interp->at, column, "TOROT and TOFRAME need G17");
	if (has_frame(sinumerik))
		return fault(&interp->at, column,
			     "TOROT and TOFRAME while TRANS, ROT, SCALE or MIRROR is in force are not supported: "
			     "a parameter of the control (MD28082) decides what they make of it");
	if (sinumerik->frames.unsure)
		return fault(&interp->at, column, "frames after TRAORI: select the work offset again first");
	if (!kinematics->direction(kinematics->context, line_loc(&interp->at, column), &zero, &interp->state.canonical,
				   &tool))
		return false;
	frame.matrix = frame_of(tool);
	return change(interp, column, &frame, true);
}

bool sinumerik_tool_frame_select(struct interp *interp, const struct sinumerik_block *block)
{
	return block->code[SINUMERIK_TOOL_FRAME] == CODE_NONE || select_frame(interp, block);
}

bool sinumerik_tool_frame_check(struct interp *interp, const struct sinumerik_block *block, bool arc)
{
	if (!arc && !sinumerik_block_has(block, 'X') && !sinumerik_block_has(block, 'Y') &&
	    !(block->addresses & SINUMERIK_DIRECTION_BITS))
		return true;
	return fault(&interp->at, sinumerik_block_axis_column(block),
		     "TOROT and TOFRAME lay Z along the tool; where X and Y then point is a matter of the control's "
		     "settings (MD21110, SD42980): only Z and rotary axes are supported before TOROTOF; a plane by "
		     "CYCLE800 or ROT has all three");
}
