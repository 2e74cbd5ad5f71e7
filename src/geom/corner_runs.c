#include "geom/corner_runs.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "geom/tolerance.h"

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
	*run = (struct corner_run){(uint32_t)*count, (seen.count + BVH_WIDTH - 1) / BVH_WIDTH, 0};
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

/* Twice the area of a triangle, along its normal. */
static vec3 area_of(const mesh_triangle *t)
{
	const vec3 p = mesh_corner(t, 0);

	return vec3_cross(vec3_sub(mesh_corner(t, 1), p), vec3_sub(mesh_corner(t, 2), p));
}

/* mm, from the tree's origin: how far triangles reach along n, rounded up. */
static double reach_of_triangles(const struct corner_runs *runs, const struct bvh *bvh, size_t first, size_t count,
				 const float n[3])
{
	const double origin = n[0] * bvh->origin.x + n[1] * bvh->origin.y + n[2] * bvh->origin.z;

	return runs->kernels->support(&bvh->mesh.triangles[first], count, n) - origin +
	       SUPPORT_ROUNDING * (vec3_norm(bvh->origin) + vec3_norm(bvh->half));
}

/* The same for a branch with caps: not more than its children reach according to their caps. */
static double reach_of_branch(const struct corner_runs *runs, const struct bvh *bvh, uint32_t at, const float n[3])
{
	const struct branch_caps *caps = &runs->caps[runs->runs[at].caps - 1];
	float reach[BVH_WIDTH], most = -INFINITY;

	runs->kernels->caps_reach(&bvh->nodes[at], caps, n, reach);
	for (int i = 0; i < bvh->nodes[at].used; i++)
		most = reach[i] > most ? reach[i] : most;
	return most + SUPPORT_ROUNDING * vec3_norm(bvh->half);
}

static vec3 area_of_triangles(const struct bvh *bvh, size_t first, size_t count)
{
	vec3 sum = {0, 0, 0};

	for (size_t i = first; i < first + count; i++)
		sum = vec3_add(sum, area_of(&bvh->mesh.triangles[i]));
	return sum;
}

/* Sets the caps of a branch, and of those below it that have caps; returns the area. The depth of a tree is bounded. */
static vec3 add_caps(struct corner_runs *runs, size_t *count, const struct bvh *bvh, uint32_t at)
{
	const struct bvh_node *node = &bvh->nodes[at];
	struct branch_caps *caps = &runs->caps[*count];
	vec3 sum = {0, 0, 0};

	memset(caps, 0, sizeof(*caps));
	runs->runs[at].caps = (uint32_t)++*count;
	for (int i = 0; i < node->used; i++) {
		const struct bvh_node *below = node->count[i] ? NULL : &bvh->nodes[node->first[i]];
		const size_t first = below ? below->begin : node->first[i];
		const size_t total = below ? below->total : node->count[i];
		const bool large = total > RUN_TRIANGLES;
		const vec3 area = large ? add_caps(runs, count, bvh, node->first[i])
					: area_of_triangles(bvh, first, total);
		const double length = vec3_norm(area);
		const vec3 unit = vec3_scale(1 / length, area);
		const float n[3] = {(float)unit.x, (float)unit.y, (float)unit.z};

		sum = vec3_add(sum, area);
		if (!(length > 0) || !isfinite(1 / length) || !isfinite(length))
			continue;
		for (int k = 0; k < 3; k++)
			caps->normal[k][i] = n[k];
		caps->reach[i] = nextafterf((float)(large ? reach_of_branch(runs, bvh, node->first[i], n)
							  : reach_of_triangles(runs, bvh, first, total, n)),
					    INFINITY);
	}
	return sum;
}

/* The number of branches with more triangles than a run. */
static size_t count_large(const struct bvh *bvh)
{
	size_t count = 0;

	for (size_t i = 0; i < bvh->node_count; i++)
		count += bvh->nodes[i].total > RUN_TRIANGLES;
	return count;
}

static void add_runs(struct corner_runs *runs, const struct bvh *bvh)
{
	size_t count = 0, capacity = 0;

	if (bvh->nodes[0].total <= RUN_TRIANGLES)
		add_run(runs, &count, &capacity, bvh, 0);
	for (size_t i = 0; i < bvh->node_count; i++) {
		const struct bvh_node *node = &bvh->nodes[i];

		for (int k = 0; node->total > RUN_TRIANGLES && k < node->used; k++)
			if (!node->count[k] && bvh->nodes[node->first[k]].total <= RUN_TRIANGLES)
				add_run(runs, &count, &capacity, bvh, node->first[k]);
	}
}

struct corner_runs *corner_runs_new(const struct bvh *bvh)
{
	struct corner_runs *runs = mem_zalloc(1, sizeof(*runs));
	const size_t large = count_large(bvh);
	size_t count = 0;

	runs->kernels = simd_kernels_at_level(bvh->simd_level);
	runs->runs = mem_zalloc(bvh->node_count, sizeof(*runs->runs));
	if (bvh->mesh.count <= RUN_MESH_TRIANGLES)
		add_runs(runs, bvh);
	if (large) {
		runs->caps = mem_alloc(large * sizeof(*runs->caps));
		add_caps(runs, &count, bvh, 0);
	}
	return runs;
}

void corner_runs_free(struct corner_runs *runs)
{
	if (!runs)
		return;
	free(runs->points);
	free(runs->caps);
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
