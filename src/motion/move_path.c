#include "motion/move_path.h"

#include <math.h>

#include "base/same_double.h"
#include "geom/tolerance.h"

/* Ends the path at `end`; an axis that differs from its start by rounding only keeps its start. */
static void end_at(struct path *path, const axis_values *end)
{
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		const double start = path->start.v[slot], there = end->v[slot];

		path->end.v[slot] = fabs(there - start) <= OFFSET_DUST ? start : there;
	}
}

bool move_path_moves(const struct path *path)
{
	for (int slot = 0; slot < SLOT_COUNT; slot++)
		if (!same_double(path->start.v[slot], path->end.v[slot]))
			return true;
	return false;
}

int move_path_axes(const struct path *path)
{
	int count = 0;

	for (int slot = 0; slot < SLOT_COUNT; slot++)
		count += !same_double(path->start.v[slot], path->end.v[slot]);
	return count;
}

/*
 * Under TCP a rapid keeps the tip on a line only on machines with linear rapids. On others each axis moves on its own
 * to the same end, and the path of the tip is unknown.
 */
static bool goes_as_axes(const struct move_start *from, const struct canon_move *move)
{
	return move->tcp && move->kind == CANON_RAPID && from->machine->controller.rapid != RAPID_LINEAR;
}

static bool turns(const struct path *path)
{
	for (int slot = SLOT_A; slot <= SLOT_C; slot++)
		if (!same_double(path->start.v[slot], path->end.v[slot]))
			return true;
	return false;
}

static enum path_kind kind_of(const struct move_start *from, const struct canon_move *move,
			      const struct path *path)
{
	if (goes_as_axes(from, move) && turns(path))
		return PATH_BOX;
	if (move->tcp && !goes_as_axes(from, move))
		return PATH_TCP;
	if (move->kind == CANON_ARC)
		return PATH_ARC;
	if (move->kind == CANON_RAPID && (move->apart || from->machine->controller.rapid == RAPID_ANY) &&
	    move_path_axes(path) > 1)
		return PATH_BOX;
	return PATH_STRAIGHT;
}

void move_path_set(struct path *path, const struct move_start *from, const struct canon_move *move,
		   struct path *guided)
{
	path->circular = move->kind == CANON_ARC;
	if (!move->tcp)
		path->start = *from->position;
	else if (from->controller)
		path->start = *from->controller;
	else
		path->start = tcp_from_machine(from->tcp, from->position);
	end_at(path, &move->end);
	if (path->circular) {
		path->arc = move->arc;
		/* An arc keeps its X Y Z, which belong to its centre and sweep. */
		for (int slot = SLOT_X; slot <= SLOT_Z; slot++)
			path->end.v[slot] = move->end.v[slot];
	}
	if (goes_as_axes(from, move)) {
		const axis_values end = tcp_to_machine(from->tcp, &path->end);

		*guided = *path;
		path->start = *from->position;
		end_at(path, &end);
	}
	path->kind = kind_of(from, move, path);
	path->tcp = path->kind == PATH_TCP ? from->tcp : NULL;
}
