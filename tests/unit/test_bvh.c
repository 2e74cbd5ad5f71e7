#include "geom/bvh.h"

#include <stdlib.h>
#include <string.h>

#include "geom/simd_level.h"
#include "solids.h"
#include "suite.h"

/* The results of a walk over all boxes. */
struct census {
	const struct bvh *bvh;
	long number;
	unsigned char *seen;	/* for each triangle, the number of leaves that hold it */
	unsigned char *visited;	/* for each node, the number of visits */
	int depth;
};

/* The corners of a run lie exactly in the box, computed in double. */
static void expect_inside(const struct census *c, const struct bvh_node *node, int lane, size_t first, size_t count)
{
	const double origin[3] = {c->bvh->origin.x, c->bvh->origin.y, c->bvh->origin.z};

	for (size_t i = first; i < first + count; i++) {
		for (int k = 0; k < 9; k++) {
			double at = c->bvh->mesh.triangles[i].v[k / 3][k % 3] - origin[k % 3];
			double centre = node->centre[k % 3][lane], half = node->half[k % 3][lane];

			require(at >= centre - half && at <= centre + half, "case %ld: triangle %zu is outside its box",
				c->number, i);
		}
	}
}

/* Returns the run of triangles below a node; runs of siblings follow each other. */
static void take(struct census *c, size_t at, int depth, size_t *first, size_t *count)
{
	const struct bvh_node *node = &c->bvh->nodes[at];

	require(at < c->bvh->node_count && !c->visited[at]++, "case %ld: node %zu", c->number, at);
	require(node->used >= 1 && node->used <= BVH_WIDTH, "case %ld: %d children", c->number, node->used);
	c->depth = depth > c->depth ? depth : c->depth;
	*first = SIZE_MAX;
	*count = 0;
	for (int l = 0; l < node->used; l++) {
		size_t begin = node->first[l], length = node->count[l];

		require(length <= BVH_LEAF_SIZE, "case %ld: a leaf of %zu", c->number, length);
		for (size_t i = begin; i < begin + length; i++)
			require(i < c->bvh->mesh.count && !c->seen[i]++, "case %ld: triangle %zu", c->number, i);
		if (!length)
			take(c, node->first[l], depth + 1, &begin, &length);
		expect_inside(c, node, l, begin, length);
		*first = begin < *first ? begin : *first;
		*count += length;
	}
	for (int l = node->used; l < BVH_WIDTH; l++)
		for (int k = 0; k < 3; k++)
			require(memcmp(&node->centre[k][l], &node->centre[k][0], sizeof(float)) == 0 &&
					memcmp(&node->half[k][l], &node->half[k][0], sizeof(float)) == 0,
				"case %ld: the box of an unused child", c->number);
}

static int compare_triangles(const void *a, const void *b)
{
	return memcmp(a, b, sizeof(mesh_triangle));
}

static mesh_triangle *sorted_copy(const struct mesh *mesh)
{
	mesh_triangle *copy = mem_alloc(mesh->count * sizeof(*copy));

	memcpy(copy, mesh->triangles, mesh->count * sizeof(*copy));
	qsort(copy, mesh->count, sizeof(*copy), compare_triangles);
	return copy;
}

/* Builds the tree, checks all of it and returns its depth. */
static int examine(struct mesh *mesh, long number)
{
	mesh_triangle *before = sorted_copy(mesh), *after;
	size_t first, count, all = mesh->count;
	struct bvh *bvh = bvh_new(mesh);
	struct census c = {bvh, number, mem_zalloc(all, 1), mem_zalloc(bvh->node_count, 1), 0};

	require(!mesh->triangles && !mesh->count, "case %ld: the mesh was to be taken over", number);
	after = sorted_copy(&bvh->mesh);
	require(bvh->mesh.count == all && !memcmp(before, after, all * sizeof(*before)), "case %ld: other triangles",
		number);
	take(&c, 0, 1, &first, &count);
	require(first == 0 && count == all, "case %ld: %zu of %zu triangles in leaves", number, count, all);
	for (size_t i = 0; i < all; i++) {
		for (int k = 0; k < 3; k++) {
			vec3 to = vec3_sub(mesh_corner(&bvh->mesh.triangles[i], k), bvh->origin);

			require(vec3_norm(to) <= bvh->radius, "case %ld: beyond the radius", number);
			require(fabs(to.x) <= bvh->half.x && fabs(to.y) <= bvh->half.y && fabs(to.z) <= bvh->half.z,
				"case %ld: beyond the bounds", number);
		}
	}
	bvh_free(bvh);
	free(before);
	free(after);
	free(c.seen);
	free(c.visited);
	return c.depth;
}

static void add_at(struct mesh *mesh, vec3 at, double size)
{
	solid_add(mesh, at, vec3_add(at, (vec3){size, 0, 0}), vec3_add(at, (vec3){0, size, size}));
}

START_TEST(random_soups)
{
	for (long n = 0; n < random_cases(1500); n++) {
		struct random random = random_case(1, n);
		double size = random_size(&random, 1e-6, 1e6), offset = random_size(&random, 1e-3, 1e6);
		vec3 middle = random_point(&random, offset);
		struct mesh mesh = {0};
		int count = 1 + random_below(&random, n % 10 ? 40 : 2000);

		for (int i = 0; i < count; i++)
			solid_add(&mesh, vec3_add(middle, random_point(&random, size)),
				  vec3_add(middle, random_point(&random, size)),
				  vec3_add(middle, random_point(&random, size)));
		examine(&mesh, n);
	}
}
END_TEST

