/* length_change.h - what moves where Fanuc and Haas controls change the length compensation. */
#ifndef FIVECHECK_GCODE_EXECUTE_LENGTH_CHANGE_H
#define FIVECHECK_GCODE_EXECUTE_LENGTH_CHANGE_H

#include <stdbool.h>

#include "gcode/state.h"

/* X, Y and Z as the program speaks of where the tool is; the other slots are 0. */
slot_values length_change_place(const struct interp *interp);

/* A change of the length, of the block in hand. */
struct length_change {
	int column;	/* of its G-code */
	slot_values shift;	/* what it takes from the coordinates of X, Y and Z while the axes stand */
	int doubt;	/* the code that may have taken the former length back, or CODE_NONE */
	bool ends_tcp;
};

/*
 * Coordinates that the block gives absolutely are reached either way. For the
 * rest the machine file's length_offset_moves decides: "no" leaves the axes,
 * "yes" moves them by the shift with this block. False: reported, with what to write.
 */
bool length_change_settle(struct interp *interp, const struct length_change *change);

/* The motion of a block that names no axis; nothing if none is due. */
bool length_change_go(struct interp *interp);

#endif
