#include "gcode/dialect/sinumerik/sinumerik_great_circle.h"

#include <math.h>

#include "base/math/math_functions.h"
#include "base/units.h"
#include "gcode/dialect/sinumerik/sinumerik_frame.h"
#include "gcode/execute/motion_commands.h"
#include "gcode/execute/tool_length.h"

/* Radians: how far a rotary axis may be beside its straight way in a piece; a longer piece is halved. */
#define BESIDE 2e-5
/* As a part of the move: a piece that is halved so often comes to where an axis would have to turn infinitely fast. */
#define SHORTEST (1.0 / 65536)
/* Radians */
#define SAME_DIRECTION 1e-9
#define SAME_END 1e-6

static double widest(const struct kinematics_great_circle *piece)
{
	double most = 0;

	for (int slot = SLOT_A; slot <= SLOT_C; slot++)
		most = fmax(most, piece->beside[slot]);
	return most;
}

/* The target's rotary positions, or those of the way where `rotary` is given, and the part `s` of its linear way. */
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
	sinumerik_of(interp)->place = place;
	sinumerik_of(interp)->placed = true;
	return true;
}

static axis_values rotary_of(const struct interp *interp, const slot_values *target)
{
	axis_values rotary = interp->state.canonical;

	for (int slot = SLOT_A; slot <= SLOT_C; slot++)
		rotary.v[slot] = radians(target->v[slot] + interp->state.offset.v[slot]);
	return rotary;
}

/* The directions at both ends; false: reported. */
static bool find_ends(struct interp *interp, int column, const axis_values *last, const vec3 *direction,
		      struct kinematics_great_circle *piece)
{
	const struct kinematics *kinematics = interp->kinematics;
	const struct srcloc loc = line_loc(&interp->at, column);

	*piece = (struct kinematics_great_circle){.rotary_zero = tool_length_rotary_zero(interp),
						  .rotary = interp->state.canonical};
	if (!kinematics->direction(kinematics->context, loc, &piece->rotary_zero, &piece->rotary, &piece->from))
		return false;
	piece->to = direction ? *direction : piece->from;
	return direction || kinematics->direction(kinematics->context, loc, &piece->rotary_zero, last, &piece->to);
}

static bool check_end(struct interp *interp, int column, const axis_values *rotary, const axis_values *last)
{
	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		if (fabs(rotary->v[slot] - last->v[slot]) > SAME_END)
			return fault(&interp->at, column,
				     "the great circle (ORIVECT) ends with %c at %.9g degrees, and the block gives "
				     "%.9g: the control "
				     "changes over at the pole or alarms; ORIAXES turns the axes evenly",
				     AXIS_LETTERS[slot], degrees(rotary->v[slot]), degrees(last->v[slot]));
	}
	return true;
}

/* True: the block goes evenly, which its first piece finds out before anything has moved. */
static bool near_pole(struct interp *interp, int column, bool *pole)
{
	*pole = interp->config->controller.orientation_pole == ORIENTATION_POLE_AXES;
	return *pole ||
	       fault(
		   &interp->at, column,
		   "the great circle (ORIVECT) leads through or near a pole of the rotary axes, or out of their "
		   "limits: a parameter of the control (MD21108) decides what it does there: orientation_pole=\"axes\" "
		   "of the machine's <controller> says that the axes of such a block turn evenly, as with ORIAXES");
}

/* Can the whole way be followed? *pole: it cannot, and the block goes evenly. False: reported. */
static bool try_way(struct interp *interp, int column, struct kinematics_great_circle piece, bool *pole)
{
	const struct kinematics *kinematics = interp->kinematics;
	double step = 1;

	*pole = false;
	while (piece.s0 < 1) {
		const axis_values before = piece.rotary;

		piece.s1 = fmin(1, piece.s0 + step);
		if (!kinematics->great_circle(kinematics->context, line_loc(&interp->at, column), &piece))
			return false;
		if (widest(&piece) > BESIDE) {
			piece.rotary = before;
			step /= 2;
			if (step < SHORTEST)
				return near_pole(interp, column, pole);
			continue;
		}
		piece.s0 = piece.s1;
		step *= 2;
	}
	return true;
}

static bool go_in_pieces(struct interp *interp, int column, const slot_values *target, const axis_values *last,
			 struct kinematics_great_circle *piece, const struct canon_move *move)
{
	const struct kinematics *kinematics = interp->kinematics;
	const slot_values start = *sinumerik_frame_place(interp);
	double step = 1;

	while (piece->s0 < 1) {
		const axis_values before = piece->rotary;
		struct canon_move part = *move;

		piece->s1 = fmin(1, piece->s0 + step);
		if (!kinematics->great_circle(kinematics->context, line_loc(&interp->at, column), piece))
			return false;
		if (widest(piece) > BESIDE) {
			/* try_way has shown that this ends. */
			piece->rotary = before;
			step /= 2;
			continue;
		}
		if (piece->s1 >= 1 && last && !check_end(interp, column, &piece->rotary, last))
			return false;
		for (int slot = SLOT_A; slot <= SLOT_C; slot++)
			part.turn_spread[slot - SLOT_A] = piece->beside[slot];
		part.feed.seconds *= piece->s1 - piece->s0;
		if (!go_to(interp, &start, target, piece->s1, piece->s1 >= 1 && last ? NULL : &piece->rotary, &part))
			return false;
		piece->s0 = piece->s1;
		step *= 2;
	}
	return true;
}

bool sinumerik_great_circle_go(struct interp *interp, int column, const slot_values *target, const vec3 *direction,
			       const struct canon_move *move, bool *evenly)
{
	const axis_values last = rotary_of(interp, target);
	const slot_values start = *sinumerik_frame_place(interp);
	struct kinematics_great_circle piece;
	struct canon_move whole = *move;
	double angle;

	*evenly = false;
	if (interp->corner.on || interp->block.corner)
		return fault(&interp->at, column, "CHF, CHR or RND in a block that turns the tool is not supported");
	if (!find_ends(interp, column, &last, direction, &piece))
		return false;
	angle = math_atan2(vec3_norm(vec3_cross(piece.from, piece.to)), vec3_dot(piece.from, piece.to));
	if (angle > PI - SAME_END)
		return fault(&interp->at, column,
			     "the tool turns round to the opposite direction: the plane of a great circle (ORIVECT) is "
			     "not certain");
	if (angle > SAME_DIRECTION && !try_way(interp, column, piece, evenly))
		return false;
	if (*evenly)
		return true;
	if (angle > SAME_DIRECTION)
		return go_in_pieces(interp, column, target, direction ? NULL : &last, &piece, move);
	/* The direction stays, and so do the axes, unless the block turns one that the tool lies along. */
	if (!direction && !check_end(interp, column, &interp->state.canonical, &last))
		return false;
	return go_to(interp, &start, target, 1, &interp->state.canonical, &whole);
}
