/* cube.h - a cube of the stock. */
#ifndef FIVECHECK_STOCK_CUBE_H
#define FIVECHECK_STOCK_CUBE_H

#include "geom/vec3.h"

struct cube {
	vec3 centre;
	double half;	/* mm: half of an edge; the edges are those of the coordinates */
};

#endif
