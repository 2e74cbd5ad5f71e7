/* klartext_pocket.h - milling cycles for pockets, slots, bores, threads, studs and faces: the region of the tool. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_CYCLES_KLARTEXT_POCKET_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_CYCLES_KLARTEXT_POCKET_H

#include <stdbool.h>

#include "gcode/dialect/klartext/cycles/klartext_parameter.h"

/* Is this a cycle of which only the region is known? */
bool klartext_pocket_is(int number);

/* Carries out the cycle by klartext_region_carry_out. False: reported, or the sink wants no more. */
bool klartext_pocket_make(const struct klartext_call_of *call);

/*
 * Carries out the older cycles 3, 4 and 5, whose definition has several lines. The tool starts at the set-up clearance
 * and returns there.
 */
bool klartext_pocket_make_old(const struct klartext_call_of *call);

#endif
