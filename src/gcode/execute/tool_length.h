/* tool_length.h - tool length compensation, and tool centre point control on and off. */
#ifndef FIVECHECK_GCODE_EXECUTE_TOOL_LENGTH_H
#define FIVECHECK_GCODE_EXECUTE_TOOL_LENGTH_H

#include <stdbool.h>

#include "gcode/state.h"

/* G43, G43.4 and G49 of the block; nothing without one. What axes do meanwhile: length_change.h. */
bool tool_length_select(struct interp *interp);

/* Rotary zero under TCP with the offsets in force. */
axis_values tool_length_rotary_zero(const struct interp *interp);

/* TCP on or off with the length in force; `column` is to blame if the sink objects. */
bool tool_length_switch_tcp(struct interp *interp, int column, enum tcp_source source);

/* The machine's own M-codes of the block that switch TCP. */
bool tool_length_mcode(struct interp *interp);

/*
 * Under TCP, tells the sink about work offsets that have changed, when rotary
 * zero depends on them; `column` is to blame if the sink objects.
 */
bool tool_length_offsets_changed(struct interp *interp, int column);

/*
 * Between these two, positions are those of the machine's axes, TCP and turned
 * coordinates or not, for the codes that move the axes themselves (G28, G30,
 * G53, M6). suspend fills in what resume needs.
 */
struct suspended {
	enum tcp_source tcp;
	bool frame;
};

/* After G28, G30, G53 or DOUBT_M6 has moved the axes marked: what became of the length compensation. */
void tool_length_after_machine(struct interp *interp, int code, const bool moved[SLOT_COUNT]);

/* Does it depend on such a length where a program coordinate of the axis is? True: reported at the column. */
bool tool_length_is_in_doubt(struct interp *interp, int slot, int column);

bool tool_length_suspend(struct interp *interp, int column, struct suspended *suspended);
bool tool_length_resume(struct interp *interp, int column, const struct suspended *suspended);

#endif
