#include "geom/corner_runs.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"

/* A hash table of the corners of one run; it has more places than a run has corners. */
enum { PLACES = 512 };

struct seen {
	uint32_t place[PLACES];	/* the corner's number in the run, from 1; 0: free */
	float corners[3 * RUN_TRIANGLES][3];
	uint32_t bits[3 * RUN_TRIANGLES][3];
	uint32_t count;
};

static uint32_t hash_of(const uint32_t bits[3])
{
	return (bits[0] * 0x9e3779b1u ^ bits[1] * 0x85ebca77u ^ bits[2] * 0xc2b2ae3du) >> 16;
}

static void add_corner(struct seen *seen, const float p[3])
{
	uint32_t bits[3], at;

	memcpy(bits, p, sizeof(bits));
	at = hash_of(bits) % PLACES;
	for (; seen->place[at]; at = (at + 1) % PLACES)
		if (!memcmp(seen->bits[seen->place[at] - 1], bits, sizeof(bits)))
			return;
	memcpy(seen->bits[seen->count], bits, sizeof(bits));
	memcpy(seen->corners[seen->count++], p, sizeof(seen->corners[0]));
	seen->place[at] = seen->count;
}

/* Appends the run of a branch; its last group is filled up with its last corner. */
static void add_run(struct corner_runs *runs, size_t *count, size_t *capacity, const struct bvh *bvh, uint32_t node)
{
	const struct bvh_node *branch = &bvh->nodes[node];
	struct seen seen = {.count = 0};
	struct corner_run *run = &runs->runs[node];

	for (uint32_t i = 0; i < branch->total; i++)
		for (int k = 0; k < 3; k++)
			add_corner(&seen, bvh->mesh.triangles[branch->begin + i].v[k]);
	*run = (struct corner_run){(uint32_t)*count, (seen.count + BVH_WIDTH - 1) / BVH_WIDTH};
	runs->points = mem_grow(runs->points, capacity, *count + run->groups, 3 * BVH_WIDTH * sizeof(float));
	for (uint32_t i = 0; i < run->groups * BVH_WIDTH; i++) {
		const float *p = seen.corners[i < seen.count ? i : seen.count - 1];
		float *to = &runs->points[(*count + i / BVH_WIDTH) * 3 * BVH_WIDTH + i % BVH_WIDTH];

		to[0] = (float)(p[0] - bvh->origin.x);
		to[BVH_WIDTH] = (float)(p[1] - bvh->origin.y);
		to[2 * BVH_WIDTH] = (float)(p[2] - bvh->origin.z);
	}
	*count += run->groups;
}

struct corner_runs *corner_runs_new(const struct bvh *bvh)
{
	struct corner_runs *runs = mem_zalloc(1, sizeof(*runs));
	size_t count = 0, capacity = 0;

	runs->kernels = simd_kernels_at_level(bvh->simd_level);
	if (bvh->mesh.count > RUN_MESH_TRIANGLES)
		return runs;
	runs->runs = mem_zalloc(bvh->node_count, sizeof(*runs->runs));
	if (bvh->nodes[0].total <= RUN_TRIANGLES)
		add_run(runs, &count, &capacity, bvh, 0);
	for (size_t i = 0; i < bvh->node_count; i++) {
		const struct bvh_node *node = &bvh->nodes[i];

		for (int k = 0; node->total > RUN_TRIANGLES && k < node->used; k++)
			if (!node->count[k] && bvh->nodes[node->first[k]].total <= RUN_TRIANGLES)
				add_run(runs, &count, &capacity, bvh, node->first[k]);
	}
	return runs;
}

void corner_runs_free(struct corner_runs *runs)
{
	if (!runs)
		return;
	free(runs->points);
	free(runs->runs);
	free(runs);
}

vec3 corner_runs_farthest(const struct corner_runs *runs, const struct corner_run *run, const float n[3])
{
	vec3 farthest = {0, 0, 0};
	float most = -INFINITY;

	for (uint32_t i = 0; i < run->groups * BVH_WIDTH; i++) {
		const float *p = &runs->points[(run->first + i / BVH_WIDTH) * 3 * BVH_WIDTH + i % BVH_WIDTH];
		float along = n[0] * p[0] + n[1] * p[BVH_WIDTH] + n[2] * p[2 * BVH_WIDTH];

		if (along > most) {
			most = along;
			farthest = (vec3){p[0], p[BVH_WIDTH], p[2 * BVH_WIDTH]};
		}
	}
	return farthest;
}
