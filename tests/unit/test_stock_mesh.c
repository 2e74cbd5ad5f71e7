/* test_stock_mesh.c - the mesh of the remaining stock is closed, contains all that remains, and little more. */
#include <math.h>

#include "geom/inside.h"
#include "geom/point_distance.h"
#include "geom/topology.h"
#include "machine/tool_solid.h"
#include "random.h"
#include "solids.h"
#include "stock/stock_mesh.h"
#include "suite.h"

/* A box of 40 x 30 x 10 mm with a slot of a flat cutter of 10 mm along X: its floor at z = 5, its round end at x = 5. */
struct slotted {
	struct mesh mesh;
	struct topology topology;
	struct cutter cutter;
	struct cut_log log;
	struct stock_cells cells;
	struct bvh *bvh;
};

/* The box with the first `cuts` pieces of the slot, cut by this tool. */
static void slotted_init_with(struct slotted *s, const struct tool_solid *tool, int cuts, double uncertainty,
			      double excess)
{
	const xform up = {mat3_identity(), {0, 0, 5}};
	struct blank blank;

	*s = (struct slotted){.bvh = NULL};
	solid_box(&s->mesh, (vec3){20, 15, 5});
	solid_place(&s->mesh, &up);
	s->bvh = bvh_new(&s->mesh);
	topology_init(&s->topology, &s->bvh->mesh);
	cutter_init(&s->cutter, tool);
	cut_log_init(&s->log, &s->cutter);
	/* The slot has pieces, so that cubes at their seams are removed in parts. */
	for (int i = 0; i < cuts; i++)
		cut_log_add(&s->log, &(struct cut){.from = i, .to = i + 1,
						   .way = {{{-40 + 15 * i, 0, 25}, {0, 0, 1}},
							   {{-25 + 15 * i, 0, 25}, {0, 0, 1}}}});
	blank = (struct blank){s->bvh, &s->topology, uncertainty, excess};
	stock_cells_init(&s->cells, &blank, &s->log, 0.05);
}

static void slotted_init_of(struct slotted *s, double uncertainty, double excess)
{
	static const struct tool_section sections[] = {{20, 10, 10}};
	static const struct tool_solid flat = {.sections = sections, .count = 1, .tip = TIP_FLAT};

	slotted_init_with(s, &flat, 3, uncertainty, excess);
}

static void slotted_init(struct slotted *s)
{
	slotted_init_of(s, 0, 0);
}

static void slotted_release(struct slotted *s)
{
	stock_cells_release(&s->cells);
	cut_log_release(&s->log);
	cutter_release(&s->cutter);
	topology_release(&s->topology);
	bvh_free(s->bvh);
}

/* mm: the depth of a point inside the remaining stock (negative: outside), except near the corners of the slot. */
static double depth_of(vec3 p, bool cut)
{
	const double past = p.x > 5 ? sqrt((p.x - 5) * (p.x - 5) + p.y * p.y) : fabs(p.y);
	const double box = fmin(fmin(20 - fabs(p.x), 15 - fabs(p.y)), fmin(p.z, 10 - p.z));

	return cut ? fmin(box, fmax(past - 5, 5 - p.z)) : box;
}

/* Before the cuts and after them. */
START_TEST(mesh_encloses_what_remains)
{
	const bool cut = _i;
	struct random random = random_case(1, _i);
	struct topology topology;
	struct slotted s;
	struct mesh mesh;
	struct bvh *bvh;
	double edge, excess;
	int inside = 0;

	slotted_init(&s);
	edge = stock_mesh_build(&s.cells, cut ? 10 : -1, 64, UINT64_MAX, &mesh, &excess);
	ck_assert(edge * 64 >= 40 && edge * 32 < 40.1);
	bvh = bvh_new(&mesh);
	topology_init(&topology, &bvh->mesh);
	ck_assert(topology.closed && topology.open_edges == 0 && topology.degenerate == 0);
	for (int n = 0; n < 20000; n++) {
		const vec3 off = random_point(&random, 1), p = {22 * off.x, 17 * off.y, 5 + 6 * off.z};
		const bool is_inside = mesh_inside(bvh, &topology, p) == INSIDE_YES;
		const double depth = depth_of(p, cut);

		inside += is_inside;
		if (depth > 1e-3)
			ck_assert(is_inside);
		if (depth < -2 * edge)
			ck_assert(!is_inside);
		if (is_inside && mesh_point_distance(bvh, p) > excess)
			ck_assert(depth > -1e-3);
	}
	/* Here walls and floor are plane, and the cutter is large. */
	ck_assert_double_le(excess, 3 * edge);
	ck_assert_int_gt(inside, 1000);
	topology_release(&topology);
	bvh_free(bvh);
	slotted_release(&s);
}
END_TEST

