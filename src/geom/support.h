/* support.h - the support function of triangles: their extent in a direction. */
#ifndef FIVECHECK_GEOM_SUPPORT_H
#define FIVECHECK_GEOM_SUPPORT_H

#include <stddef.h>

#include "geom/mesh.h"
#include "geom/vec3.h"

/*
 * The greatest n.p (mm) over the corners p of `count` triangles, at least one; n is a unit vector. Every level of SIMD
 * (simd_level.h) gives the same bits. The error is at most SUPPORT_ROUNDING times the largest |p|.
 */
double support(const mesh_triangle *triangles, size_t count, vec3 n, int level);

#endif
