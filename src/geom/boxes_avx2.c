#include "geom/simd_level.h"

#define LANES_LEVEL LANES_AVX2
#define BOXES_APART boxes_apart_avx2

#if LANES_LEVEL <= LANES_BEST
#include "geom/boxes_kernel.h"
#endif
