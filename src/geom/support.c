#include "geom/support.h"

#include "geom/simd_kernels.h"

support_fn *support_at_level(int level)
{
#if LANES_BEST == LANES_AVX2
	if (level == LANES_AVX2)
		return support_avx2;
	if (level == LANES_SSE2)
		return support_sse2;
#endif
	(void)level;
	return support_scalar;
}

double support(const mesh_triangle *triangles, size_t count, vec3 n, int level)
{
	const float direction[3] = {(float)n.x, (float)n.y, (float)n.z};

	return support_at_level(level)(triangles, count, direction);
}
