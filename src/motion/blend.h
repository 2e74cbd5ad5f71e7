/* blend.h - how far a control may leave the programmed path to round its corners (G64, path_tolerance). */
#ifndef FIVECHECK_MOTION_BLEND_H
#define FIVECHECK_MOTION_BLEND_H

#include <stdbool.h>

#include "gcode/canon.h"
#include "machine/machine.h"

/*
 * The path tolerance of each axis that the machine has, mm and radians. The P of G64 counts if there is one; else the
 * machine file's path_tolerance, with or without G64: controls blend from power-on until G61, and a program need not
 * have said either. P is a length: rotary axes take the machine file's degrees or, if it gives none, P as degrees.
 */
axis_values blend_path_tolerance(const struct machine *machine, const struct canon_move *move);

/* G64 is in force, and neither the program nor the machine file gives a tolerance. */
bool blend_is_unbounded(const struct machine *machine, const struct canon_move *move);

#endif
