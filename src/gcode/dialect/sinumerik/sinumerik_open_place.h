/* sinumerik_open_place.h - the uncertain position of the tool after a milling cycle whose path is not known. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_OPEN_PLACE_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_OPEN_PLACE_H

#include "gcode/dialect/sinumerik/sinumerik_state.h"

/*
 * From now on the tool is somewhere in a box about its place; `half`: half its size along the program's axes, mm.
 */
void sinumerik_open_place_set(struct interp *interp, const double half[SLOT_Z + 1]);

/* A place that G40 without a move has left open counts as one, too. */
void sinumerik_open_place_take_over(struct interp *interp);

/* The axes of the program (letter_bit) have been commanded to a position: along them the tool is where it should be. */
void sinumerik_open_place_settle(struct interp *interp, uint32_t letters);

/* The same of the axes of the machine, while no transformation is on. */
void sinumerik_open_place_settle_machine(struct interp *interp, uint32_t letters);

/*
 * Is the place of the tool known? False: it is not, which was reported; `what` names in the message the thing that
 * needs the place.
 */
bool sinumerik_open_place_check(const struct interp *interp, int column, const char *what);

/*
 * Call before coordinates turn (CYCLE800, TRAORI and their ends), and before the axes of the machine are moved while
 * CYCLE800 has swivelled: where the tool stands aside in a direction that is not known, it may then be aside along any
 * axis.
 */
void sinumerik_open_place_turned(struct interp *interp);

/*
 * To a target in program coordinates, anywhere in a box about the way there; from where the tool has been left open,
 * as far beside the way as there. Its end is closed again. A feed of 0, mm/s, is a rapid. False: reported.
 */
bool sinumerik_open_place_go(struct interp *interp, const slot_values *target, const double half[SLOT_Z + 1],
			     double feed);

#endif
