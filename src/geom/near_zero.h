/* near_zero.h - closes meshes that are open only by the rounding of coordinates that were meant to be 0. */
#ifndef FIVECHECK_GEOM_NEAR_ZERO_H
#define FIVECHECK_GEOM_NEAR_ZERO_H

#include "geom/mesh.h"

/*
 * A program that draws round bodies with sines may compute one corner as 0 for one triangle and as sin(2 pi) times the
 * radius for its neighbour: -2.4e-16 times it in double, 1.7e-7 times it in float. If that is all that opens the mesh,
 * these coordinates become 0, and the largest displacement of a corner is added to mesh->rounding. Any other mesh stays
 * as it is.
 */
void near_zero_close(struct mesh *mesh);

#endif
