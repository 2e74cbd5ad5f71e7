/* simd_level.h - the instruction sets that the box tests and support functions are compiled for. */
#ifndef FIVECHECK_GEOM_SIMD_LEVEL_H
#define FIVECHECK_GEOM_SIMD_LEVEL_H

#include <stdbool.h>

/* Numbers of the levels, for the preprocessor too. */
#define LANES_SCALAR 0
#define LANES_SSE2 1	/* part of every x86-64 */
#define LANES_AVX2 2

#if defined(__x86_64__) && defined(__GNUC__)
#define LANES_BEST LANES_AVX2
#else
#define LANES_BEST LANES_SCALAR
#endif

/* The environment variable that names a level to use instead of the highest: scalar, sse2, avx2. */
#define SIMD_LEVEL_VARIABLE "FIVECHECK_SIMD"

/* The level with this name; false: there is none, or this processor does not have it. */
bool simd_level_of(const char *name, int *level);

/* The level that SIMD_LEVEL_VARIABLE names, else the highest of this processor; all lower ones work, too. */
int simd_level(void);

#endif
