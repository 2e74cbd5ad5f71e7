#include "gcode/dialect/klartext/path/klartext_vector.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "base/units.h"
#include "gcode/dialect/klartext/frames/klartext_frame.h"
#include "gcode/execute/great_circle_pieces.h"

/* A piece of the turn. It begins where the piece before it ends. */
struct piece {
	double s0, s1; /* parts of the whole turn */
	axis_values from, to; /* rotary positions, radians */
	double beside[SLOT_COUNT];
};

struct follower {
	struct interp *interp;
	int column;
	vec3 start; /* programmed point */
	const struct klartext_target *target;
	const struct canon_move *move;
	double angle; /* of the whole turn, radians */
	struct piece *pieces; /* owned */
	size_t count, capacity;
};

/*
 * TNC 640 user's manual, "FUNCTION TCPM", PATHCTRL VECTOR: the tool turns in the plane of its first and last
 * directions. The manual does not say how it turns there: at a constant rate, or like the vector to a point that moves
 * evenly on the straight line between the directions. In a turn by w <= 90 degrees the two differ by at most 0.0184
 * w^3, counted as an angle. Both are checked.
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

static bool keep_piece(void *context, const struct kinematics_great_circle *found)
{
	struct follower *follower = context;
	const struct piece *last = follower->count ? &follower->pieces[follower->count - 1] : NULL;
	struct piece piece = {.s0 = found->s0, .s1 = found->s1, .to = found->rotary};

	piece.from = last ? last->to : follower->interp->state.canonical;
	memcpy(piece.beside, found->beside, sizeof(piece.beside));
	follower->pieces = mem_grow(follower->pieces, &follower->capacity, follower->count + 1, sizeof(piece));
	follower->pieces[follower->count++] = piece;
	return true;
}

/*
 * The largest deviation of the axis from its straight way in a piece if the tool may have turned `shift` more or less
 * than evenly. Near a pole an axis turns far in a short piece, so all pieces within the shift count.
 */
static double find_spread(const struct follower *follower, const struct piece *piece, int slot, double shift)
{
	double low = piece->from.v[slot], high = low, rate = 0, beside = 0;

	for (size_t i = 0; i < follower->count; i++) {
		const struct piece *other = &follower->pieces[i];
		const double from = other->from.v[slot], to = other->to.v[slot];

		if (other->s1 < piece->s0 - shift || other->s0 > piece->s1 + shift)
			continue;
		low = fmin(low, fmin(from, to));
		high = fmax(high, fmax(from, to));
		rate = fmax(rate, fabs(to - from) / (other->s1 - other->s0));
		beside = fmax(beside, other->beside[slot]);
	}
	return 2 * beside + fmin(rate * shift, high - low);
}

static bool go_piece(const struct follower *follower, const struct piece *piece)
{
	/* a part of the turn, 0 to 1 */
	const double shift = BEHIND * follower->angle * follower->angle;
	struct klartext_target to = *follower->target;
	struct canon_move part = *follower->move;

	for (int slot = SLOT_A; slot <= SLOT_C; slot++)
		part.turn_spread[slot - SLOT_A] = find_spread(follower, piece, slot, shift);
	if (piece->s1 >= 1)
		return check_end(follower, &to.others, &piece->to) &&
		       klartext_move_turning(follower->interp, &to, &part);
	to.point = vec3_add(follower->start,
			    vec3_scale(piece->s1, vec3_sub(follower->target->point, follower->start)));
	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		if (follower->interp->config->has_axis[slot])
			to.others.v[slot] = state_from_canonical(slot, piece->to.v[slot]);
	}
	return klartext_move_turning(follower->interp, &to, &part);
}

static bool go_in_pieces(struct follower *follower, const struct kinematics_great_circle *way)
{
	bool good = great_circle_pieces_go(follower->interp, follower->column, way, keep_piece, follower);

	for (size_t i = 0; i < follower->count && good; i++)
		good = go_piece(follower, &follower->pieces[i]);
	free(follower->pieces);
	return good;
}

bool klartext_vector_go(struct interp *interp, int column, const struct klartext_target *target, bool rapid,
			const struct canon_feed *feed)
{
	const struct canon_move move = {.kind = rapid ? CANON_RAPID : CANON_FEED, .feed = *feed};
	struct follower follower = {.interp = interp,
				    .column = column,
				    .start = klartext_frame_point(interp),
				    .target = target,
				    .move = &move};
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
	return go_in_pieces(&follower, &way);
}
