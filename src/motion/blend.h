/* blend.h - how far a control may leave the programmed path when it rounds corners (G64, path_tolerance). */
#ifndef FIVECHECK_MOTION_BLEND_H
#define FIVECHECK_MOTION_BLEND_H

#include <stdbool.h>

#include "base/same_double.h"
#include "gcode/canon.h"
#include "machine/machine.h"
#include "motion/axis_table.h"

/*
 * The path tolerance of each axis of the machine, mm and radians. The P of G64 counts if it is given. Otherwise the
 * machine file's path_tolerance counts, with or without G64, because controls blend from power-on until G61. P is a
 * length: rotary axes take the program's own tolerance of turns (canon_move.blend_turn), or else the machine file's
 * degrees or, without these, P as degrees.
 */
struct blend {
	bool taken;	/* from a move with: */
	bool on;
	double programmed, turn;
	axis_values tolerance;
};

/* blend_take for a move that differs from the last one. */
void blend_change(struct blend *blend, const struct machine *machine, const struct axis_table *axes,
		  const struct canon_move *move);

/* Takes the data of the move, which rarely changes. A blend of zeros has not seen a move yet. */
static inline void blend_take(struct blend *blend, const struct machine *machine, const struct axis_table *axes,
			      const struct canon_move *move)
{
	if (!blend->taken || blend->on != move->blend || !same_double(blend->programmed, move->blend_tolerance) ||
	    !same_double(blend->turn, move->blend_turn))
		blend_change(blend, machine, axes, move);
}

/* Is G64 active without a tolerance from the program or the machine file? */
bool blend_is_unbounded(const struct machine *machine, const struct canon_move *move);

#endif
