/* nesting.h - shells that are drawn inside out, and shells inside shells. */
#ifndef FIVECHECK_GEOM_NESTING_H
#define FIVECHECK_GEOM_NESTING_H

#include <stddef.h>

#include "geom/mesh.h"
#include "geom/topology.h"

/* A shell whose triangles face the other way than those of the shell around it is a cavity; it is not counted here. */
struct nesting {
	size_t inverted;	/* oriented shells that face inward and are inside no other one */
	size_t nested; /* oriented shells in a little larger one that faces the same way: solid, or a faulty cavity */
};

/* In a mesh with thousands of shells only those that face inward are counted, including cavities. */
void nesting_find(struct nesting *nesting, const struct mesh *mesh, const struct topology *topology);

#endif
