/* dynamic_work_offset.h - G254 and G255 of Haas: the work zero where the turned table has taken it. */
#ifndef FIVECHECK_GCODE_EXECUTE_DYNAMIC_WORK_OFFSET_H
#define FIVECHECK_GCODE_EXECUTE_DYNAMIC_WORK_OFFSET_H

#include <stdbool.h>

#include "gcode/state.h"

/*
 * Haas mill operator's manual (NGC), "G254 Dynamic Work Offset (DWO)": while it
 * is on, the place to which the rotary axes have carried the work zero stands
 * in for X, Y and Z of the work offset. That is a shift: the coordinates stay
 * parallel to the machine's axes. The manual wants the work offset selected and
 * all rotary motion done before it, X, Y and Z led somewhere before anything is
 * cut, and G255 before any rotary motion; programs that do otherwise are
 * refused, because it does not say where the control would take them.
 */

/* Before anything of the block is carried out: does it keep to that? False: reported. */
bool dynamic_work_offset_start_block(struct interp *interp);

/* G254 and G255 of the block; nothing without one. False: reported. */
bool dynamic_work_offset_switch(struct interp *interp);

/* The work offset that the block selects is the one in force, or G254 is not. False: reported. */
bool dynamic_work_offset_check_system(struct interp *interp, int system);

/* What the block's axis words say after G254 or G255 is known. False: reported. */
bool dynamic_work_offset_check_words(struct interp *interp);

/* The block cuts nothing, or X, Y and Z have been led somewhere since; after G255 by the block itself at the latest. */
bool dynamic_work_offset_check_cut(struct interp *interp);

/* No rotary axis leaves its place for this position while G254 is in force. False: reported. */
bool dynamic_work_offset_check_turn(struct interp *interp, const slot_values *position);

/* Is the coordinate that a program would read the control's? False: reported at the column. */
bool dynamic_work_offset_check_read(struct interp *interp, int slot, int column);

/* G28 ignores G254 on its way, too: the offset in force without it, and then with it again. */
void dynamic_work_offset_suspend(struct state *state, bool *suspended);
void dynamic_work_offset_resume(struct state *state, bool suspended);

#endif
