/* sinumerik_pattern.h - patterns of holes: HOLES1, HOLES2, CYCLE802. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_PATTERN_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_PATTERN_H

#include "gcode/dialect/sinumerik/sinumerik_state.h"

/* Is it a pattern of holes? */
bool sinumerik_pattern_is(const char *name);

/* Goes to each hole of the pattern and drills it by the modal cycle, if there is one. False: reported. */
bool sinumerik_pattern_run(struct interp *interp, const char *name, int column);

/* Carries out the cycle that MCALL has given, where the tool is. False: reported. */
bool sinumerik_pattern_modal_cycle(struct interp *interp);

#endif
