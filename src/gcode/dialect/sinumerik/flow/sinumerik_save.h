/* sinumerik_save.h - PROC ... SAVE: the return restores G-codes and the programmable frame. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_FLOW_SINUMERIK_SAVE_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_FLOW_SINUMERIK_SAVE_H

#include "gcode/dialect/sinumerik/state/sinumerik_state.h"

void sinumerik_save_modes(const struct interp *interp, struct sinumerik_saved *saved);

/* Restores the modes at the return. False: reported at the column. */
bool sinumerik_save_restore(struct interp *interp, const struct sinumerik_saved *saved, int column);

#endif
