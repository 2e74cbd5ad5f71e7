/* reach_kernel.h - the extent of boxes and points in a direction, for one level of SIMD; see simd_kernels.h. */
#include <math.h>

#include "geom/bvh.h"
#include "geom/corner_runs.h"
#include "geom/lanes.h"
#include "geom/simd_kernels.h"

static LANES_TARGET void AT_LEVEL(boxes_reach)(const struct bvh_node *node, const float n[3], float reach[BVH_WIDTH])
{
	lanes all = lanes_all(0);

	for (int k = 0; k < 3; k++) {
		lanes middle = lanes_mul(lanes_all(n[k]), lanes_load(node->centre[k]));
		lanes half = lanes_mul(lanes_abs(lanes_all(n[k])), lanes_load(node->half[k]));

		all = lanes_add(all, lanes_add(middle, half));
	}
	lanes_store(reach, all);
}

static LANES_TARGET int AT_LEVEL(greatest_of)(const float numbers[BVH_WIDTH], unsigned among)
{
	const lanes all = lanes_where(among, lanes_load(numbers), lanes_all(-INFINITY));

	return __builtin_ctz(lanes_reaching(all, lanes_greatest(all)) & among);
}

static LANES_TARGET void AT_LEVEL(caps_reach)(const struct bvh_node *node, const struct branch_caps *caps,
					      const float n[3], float reach[BVH_WIDTH])
{
	lanes along = lanes_all(0), box = lanes_all(0), cap;

	for (int k = 0; k < 3; k++)
		along = lanes_add(along, lanes_mul(lanes_all(n[k]), lanes_load(caps->normal[k])));
	along = lanes_max(along, lanes_all(0));
	cap = lanes_mul(along, lanes_load(caps->reach));
	for (int k = 0; k < 3; k++) {
		lanes rest = lanes_sub(lanes_all(n[k]), lanes_mul(along, lanes_load(caps->normal[k])));
		lanes middle = lanes_load(node->centre[k]), half = lanes_load(node->half[k]);

		box = lanes_add(box, lanes_add(lanes_mul(lanes_all(n[k]), middle),
					       lanes_mul(lanes_abs(lanes_all(n[k])), half)));
		cap = lanes_add(cap, lanes_add(lanes_mul(rest, middle), lanes_mul(lanes_abs(rest), half)));
	}
	lanes_store(reach, lanes_min(box, cap));
}

static LANES_TARGET float AT_LEVEL(points_reach)(const float *points, size_t groups, const float n[3])
{
	const lanes all[3] = {lanes_all(n[0]), lanes_all(n[1]), lanes_all(n[2])};
	lanes most = lanes_all(-INFINITY);

	for (; groups; groups--, points += 3 * LANES) {
		lanes x = lanes_mul(all[0], lanes_load(points)), y = lanes_mul(all[1], lanes_load(points + LANES));
		lanes z = lanes_mul(all[2], lanes_load(points + 2 * LANES));

		most = lanes_max(most, lanes_add(lanes_add(x, y), z));
	}
	return lanes_first(lanes_greatest(most));
}
