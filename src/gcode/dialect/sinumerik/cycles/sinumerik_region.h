/* sinumerik_region.h - milling cycles whose region is known, but not the path of the tool in it. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_CYCLES_SINUMERIK_REGION_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_CYCLES_SINUMERIK_REGION_H

#include "gcode/dialect/sinumerik/state/sinumerik_state.h"

/* Is it the name of a pocket, slot, long hole, face, or internal thread? */
bool sinumerik_region_is(const char *name);

/*
 * Executes such a cycle: the tool moves to the retraction plane above the region, may be anywhere in the region down
 * to its depth, and returns to the retraction plane. After it the position above the region is uncertain. `arguments`
 * as for sinumerik_cycle_drill. False: reported.
 */
bool sinumerik_region_mill(struct interp *interp, const char *name, const double *arguments, size_t count, int column);

/* Can MCALL call it at positions, with these arguments? False: reported. */
bool sinumerik_region_check_modal(struct interp *interp, const char *name, const double *arguments, size_t count,
				  int column);

/* The same, at the present place of the tool in the plane. */
bool sinumerik_region_mill_here(struct interp *interp, const char *name, const double *arguments, size_t count,
				int column);

#endif
