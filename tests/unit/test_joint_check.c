/*
 * test_joint_check.c - gaps between the bodies of a joint, against closed forms, for every position and rotation of the
 * machine.
 */
#include "scene/joint_check.h"

#include "model_case.h"
#include "suite.h"

/* A bed, and a slide of X `gap` mm above it. The other links have no bodies. */
static void start(struct model *model, double gap)
{
	model_init(model);
	model_box(model, ROLE_MACHINE, LINK_BASE, (vec3){-300, -200, 0}, (vec3){300, 200, 100});
	model_box(model, ROLE_MACHINE, LINK_X, (vec3){-50, -50, 100 + gap}, (vec3){50, 50, 200 + gap});
}

/* Expects this distance in the doubt, which is a lower bound and may be a tenth too small. 0: no doubt. */
static void expect(struct model *model, enum doubt_kind kind, int body, int against, double distance)
{
	struct doubts doubts = {0};
	const struct doubt *doubt;

	joint_check(model->scene, &doubts);
	doubt = model_doubt(&doubts, kind);
	ck_assert_uint_eq(doubts.count, distance > 0);
	if (doubt) {
		ck_assert_int_eq(doubt->body, body);
		ck_assert_int_eq(doubt->against, against);
		require(doubt->value <= distance + 1e-3 && doubt->value >= 0.899 * distance, "%g mm, not %g",
			doubt->value, distance);
	}
	doubts_release(&doubts);
}

START_TEST(both_sides_of_a_gap)
{
	static const double gaps[] = {0, 30, 49.9, 56, 300};
	struct random random = random_case(1, 0);

	for (int i = 0; i < COUNT(gaps); i++) {
		for (int k = 0; k < 10; k++) {
			const xform by = random_place(&random, 2000);
			struct model model;

			start(&model, gaps[i]);
			if (k)
				model_move(&model, &by);
			expect(&model, DOUBT_GAP, 1, 0, gaps[i] > 50 ? gaps[i] : 0);
			model.machine.axes[0].checked = "a long ball screw";
			expect(&model, DOUBT_GAP, 1, 0, 0);
			model_release(&model);
		}
	}
}
END_TEST

/* The bodies are examined with the axes at home, not at 0. */
START_TEST(at_home)
{
	struct model model;

	start(&model, 10);
	model.machine.axes[0].home = 450;
	expect(&model, DOUBT_GAP, 1, 0, sqrt(100 * 100 + 10 * 10));
	model_release(&model);
}
END_TEST

/*
 * The nearest of all bodies that carry the link counts, also over other axes; bodies of a setup and of other branches
 * do not.
 */
START_TEST(what_carries)
{
	struct model model;
	int head;

	start(&model, 10);
	head = model_box(&model, ROLE_MACHINE, LINK_Z, (vec3){-20, -20, 400}, (vec3){20, 20, 500});
	/* The head is 190 mm above the slide. */
	expect(&model, DOUBT_GAP, head, 1, 190);
	/* A table and a part beside the head do not hold it. */
	model_box(&model, ROLE_MACHINE, LINK_Y, (vec3){-300, -200, 120}, (vec3){-200, 200, 390});
	model_box(&model, ROLE_FIXTURE, LINK_X, (vec3){-20, -20, 300}, (vec3){20, 20, 399});
	expect(&model, DOUBT_GAP, head, 1, 190);
	/* A column of the base holds it, although X is between them. */
	model_box(&model, ROLE_MACHINE, LINK_BASE, (vec3){100, -20, 390}, (vec3){140, 20, 500});
	expect(&model, DOUBT_GAP, head, 5, 80);
	model_box(&model, ROLE_MACHINE, LINK_BASE, (vec3){60, -20, 390}, (vec3){140, 20, 500});
	expect(&model, DOUBT_GAP, head, 0, 0);
	model_release(&model);
}
END_TEST

/* A link without a body is not judged. */
START_TEST(not_judged)
{
	struct model model;

	model_init(&model);
	model_box(&model, ROLE_MACHINE, LINK_Z, (vec3){-20, -20, 400}, (vec3){20, 20, 500});
	expect(&model, DOUBT_GAP, 0, 0, 0);
	model_release(&model);
}
END_TEST

static void excuse(struct model *model, int a, int b)
{
	model->scene->pairs = mem_realloc(model->scene->pairs, model->scene->pair_count + 1,
					  sizeof(*model->scene->pairs));
	model->scene->pairs[model->scene->pair_count++] = (struct scene_pair){.a = a, .b = b, .status = PAIR_ADJACENT};
}

/* Among the pairs that a wide adjacent_within excuses, the farthest pair that is no joint is named. */
START_TEST(excused_apart)
{
	static const double gaps[] = {19, 23, 45};

	for (int i = 0; i < COUNT(gaps); i++) {
		for (double within = 5; within < 100; within += 45) {
			struct model model;

			start(&model, gaps[i]);
			/* The slide has a second body, near the bed. */
			model_box(&model, ROLE_MACHINE, LINK_X, (vec3){-50, -50, 101}, (vec3){50, 50, 105});
			excuse(&model, 0, 2);
			excuse(&model, 0, 1);
			model.machine.adjacent_within = within;
			expect(&model, DOUBT_EXCUSED_APART, 0, 1, within > 20 && gaps[i] > 20 ? gaps[i] : 0);
			model_release(&model);
		}
	}
}
END_TEST

int main(void)
{
	const TTest *const tests[] = {both_sides_of_a_gap, at_home, what_carries, not_judged, excused_apart};

	return RUN_TESTS("joint_check", tests);
}
