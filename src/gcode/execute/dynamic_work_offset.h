/* dynamic_work_offset.h - G254 and G255 of Haas: a work zero that follows the turned table. */
#ifndef FIVECHECK_GCODE_EXECUTE_DYNAMIC_WORK_OFFSET_H
#define FIVECHECK_GCODE_EXECUTE_DYNAMIC_WORK_OFFSET_H

#include <stdbool.h>

#include "gcode/state.h"

/*
 * Haas mill operator's manual (NGC), "G254 Dynamic Work Offset (DWO)": while G254 is on, X, Y and Z of the work offset
 * are the place to which the rotary axes have carried the work zero. This is only a shift: the coordinates stay
 * parallel to the machine's axes. The manual requires that a program selects the work offset and completes all rotary
 * motion before G254, moves X, Y and Z before it cuts, and commands G255 before any rotary motion. Other programs are
 * refused, because the manual does not say where the axes would move.
 */

/* Call first for each block: refuses what the manual does not allow together with G254. */
bool dynamic_work_offset_start_block(struct interp *interp);

/* Carries out the block's G254 or G255, if it has one. False: reported. */
bool dynamic_work_offset_switch(struct interp *interp);

/* Refuses the selection of another work offset while G254 is on. */
bool dynamic_work_offset_check_system(struct interp *interp, int system);

/* Refuses increments from a coordinate that is not known after G254 or G255. */
bool dynamic_work_offset_check_words(struct interp *interp);

/* Refuses a cut after G254 or G255 before absolute words have moved X, Y and Z. */
bool dynamic_work_offset_check_cut(struct interp *interp);

/* Refuses a position that turns a rotary axis while G254 is on. */
bool dynamic_work_offset_check_turn(struct interp *interp, const slot_values *position);

/* Can a program read this coordinate? False: it is not known, which was reported at the column. */
bool dynamic_work_offset_check_read(struct interp *interp, int slot, int column);

/* G28 ignores G254: suspend cancels the offset for the duration of G28, resume restores it. */
void dynamic_work_offset_suspend(struct state *state, bool *suspended);
void dynamic_work_offset_resume(struct state *state, bool suspended);

#endif
