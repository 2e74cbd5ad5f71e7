/* simd_level.h - the instruction sets that the box tests are compiled for. */
#ifndef FIVECHECK_GEOM_SIMD_LEVEL_H
#define FIVECHECK_GEOM_SIMD_LEVEL_H

#include "base/ablation.h"

/* Numbers of the levels, for the preprocessor too. */
#define LANES_SCALAR 0
#define LANES_SSE2 1	/* part of every x86-64 */
#define LANES_AVX2 2

#if defined(__x86_64__) && defined(__GNUC__)
#define LANES_BEST LANES_AVX2
#else
#define LANES_BEST LANES_SCALAR
#endif

/* The highest level that this processor has; all lower ones work too. */
static inline int simd_level(void)
{
#if LANES_BEST == LANES_AVX2
	if (!WITH_SIMD)
		return LANES_SCALAR;
	return __builtin_cpu_supports("avx2") ? LANES_AVX2 : LANES_SSE2;
#else
	return LANES_SCALAR;
#endif
}

#endif