/*
 * The true blank may be larger by `uncertainty` and smaller by `excess`: the mesh encloses the one, and below `excess`
 * of the mesh there is material of the other.
 */
START_TEST(doubts_about_the_blank_add_up)
{
	static const struct {
		double uncertainty, excess;
	} cases[] = {{0, 3}, {0.5, 3}, {0.5, 0}, {0, 0.01}, {1, 1}, {0, 100}};
	const double uncertainty = cases[_i / 2].uncertainty, doubt = cases[_i / 2].excess;
	const bool cut = _i % 2;
	struct random random = random_case(2, _i);
	struct topology topology;
	struct slotted s;
	struct mesh mesh;
	struct bvh *bvh;
	double edge, excess;

	slotted_init_of(&s, uncertainty, doubt);
	edge = stock_mesh_build(&s.cells, cut ? 10 : -1, 64, UINT64_MAX, &mesh, &excess);
	bvh = bvh_new(&mesh);
	topology_init(&topology, &bvh->mesh);
	for (int n = 0; n < 5000; n++) {
		const vec3 off = random_point(&random, 1), p = {22 * off.x, 17 * off.y, 5 + 7 * off.z};
		const bool is_inside = mesh_inside(bvh, &topology, p) == INSIDE_YES;
		const double depth = depth_of(p, false);

		if (!cut && depth > 1e-3 - uncertainty)
			ck_assert(is_inside);
		if (is_inside && mesh_point_distance(bvh, p) > excess)
			ck_assert(depth >= doubt && depth_of(p, cut) > -1e-3);
	}
	ck_assert_double_le(excess, uncertainty + doubt + 4 * edge);
	topology_release(&topology);
	bvh_free(bvh);
	slotted_release(&s);
}
END_TEST

/* With too little effort there is no mesh. */
START_TEST(mesh_that_costs_too_much_is_none)
{
	struct slotted s;
	struct mesh mesh;

	slotted_init(&s);
	ck_assert_double_le(stock_mesh_build(&s.cells, 10, 64, 1, &mesh, NULL), 0);
	ck_assert_uint_eq(mesh.count, 0);
	slotted_release(&s);
}
END_TEST

/*
 * Narrow slots leave a wall in each cube: the mesh is whole, although deep below its surface much is cut. If fine cubes
 * cost too much, the mesh is made of larger ones.
 */
START_TEST(cut_places_deep_in_the_mesh_are_told)
{
	static const struct tool_section sections[] = {{20, 0.5, 0.5}};
	static const struct tool_solid narrow = {.sections = sections, .count = 1, .tip = TIP_FLAT};
	struct slotted s;
	struct stock_remainder remainder = {.known = false};
	struct bvh *bvh;
	double deepest = 0;

	slotted_init_with(&s, &narrow, 0, 0, 0);
	for (int i = 0; i < 30; i++)
		cut_log_add(&s.log, &(struct cut){.from = i, .to = i + 1,
						  .way = {{{-40, i - 14.5, 21}, {0, 0, 1}},
							  {{40, i - 14.5, 21}, {0, 0, 1}}}});
	stock_remainder_build(&s.cells, 100, 300, &remainder);
	ck_assert(remainder.known && remainder.coarse);
	ck_assert_double_gt(remainder.edge, 2);
	ck_assert_double_lt(remainder.edge, 7);
	bvh = bvh_new(&remainder.mesh);
	for (int i = 0; i < 30; i++)
		deepest = fmax(deepest, mesh_point_distance(bvh, (vec3){0, i - 14.5, 5}));
	ck_assert_double_gt(deepest, 4.9);
	ck_assert_double_ge(remainder.excess, deepest);
	bvh_free(bvh);
	slotted_release(&s);
}
END_TEST

int main(void)
{
	TCase *cases = tcase_create("all");

	tcase_add_loop_test(cases, mesh_encloses_what_remains, 0, 2);
	tcase_add_loop_test(cases, doubts_about_the_blank_add_up, 0, 12);
	tcase_add_test(cases, mesh_that_costs_too_much_is_none);
	tcase_add_test(cases, cut_places_deep_in_the_mesh_are_told);
	return run_suite("stock_mesh", cases);
}
