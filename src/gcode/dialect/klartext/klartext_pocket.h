/* klartext_pocket.h - pockets, slots, bores, threads, studs and faces that a cycle mills: where the tool stays. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_POCKET_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_POCKET_H

#include <stdbool.h>

#include "gcode/dialect/klartext/klartext_parameter.h"

/* Is it a cycle of which only the region is known? */
bool klartext_pocket_is(int number);

/* Carries it out as klartext_region_carry_out says. False: reported, or the sink wants no more. */
bool klartext_pocket_make(const struct klartext_call_of *call);

/*
 * The older cycles 3, 4 and 5, whose definition is in lines. The tool stands at the set-up
 * clearance, and comes back there.
 */
bool klartext_pocket_make_old(const struct klartext_call_of *call);

#endif
