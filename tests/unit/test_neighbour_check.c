/* test_neighbour_check.c - excused neighbours that meet when their joint moves, against closed forms. */
#include "scene/neighbour_check.h"

#include "base/same_double.h"
#include "base/units.h"
#include "model_case.h"
#include "scene/model_check.h"
#include "suite.h"

/*
 * A bed with a wall at X 200, and a slide of X that stands on the bed. At X = x the face of the slide is x - 150 mm
 * deep in the wall: 80 mm at 230, the end of the travel.
 */
static void start(struct model *model, double most)
{
	model_init(model);
	model_box(model, ROLE_MACHINE, LINK_BASE, (vec3){200, -200, 0}, (vec3){500, 200, 400});
	model_box(model, ROLE_MACHINE, LINK_X, (vec3){-50, -50, 100}, (vec3){50, 50, 200});
	model->machine.axes[LINK_X - 1].limit_max = most;
}

static void excuse(struct model *model, enum pair_status status)
{
	struct scene_pair pair = {.a = 0, .b = 1, .status = status};

	chain_init(&pair.chain, &model->machine, model->bodies[0].link, model->bodies[1].link);
	model->scene->pairs = mem_realloc(model->scene->pairs, 1, sizeof(*model->scene->pairs));
	model->scene->pairs[0] = pair;
	model->scene->pair_count = 1;
}

/* Expects the doubt with its depth (mm) and the position of the joint; depth 0: no doubt. */
static void expect(struct model *model, double depth, double position)
{
	struct doubts doubts = {0};
	const struct doubt *doubt;

	neighbour_check(model->scene, &doubts);
	doubt = model_doubt(&doubts, DOUBT_NEIGHBOURS_MEET);
	ck_assert_uint_eq(doubts.count, depth > 0);
	if (doubt) {
		require(fabs(doubt->value - depth) < 1e-3, "%g mm, not %g", doubt->value, depth);
		require(fabs(doubt->limit - position) < 1e-9, "at %g, not %g", doubt->limit, position);
		ck_assert_int_eq(doubt->body, 0);
		ck_assert_int_eq(doubt->against, 1);
	}
	doubts_release(&doubts);
}

/* The end of the travel decides. On some machines guideways are drawn a little into each other. */
START_TEST(linear)
{
	static const struct {
		double most, depth;
	} cases[] = {{140, 0}, {160, 0}, {174, 0}, {176, 26}, {230, 80}};
	struct random random = random_case(1, 0);

	for (int i = 0; i < COUNT(cases); i++) {
		for (int k = 0; k < 5; k++) {
			const xform by = random_place(&random, 2000);
			struct model model;

			start(&model, cases[i].most);
			if (k)
				model_move(&model, &by);
			excuse(&model, PAIR_ADJACENT);
			expect(&model, cases[i].depth, cases[i].most);
			model_release(&model);
		}
	}
}
END_TEST

/* Only excused pairs are doubted, and no pair that the file marks as checked. */
START_TEST(not_judged)
{
	static const enum pair_status others[] = {PAIR_CHECKED, PAIR_WAIVED, PAIR_OUT_OF_REACH};
	struct model model;

	start(&model, 230);
	for (int i = 0; i < COUNT(others); i++) {
		excuse(&model, others[i]);
		expect(&model, 0, 0);
	}
	excuse(&model, PAIR_ADJACENT);
	model.machine.axes[LINK_X - 1].checked = "a bellows";
	expect(&model, 0, 0);
	model_release(&model);
}
END_TEST

/* A pair that is drawn as deep at home is not doubted: 30 mm at home, 50 mm at the end. */
START_TEST(as_deep_at_home)
{
	struct model model;

	start(&model, 200);
	model.machine.axes[LINK_X - 1].home = 180;
	excuse(&model, PAIR_ADJACENT);
	expect(&model, 0, 0);
	model.machine.axes[LINK_X - 1].home = 160;
	expect(&model, 50, 200);
	model_release(&model);
}
END_TEST

