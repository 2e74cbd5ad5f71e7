/* weld.h - finds which corners of a triangle soup are the same vertex. */
#ifndef FIVECHECK_GEOM_WELD_H
#define FIVECHECK_GEOM_WELD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "geom/mesh.h"

/* A mesh with numbered vertices, and working memory for sorting: three entries for each triangle. */
struct soup {
	const struct mesh *mesh;	/* borrowed */
	size_t corner_count;
	uint32_t *vertex;	/* the number of the vertex of each corner */
	uint32_t vertex_count;
	uint64_t *keys, *scratch;
};

/* Corners with equal coordinates are the same vertex (-0 is 0). At most INT32_MAX / 3 triangles. */
void soup_init(struct soup *soup, const struct mesh *mesh);
void soup_release(struct soup *soup);

/* Does the triangle have fewer than three vertices? */
static inline bool soup_is_degenerate(const struct soup *soup, size_t triangle)
{
	const uint32_t *v = &soup->vertex[3 * triangle];

	return v[0] == v[1] || v[1] == v[2] || v[2] == v[0];
}

/* Sorts soup->keys[0..count), which are below 2^bits (32 to 64). Fast if keys differ in their upper bits. */
void soup_sort_keys(struct soup *soup, size_t count, int bits);

#endif
