/* support_kernel.h - the support function of support.h for one level of SIMD; see simd_kernels.h. */
#include <math.h>

#include "geom/lanes.h"
#include "geom/simd_kernels.h"

enum {
	TURN = 3 * LANES,	/* floats after which corners begin at the same lane again */
	TURN_READS = TURN + 2	/* floats that a turn reads */
};

/*
 * Corners lie as x y z x y z ... in memory. Three vectors, read one float apart, have x, y and z of the same corner in
 * every third lane; the mixed values in the other lanes are replaced by the smallest float.
 */
LANES_FUNCTION lanes greatest_of_turn(const float *at, const lanes n[3], lanes most)
{
	static const float begins[3][LANES] = {
		{0, -INFINITY, -INFINITY, 0, -INFINITY, -INFINITY, 0, -INFINITY},
		{-INFINITY, 0, -INFINITY, -INFINITY, 0, -INFINITY, -INFINITY, 0},
		{-INFINITY, -INFINITY, 0, -INFINITY, -INFINITY, 0, -INFINITY, -INFINITY},
	};

	for (int k = 0; k < 3; k++) {
		const float *from = at + k * LANES;
		lanes x = lanes_mul(n[0], lanes_load(from)), y = lanes_mul(n[1], lanes_load(from + 1));
		lanes z = lanes_mul(n[2], lanes_load(from + 2));
		lanes along = lanes_add(lanes_add(x, y), z);

		most = lanes_max(most, lanes_add(along, lanes_load(begins[k])));
	}
	return most;
}

static LANES_TARGET float AT_LEVEL(support)(const mesh_triangle *triangles, size_t count, const float n[3])
{
	const float *at = triangles[0].v[0], *end = at + count * (sizeof(*triangles) / sizeof(float));
	const lanes all[3] = {lanes_all(n[0]), lanes_all(n[1]), lanes_all(n[2])};
	lanes most = lanes_all(-INFINITY);
	float each[LANES], greatest = -INFINITY;

	for (; end - at >= TURN_READS; at += TURN)
		most = greatest_of_turn(at, all, most);
	lanes_store(each, most);
	for (int i = 0; i < LANES; i++)
		greatest = each[i] > greatest ? each[i] : greatest;
	for (; at < end; at += 3) {
		float along = n[0] * at[0] + n[1] * at[1] + n[2] * at[2];

		greatest = along > greatest ? along : greatest;
	}
	return greatest;
}
