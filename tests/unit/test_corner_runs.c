#include "geom/corner_runs.h"

#include "scene/convex.h"
#include "solids.h"
#include "suite.h"

/* A prism of many sides and rows, or triangles anywhere; somewhere in space. */
static struct bvh *random_tree(struct random *random, int level)
{
	double size = random_size(random, 1e-2, 1e4);
	vec3 middle = random_point(random, random_size(random, 1e-2, 1e5));
	struct mesh mesh = {0};
	struct bvh *bvh;

	if (random_below(random, 2))
		solid_prism(&mesh, 3 + random_below(random, 40), size, size, 1 + random_below(random, 12));
	for (int i = random_below(random, 200) + !mesh.count; i > 0; i--)
		solid_add(&mesh, random_point(random, size), random_point(random, size), random_point(random, size));
	for (size_t i = 0; i < mesh.count; i++)
		for (int k = 0; k < 3; k++) {
			mesh.triangles[i].v[k][0] += (float)middle.x;
			mesh.triangles[i].v[k][1] += (float)middle.y;
			mesh.triangles[i].v[k][2] += (float)middle.z;
		}
	bvh = bvh_new(&mesh);
	bvh->simd_level = level;
	return bvh;
}

/* The definition, for the triangles of a run of the mesh. */
static long double true_support(const struct bvh *bvh, size_t first, size_t count, vec3 n)
{
	long double greatest = -INFINITY;

	for (size_t i = first; i < first + count; i++) {
		for (int k = 0; k < 3; k++) {
			vec3 p = mesh_corner(&bvh->mesh.triangles[i], k);

			greatest = fmaxl(greatest, (long double)n.x * p.x + (long double)n.y * p.y +
						       (long double)n.z * p.z);
		}
	}
	return greatest;
}

/* A branch or a leaf anywhere in the tree. */
static struct leaf random_leaf(struct random *random, const struct bvh *bvh)
{
	const uint32_t at = (uint32_t)random_below(random, (int)bvh->node_count);
	const struct bvh_node *node = &bvh->nodes[at];
	const int child = random_below(random, node->used);

	if (random_below(random, 2))
		return (struct leaf){at, 0};
	return (struct leaf){node->first[child], node->count[child]};
}

START_TEST(the_support_is_just_enough_at_every_level)
{
	for (long n = 0; n < random_cases(4000); n++) {
		for (int level = LANES_SCALAR; level <= simd_level(); level++) {
			struct random random = random_case(1, n);
			struct bvh *bvh = random_tree(&random, level);
			struct corner_runs *corners = corner_runs_new(bvh);
			const struct leaf leaf = random_leaf(&random, bvh);
			const struct bvh_node *node = leaf.count ? NULL : &bvh->nodes[leaf.first];
			const struct mesh_part part = mesh_part_of(bvh, corners, leaf);
			const xform place = xform_identity();
			struct seen_corners seen = {0};
			const bool sees = random_below(&random, 2);
			const struct convex convex = convex_of_mesh(&part, &place, sees ? &seen : NULL);
			const vec3 m = vec3_scale(random_size(&random, 1e-3, 1e3), random_unit(&random));
			const double size = 2 * vec3_norm(bvh->half) * vec3_norm(m);
			const double slack = random_below(&random, 2) ? random_size(&random, 1e-8, 1) * bvh->radius : 0;
			const double off = slack * vec3_norm(m);
			long visits = 0;
			vec3 at;
			double got;
			long double want = true_support(bvh, node ? node->begin : leaf.first,
							node ? node->total : leaf.count, m);

			for (int i = sees ? random_below(&random, 80) : 0; i > 0; i--)
				convex_support(&convex, random_unit(&random), 0, NULL, &visits);
			got = convex_support(&convex, m, slack, &at, &visits);
			require(got >= (double)want && got <= (double)want + off + 2e-6 * size + 1e-12 * fabs((double)want),
				"case %ld, level %d: %.17g, not %.17Lg", n, level, got, want);
			require(vec3_dot(m, at) >= (double)want - off - 4e-6 * size - 1e-12 * fabs((double)want),
				"case %ld, level %d: the point reaches %.17g of %.17Lg", n, level, vec3_dot(m, at), want);
			corner_runs_free(corners);
			bvh_free(bvh);
		}
	}
}
END_TEST

START_TEST(every_level_gives_the_same_bits)
{
	for (long n = 0; n < random_cases(2000); n++) {
		double first = 0;

		for (int level = LANES_SCALAR; level <= simd_level(); level++) {
			struct random random = random_case(2, n);
			struct bvh *bvh = random_tree(&random, level);
			struct corner_runs *corners = corner_runs_new(bvh);
			const struct mesh_part part = mesh_part_of(bvh, corners, (struct leaf){0, 0});
			const xform place = xform_identity();
			const struct convex convex = convex_of_mesh(&part, &place, NULL);
			long visits = 0;
			double got = convex_support(&convex, random_unit(&random), 0, NULL, &visits);

			if (level == LANES_SCALAR)
				first = got;
			require(!(got < first) && !(got > first), "case %ld: level %d says %a, the scalar one %a", n, level,
				got, first);
			corner_runs_free(corners);
			bvh_free(bvh);
		}
	}
}
END_TEST

