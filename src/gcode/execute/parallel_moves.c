#include "gcode/execute/parallel_moves.h"

#include <math.h>
#include <string.h>

#include "base/same_double.h"
#include "gcode/execute/motion_commands.h"
#include "gcode/execute/probed_axes.h"

/* mm: how wide a parallel move is, and how many there may be along an axis. */
#define WIDTH 1.0
#define MOST 32

static int parts(double half)
{
	return (int)fmin(fmax(1, ceil(2 * half / WIDTH)), MOST);
}

static bool is_plain(const struct interp *interp, const slot_values *target)
{
	bool same = !interp->state.frame.on && !probed_axes_any(&interp->state);

	for (int slot = SLOT_A; slot < SLOT_COUNT; slot++)
		same = same && same_double(target->v[slot], interp->state.position.v[slot]);
	return same;
}

/* From start to target, both aside by the same way. */
static bool go_aside(struct interp *interp, const slot_values *start, const slot_values *target, const double aside[3],
		     const struct canon_move *move)
{
	struct canon_move there = *move, along = *move;
	slot_values from = *start, to = *target;

	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		from.v[slot] += aside[slot];
		to.v[slot] += aside[slot];
	}
	return motion_commands_go(interp, &from, &there) && motion_commands_go(interp, &to, &along);
}

bool parallel_moves_go(struct interp *interp, const slot_values *target, const struct canon_move *move)
{
	const slot_values start = interp->state.position;
	struct canon_move part = *move, last = *move;
	int count[3];

	if (!is_plain(interp, target))
		return motion_commands_go(interp, target, &last);
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		count[slot] = parts(move->spread[slot]);
		part.spread[slot] = move->spread[slot] / count[slot];
		/* Back from the last of them: it stays within the same region, and cuts nothing for certain either. */
		last.spread[slot] = part.spread[slot];
	}
	for (int i = 0; i < count[0] * count[1] * count[2]; i++) {
		const int at[3] = {i % count[0], i / count[0] % count[1], i / count[0] / count[1]};
		double aside[3];

		for (int slot = SLOT_X; slot <= SLOT_Z; slot++)
			aside[slot] = (2 * at[slot] + 1) * part.spread[slot] - move->spread[slot];
		if (!go_aside(interp, &start, target, aside, &part))
			return false;
	}
	return motion_commands_go(interp, target, &last);
}

bool parallel_moves_go_from_open(struct interp *interp, const slot_values *target, struct canon_move *move)
{
	double *loose = interp->comp.loose, open[3];
	struct canon_move wide = *move;

	memcpy(open, loose, sizeof(open));
	if (!(open[0] + open[1] + open[2] > 0) || !is_plain(interp, target))
		return motion_commands_go(interp, target, move);
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		wide.spread[slot] += open[slot];
		loose[slot] = 0;
	}
	if (!parallel_moves_go(interp, target, &wide))
		return false;
	memcpy(loose, open, sizeof(open));
	return true;
}
