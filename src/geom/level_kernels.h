/* level_kernels.h - all kernels for one level of SIMD, given by LANES_LEVEL and AT_LEVEL (boxes_kernel.h). */
#include "geom/boxes_kernel.h"
#include "geom/item_kernel.h"
#include "geom/nearness_kernel.h"
#include "geom/reach_kernel.h"
#include "geom/simd_kernels.h"
#include "geom/support_kernel.h"

const struct simd_kernels AT_LEVEL(simd_kernels) = {
	.boxes_apart = AT_LEVEL(boxes_apart),
	.support = AT_LEVEL(support),
	.boxes_near = AT_LEVEL(boxes_near),
	.boxes_reach = AT_LEVEL(boxes_reach),
	.greatest_of = AT_LEVEL(greatest_of),
	.caps_reach = AT_LEVEL(caps_reach),
	.points_reach = AT_LEVEL(points_reach),
	.bvh_items_bounds = AT_LEVEL(bvh_items_bounds),
};
