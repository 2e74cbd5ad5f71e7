/* nearness_kernel.h - the distance of boxes from a point, for one level of SIMD; see simd_kernels.h. */
#include "geom/bvh.h"
#include "geom/lanes.h"
#include "geom/simd_kernels.h"

/* More than the rounding of the squares and their sum: below 8 roundings of float. */
#define SQUARES_KEPT (1 - 0x1p-21f)

static LANES_TARGET unsigned AT_LEVEL(boxes_near)(const struct bvh_node *node, const float p[3], float slack,
						  float within2, float near2[BVH_WIDTH])
{
	lanes all = lanes_all(0);

	for (int k = 0; k < 3; k++) {
		lanes to = lanes_abs(lanes_sub(lanes_all(p[k]), lanes_load(node->centre[k])));
		lanes most = lanes_add(lanes_load(node->half[k]), lanes_all(slack));
		lanes beyond = lanes_max(lanes_sub(to, most), lanes_all(0));

		all = lanes_add(all, lanes_mul(beyond, beyond));
	}
	all = lanes_mul(all, lanes_all(SQUARES_KEPT));
	lanes_store(near2, all);
	return lanes_reaching(lanes_all(within2), all) & ((1u << node->used) - 1);
}
