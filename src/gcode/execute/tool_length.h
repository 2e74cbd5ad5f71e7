/* tool_length.h - tool length compensation, and switching of tool centre point control. */
#ifndef FIVECHECK_GCODE_EXECUTE_TOOL_LENGTH_H
#define FIVECHECK_GCODE_EXECUTE_TOOL_LENGTH_H

#include <stdbool.h>

#include "gcode/state.h"

/* Carries out the block's G43, G43.4, G234 or G49, if it has one. length_change.h decides whether axes move then. */
bool tool_length_select(struct interp *interp);

/* The rotary zero of TCP with the active offsets. */
axis_values tool_length_rotary_zero(const struct interp *interp);

/* Switches TCP, with the active length. False: the machine cannot do it, which was reported at the column. */
bool tool_length_switch_tcp(struct interp *interp, int column, enum tcp_source source);

/* Carries out the machine's M-code that switches TCP, if the block has one. */
bool tool_length_mcode(struct interp *interp);

/*
 * Call after a change of offsets: passes the new rotary zero to the kinematics, if TCP is on and depends on it. False:
 * reported at the column.
 */
bool tool_length_offsets_changed(struct interp *interp, int column);

/* Call after G28, G30, G53 or DOUBT_M6 has moved the marked axes: the control may have cancelled the length. */
void tool_length_after_machine(struct interp *interp, int code, const bool moved[SLOT_COUNT]);

/* May the control have cancelled a length on which the axis' coordinate depends? True: reported at the column. */
bool tool_length_is_in_doubt(struct interp *interp, int slot, int column);

struct suspended {
	enum tcp_source tcp;
	bool frame;
};

/*
 * Between these two calls positions are those of the machine's axes, without TCP and turned coordinates, for the codes
 * that move the machine's axes (G28, G30, G53, M6). suspend sets the data for resume. False: reported at the column.
 */
bool tool_length_suspend(struct interp *interp, int column, struct suspended *suspended);
bool tool_length_resume(struct interp *interp, int column, const struct suspended *suspended);

#endif
