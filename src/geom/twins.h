/* twins.h - triangles that are drawn from both sides: the same three vertices, facing opposite ways. */
#ifndef FIVECHECK_GEOM_TWINS_H
#define FIVECHECK_GEOM_TWINS_H

#include <stddef.h>
#include <stdint.h>

#include "geom/weld.h"

enum twin {
	TWIN_NONE,	/* no opposite triangle, or one of the surplus triangles on one side */
	TWIN_KEPT,	/* the one kept of a place with as many triangles on both sides */
	TWIN_DROPPED	/* the others, equally many on both sides */
};

/* Fills twins[0..mesh->count), which are all TWIN_NONE, with enum twin; returns the number of dropped ones. */
size_t twins_find(struct soup *soup, uint8_t *twins);

#endif
