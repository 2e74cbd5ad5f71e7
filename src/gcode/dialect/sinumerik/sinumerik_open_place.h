/* sinumerik_open_place.h - where a milling cycle has left the tool, of which only the region is known. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_OPEN_PLACE_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_OPEN_PLACE_H

#include "gcode/dialect/sinumerik/sinumerik_state.h"

/*
 * Does the tool stand at a place that is known? False: it does not, which was reported: `what` names what needs the
 * place.
 */
bool sinumerik_open_place_check(const struct interp *interp, int column, const char *what);

/*
 * Call before coordinates turn (CYCLE800, TRAORI and their ends): where the tool stands aside in a direction that is
 * not known, it may then be aside along any axis.
 */
void sinumerik_open_place_turned(struct interp *interp);

#endif
