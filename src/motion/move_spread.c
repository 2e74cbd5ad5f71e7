#include "motion/move_spread.h"

static void add_linear(struct move_spread *spread, const struct machine *machine, const struct canon_move *move,
		       const axis_values *beside, axis_values *tolerance)
{
	for (size_t i = 0; i < machine->axis_count; i++) {
		const int slot = machine->axes[i].slot;

		if (slot > SLOT_Z || !(beside->v[slot] > 0))
			continue;
		tolerance->v[slot] += beside->v[slot];
		if (move->between[slot] && move->kind != CANON_ARC && !move->tcp)
			continue;
		spread->room.v[slot] = beside->v[slot];
		spread->acts = true;
	}
}

static void add_rotary(struct move_spread *spread, const struct canon_move *move, axis_values *tolerance)
{
	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		const double beside = move->turn_spread[slot - SLOT_A];

		if (!(beside > 0))
			continue;
		tolerance->v[slot] += beside;
		spread->room.v[slot] += beside;
		spread->acts = spread->turns = true;
	}
}

void move_spread_find(struct move_spread *spread, const struct machine *machine, const struct tcp *tcp,
		      const axis_values *position, const struct canon_move *move, axis_values *tolerance)
{
	axis_values beside = {{move->spread[0], move->spread[1], move->spread[2]}};

	/* Under TCP the spread is along X, Y and Z of the workpiece, which a table rotates. */
	if (move->tcp)
		beside = tcp_spread(tcp, position, &move->end, move->spread);
	*spread = (struct move_spread){0};
	add_linear(spread, machine, move, &beside, tolerance);
	add_rotary(spread, move, tolerance);
}

void move_spread_follow(struct move_spread *spread, const struct tcp *tcp, const struct canon_move *move,
			const struct path *path, axis_values *tolerance)
{
	const axis_values follow = tcp_follow(tcp, &path->start, &path->end, move->turn_spread);

	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		tolerance->v[slot] += follow.v[slot];
		spread->room.v[slot] += follow.v[slot];
	}
}
