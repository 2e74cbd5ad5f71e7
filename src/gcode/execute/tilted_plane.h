/* tilted_plane.h - the plane that the words of G68.2 describe: by angles, by points, or by directions. */
#ifndef FIVECHECK_GCODE_EXECUTE_TILTED_PLANE_H
#define FIVECHECK_GCODE_EXECUTE_TILTED_PLANE_H

#include "gcode/state.h"

/*
 * Takes the block's G68.2. *complete: the plane is known now, *turn leads from its directions to those of the work
 * offset, and *origin is where it lies, mm from the offsets in force. Else further blocks give the rest. False:
 * the words describe no plane, which was reported.
 */
bool tilted_plane_take(struct interp *interp, bool *complete, mat3 *turn, vec3 *origin);

/* Call before anything else of a block: refuses what stands between the blocks of one plane. */
bool tilted_plane_check_block(struct interp *interp);

#endif
