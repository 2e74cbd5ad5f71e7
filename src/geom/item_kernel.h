/* item_kernel.h - the bounds of the boxes of triangles for one level of SIMD; see simd_kernels.h. */
#include <float.h>

#include "geom/lanes.h"
#include "geom/simd_kernels.h"

static LANES_TARGET void AT_LEVEL(bvh_items_bounds)(const struct bvh_item *items, size_t count, struct bvh_item *box,
						    struct bvh_item *middles)
{
	lanes least = lanes_all(FLT_MAX), least_middle = lanes_all(FLT_MAX);

	for (size_t i = 0; i < count; i++) {
		lanes item = lanes_load(items[i].bounds);

		least = lanes_min(item, least);
		/* low - (-high) in the front half, (-high) - low behind. */
		least_middle = lanes_min(lanes_sub(item, lanes_swap_halves(item)), least_middle);
	}
	lanes_store(box->bounds, least);
	lanes_store(middles->bounds, least_middle);
}