START_TEST(the_greatest_of_eight_is_the_first_of_equal_ones)
{
	for (long n = 0; n < random_cases(4000); n++) {
		struct random random = random_case(5, n);
		const unsigned among = 1 + (unsigned)random_below(&random, (1u << BVH_WIDTH) - 1);
		float numbers[BVH_WIDTH];
		int want = -1;

		for (int i = 0; i < BVH_WIDTH; i++) {
			numbers[i] = random_below(&random, 4) ? (float)random_below(&random, 5) - 2 : -INFINITY;
			if (among >> i & 1 && (want < 0 || numbers[i] > numbers[want]))
				want = i;
		}
		for (int level = LANES_SCALAR; level <= simd_level(); level++)
			require(simd_kernels_at_level(level)->greatest_of(numbers, among) == want, "case %ld, level %d", n,
				level);
	}
}
END_TEST

START_TEST(no_child_reaches_beyond_its_cap)
{
	long tried = 0;

	for (long n = 0; n < random_cases(400); n++) {
		for (int level = LANES_SCALAR; level <= simd_level(); level++) {
			struct random random = random_case(3, n);
			struct bvh *bvh = random_tree(&random, level);
			struct corner_runs *corners = corner_runs_new(bvh);
			const vec3 m = vec3_scale(random_size(&random, 1e-3, 1e3), random_unit(&random));
			const float along[3] = {(float)m.x, (float)m.y, (float)m.z};
			const vec3 rounded = {along[0], along[1], along[2]};
			const double size = vec3_norm(m) * vec3_norm(bvh->half);

			for (size_t at = 0; at < bvh->node_count; at++) {
				const struct bvh_node *node = &bvh->nodes[at];
				float reach[BVH_WIDTH], box[BVH_WIDTH];

				if (!corners->runs[at].caps)
					continue;
				corners->kernels->caps_reach(node, &corners->caps[corners->runs[at].caps - 1], along, reach);
				corners->kernels->boxes_reach(node, along, box);
				for (int i = 0; i < node->used; i++, tried++) {
					const struct bvh_node *below = &bvh->nodes[node->first[i]];
					const bool leaf = node->count[i] > 0;
					const double want =
					    (double)true_support(bvh, leaf ? node->first[i] : below->begin,
								 leaf ? node->count[i] : below->total, rounded) -
					    vec3_dot(rounded, bvh->origin);

					require(reach[i] >= want - 0x1p-20 * size && reach[i] <= box[i],
						"case %ld, level %d: %.9g, not %.9g to %.9g", n, level, (double)reach[i],
						want, (double)box[i]);
				}
			}
			corner_runs_free(corners);
			bvh_free(bvh);
		}
	}
	require(tried > 1000, "only %ld children tried", tried);
}
END_TEST

/* The node pairs of 200 supports. */
static long cost_of_supports(const struct bvh *bvh, const struct corner_runs *corners, double slack)
{
	const struct mesh_part part = mesh_part_of(bvh, corners, (struct leaf){0, 0});
	const xform place = xform_identity();
	const struct convex convex = convex_of_mesh(&part, &place, NULL);
	struct random random = random_case(4, 0);
	long visits = 0;

	for (int i = 0; i < 200; i++)
		convex_support(&convex, random_unit(&random), slack, NULL, &visits);
	return visits;
}

/* The purpose of caps: the boxes of a finely meshed ball reach beyond it nearly everywhere. */
START_TEST(caps_save_most_nodes_of_a_fine_ball)
{
	struct mesh mesh = {0};
	struct bvh *bvh;
	struct corner_runs *corners;
	long with, without;

	solid_sphere(&mesh, 100, 200, 100);
	bvh = bvh_new(&mesh);
	corners = corner_runs_new(bvh);
	with = cost_of_supports(bvh, corners, 0.01);
	for (size_t at = 0; at < bvh->node_count; at++)
		corners->runs[at].caps = 0;
	without = cost_of_supports(bvh, corners, 0.01);
	require(2 * with < without, "%ld node pairs with caps, %ld without", with, without);
	corner_runs_free(corners);
	bvh_free(bvh);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("support");

	tcase_add_test(tcase, the_support_is_just_enough_at_every_level);
	tcase_add_test(tcase, every_level_gives_the_same_bits);
	tcase_add_test(tcase, the_greatest_of_eight_is_the_first_of_equal_ones);
	tcase_add_test(tcase, no_child_reaches_beyond_its_cap);
	tcase_add_test(tcase, caps_save_most_nodes_of_a_fine_ball);
	return run_suite("corner_runs", tcase);
}
