/* klartext_preset.h - the active preset: CYCL DEF 247, PRESET SELECT, and the only preset of a setup. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_FRAMES_KLARTEXT_PRESET_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_FRAMES_KLARTEXT_PRESET_H

#include <stdbool.h>

#include "gcode/dialect/klartext/state/klartext_state.h"

/* Carries out CYCL DEF 247 at the end of its definition. False: reported. */
bool klartext_preset_select(struct interp *interp, const struct klartext_cycle *cycle);

/*
 * Is the active preset known? At the start of a program it is known only if the setup has a single preset. Called for
 * each axis word. False: reported.
 */
bool klartext_preset_check(struct interp *interp, int column);

/* Is it known whether the plane is still tilted, after a preset in a tilted plane? False: reported. */
bool klartext_preset_check_plane(struct interp *interp, int column);

#endif