/*
 * An endless rotary axis is turned once: an arm of C, 300 mm long and 40 mm wide, points into a post at -90 degrees.
 * The middles of the two triangles at the arm's end are 60 - 20/3 mm from the flanks of the post, and `behind` mm from
 * its far side.
 */
START_TEST(endless_rotary)
{
	static const double behinds[] = {20, 100};

	for (int i = 0; i < COUNT(behinds); i++) {
		struct model model;

		model_init(&model);
		model.machine.axes[LINK_C - 1].parent = LINK_BASE;
		model_box(&model, ROLE_MACHINE, LINK_BASE, (vec3){-60, 200, 0}, (vec3){60, 300 + behinds[i], 200});
		model_box(&model, ROLE_MACHINE, LINK_C, (vec3){0, -20, 50}, (vec3){300, 20, 90});
		excuse(&model, PAIR_ADJACENT);
		expect(&model, i ? 60 - 20.0 / 3 : 0, radians(-90));
		model_release(&model);
	}
}
END_TEST

static void add_shell(struct mesh *mesh, double half, bool inverted)
{
	struct mesh box = {0};

	solid_box(&box, (vec3){half, half, half});
	for (size_t i = 0; i < box.count; i++) {
		const tri t = tri_of(&box, i);

		solid_add(mesh, t.p[0], t.p[inverted ? 2 : 1], t.p[inverted ? 1 : 2]);
	}
	mesh_release(&box);
}

/*
 * A body in a cavity is in no material, however large the solid around the cavity is: only the wall that it enters
 * counts.
 */
START_TEST(in_a_cavity)
{
	static const struct {
		double most, depth;
	} cases[] = {{150, 0}, {220, 0}, {270, 70}};

	for (int i = 0; i < COUNT(cases); i++) {
		struct mesh housing = {0};
		struct model model;

		model_init(&model);
		add_shell(&housing, 400, false);
		add_shell(&housing, 250, true);
		model_mesh(&model, model_body(&model, ROLE_MACHINE, LINK_BASE), &housing);
		model_box(&model, ROLE_MACHINE, LINK_X, (vec3){-50, -50, -50}, (vec3){50, 50, 50});
		model.machine.axes[LINK_X - 1].limit_min = 0;
		model.machine.axes[LINK_X - 1].limit_max = cases[i].most;
		excuse(&model, PAIR_ADJACENT);
		expect(&model, cases[i].depth, cases[i].most);
		model_release(&model);
	}
}
END_TEST

/* All doubts of a model come in the same order with two threads: neighbours, a gap, a travel, a distant spindle. */
START_TEST(threads_change_nothing)
{
	struct doubts doubts[2] = {{0}, {0}};

	for (int k = 0; k < 2; k++) {
		struct model model;

		start(&model, 230);
		model_box(&model, ROLE_MACHINE, LINK_Z, (vec3){-50, -50, 400}, (vec3){50, 50, 500});
		model_box(&model, ROLE_MACHINE, LINK_C, (vec3){-50, -50, -400}, (vec3){50, 50, -300});
		excuse(&model, PAIR_ADJACENT);
		model_check(model.scene, 1 + k);
		doubts_add_all(&doubts[k], &model.scene->doubts);
		model_release(&model);
	}
	ck_assert_ptr_nonnull(model_doubt(&doubts[0], DOUBT_NEIGHBOURS_MEET));
	ck_assert_uint_gt(doubts[0].count, 3);
	ck_assert_uint_eq(doubts[0].count, doubts[1].count);
	for (size_t i = 0; i < doubts[0].count; i++) {
		ck_assert_int_eq(doubts[0].items[i].kind, doubts[1].items[i].kind);
		ck_assert_int_eq(doubts[0].items[i].axis, doubts[1].items[i].axis);
		ck_assert(same_double(doubts[0].items[i].value, doubts[1].items[i].value));
	}
	doubts_release(&doubts[0]);
	doubts_release(&doubts[1]);
}
END_TEST

int main(void)
{
	const TTest *const tests[] = {linear, not_judged, as_deep_at_home, endless_rotary, in_a_cavity,
				      threads_change_nothing};

	return RUN_TESTS("neighbour_check", tests);
}