START_TEST(degenerate_soups)
{
	struct mesh one = {0}, points = {0}, same = {0}, line = {0}, growing = {0}, nested = {0};

	add_at(&one, (vec3){1, 2, 3}, 4);
	ck_assert_int_eq(examine(&one, 0), 1);
	for (int i = 0; i < 9; i++)
		solid_add(&points, (vec3){7, 7, 7}, (vec3){7, 7, 7}, (vec3){7, 7, 7});
	examine(&points, 1);
	for (int i = 0; i < 5000; i++) {
		add_at(&same, (vec3){1, 1, 1}, 1);
		add_at(&line, (vec3){0.25 * i, 0, 0}, 0.1);
		/* Sizes grow geometrically: each split at the middle separates only one triangle. */
		add_at(&growing, (vec3){pow(2, i * 0.005), 0, 0}, 1e-3);
		/* All triangles have the same centre. */
		solid_add(&nested, (vec3){-i, -i, -i}, (vec3){i, i, i}, (vec3){0, 0, i});
	}
	ck_assert_int_le(examine(&same, 2), 8);
	ck_assert_int_le(examine(&line, 3), 12);
	ck_assert_int_le(examine(&growing, 4), 60);
	ck_assert_int_le(examine(&nested, 5), 60);
}
END_TEST

START_TEST(hundred_thousand)
{
	struct random random = random_case(3, 0);
	struct mesh mesh = {0}, big = {0};

	solid_sphere(&mesh, 100, 200, 250);
	big.triangles = mem_alloc(100000 * sizeof(*big.triangles));
	big.count = 100000;
	for (size_t i = 0; i < big.count; i++)
		big.triangles[i] = mesh.triangles[(size_t)random_below(&random, (int)mesh.count)];
	mesh_release(&mesh);
	/* A perfectly balanced tree has depth 8. */
	ck_assert_int_le(examine(&big, 0), 20);
}
END_TEST

/* Fails unless both trees have the same bytes. */
static void expect_same(const struct bvh *a, const struct bvh *b, const char *what)
{
	require(a->node_count == b->node_count && a->mesh.count == b->mesh.count, "%s: another size", what);
	require(!memcmp(a->mesh.triangles, b->mesh.triangles, a->mesh.count * sizeof(*a->mesh.triangles)),
		"%s: another order of triangles", what);
	for (size_t i = 0; i < a->node_count; i++) {
		const struct bvh_node *p = &a->nodes[i], *q = &b->nodes[i];

		require(!memcmp(p->centre, q->centre, sizeof(p->centre)) && !memcmp(p->half, q->half, sizeof(p->half)) &&
				!memcmp(p->first, q->first, sizeof(p->first)) &&
				!memcmp(p->count, q->count, sizeof(p->count)) && p->begin == q->begin &&
				p->total == q->total && p->used == q->used,
			"%s: node %zu differs", what, i);
	}
}

static struct mesh copy_of(const struct mesh *mesh)
{
	struct mesh copy = *mesh;

	copy.triangles = mem_alloc(mesh->count * sizeof(*copy.triangles));
	memcpy(copy.triangles, mesh->triangles, mesh->count * sizeof(*copy.triangles));
	return copy;
}

/* Neither the processor nor the number of threads may change the order of triangles, because findings depend on it. */
START_TEST(one_tree)
{
	static const char *const levels[] = {"scalar", "sse2", "avx2"};

	for (long n = 0; n < random_cases(60); n++) {
		struct random random = random_case(4, n);
		struct mesh mesh = {0}, copy;
		int count = n % 20 ? 1 + random_below(&random, 3000) : BVH_LARGE;
		struct bvh *scalar, *other;

		for (int i = 0; i < count; i++) {
			vec3 at = {random_below(&random, 50), random_below(&random, 50) * 0.1, random_below(&random, 3)};

			solid_add(&mesh, at, vec3_add(at, random_point(&random, 1)), vec3_add(at, random_point(&random, 1)));
		}
		setenv(SIMD_LEVEL_VARIABLE, levels[0], 1);
		copy = copy_of(&mesh);
		scalar = bvh_new(&copy);
		for (int level = 1; level < 3; level++) {
			setenv(SIMD_LEVEL_VARIABLE, levels[level], 1);
			copy = copy_of(&mesh);
			other = bvh_new(&copy);
			expect_same(scalar, other, levels[level]);
			bvh_free(other);
		}
		unsetenv(SIMD_LEVEL_VARIABLE);
		for (int threads = 2; threads < 5; threads++) {
			copy = copy_of(&mesh);
			other = bvh_new_by(&copy, threads);
			expect_same(scalar, other, "threads");
			bvh_free(other);
		}
		bvh_free(scalar);
		mesh_release(&mesh);
	}
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("trees");

	tcase_add_test(tcase, random_soups);
	tcase_add_test(tcase, degenerate_soups);
	tcase_add_test(tcase, hundred_thousand);
	tcase_add_test(tcase, one_tree);
	return run_suite("bvh", tcase);
}
