#include "geom/bvh.h"

#include <assert.h>
#include <float.h>
#include <stdbool.h>
#include <stdlib.h>

#include "base/mem.h"
#include "geom/simd_level.h"

/* A run of triangles and the bounds of it. */
struct run {
	size_t first, count;
	float least[3], greatest[3];	/* of the corners */
	float low[3], high[3];	/* of the sums of the least and greatest corner: twice the middles */
};

struct builder {
	struct bvh *bvh;
	size_t capacity;
};

static inline float least3(float a, float b, float c)
{
	float ab = a < b ? a : b;

	return ab < c ? ab : c;
}

static inline float greatest3(float a, float b, float c)
{
	float ab = a > b ? a : b;

	return ab > c ? ab : c;
}

static inline float twice_middle(const mesh_triangle *t, int axis)
{
	float a = t->v[0][axis], b = t->v[1][axis], c = t->v[2][axis];

	return least3(a, b, c) + greatest3(a, b, c);
}

static void run_measure(struct run *run, const mesh_triangle *triangles)
{
	for (int k = 0; k < 3; k++) {
		run->least[k] = run->low[k] = FLT_MAX;
		run->greatest[k] = run->high[k] = -FLT_MAX;
	}
	for (size_t i = run->first; i < run->first + run->count; i++) {
		const mesh_triangle *t = &triangles[i];

		for (int k = 0; k < 3; k++) {
			float low = least3(t->v[0][k], t->v[1][k], t->v[2][k]);
			float high = greatest3(t->v[0][k], t->v[1][k], t->v[2][k]);
			float middle = low + high;

			run->least[k] = low < run->least[k] ? low : run->least[k];
			run->greatest[k] = high > run->greatest[k] ? high : run->greatest[k];
			run->low[k] = middle < run->low[k] ? middle : run->low[k];
			run->high[k] = middle > run->high[k] ? middle : run->high[k];
		}
	}
}

/* Moves the triangles whose middle is below the bound to the front; returns how many. */
static size_t partition(mesh_triangle *t, size_t count, int axis, float bound)
{
	size_t i = 0, j = count;

	for (;;) {
		mesh_triangle keep;

		while (i < j && twice_middle(&t[i], axis) < bound)
			i++;
		while (i < j && !(twice_middle(&t[j - 1], axis) < bound))
			j--;
		if (i == j)
			return i;
		keep = t[i];
		t[i] = t[j - 1];
		t[j - 1] = keep;
	}
}

/* Halves a run at the middle of its longest side, or by number where that would be lopsided. */
static void run_split(const struct run *run, mesh_triangle *triangles, struct run out[2])
{
	size_t least_share = run->count / 16 + 1, front;
	int axis = 0;

	for (int k = 1; k < 3; k++)
		if (run->high[k] - run->low[k] > run->high[axis] - run->low[axis])
			axis = k;
	front = partition(triangles + run->first, run->count, axis, 0.5f * run->low[axis] + 0.5f * run->high[axis]);
	if (front < least_share || run->count - front < least_share)
		front = run->count / 2;
	out[0].first = run->first;
	out[0].count = front;
	out[1].first = run->first + front;
	out[1].count = run->count - front;
	run_measure(&out[0], triangles);
	run_measure(&out[1], triangles);
}

/*
 * Up to eight runs of about the same size; the largest is halved as long as there is room. Runs that
 * fit into one node are divided only when they are alone: half-empty nodes at the bottom would be most of the tree.
 */
static int split_wide(const struct run *run, mesh_triangle *triangles, struct run out[BVH_WIDTH])
{
	size_t enough = run->count > BVH_WIDTH ? BVH_WIDTH : BVH_LEAF_SIZE;
	int used = 1;

	out[0] = *run;
	while (used < BVH_WIDTH) {
		int largest = 0;
		struct run halves[2];

		for (int i = 1; i < used; i++)
			if (out[i].count > out[largest].count)
				largest = i;
		if (out[largest].count <= enough)
			break;
		run_split(&out[largest], triangles, halves);
		out[largest] = halves[0];
		out[used++] = halves[1];
	}
	return used;
}

