#include "geom/simd_level.h"

#define LANES_LEVEL LANES_SSE2
#define AT_LEVEL(name) name##_sse2

#if LANES_LEVEL <= LANES_BEST
#include "geom/level_kernels.h"
#endif
