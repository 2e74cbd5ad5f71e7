/* length_change.h - what moves where a control changes the length compensation. */
#ifndef FIVECHECK_GCODE_EXECUTE_LENGTH_CHANGE_H
#define FIVECHECK_GCODE_EXECUTE_LENGTH_CHANGE_H

#include <stdbool.h>

#include "gcode/state.h"

/* X, Y and Z of the tool in program coordinates; the other slots are 0. */
slot_values length_change_place(const struct interp *interp);

/* The block's change of the length. */
struct length_change {
	int column;	/* of its G-code */
	slot_values shift;	/* how much smaller X, Y and Z become while the axes stand */
	int doubt;	/* the code that may have taken the former length back, or CODE_NONE */
	bool ends_tcp;
};

/*
 * Decides what moves. The axes reach absolute coordinates of the block in any
 * case. For other axes the machine file's length_offset_moves decides: "no"
 * leaves them, "yes" moves them by the shift with this block. False: it is not
 * known; the message says what to write.
 */
bool length_change_settle(struct interp *interp, const struct length_change *change);

/* Moves the axes by the shift if the block names no axis and the shift moves them. */
bool length_change_go(struct interp *interp);

#endif
