#include "geom/simd_level.h"

#define LANES_LEVEL LANES_SCALAR
#define AT_LEVEL(name) name##_scalar

#include "geom/boxes_kernel.h"
#include "geom/item_kernel.h"
#include "geom/reach_kernel.h"
#include "geom/support_kernel.h"
