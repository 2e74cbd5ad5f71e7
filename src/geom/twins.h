/* twins.h - triangles that are drawn from both sides: the same three vertices, facing opposite ways. */
#ifndef FIVECHECK_GEOM_TWINS_H
#define FIVECHECK_GEOM_TWINS_H

#include <stddef.h>
#include <stdint.h>

#include "geom/weld.h"

enum twin {
	TWIN_NONE,	/* no triangle faces the other way, or it is the surplus of more triangles on one side */
	TWIN_KEPT,	/* one triangle of a place that is drawn from both sides alike */
	TWIN_DROPPED	/* the others, as many on one side as on the other */
};

/* Fills twins[0..mesh->count), which are all TWIN_NONE, with enum twin; returns how many are dropped. */
size_t twins_find(struct soup *soup, uint8_t *twins);

#endif