/* The box of a run, relative to the origin: the half sizes grow by the rounding of both. */
static void set_box(struct bvh_node *node, int lane, const struct run *run, const double origin[3])
{
	for (int k = 0; k < 3; k++) {
		double low = run->least[k] - origin[k], high = run->greatest[k] - origin[k];
		float centre = (float)(0.5 * (low + high));
		double half = high - centre > centre - low ? high - centre : centre - low;

		node->centre[k][lane] = centre;
		node->half[k][lane] = (float)(half * (1 + 4 * (double)FLT_EPSILON)) + FLT_MIN;
	}
}

static size_t new_node(struct builder *b)
{
	b->bvh->nodes = mem_grow(b->bvh->nodes, &b->capacity, b->bvh->node_count + 1, sizeof(*b->bvh->nodes));
	b->bvh->nodes[b->bvh->node_count] = (struct bvh_node){0};
	return b->bvh->node_count++;
}

/* Recursion is bounded: each level leaves at most 15/16 of the triangles to a child. */
static void build(struct builder *b, size_t at, const struct run *run)
{
	const double origin[3] = {b->bvh->origin.x, b->bvh->origin.y, b->bvh->origin.z};
	struct run runs[BVH_WIDTH];
	int used = split_wide(run, b->bvh->mesh.triangles, runs);

	b->bvh->nodes[at].used = (uint8_t)used;
	b->bvh->nodes[at].begin = (uint32_t)run->first;
	b->bvh->nodes[at].total = (uint32_t)run->count;
	for (int i = 0; i < BVH_WIDTH; i++)
		set_box(&b->bvh->nodes[at], i, &runs[i < used ? i : 0], origin);
	for (int i = 0; i < used; i++) {
		bool leaf = runs[i].count <= BVH_LEAF_SIZE;
		size_t first = leaf ? runs[i].first : new_node(b);

		b->bvh->nodes[at].first[i] = (uint32_t)first;
		b->bvh->nodes[at].count[i] = leaf ? (uint8_t)runs[i].count : 0;
		if (!leaf)
			build(b, first, &runs[i]);
	}
}

static double farthest_corner(const struct mesh *mesh, vec3 from)
{
	double farthest = 0;

	for (size_t i = 0; i < mesh->count; i++)
		for (int k = 0; k < 3; k++)
			farthest = fmax(farthest, vec3_norm2(vec3_sub(mesh_corner(&mesh->triangles[i], k), from)));
	return sqrt(farthest) * (1 + 4 * DBL_EPSILON);
}

struct bvh *bvh_new(struct mesh *mesh)
{
	struct bvh *bvh = mem_zalloc(1, sizeof(*bvh));
	struct builder b = {bvh, 0};
	struct run all = {0};
	vec3 least, greatest;

	assert(mesh->count > 0 && mesh->count <= UINT32_MAX);
	bvh->mesh = *mesh;
	*mesh = (struct mesh){0};
	all.count = bvh->mesh.count;
	run_measure(&all, bvh->mesh.triangles);
	least = (vec3){all.least[0], all.least[1], all.least[2]};
	greatest = (vec3){all.greatest[0], all.greatest[1], all.greatest[2]};
	bvh->origin = vec3_scale(0.5, vec3_add(least, greatest));
	bvh->half = vec3_scale(0.5, vec3_sub(greatest, least));
	bvh->radius = farthest_corner(&bvh->mesh, bvh->origin);
	bvh->simd_level = simd_level();
	build(&b, new_node(&b), &all);
	bvh->nodes = mem_realloc(bvh->nodes, bvh->node_count, sizeof(*bvh->nodes));
	return bvh;
}

void bvh_free(struct bvh *bvh)
{
	if (!bvh)
		return;
	mesh_release(&bvh->mesh);
	free(bvh->nodes);
	free(bvh);
}
