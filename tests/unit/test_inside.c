/*
 * test_inside.c - points against boxes, whose inside is known from the coordinates, in all forms in which boxes are
 * drawn; a torus against solid angles.
 */
#include "geom/inside.h"

#include <math.h>

#include "base/mem.h"
#include "geom/edge_balance.h"
#include "geom/nesting.h"
#include "random.h"
#include "suite.h"

struct block {
	vec3 least, greatest;
};

static void add_triangle(struct mesh *mesh, vec3 a, vec3 b, vec3 c)
{
	const vec3 corners[3] = {a, b, c};
	mesh_triangle *t;

	mesh->triangles = mem_realloc(mesh->triangles, mesh->count + 1, sizeof(*t));
	t = &mesh->triangles[mesh->count++];
	for (int k = 0; k < 3; k++) {
		t->v[k][0] = (float)corners[k].x;
		t->v[k][1] = (float)corners[k].y;
		t->v[k][2] = (float)corners[k].z;
	}
}

static void add_block(struct mesh *mesh, struct block block, bool inverted)
{
	static const int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
					{2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
	vec3 p[8];

	for (int k = 0; k < 8; k++)
		p[k] = (vec3){k & 1 ? block.greatest.x : block.least.x, k & 2 ? block.greatest.y : block.least.y,
			      k & 4 ? block.greatest.z : block.least.z};
	for (int f = 0; f < 6; f++) {
		vec3 a = p[faces[f][0]], b = p[faces[f][1]], c = p[faces[f][2]], d = p[faces[f][3]];

		add_triangle(mesh, a, inverted ? c : b, inverted ? b : c);
		add_triangle(mesh, a, inverted ? d : c, inverted ? c : d);
	}
}

static bool in_block(struct block block, vec3 p)
{
	return p.x > block.least.x && p.x < block.greatest.x && p.y > block.least.y && p.y < block.greatest.y &&
	       p.z > block.least.z && p.z < block.greatest.z;
}

/* Checks the answer for a point, on a copy of the mesh. */
struct model {
	struct bvh *bvh;
	struct topology topology;
};

static void model_init(struct model *model, struct mesh *mesh)
{
	model->bvh = bvh_new(mesh);
	topology_init(&model->topology, &model->bvh->mesh);
}

static void model_release(struct model *model)
{
	topology_release(&model->topology);
	bvh_free(model->bvh);
}

/* mesh_inside; the cheaper functions must say the same of INSIDE_YES. */
static enum inside inside_of(const struct model *model, vec3 p)
{
	const enum inside inside = mesh_inside(model->bvh, &model->topology, p);

	ck_assert_int_eq(mesh_is_inside(model->bvh, &model->topology, p), inside == INSIDE_YES);
	if (edge_balance_is_closed(&model->bvh->mesh) && !model->topology.doubled)
		ck_assert_int_eq(mesh_is_inside_closed(model->bvh, p), inside == INSIDE_YES);
	return inside;
}

static const struct block outer = {{-10, -8, -6}, {10, 8, 6}}, inner = {{-6, -7, -5.5}, {6, 7, 5.5}};
static const struct block aside = {{20, -8, -6}, {30, 8, 6}};

static void expect(struct mesh *mesh, enum inside in_inner, enum inside in_outer, enum inside in_aside, enum inside out)
{
	struct model model;

	model_init(&model, mesh);
	ck_assert_int_eq(inside_of(&model, (vec3){1, 2, 0.5}), in_inner);
	ck_assert_int_eq(inside_of(&model, (vec3){0, 0, 0}), in_inner);
	ck_assert_int_eq(inside_of(&model, (vec3){7, 4, 3}), in_outer);
	ck_assert_int_eq(inside_of(&model, (vec3){25, 0, 0}), in_aside);
	ck_assert_int_eq(inside_of(&model, (vec3){15, 0, 0}), out);
	ck_assert_int_eq(inside_of(&model, (vec3){0, 0, 6.5}), out);
	model_release(&model);
}

static void add_doubled(struct mesh *mesh, struct block block)
{
	add_block(mesh, block, false);
	add_block(mesh, block, true);
}

START_TEST(drawn_in_all_ways)
{
	struct mesh mesh = {0};

	add_block(&mesh, outer, false);
	expect(&mesh, INSIDE_YES, INSIDE_YES, INSIDE_NO, INSIDE_NO);
	add_block(&mesh, outer, true);
	expect(&mesh, INSIDE_YES, INSIDE_YES, INSIDE_NO, INSIDE_NO);
	/* A cavity; the same with all triangles reversed; a shell inside a cavity. */
	add_block(&mesh, outer, false);
	add_block(&mesh, inner, true);
	expect(&mesh, INSIDE_NO, INSIDE_YES, INSIDE_NO, INSIDE_NO);
	add_block(&mesh, outer, true);
	add_block(&mesh, inner, false);
	expect(&mesh, INSIDE_NO, INSIDE_YES, INSIDE_NO, INSIDE_NO);
	add_block(&mesh, outer, false);
	add_block(&mesh, inner, false);
	expect(&mesh, INSIDE_YES, INSIDE_YES, INSIDE_NO, INSIDE_NO);
	/* One block faces outward, the one beside it inward. */
	add_block(&mesh, outer, false);
	add_block(&mesh, aside, true);
	expect(&mesh, INSIDE_YES, INSIDE_YES, INSIDE_YES, INSIDE_NO);
}
END_TEST

START_TEST(drawn_from_both_sides)
{
	struct mesh mesh = {0};
	struct topology t;

	add_doubled(&mesh, outer);
	topology_init(&t, &mesh);
	ck_assert_uint_eq(t.doubled, 12);
	ck_assert(t.closed && !t.plain && !topology_is_open(&t));
	topology_release(&t);
	expect(&mesh, INSIDE_YES, INSIDE_YES, INSIDE_NO, INSIDE_NO);
	/* A block that is drawn four times. */
	add_doubled(&mesh, outer);
	add_doubled(&mesh, outer);
	expect(&mesh, INSIDE_YES, INSIDE_YES, INSIDE_NO, INSIDE_NO);
	/* A doubled block beside a block that is drawn once. */
	add_doubled(&mesh, outer);
	add_block(&mesh, aside, false);
	expect(&mesh, INSIDE_YES, INSIDE_YES, INSIDE_YES, INSIDE_NO);
	/* This can be a cavity or a solid, so the answer is unknown. */
	add_doubled(&mesh, outer);
	add_doubled(&mesh, inner);
	expect(&mesh, INSIDE_UNKNOWN, INSIDE_YES, INSIDE_NO, INSIDE_NO);
	/* Without a lid the block is open. */
	add_block(&mesh, outer, false);
	mesh.count = 11;
	add_block(&mesh, outer, true);
	mesh.triangles[22] = mesh.triangles[21];
	mesh.count = 22;
	expect(&mesh, INSIDE_UNKNOWN, INSIDE_UNKNOWN, INSIDE_NO, INSIDE_NO);
	/* Two solids with a common face: only this face is drawn twice. */
	add_block(&mesh, (struct block){{-10, -8, -6}, {0.5, 8, 6}}, false);
	add_block(&mesh, (struct block){{0.5, -8, -6}, {10, 8, 6}}, false);
	expect(&mesh, INSIDE_YES, INSIDE_YES, INSIDE_NO, INSIDE_NO);
}
END_TEST

START_TEST(drawn_badly)
{
	struct mesh mesh = {0};
	mesh_triangle swap;

	/* A hole: the inside is unknown, the outside is known. */
	add_block(&mesh, outer, false);
	mesh.count = 11;
	expect(&mesh, INSIDE_UNKNOWN, INSIDE_UNKNOWN, INSIDE_NO, INSIDE_NO);
	/* A closed solid beside the block with the hole. */
	add_block(&mesh, outer, false);
	mesh.count = 11;
	add_block(&mesh, aside, false);
	expect(&mesh, INSIDE_UNKNOWN, INSIDE_UNKNOWN, INSIDE_YES, INSIDE_NO);
	/* Neighbours that face opposite ways: there is no winding number, but every edge has two sides. */
	add_block(&mesh, outer, false);
	for (int t = 0; t < 12; t += 5) {
		swap = mesh.triangles[t];
		for (int k = 0; k < 3; k++) {
			mesh.triangles[t].v[1][k] = swap.v[2][k];
			mesh.triangles[t].v[2][k] = swap.v[1][k];
		}
	}
	expect(&mesh, INSIDE_YES, INSIDE_YES, INSIDE_NO, INSIDE_NO);
}
END_TEST

/* Blocks with whole coordinates in all forms; some points lie in the planes of their faces and edges. */
START_TEST(random_blocks)
{
	struct random state = random_case(5, 0);
	int inside = 0;

	for (int turn = 0; turn < 400; turn++) {
		struct block blocks[4];
		struct mesh mesh = {0};
		struct model model;
		bool all_inward = turn % 3 == 0;

		/* The blocks are in a row along x, so they are apart. */
		for (int b = 0; b < 4; b++) {
			double x = 10 * b;

			blocks[b].least = (vec3){x, floor(4 * random_in(&state, 0, 1)), floor(4 * random_in(&state, 0, 1))};
			blocks[b].greatest = (vec3){x + 2 + floor(7 * random_in(&state, 0, 1)),
						    5 + floor(4 * random_in(&state, 0, 1)), 5 + floor(4 * random_in(&state, 0, 1))};
			add_block(&mesh, blocks[b], all_inward || random_in(&state, 0, 1) < 0.3);
			if (random_in(&state, 0, 1) < 0.3)
				add_doubled(&mesh, blocks[b]);
		}
		model_init(&model, &mesh);
		for (int i = 0; i < 200; i++) {
			vec3 p = {floor(80 * random_in(&state, 0, 1)) / 2 + 0.25, floor(20 * random_in(&state, 0, 1)) / 2,
				  floor(20 * random_in(&state, 0, 1)) / 2};
			bool truth = false, on_surface = false;

			for (int b = 0; b < 4; b++) {
				struct block grown = blocks[b], shrunk = blocks[b];

				grown.least = vec3_sub(grown.least, (vec3){0.1, 0.1, 0.1});
				grown.greatest = vec3_add(grown.greatest, (vec3){0.1, 0.1, 0.1});
				shrunk.least = vec3_add(shrunk.least, (vec3){0.1, 0.1, 0.1});
				shrunk.greatest = vec3_sub(shrunk.greatest, (vec3){0.1, 0.1, 0.1});
				on_surface |= in_block(grown, p) && !in_block(shrunk, p);
				truth |= in_block(blocks[b], p);
			}
			if (on_surface)
				continue;
			ck_assert_int_eq(inside_of(&model, p), truth ? INSIDE_YES : INSIDE_NO);
			inside += truth;
		}
		model_release(&model);
	}
	ck_assert_int_gt(inside, 5000);
}
END_TEST

/* The answer of the ray against the sum of the solid angles. */
START_TEST(ray_matches_solid_angles)
{
	enum { N = 60 };
	struct mesh mesh = {0};
	struct model model;
	struct random state = random_case(77, 0);
	int inside = 0, free_rays = 0;

	for (int i = 0; i < N * N; i++) {
		vec3 p[4];

		for (int k = 0; k < 4; k++) {
			double u = 6.283185307179586 * ((i / N + (k & 1)) % N) / N;
			double v = 6.283185307179586 * ((i % N + (k >> 1)) % N) / N;

			p[k] = (vec3){(3 + cos(v)) * cos(u), (3 + cos(v)) * sin(u), sin(v)};
		}
		add_triangle(&mesh, p[0], p[1], p[3]);
		add_triangle(&mesh, p[0], p[3], p[2]);
	}
	add_block(&mesh, (struct block){{2.75, -0.25, -0.25}, {3.25, 0.25, 0.25}}, true);
	model_init(&model, &mesh);
	for (int i = 0; i < 1000; i++) {
		vec3 p = {9 * random_in(&state, 0, 1) - 4.5, 9 * random_in(&state, 0, 1) - 4.5, 3 * random_in(&state, 0, 1) - 1.5};
		bool truth = mesh_winding_number(&model.bvh->mesh, p) != 0;

		ck_assert_int_eq(inside_of(&model, p), truth ? INSIDE_YES : INSIDE_NO);
		inside += truth;
		free_rays += mesh_ray_is_free(model.bvh, p);
		ck_assert(!truth || !mesh_ray_is_free(model.bvh, p));
	}
	ck_assert_int_gt(inside, 150);
	/* Most points outside the torus have a free ray, also those in its hole. */
	ck_assert_int_gt(free_rays, (1000 - inside) * 9 / 10);
	model_release(&model);
}
END_TEST

static void expect_nesting(struct mesh *mesh, size_t inverted, size_t nested)
{
	struct topology topology;
	struct nesting nesting;

	topology_init(&topology, mesh);
	nesting_find(&nesting, mesh, &topology);
	ck_assert_uint_eq(nesting.inverted, inverted);
	ck_assert_uint_eq(nesting.nested, nested);
	topology_release(&topology);
}

START_TEST(shells_within_shells)
{
	struct mesh mesh = {0};

	add_block(&mesh, outer, false);
	expect_nesting(&mesh, 0, 0);
	add_block(&mesh, inner, true);
	expect_nesting(&mesh, 0, 0);
	add_block(&mesh, aside, true);
	expect_nesting(&mesh, 1, 0);
	mesh.count = 0;
	add_block(&mesh, outer, true);
	expect_nesting(&mesh, 1, 0);
	add_block(&mesh, inner, true);
	expect_nesting(&mesh, 1, 1);
	mesh.count = 12;
	add_block(&mesh, inner, false);
	expect_nesting(&mesh, 1, 0);
	mesh.count = 0;
	add_block(&mesh, outer, false);
	add_block(&mesh, inner, false);
	expect_nesting(&mesh, 0, 1);
	mesh_release(&mesh);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("core");

	tcase_add_test(tcase, drawn_in_all_ways);
	tcase_add_test(tcase, drawn_from_both_sides);
	tcase_add_test(tcase, drawn_badly);
	tcase_add_test(tcase, random_blocks);
	tcase_add_test(tcase, ray_matches_solid_angles);
	tcase_add_test(tcase, shells_within_shells);
	return run_suite("inside", tcase);
}
