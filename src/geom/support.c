#include "geom/support.h"

#include "geom/simd_kernels.h"

double support(const mesh_triangle *triangles, size_t count, vec3 n, int level)
{
	const float direction[3] = {(float)n.x, (float)n.y, (float)n.z};

	return simd_kernels_at_level(level)->support(triangles, count, direction);
}
