/* tilted_plane.h - the tilted plane of the words of G68.2: given by angles, points, or directions. */
#ifndef FIVECHECK_GCODE_EXECUTE_TILTED_PLANE_H
#define FIVECHECK_GCODE_EXECUTE_TILTED_PLANE_H

#include "gcode/state.h"

/*
 * Reads the block's G68.2. *complete: the plane is known; *turn rotates its directions to those of the work offset, and
 * *origin is its origin, mm relative to the active offsets. Otherwise further blocks give the rest. False: the words
 * describe no plane, which was reported.
 */
bool tilted_plane_take(struct interp *interp, bool *complete, mat3 *turn, vec3 *origin);

/* Call first for each block: refuses other blocks between the blocks of one plane. */
bool tilted_plane_check_block(struct interp *interp);

#endif
