#include "gcode/dialect/sinumerik/path/sinumerik_great_circle.h"

#include <math.h>

#include "base/units.h"
#include "gcode/dialect/sinumerik/frames/sinumerik_frame.h"
#include "gcode/execute/great_circle_pieces.h"
#include "gcode/execute/motion_commands.h"

/* The rotary positions of the target, or those on the path if `rotary` is given; `s` is the part of the linear path. */
static bool go_to(struct interp *interp, const slot_values *start, const slot_values *target, double s,
		  const axis_values *rotary, struct canon_move *move)
{
	slot_values place = *target, straight;

	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		if (!slot_is_rotary(slot) && s < 1)
			place.v[slot] = start->v[slot] + s * (target->v[slot] - start->v[slot]);
		else if (slot_is_rotary(slot) && rotary && interp->config->has_axis[slot])
			place.v[slot] = state_from_canonical(slot, rotary->v[slot]) - interp->state.offset.v[slot];
	}
	straight = sinumerik_frame_straight(interp, &place);
	if (!motion_commands_go(interp, &straight, move))
		return false;
	sinumerik_of(interp)->place.program = place;
	sinumerik_of(interp)->place.known = true;
	return true;
}

static axis_values rotary_of(const struct interp *interp, const slot_values *target)
{
	axis_values rotary = interp->state.canonical;

	for (int slot = SLOT_A; slot <= SLOT_C; slot++)
		rotary.v[slot] = radians(target->v[slot] + interp->state.offset.v[slot]);
	return rotary;
}

static bool check_end(struct interp *interp, int column, const axis_values *rotary, const axis_values *last)
{
	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		if (fabs(rotary->v[slot] - last->v[slot]) > GREAT_CIRCLE_SAME_END)
			return fault(&interp->at, column,
				     "the great circle (ORIVECT) ends with %c at %.9g degrees, and the block gives "
				     "%.9g: the control "
				     "changes over at the pole or alarms; ORIAXES turns the axes evenly",
				     AXIS_LETTERS[slot], degrees(rotary->v[slot]), degrees(last->v[slot]));
	}
	return true;
}

/* True: the axes turn evenly in this block. The first piece finds this out, before anything has moved. */
static bool near_pole(struct interp *interp, int column, bool *pole)
{
	*pole = interp->config->controller.orientation_pole == ORIENTATION_POLE_AXES;
	return *pole ||
	       fault(
		   &interp->at, column,
		   "the great circle (ORIVECT) leads through or near a pole of the rotary axes, or out of their "
		   "limits: a parameter of the control (MD21108) decides what it does there: set "
		   "orientation_pole=\"axes\" in the machine file's <controller> if the axes of such a block turn "
		   "evenly, as with ORIAXES");
}

struct follower {
	struct interp *interp;
	int column;
	const slot_values *start, *target;
	const axis_values *last; /* the rotary positions of the target; NULL: the great circle gives them */
	const struct canon_move *move;
};

static bool go_piece(void *context, const struct kinematics_great_circle *piece)
{
	const struct follower *follower = context;
	const bool given = piece->s1 >= 1 && follower->last;
	struct canon_move part = *follower->move;

	if (given && !check_end(follower->interp, follower->column, &piece->rotary, follower->last))
		return false;
	for (int slot = SLOT_A; slot <= SLOT_C; slot++)
		part.turn_spread[slot - SLOT_A] = piece->beside[slot];
	part.feed.seconds *= piece->s1 - piece->s0;
	return go_to(follower->interp, follower->start, follower->target, piece->s1, given ? NULL : &piece->rotary,
		     &part);
}

bool sinumerik_great_circle_go(struct interp *interp, int column, const slot_values *target, const vec3 *direction,
			       const struct canon_move *move, bool *evenly)
{
	const axis_values last = rotary_of(interp, target);
	const slot_values start = *sinumerik_frame_place(interp);
	struct follower follower = {interp, column, &start, target, direction ? NULL : &last, move};
	struct kinematics_great_circle way;
	struct canon_move whole = *move;
	double angle;
	bool can = true;

	*evenly = false;
	if (interp->corner.on || interp->block.corner)
		return fault(&interp->at, column, "CHF, CHR or RND in a block that turns the tool is not supported");
	if (!great_circle_pieces_find(interp, column, &last, direction, &way, &angle))
		return false;
	if (angle > PI - GREAT_CIRCLE_SAME_END)
		return fault(&interp->at, column,
			     "the tool turns round to the opposite direction: the plane of a great circle (ORIVECT) is "
			     "not certain");
	if (angle > GREAT_CIRCLE_SAME_DIRECTION && !great_circle_pieces_try(interp, column, &way, &can))
		return false;
	if (!can && !near_pole(interp, column, evenly))
		return false;
	if (*evenly)
		return true;
	if (angle > GREAT_CIRCLE_SAME_DIRECTION)
		return great_circle_pieces_go(interp, column, &way, go_piece, &follower);
	/*
	 * The direction does not change, and neither do the axes, unless the block turns an axis that is parallel to
	 * the tool.
	 */
	if (!direction && !check_end(interp, column, &interp->state.canonical, &last))
		return false;
	return go_to(interp, &start, target, 1, &interp->state.canonical, &whole);
}
