/* nesting.h - shells that are drawn inside out, and shells inside shells. */
#ifndef FIVECHECK_GEOM_NESTING_H
#define FIVECHECK_GEOM_NESTING_H

#include <stddef.h>

#include "geom/mesh.h"
#include "geom/topology.h"

/* A shell whose triangles face the other way than those of the shell around it is a cavity, and counts nowhere here. */
struct nesting {
	size_t inverted;	/* oriented shells in no other one whose triangles face inward */
	size_t nested;	/* oriented shells in another one that faces the same way: solid throughout, or a faulty cavity */
};

/*
 * Takes time in proportion to triangles times components: of a mesh where that is more than a second or so,
 * only the shells that face inward are counted, cavities among them.
 */
void nesting_find(struct nesting *nesting, const struct mesh *mesh, const struct topology *topology);

#endif
