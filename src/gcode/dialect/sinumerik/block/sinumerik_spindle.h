/* sinumerik_spindle.h - the master spindle: it turns the tool; S, M3 and the like without a number mean it. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_BLOCK_SINUMERIK_SPINDLE_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_BLOCK_SINUMERIK_SPINDLE_H

#include "gcode/dialect/sinumerik/state/sinumerik_state.h"

/* Reads what follows SETMS: "(3)", or nothing for the first spindle. False: reported. */
bool sinumerik_spindle_take_master(struct interp *interp, struct lexer *lexer);

/* S3, M3: is the spindle with this number the master? False: reported. */
bool sinumerik_spindle_check(const struct interp *interp, const char *name, int column);

#endif
