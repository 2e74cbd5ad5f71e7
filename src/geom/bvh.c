#include "geom/bvh.h"

#include <assert.h>
#include <float.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "base/minmax.h"
#include "base/parallel_for.h"
#include "geom/simd_kernels.h"
#include "geom/simd_level.h"

/* A run of triangles and its bounds. */
struct run {
	size_t first, count;
	struct bvh_item box;	/* of the triangles */
	struct bvh_item middles;	/* of the sums of their least and greatest corners: twice the middles */
};

/* Boxes are sorted instead of their triangles; the triangles are put in the same order at the end. */
struct builder {
	struct bvh_node *nodes;
	size_t node_count, capacity;
	double origin[3];
	struct bvh_item *items;
	uint32_t *triangle;	/* of each item */
	bvh_items_bounds_fn *bounds_of;
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

static inline float least_of(const struct bvh_item *item, int axis)
{
	return item->bounds[axis];
}

static inline float greatest_of(const struct bvh_item *item, int axis)
{
	return -item->bounds[4 + axis];
}

static struct bvh_item item_of(const mesh_triangle *t)
{
	struct bvh_item item = {{0}};

	for (int k = 0; k < 3; k++) {
		item.bounds[k] = least3(t->v[0][k], t->v[1][k], t->v[2][k]);
		item.bounds[4 + k] = -greatest3(t->v[0][k], t->v[1][k], t->v[2][k]);
	}
	return item;
}

static inline float twice_middle(const struct bvh_item *item, int axis)
{
	return least_of(item, axis) + greatest_of(item, axis);
}

static void run_measure(struct run *run, const struct builder *b)
{
	b->bounds_of(b->items + run->first, run->count, &run->box, &run->middles);
}

static void swap_items(const struct builder *b, size_t i, size_t j)
{
	struct bvh_item item = b->items[i];
	uint32_t triangle = b->triangle[i];

	b->items[i] = b->items[j];
	b->items[j] = item;
	b->triangle[i] = b->triangle[j];
	b->triangle[j] = triangle;
}

/* A tree has about one node for this number of triangles. */
enum { LIKELY_SHARE = 3 };

/* The number of items that are compared before any is moved. */
enum { BLOCK = 64 };

/* Items of one side that belong to the other side, in the order of the scan. */
struct misplaced {
	size_t at[BLOCK];
	size_t first, count;
};

/*
 * Partitions the items from *from to *to and narrows this range: items whose middle is below the bound are moved in
 * front of it, the others behind it. The i-th item from the front that is not below the bound is exchanged with the
 * i-th from the back that is (Hoare). Both are searched in blocks without a branch per item (Edelkamp and Weiss,
 * "BlockQuicksort", 2016), which takes half the time.
 */
static void part_blocks(const struct builder *b, int axis, float bound, size_t *from, size_t *to)
{
	struct misplaced front = {.count = 0}, back = {.count = 0};

	while (*to - *from > 2 * BLOCK) {
		if (front.first == front.count) {
			front.first = front.count = 0;
			for (size_t k = *from; k < *from + BLOCK; k++) {
				front.at[front.count] = k;
				front.count += !(twice_middle(&b->items[k], axis) < bound);
			}
		}
		if (back.first == back.count) {
			back.first = back.count = 0;
			for (size_t k = *to; k-- > *to - BLOCK;) {
				back.at[back.count] = k;
				back.count += twice_middle(&b->items[k], axis) < bound;
			}
		}
		while (front.first < front.count && back.first < back.count)
			swap_items(b, front.at[front.first++], back.at[back.first++]);
		if (front.first == front.count)
			*from += BLOCK;
		if (back.first == back.count)
			*to -= BLOCK;
	}
}

/* Moves the items of the run whose middle is below the bound to its front; returns their number. */
static size_t partition(const struct builder *b, const struct run *run, int axis, float bound)
{
	size_t i = run->first, j = run->first + run->count;

	if (run->count > 2 * BLOCK)
		part_blocks(b, axis, bound, &i, &j);
	for (;;) {
		while (i < j && twice_middle(&b->items[i], axis) < bound)
			i++;
		while (i < j && !(twice_middle(&b->items[j - 1], axis) < bound))
			j--;
		if (i == j)
			return i - run->first;
		swap_items(b, i, j - 1);
	}
}

/* Halves a run at the middle of its longest side, or by number if the parts would differ too much in size. */
static void run_split(const struct run *run, const struct builder *b, struct run out[2])
{
	const struct bvh_item *middles = &run->middles;
	size_t least_share = run->count / 16 + 1, front;
	int axis = 0;

	for (int k = 1; k < 3; k++)
		if (greatest_of(middles, k) - least_of(middles, k) >
		    greatest_of(middles, axis) - least_of(middles, axis))
			axis = k;
	front = partition(b, run, axis, 0.5f * least_of(middles, axis) + 0.5f * greatest_of(middles, axis));
	if (front < least_share || run->count - front < least_share)
		front = run->count / 2;
	out[0].first = run->first;
	out[0].count = front;
	out[1].first = run->first + front;
	out[1].count = run->count - front;
	run_measure(&out[0], b);
	run_measure(&out[1], b);
}

/* One run for each triangle. They become leaves of one node, where their order does not matter. */
static int split_single(const struct run *run, const struct builder *b, struct run out[BVH_WIDTH])
{
	for (size_t i = 0; i < run->count; i++)
		out[i] = (struct run){.first = run->first + i, .count = 1, .box = b->items[run->first + i]};
	return (int)run->count;
}

/*
 * Divides into up to eight runs of about the same size: the largest one is halved as long as there is room. A run that
 * fits into one node is divided only if it is the only one: half-empty nodes at the bottom would be most of the tree.
 */
static int split_wide(const struct run *run, const struct builder *b, struct run out[BVH_WIDTH])
{
	const size_t enough = BVH_WIDTH;
	int used = 1;

	if (run->count <= enough)
		return split_single(run, b, out);
	out[0] = *run;
	while (used < BVH_WIDTH) {
		int largest = 0;
		struct run halves[2];

		for (int i = 1; i < used; i++)
			if (out[i].count > out[largest].count)
				largest = i;
		if (out[largest].count <= enough)
			break;
		run_split(&out[largest], b, halves);
		out[largest] = halves[0];
		out[used++] = halves[1];
	}
	return used;
}

/* The box of a run, relative to the origin: the half sizes grow by the rounding of both. */
static void set_box(struct bvh_node *node, int lane, const struct run *run, const double origin[3])
{
	for (int k = 0; k < 3; k++) {
		double low = least_of(&run->box, k) - origin[k], high = greatest_of(&run->box, k) - origin[k];
		float centre = (float)(0.5 * (low + high));
		double half = high - centre > centre - low ? high - centre : centre - low;

		node->centre[k][lane] = centre;
		node->half[k][lane] = (float)(half * (1 + 4 * (double)FLT_EPSILON)) + FLT_MIN;
	}
}

/* The boxes of missing children are copies of the first one. */
static void copy_box(struct bvh_node *node, int lane)
{
	for (int k = 0; k < 3; k++) {
		node->centre[k][lane] = node->centre[k][0];
		node->half[k][lane] = node->half[k][0];
	}
}

static size_t new_node(struct builder *b)
{
	b->nodes = mem_grow(b->nodes, &b->capacity, b->node_count + 1, sizeof(*b->nodes));
	b->nodes[b->node_count] = (struct bvh_node){0};
	return b->node_count++;
}

/* Divides the run among the children of a new node; returns their number. Inner children have no node yet. */
static int new_parent(struct builder *b, const struct run *run, struct run runs[BVH_WIDTH])
{
	int used = split_wide(run, b, runs);
	size_t at = new_node(b);
	struct bvh_node *node = &b->nodes[at];

	node->used = (uint8_t)used;
	node->begin = (uint32_t)run->first;
	node->total = (uint32_t)run->count;
	for (int i = 0; i < used; i++)
		set_box(node, i, &runs[i], b->origin);
	for (int i = used; i < BVH_WIDTH; i++)
		copy_box(node, i);
	for (int i = 0; i < used; i++) {
		bool leaf = runs[i].count <= BVH_LEAF_SIZE;

		node->first[i] = leaf ? (uint32_t)runs[i].first : 0;
		node->count[i] = leaf ? (uint8_t)runs[i].count : 0;
	}
	return used;
}

/* Appends the tree of the run. The recursion is bounded: at each level a child has at most 15/16 of the triangles. */
static void build(struct builder *b, const struct run *run)
{
	struct run runs[BVH_WIDTH];
	size_t at = b->node_count;
	int used = new_parent(b, run, runs);

	for (int i = 0; i < used; i++) {
		if (b->nodes[at].count[i])
			continue;
		b->nodes[at].first[i] = (uint32_t)b->node_count;
		build(b, &runs[i]);
	}
}

/* The children of the root, each built by one thread. */
struct crew {
	struct run runs[BVH_WIDTH];
	struct builder builders[BVH_WIDTH];
};

static void build_branch(void *context, int worker, size_t i)
{
	struct crew *crew = context;

	(void)worker;
	build(&crew->builders[i], &crew->runs[i]);
}

/* Appends the tree of a branch, whose nodes are numbered from 0. */
static void join_branch(struct builder *b, const struct builder *branch)
{
	const size_t before = b->node_count;

	b->nodes = mem_grow(b->nodes, &b->capacity, before + branch->node_count, sizeof(*b->nodes));
	memcpy(b->nodes + before, branch->nodes, branch->node_count * sizeof(*b->nodes));
	b->node_count += branch->node_count;
	for (struct bvh_node *node = b->nodes + before; node < b->nodes + b->node_count; node++)
		for (int i = 0; i < node->used; i++)
			node->first[i] += node->count[i] ? 0 : (uint32_t)before;
}

/* Makes the same nodes as build, in the same order. */
static void build_together(struct builder *b, const struct run *run, int threads)
{
	struct crew crew;
	int used = new_parent(b, run, crew.runs);

	for (int i = 0; i < used; i++) {
		crew.builders[i] = *b;
		crew.builders[i].nodes = NULL;
		crew.builders[i].node_count = crew.builders[i].capacity = 0;
	}
	parallel_for((size_t)used, threads, build_branch, &crew);
	for (int i = 0; i < used; i++) {
		b->nodes[0].first[i] = (uint32_t)b->node_count;
		join_branch(b, &crew.builders[i]);
		free(crew.builders[i].nodes);
	}
}

/* Puts the triangles into the order of the items, in the memory of the items, which are no longer needed. */
static void sort_triangles(struct builder *b, struct mesh *mesh)
{
	mesh_triangle *sorted = mem_realloc(b->items, mesh->count, sizeof(*sorted));

	b->items = NULL;
	for (size_t i = 0; i < mesh->count; i++)
		sorted[i] = mesh->triangles[b->triangle[i]];
	free(mesh->triangles);
	mesh->triangles = sorted;
}

static double farthest_corner(const struct mesh *mesh, vec3 from)
{
	double farthest = 0;

	for (size_t i = 0; i < mesh->count; i++)
		for (int k = 0; k < 3; k++)
			farthest = larger(farthest, vec3_norm2(vec3_sub(mesh_corner(&mesh->triangles[i], k), from)));
	return sqrt(farthest) * (1 + 4 * DBL_EPSILON);
}

static void fill_items(struct builder *b, const struct mesh *mesh)
{
	/* Large enough for sort_triangles: a block that grows would have to move. */
	b->items = mem_alloc(mesh->count * (sizeof(*b->items) > sizeof(mesh_triangle) ? sizeof(*b->items) :
										     sizeof(mesh_triangle)));
	b->triangle = mem_alloc(mesh->count * sizeof(*b->triangle));
	for (size_t i = 0; i < mesh->count; i++) {
		b->items[i] = item_of(&mesh->triangles[i]);
		b->triangle[i] = (uint32_t)i;
	}
}

static void set_bounds(struct bvh *bvh, const struct bvh_item *box)
{
	vec3 least = {least_of(box, 0), least_of(box, 1), least_of(box, 2)};
	vec3 greatest = {greatest_of(box, 0), greatest_of(box, 1), greatest_of(box, 2)};

	bvh->origin = vec3_scale(0.5, vec3_add(least, greatest));
	bvh->half = vec3_scale(0.5, vec3_sub(greatest, least));
	bvh->radius = farthest_corner(&bvh->mesh, bvh->origin);
}

struct bvh *bvh_new_by(struct mesh *mesh, int threads)
{
	struct bvh *bvh = mem_zalloc(1, sizeof(*bvh));
	struct builder b = {.bounds_of = simd_kernels_at_level(simd_level())->bvh_items_bounds};
	struct run all = {.count = mesh->count};

	assert(mesh->count > 0 && mesh->count <= UINT32_MAX);
	bvh->mesh = *mesh;
	*mesh = (struct mesh){0};
	fill_items(&b, &bvh->mesh);
	run_measure(&all, &b);
	set_bounds(bvh, &all.box);
	b.origin[0] = bvh->origin.x;
	b.origin[1] = bvh->origin.y;
	b.origin[2] = bvh->origin.z;
	b.capacity = all.count / LIKELY_SHARE + 1;
	b.nodes = mem_alloc(b.capacity * sizeof(*b.nodes));
	if (threads > 1 && all.count >= BVH_LARGE)
		build_together(&b, &all, threads);
	else
		build(&b, &all);
	sort_triangles(&b, &bvh->mesh);
	free(b.triangle);
	bvh->nodes = mem_realloc(b.nodes, b.node_count, sizeof(*b.nodes));
	bvh->node_count = b.node_count;
	bvh->simd_level = simd_level();
	return bvh;
}

struct bvh *bvh_new(struct mesh *mesh)
{
	return bvh_new_by(mesh, 1);
}

void bvh_free(struct bvh *bvh)
{
	if (!bvh)
		return;
	mesh_release(&bvh->mesh);
	free(bvh->nodes);
	free(bvh);
}
