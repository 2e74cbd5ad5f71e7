/*
 * axis_cache.h - the separating axes of the paper's interpolated method: those of triangle pairs at both ends of one
 * motion.
 */
#ifndef FIVECHECK_CHECK_SAMPLED_AXIS_CACHE_H
#define FIVECHECK_CHECK_SAMPLED_AXIS_CACHE_H

#include <stddef.h>
#include <stdint.h>

#include "geom/tri.h"

/* N1, N2 and the nine cross products of edges, each in its place even when it vanishes. */
enum { PAPER_AXES = 11 };

struct axis_pair {
	vec3 start[PAPER_AXES], end[PAPER_AXES];
};

struct axis_cache;

struct axis_cache *axis_cache_new(void);
void axis_cache_free(struct axis_cache *cache);

/* Empties the cache: a new motion begins. */
void axis_cache_clear(struct axis_cache *cache);

/* The axes of triangles i and j; NULL: not in the cache. Then axis_cache_add makes room, which the caller fills. */
const struct axis_pair *axis_cache_find(const struct axis_cache *cache, uint32_t i, uint32_t j);
struct axis_pair *axis_cache_add(struct axis_cache *cache, uint32_t i, uint32_t j);

void paper_axes(const tri *a, const tri *b, vec3 axes[PAPER_AXES]);

#endif
