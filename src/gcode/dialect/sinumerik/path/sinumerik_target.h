/* sinumerik_target.h - the end position that the axis words of a block command. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_PATH_SINUMERIK_TARGET_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_PATH_SINUMERIK_TARGET_H

#include "gcode/dialect/sinumerik/block/sinumerik_block.h"

/*
 * Is everything known that the words need: units, G90 or G91, the plane, the work offset, the edge of the tool, the
 * frames? False: it is not; the report names what would tell it.
 */
bool sinumerik_target_check(struct interp *interp, const struct sinumerik_block *block, bool machine, bool arc);

/* The same for a cycle, whose coordinates are absolute lengths in the active plane. */
bool sinumerik_target_check_cycle(struct interp *interp, int column);

/* Program coordinates at the end of the block's motion, mm and degrees. Other axes stay. False: reported. */
bool sinumerik_target_find(struct interp *interp, const struct sinumerik_block *block, slot_values *target);

/* The same for SUPA, G53 and G153: positions of the machine's axes, for which the tool length still counts. */
bool sinumerik_target_find_machine(struct interp *interp, const struct sinumerik_block *block, slot_values *target);

/* A length of the block in mm. */
double sinumerik_target_length(const struct interp *interp, double value);

/* A coordinate of a circle's centre or intermediate point, from `start` or absolute. */
double sinumerik_target_centre(const struct interp *interp, double value, enum sinumerik_way way, bool modal_absolute,
			       double start);

/*
 * Is it unknown whether TRAORI and CYCLE800 count rotary axes from their offsets, and does it matter? False: both,
 * which was reported.
 */
bool sinumerik_target_check_rotary_zero(const struct interp *interp, int column);

#endif
