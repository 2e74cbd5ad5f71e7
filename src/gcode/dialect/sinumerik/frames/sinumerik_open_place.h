/* sinumerik_open_place.h - the uncertain position of the tool after a milling cycle whose path is not known. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_FRAMES_SINUMERIK_OPEN_PLACE_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_FRAMES_SINUMERIK_OPEN_PLACE_H

#include "gcode/dialect/sinumerik/state/sinumerik_state.h"

/*
 * From now on the position of the tool is uncertain, by a box about its place. `half`: half the size of the box along
 * the program's axes, mm.
 */
void sinumerik_open_place_set(struct interp *interp, const double half[SLOT_Z + 1]);

/* G40 without a move also makes the position uncertain: takes over this uncertainty. */
void sinumerik_open_place_take_over(struct interp *interp);

/* The axes of the program (letter_bit) have moved to commanded positions: along them the position is certain again. */
void sinumerik_open_place_settle(struct interp *interp, uint32_t letters);

/* The same for axes of the machine, while no transformation is on. */
void sinumerik_open_place_settle_machine(struct interp *interp, uint32_t letters);

/*
 * Is the position of the tool certain? False: it is not, which was reported; `what` names in the message the thing
 * that needs the position.
 */
bool sinumerik_open_place_check(const struct interp *interp, int column, const char *what);

/*
 * Call before coordinates rotate (CYCLE800, TRAORI and their ends), and before the axes of the machine move while
 * CYCLE800 has swivelled: an uncertainty in an unknown direction may then be one along any axis.
 */
void sinumerik_open_place_turned(struct interp *interp);

/*
 * Moves to a target in program coordinates. The tool may be anywhere in a box about the path; if its position was
 * uncertain at the start, the uncertainty continues along the path. At the end the position is certain. A feed of 0
 * (mm/s) is a rapid. False: reported.
 */
bool sinumerik_open_place_go(struct interp *interp, const slot_values *target, const double half[SLOT_Z + 1],
			     double feed);

#endif
