#include "gcode/dialect/klartext/klartext_vector.h"

#include <math.h>

#include "base/units.h"
#include "gcode/dialect/klartext/klartext_frame.h"
#include "gcode/execute/great_circle_pieces.h"

struct follower {
	struct interp *interp;
	int column;
	vec3 start; /* programmed point */
	const struct klartext_target *target;
	const struct canon_move *move;
	double angle; /* of the whole turn, radians */
	axis_values before; /* where the rotary axes are at the start of the piece */
};

/*
 * TNC 640 user's manual, "FUNCTION TCPM", PATHCTRL VECTOR: the directions lie in the plane of the first and the last
 * one. How evenly the tool turns there is not said: at a constant rate, or as the vector on the straight line between
 * them, which in the part s of a turn by w <= 90 degrees is behind by at most 0.0184 w^3. Both are proved.
 */
#define BEHIND 0.02

static bool check_end(const struct follower *follower, const slot_values *others, const axis_values *rotary)
{
	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		const double reached = state_from_canonical(slot, rotary->v[slot]);

		if (follower->interp->config->has_axis[slot] &&
		    fabs(reached - others->v[slot]) > degrees(GREAT_CIRCLE_SAME_END))
			return fault(&follower->interp->at, follower->column,
				     "PATHCTRL VECTOR brings %c to %.9g degrees, and the block to %.9g: what the "
				     "control does then is not known here; write PATHCTRL AXIS",
				     AXIS_LETTERS[slot], reached, others->v[slot]);
	}
	return true;
}

static bool go_piece(void *context, const struct kinematics_great_circle *piece)
{
	struct follower *follower = context;
	/* As a part of the turn. */
	const double shift = BEHIND * follower->angle * follower->angle;
	struct klartext_target to = *follower->target;
	struct canon_move part = *follower->move;

	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		const double way = fabs(piece->rotary.v[slot] - follower->before.v[slot]);

		/* The rate of the axis here, and as much again for the pieces beside this one. */
		part.turn_spread[slot - SLOT_A] = piece->beside[slot] + 2 * shift * way / (piece->s1 - piece->s0);
	}
	follower->before = piece->rotary;
	if (piece->s1 >= 1)
		return check_end(follower, &to.others, &piece->rotary) &&
		       klartext_move_turning(follower->interp, &to, &part);
	to.point = vec3_add(follower->start,
			    vec3_scale(piece->s1, vec3_sub(follower->target->point, follower->start)));
	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		if (follower->interp->config->has_axis[slot])
			to.others.v[slot] = state_from_canonical(slot, piece->rotary.v[slot]);
	}
	return klartext_move_turning(follower->interp, &to, &part);
}

bool klartext_vector_go(struct interp *interp, int column, const struct klartext_target *target, bool rapid,
			const struct canon_feed *feed)
{
	const struct canon_move move = {.kind = rapid ? CANON_RAPID : CANON_FEED, .feed = *feed};
	struct follower follower = {.interp = interp,
				    .column = column,
				    .start = klartext_frame_point(interp),
				    .target = target,
				    .move = &move,
				    .before = interp->state.canonical};
	struct kinematics_great_circle way;
	axis_values last = interp->state.canonical;
	bool can = true;

	for (int slot = SLOT_A; slot <= SLOT_C; slot++)
		last.v[slot] = radians(target->others.v[slot]);
	if (!great_circle_pieces_find(interp, column, &last, NULL, &way, &follower.angle))
		return false;
	if (follower.angle > PI / 2)
		return fault(&interp->at, column,
			     "a turn of the tool by more than 90 degrees with PATHCTRL VECTOR is not supported; write "
			     "PATHCTRL AXIS");
	if (!(follower.angle > GREAT_CIRCLE_SAME_DIRECTION)) {
		struct canon_move whole = move;

		return check_end(&follower, &target->others, &interp->state.canonical) &&
		       klartext_move_turning(interp, target, &whole);
	}
	if (!great_circle_pieces_try(interp, column, &way, &can))
		return false;
	if (!can)
		return fault(&interp->at, column,
			     "PATHCTRL VECTOR leads through or near a pole of the rotary axes: what the control does "
			     "there is not known here; write PATHCTRL AXIS");
	return great_circle_pieces_go(interp, column, &way, go_piece, &follower);
}
