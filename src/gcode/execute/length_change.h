/* length_change.h - decides which axes move when a control changes the length compensation. */
#ifndef FIVECHECK_GCODE_EXECUTE_LENGTH_CHANGE_H
#define FIVECHECK_GCODE_EXECUTE_LENGTH_CHANGE_H

#include <stdbool.h>

#include "gcode/state.h"

/* X, Y and Z of the tool in program coordinates; the other slots are 0. */
slot_values length_change_place(const struct interp *interp);

/* The block's change of the length. */
struct length_change {
	int column;	/* of its G-code */
	slot_values shift;	/* the decrease of the coordinates X, Y and Z if the axes do not move */
	int doubt;	/* the code that may have cancelled the former length, or CODE_NONE */
	bool ends_tcp;
};

/*
 * Decides which axes move. Axes with an absolute coordinate in the block reach it in any case. For the other axes the
 * machine file's length_offset_moves decides: with "no" they stay, with "yes" they move by the shift in this block.
 * False: it is not known; the message says what to write.
 */
bool length_change_settle(struct interp *interp, const struct length_change *change);

/* Moves the axes by the shift if the block names no axis and the shift moves them. */
bool length_change_go(struct interp *interp);

#endif
