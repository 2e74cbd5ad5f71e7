/* sinumerik_pattern.h - patterns of holes: HOLES1, HOLES2, CYCLE801, CYCLE802. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_CYCLES_SINUMERIK_PATTERN_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_CYCLES_SINUMERIK_PATTERN_H

#include "gcode/dialect/sinumerik/state/sinumerik_state.h"

/* Is it the name of a pattern of holes? */
bool sinumerik_pattern_is(const char *name);

/*
 * Moves to each hole of the pattern, and executes the modal cycle there if there is one. A modal subprogram is called
 * at the first hole; sinumerik_pattern_go_on continues with the other holes. False: reported.
 */
bool sinumerik_pattern_run(struct interp *interp, const char *name, int column);

/* Has the subprogram that was called at a hole returned to the line of the pattern? */
bool sinumerik_pattern_waits(struct interp *interp);

/* Moves to the next hole, or ends the pattern. False: reported. */
bool sinumerik_pattern_go_on(struct interp *interp);

/* Executes the cycle of MCALL at the present place, or calls its subprogram. False: reported. */
bool sinumerik_pattern_modal(struct interp *interp);

#endif
