#include "geom/simd_level.h"

#define LANES_LEVEL LANES_SCALAR
#define AT_LEVEL(name) name##_scalar

#include "geom/level_kernels.h"
