#include "gcode/execute/great_circle_pieces.h"

#include <math.h>

#include "base/math/math_functions.h"
#include "gcode/execute/tool_length.h"

/* Radians: the greatest deviation of a rotary axis from linear interpolation in a piece; else the piece is halved. */
#define BESIDE 2e-5
/* As a share of the move: a piece this short is at a place where an axis would have to turn infinitely fast. */
#define SHORTEST (1.0 / 65536)

static double widest(const struct kinematics_great_circle *piece)
{
	double most = 0;

	for (int slot = SLOT_A; slot <= SLOT_C; slot++)
		most = fmax(most, piece->beside[slot]);
	return most;
}

bool great_circle_pieces_find(struct interp *interp, int column, const axis_values *last, const vec3 *direction,
			      struct kinematics_great_circle *way, double *angle)
{
	const struct kinematics *kinematics = interp->kinematics;
	const struct srcloc loc = line_loc(&interp->at, column);

	*way = (struct kinematics_great_circle){.rotary_zero = tool_length_rotary_zero(interp),
						.rotary = interp->state.canonical};
	if (!kinematics->direction(kinematics->context, loc, &way->rotary_zero, &way->rotary, &way->from))
		return false;
	way->to = direction ? *direction : way->from;
	if (!direction && !kinematics->direction(kinematics->context, loc, &way->rotary_zero, last, &way->to))
		return false;
	*angle = math_atan2(vec3_norm(vec3_cross(way->from, way->to)), vec3_dot(way->from, way->to));
	return true;
}

/* Divides the move into pieces as long as possible; `go` is NULL if nothing moves yet. *can: none became too short. */
static bool follow(struct interp *interp, int column, struct kinematics_great_circle piece, great_circle_pieces_fn go,
		   void *context, bool *can)
{
	const struct kinematics *kinematics = interp->kinematics;
	double step = 1;

	*can = true;
	while (piece.s0 < 1) {
		const axis_values before = piece.rotary;

		piece.s1 = fmin(1, piece.s0 + step);
		if (!kinematics->great_circle(kinematics->context, line_loc(&interp->at, column), &piece))
			return false;
		if (widest(&piece) > BESIDE) {
			piece.rotary = before;
			step /= 2;
			*can = step >= SHORTEST;
			if (!*can)
				return true;
			continue;
		}
		if (go && !go(context, &piece))
			return false;
		piece.s0 = piece.s1;
		step *= 2;
	}
	return true;
}

bool great_circle_pieces_try(struct interp *interp, int column, const struct kinematics_great_circle *way, bool *can)
{
	return follow(interp, column, *way, NULL, NULL, can);
}

bool great_circle_pieces_go(struct interp *interp, int column, const struct kinematics_great_circle *way,
			    great_circle_pieces_fn go, void *context)
{
	bool can;

	return follow(interp, column, *way, go, context, &can);
}
