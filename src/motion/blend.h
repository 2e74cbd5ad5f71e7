/* blend.h - how far a control may leave the programmed path when it rounds corners (G64, path_tolerance). */
#ifndef FIVECHECK_MOTION_BLEND_H
#define FIVECHECK_MOTION_BLEND_H

#include <stdbool.h>

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
	double linear, rotary;
	axis_values tolerance;
};

/* Takes over what the move says. A blend of zeros is that of a control that keeps to the path. */
void blend_take(struct blend *blend, const struct machine *machine, const struct axis_table *axes,
		const struct canon_move *move);

/* Is G64 in force without a tolerance from the program or the machine file? */
bool blend_is_unbounded(const struct machine *machine, const struct canon_move *move);

#endif
