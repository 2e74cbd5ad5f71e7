/* sinumerik_region.h - milling cycles of which the region is known in which the tool stays, but not its path. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_REGION_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_REGION_H

#include "gcode/dialect/sinumerik/sinumerik_state.h"

/* Pockets, slots, long holes, faces, and threads that are milled from within. */
bool sinumerik_region_is(const char *name);

/*
 * Carries one out: the tool goes to the retraction plane over the region, may be anywhere in the region down to its
 * depth, and comes back to the retraction plane; where it stands over the region stays open. `arguments` as for
 * sinumerik_cycle_drill. False: reported.
 */
bool sinumerik_region_mill(struct interp *interp, const char *name, const double *arguments, size_t count, int column);

/* Can MCALL call it at positions, with these arguments? False: reported. */
bool sinumerik_region_check_modal(struct interp *interp, const char *name, const double *arguments, size_t count,
				  int column);

/* As sinumerik_region_mill, at the place where the tool is over the plane. */
bool sinumerik_region_mill_here(struct interp *interp, const char *name, const double *arguments, size_t count,
				int column);

#endif
