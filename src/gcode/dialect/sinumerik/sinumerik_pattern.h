/* sinumerik_pattern.h - patterns of holes: HOLES1, HOLES2, CYCLE801, CYCLE802. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_PATTERN_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_PATTERN_H

#include "gcode/dialect/sinumerik/sinumerik_state.h"

/* Is it a pattern of holes? */
bool sinumerik_pattern_is(const char *name);

/*
 * Goes to each hole of the pattern and carries out the modal cycle there, if there is one. A modal subprogram is called
 * at the first hole; sinumerik_pattern_go_on leads to the others. False: reported.
 */
bool sinumerik_pattern_run(struct interp *interp, const char *name, int column);

/* Has the subprogram that was called at a hole come back to the line of the pattern? */
bool sinumerik_pattern_waits(struct interp *interp);

/* To the next hole, or behind the pattern. False: reported. */
bool sinumerik_pattern_go_on(struct interp *interp);

/* Carries out the cycle that MCALL has given, where the tool is, or calls its subprogram. False: reported. */
bool sinumerik_pattern_modal(struct interp *interp);

#endif
