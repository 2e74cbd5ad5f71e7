/*
 * polar_pieces.h - moves of the plane of polar coordinate interpolation, as its linear and its rotary axis make them.
 */
#ifndef FIVECHECK_GCODE_EXECUTE_POLAR_PIECES_H
#define FIVECHECK_GCODE_EXECUTE_POLAR_PIECES_H

#include <stdbool.h>

#include "gcode/state.h"

/* mm: nearer to the centre it is open which way round the rotary axis turns. */
#define POLAR_CENTRE 0.01

/*
 * Sends a move to the sink. While polar coordinate interpolation is on (state.h), the X and Y of a straight feed or of
 * an arc are a point of the plane: it becomes straight moves of X and the rotary axis, with how far the axes may be
 * beside them. False: reported, or the sink wants no more.
 */
bool polar_pieces_tell(struct interp *interp, const struct canon_move *move);

#endif
