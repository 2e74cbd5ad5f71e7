/* sinumerik_orientation.h - TRAORI: the tip of the tool is guided while the tool turns. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_PATH_SINUMERIK_ORIENTATION_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_PATH_SINUMERIK_ORIENTATION_H

#include "gcode/dialect/sinumerik/block/sinumerik_block.h"

/* Executes TRAORI, TRAFOOF, ORIWKS, ORIAXES and the like of the block. False: reported. */
bool sinumerik_orientation_select(struct interp *interp, const struct sinumerik_block *block);

/* How a block turns the tool. */
struct sinumerik_turn {
	bool on_circle;	/* in the plane of its two directions (sinumerik_great_circle.h), else the axes turn evenly */
	bool by_direction;	/* A3= B3= C3= */
	vec3 direction;	/* a unit, as kinematics_orientation has it */
};

/*
 * Under TRAORI: how the tool turns, and the rotary axes of the target where the block gives a direction and they turn
 * evenly. False: reported.
 */
bool sinumerik_orientation_find(struct interp *interp, const struct sinumerik_block *block, slot_values *target,
				struct sinumerik_turn *turn);

/* Gives the target the nearest positions of the rotary axes that turn the tool into this direction. False: reported. */
bool sinumerik_orientation_turn_to(struct interp *interp, int column, vec3 direction, slot_values *target);

#endif
