/* klartext_preset.h - the preset in force: CYCL DEF 247, PRESET SELECT, and the only preset of a setup. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_PRESET_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_PRESET_H

#include <stdbool.h>

#include "gcode/dialect/klartext/klartext_state.h"

/* CYCL DEF 247: takes effect where its definition ends. False: reported. */
bool klartext_preset_select(struct interp *interp, const struct klartext_cycle *cycle);

/*
 * Which preset is in force at the start is known only if the setup has no other. Asked at each axis word. False:
 * reported.
 */
bool klartext_preset_check(struct interp *interp, int column);

/* Has a preset in a tilted plane left open whether it is still tilted? False: it has, which was reported. */
bool klartext_preset_check_plane(struct interp *interp, int column);

#endif
