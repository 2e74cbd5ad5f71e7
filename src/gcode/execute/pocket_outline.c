#include "gcode/execute/pocket_outline.h"

#include <math.h>

#include "base/math/math_functions.h"

/* mm: the greatest gap between the ends of a closed outline. */
#define CLOSED 0.01

static void widen(struct pocket_milling *pocket, double x, double y, double radius)
{
	const double point[2] = {x, y};

	for (int i = 0; i < 2; i++) {
		pocket->low[i] = fmin(pocket->low[i], point[i] - radius);
		pocket->high[i] = fmax(pocket->high[i], point[i] + radius);
	}
}

void pocket_outline_take(struct pocket_milling *pocket, const struct canon_move *move)
{
	const double x = move->end.v[SLOT_X], y = move->end.v[SLOT_Y];

	widen(pocket, x, y, 0);
	if (move->kind == CANON_ARC) {
		const double radius = math_hypot(x - move->arc.centre.x, y - move->arc.centre.y);
		const double sweep = move->arc.normal.z < 0 ? -move->arc.sweep : move->arc.sweep;

		widen(pocket, move->arc.centre.x, move->arc.centre.y, radius + CLOSED);
		pocket->area += radius * radius * (sweep - math_sin(sweep)) / 2;
	}
	/* The first move is from the hole to the outline. */
	if (pocket->points++ == 0) {
		pocket->first[0] = x;
		pocket->first[1] = y;
	} else {
		pocket->area += (pocket->last[0] * y - pocket->last[1] * x) / 2;
	}
	pocket->last[0] = x;
	pocket->last[1] = y;
}

bool pocket_outline_is_closed(const struct pocket_milling *pocket)
{
	return pocket->points > 1 &&
	       math_hypot(pocket->last[0] - pocket->first[0], pocket->last[1] - pocket->first[1]) <= CLOSED;
}
