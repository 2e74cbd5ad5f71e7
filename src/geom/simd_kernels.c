#include "geom/simd_kernels.h"

const struct simd_kernels *simd_kernels_at_level(int level)
{
#if LANES_BEST == LANES_AVX2
	if (level == LANES_AVX2)
		return &simd_kernels_avx2;
	if (level == LANES_SSE2)
		return &simd_kernels_sse2;
#endif
	(void)level;
	return &simd_kernels_scalar;
}
