#include "geom/simd_level.h"

#define LANES_LEVEL LANES_SCALAR
#define BOXES_APART boxes_apart_scalar

#include "geom/boxes_kernel.h"
