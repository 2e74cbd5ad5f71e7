/*
 * polar_pieces.h - converts moves in the plane of polar coordinate interpolation to moves of the linear and the rotary
 * axis.
 */
#ifndef FIVECHECK_GCODE_EXECUTE_POLAR_PIECES_H
#define FIVECHECK_GCODE_EXECUTE_POLAR_PIECES_H

#include <stdbool.h>

#include "gcode/state.h"

/* mm: closer to the centre, the direction in which the rotary axis turns is not known. */
#define POLAR_CENTRE 0.01

/*
 * Sends a move to the sink. While polar coordinate interpolation is on (state.h), X and Y of a straight feed or an arc
 * are a point of the plane: the move is sent as straight moves of X and the rotary axis, with the distances that the
 * axes may be from them. False: reported, or the sink wants no more.
 */
bool polar_pieces_tell(struct interp *interp, const struct canon_move *move);

#endif
