/* cutter_comp.h - cutter radius compensation (G40, G41, G42) of LinuxCNC: moves beside the programmed path. */
#ifndef FIVECHECK_GCODE_EXECUTE_CUTTER_COMP_CUTTER_COMP_H
#define FIVECHECK_GCODE_EXECUTE_CUTTER_COMP_CUTTER_COMP_H

#include <stdbool.h>

#include "gcode/state.h"

/*
 * LinuxCNC's manual, "Cutter Compensation", and its 2.9 interpreter: the first
 * move leads beside the path, outside corners are rounded, at inside ones the
 * ways are cut off where they cross. The end of a move is known only with the
 * next one: moves wait, and the ends of their blocks with them. While
 * compensation is on, state.position is the programmed point.
 */

/* Before anything else of the block, and after G40 to G42: what compensation forbids. */
bool cutter_comp_start_block(struct interp *interp);
bool cutter_comp_check_block(struct interp *interp);

/* G40, G41, G41.1, G42, G42.1 of the block; nothing without one. */
bool cutter_comp_select(struct interp *interp);

/* The block's G41 or G42: the side and the radius, checked; the entry is made by the next move. */
bool cutter_comp_switch_on(struct interp *interp);

/* Moves are to be made by cutter_comp_line and cutter_comp_arc. */
bool cutter_comp_is_on(const struct interp *interp);

/* To the programmed position; of an arc the programmed centre and its turns. */
bool cutter_comp_line(struct interp *interp, const slot_values *target, struct canon_move *move);
bool cutter_comp_arc(struct interp *interp, const slot_values *target, struct plane_point centre, int turns,
		     struct canon_move *move);

/* Tells the sink that the block is carried out, once its moves are. */
bool cutter_comp_end_block(struct interp *interp);

/* The program stops here: what waits ends where it stands. */
bool cutter_comp_stop(struct interp *interp);

#endif
