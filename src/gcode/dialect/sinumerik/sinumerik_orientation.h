/* sinumerik_orientation.h - TRAORI: the tool's tip is guided, and the tool turns. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_ORIENTATION_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_ORIENTATION_H

#include "gcode/dialect/sinumerik/sinumerik_block.h"

/* Carries out TRAORI, TRAFOOF, ORIWKS, ORIAXES and the like of the block. False: reported. */
bool sinumerik_orientation_select(struct interp *interp, const struct sinumerik_block *block);

/*
 * Under TRAORI: the rotary axes of the target where the block gives a direction (A3= B3= C3=), and whether the way
 * there is one that can be followed. False: reported.
 */
bool sinumerik_orientation_find(struct interp *interp, const struct sinumerik_block *block, slot_values *target);

#endif
