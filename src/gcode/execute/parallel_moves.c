#include "gcode/execute/parallel_moves.h"

#include <math.h>
#include <string.h>

#include "base/same_double.h"
#include "gcode/execute/motion_commands.h"
#include "gcode/execute/probed_axes.h"

/* mm: how wide a parallel move is, and how many there may be along a side. */
#define WIDTH 1.0
#define MOST 32

struct parallel_box parallel_moves_box(const double spread[3])
{
	return (struct parallel_box){{{spread[SLOT_X], 0, 0}, {0, spread[SLOT_Y], 0}, {0, 0, spread[SLOT_Z]}}};
}

static int parts(vec3 half)
{
	return (int)fmin(fmax(1, ceil(2 * vec3_norm(half) / WIDTH)), MOST);
}

/* Adds what a box reaches along X, Y and Z. */
static void add_spread(struct canon_move *move, const vec3 half[3])
{
	for (int side = 0; side < 3; side++) {
		move->spread[SLOT_X] += fabs(half[side].x);
		move->spread[SLOT_Y] += fabs(half[side].y);
		move->spread[SLOT_Z] += fabs(half[side].z);
	}
}

static bool is_plain(const struct interp *interp, const slot_values *target)
{
	bool same = !interp->state.frame.on && !probed_axes_any(&interp->state);

	for (int slot = SLOT_A; slot < SLOT_COUNT; slot++)
		same = same && same_double(target->v[slot], interp->state.position.v[slot]);
	return same;
}

/* Straight to a place beside another one. */
static bool go_beside(struct interp *interp, const slot_values *place, vec3 aside, const struct canon_move *move)
{
	struct canon_move part = *move;
	slot_values at = *place;

	at.v[SLOT_X] += aside.x;
	at.v[SLOT_Y] += aside.y;
	at.v[SLOT_Z] += aside.z;
	return motion_commands_go(interp, &at, &part);
}

/* The i-th of the parts of a box, so that each lies beside the one before. */
static void find_part(int i, const int count[3], int at[3])
{
	const int row = i / count[0], layer = row / count[1];

	at[0] = row % 2 ? count[0] - 1 - i % count[0] : i % count[0];
	at[1] = layer % 2 ? count[1] - 1 - row % count[1] : row % count[1];
	at[2] = layer;
}

bool parallel_moves_go(struct interp *interp, const slot_values *target, const struct canon_move *move,
		       const struct parallel_box *box)
{
	const slot_values start = interp->state.position;
	struct canon_move part = *move, last = *move;
	vec3 half[3];
	int count[3], all;

	if (!is_plain(interp, target)) {
		add_spread(&last, box->half);
		return motion_commands_go(interp, target, &last);
	}
	for (int side = 0; side < 3; side++) {
		count[side] = parts(box->half[side]);
		half[side] = vec3_scale(1.0 / count[side], box->half[side]);
	}
	add_spread(&part, half);
	all = count[0] * count[1] * count[2];
	for (int i = 0; i < all && all > 1; i++) {
		const slot_values *from = i % 2 ? target : &start, *to = i % 2 ? &start : target;
		vec3 aside = {0, 0, 0};
		int at[3];

		find_part(i, count, at);
		for (int side = 0; side < 3; side++)
			aside = vec3_mad(aside, 2 * at[side] + 1 - count[side], half[side]);
		if (!go_beside(interp, from, aside, &part) || !go_beside(interp, to, aside, &part))
			return false;
	}
	/* Back from the last of them: it stays within the same region, and cuts nothing for certain either. */
	last = part;
	return motion_commands_go(interp, target, &last);
}

bool parallel_moves_go_from_open(struct interp *interp, const slot_values *target, struct canon_move *move,
				 const struct parallel_box *box)
{
	double *loose = interp->comp.loose, open[3];

	memcpy(open, loose, sizeof(open));
	if (!(open[0] + open[1] + open[2] > 0) || !is_plain(interp, target))
		return motion_commands_go(interp, target, move);
	memset(loose, 0, sizeof(open));
	if (!parallel_moves_go(interp, target, move, box))
		return false;
	memcpy(loose, open, sizeof(open));
	return true;
}
