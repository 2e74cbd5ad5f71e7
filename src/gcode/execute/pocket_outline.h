/* pocket_outline.h - the outline of a pocket of G150: its box and its direction. */
#ifndef FIVECHECK_GCODE_EXECUTE_POCKET_OUTLINE_H
#define FIVECHECK_GCODE_EXECUTE_POCKET_OUTLINE_H

#include <stdbool.h>

#include "gcode/state.h"

/* Adds a straight move or an arc of the plane XY. The first one is the move from the hole to the outline. */
void pocket_outline_take(struct pocket_milling *pocket, const struct canon_move *move);

/* Does the outline end at its start, the end of the first move? */
bool pocket_outline_is_closed(const struct pocket_milling *pocket);

#endif
