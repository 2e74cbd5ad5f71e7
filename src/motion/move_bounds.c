#include "motion/move_bounds.h"

#include <math.h>

#include "base/apart.h"
#include "base/units.h"

/* mm, radians: no machine is larger, and rounding would become visible beyond. */
#define FARTHEST 1e7

/* The largest number of pieces of a move; with more the program would seem to hang. */
#define MOST_PIECES 1e8

/* Seconds: the longest move. After moves of decades the clock would have no decimals left. */
#define LONGEST 1e9

/* False: the position is too far away, or not a number. */
static bool is_near(double position)
{
	return fabs(position) <= FARTHEST;
}

static APART bool fault_of_reach(const struct canon_move *move, struct diag *diag, const char *program)
{
	int slot = 0;

	while (is_near(move->end.v[slot]))
		slot++;
	diag_error(diag, move_place(move, program), "axis %c moves to %g, which is too far to compute",
		   AXIS_LETTERS[slot], slot_is_rotary(slot) ? degrees(move->end.v[slot]) : move->end.v[slot]);
	return false;
}

bool move_is_in_reach(const struct canon_move *move, struct diag *diag, const char *program)
{
	bool near = true;

	for (int slot = 0; slot < SLOT_COUNT; slot++)
		near &= is_near(move->end.v[slot]);
	if (!near)
		return fault_of_reach(move, diag, program);
	if (move->kind != CANON_ARC ||
	    (vec3_norm(move->arc.centre) <= FARTHEST && fabs(move->arc.sweep) <= FARTHEST))
		return true;
	diag_error(diag, move_place(move, program), "the arc is too large to compute");
	return false;
}

bool move_is_bearable(const struct canon_move *move, double seconds, struct diag *diag, const char *program)
{
	if (seconds <= LONGEST)
		return true;
	diag_error(diag, move_place(move, program), "this block takes %g s: check the feed or the dwell", seconds);
	return false;
}

bool move_is_countable(const struct canon_move *move, const struct path *path, double flatness, struct diag *diag,
		       const char *program)
{
	const axis_values second_derivative = path_second_derivative(path, 0, 1);
	double most = 0;

	for (int slot = 0; slot < SLOT_COUNT; slot++)
		most = fmax(most, second_derivative.v[slot]);
	if (sqrt(most / (8 * flatness)) <= MOST_PIECES)
		return true;
	diag_error(diag, move_place(move, program),
		   "this move needs more than %g straight pieces; give it fewer turns", MOST_PIECES);
	return false;
}
