/*
 * test_stock_fit.c - parts that are not inside their blank, against closed forms, for every position and rotation of
 * both.
 */
#include "scene/stock_fit.h"

#include "model_case.h"
#include "suite.h"

/* A blank of 100 x 80 x 40 mm on the workholding. */
static int start(struct model *model)
{
	model_init(model);
	return model_box(model, ROLE_STOCK, LINK_C, (vec3){-50, -40, 0}, (vec3){50, 40, 40});
}

static int part(struct model *model, vec3 least, vec3 most)
{
	return model_box(model, ROLE_PART, LINK_C, least, most);
}

/* mm: how far the one doubted part is outside; 0: no part is doubted. */
static double out_of(struct model *model, int body)
{
	struct doubts doubts = {0};
	const struct doubt *doubt;
	double value = 0;

	stock_fit_check(model->scene, &doubts);
	doubt = model_doubt(&doubts, DOUBT_OUT_OF_STOCK);
	ck_assert_uint_eq(doubts.count, doubt != NULL);
	if (doubt) {
		ck_assert_int_eq(doubt->body, body);
		ck_assert_int_eq(doubt->against, 0);
		value = doubt->value;
	}
	doubts_release(&doubts);
	return value;
}

/* Expects this for a part whose top is `above` mm above that of the blank, and whose end is `beside` mm beside it. */
static void expect(double above, double beside, double distance)
{
	struct random random = random_case(1, (long)(100 * above + beside));

	for (int i = 0; i < 20; i++) {
		const xform by = random_place(&random, 1000);
		struct model model;
		int body;

		start(&model);
		body = part(&model, (vec3){-30, -30, 5}, (vec3){50 + beside, 30, 40 + above});
		if (i)
			model_move(&model, &by);
		require(fabs(out_of(&model, body) - distance) < 1e-3, "place %d: %g mm, not %g", i,
			out_of(&model, body), distance);
		model_release(&model);
	}
}

START_TEST(both_sides_of_a_millimetre)
{
	expect(-5, -5, 0);
	expect(0, 0, 0);
	expect(0.95, -1, 0);
	expect(1.05, -1, 1.05);
	expect(-1, 7, 7);
	expect(3, 4, 5);
}
END_TEST

START_TEST(what_is_known_of_the_blank)
{
	struct model model;
	int body;

	start(&model);
	body = part(&model, (vec3){-30, -30, 5}, (vec3){30, 30, 43});
	ck_assert_double_eq_tol(out_of(&model, body), 3, 1e-3);
	/* The true blank may be larger by this amount. */
	model.bodies[0].uncertainty = 1.5;
	ck_assert_double_eq_tol(out_of(&model, body), 1.5, 1e-3);
	model.bodies[0].uncertainty = 2.1;
	ck_assert(!(out_of(&model, body) > 0));
	model.bodies[0].uncertainty = 0;
	model.bodies[0].checked = "r";
	ck_assert(!(out_of(&model, body) > 0));
	model.bodies[0].checked = NULL;
	model.bodies[body].checked = "r";
	ck_assert(!(out_of(&model, body) > 0));
	model_release(&model);
}
END_TEST

/* The longest side of the part that is doubted as too small for its blank; 0: no part is doubted. */
static double too_small(struct model *model)
{
	struct doubts doubts = {0};
	const struct doubt *doubt;
	double value;

	stock_fit_check(model->scene, &doubts);
	doubt = model_doubt(&doubts, DOUBT_PART_BELOW_STOCK);
	value = doubt ? doubt->value : 0;
	ck_assert(!doubt || fabs(doubt->limit - 100) < 1e-3);
	doubts_release(&doubts);
	return value;
}

/* An eighth of the blank's 100 x 80 x 40 mm is 12.5 x 10 x 5 mm, in any order. */
START_TEST(an_eighth_of_the_blank)
{
	struct model model;
	int body;

	start(&model);
	body = part(&model, (vec3){0, 0, 0}, (vec3){4.9, 12.4, 9.9});
	ck_assert_double_eq_tol(too_small(&model), 12.4, 1e-3);
	model.bodies[body].checked = "r";
	ck_assert(!(too_small(&model) > 0));
	model.bodies[body].checked = NULL;
	part(&model, (vec3){20, 0, 0}, (vec3){24, 4, 4});
	ck_assert(!(too_small(&model) > 0));
	model_release(&model);
	for (int k = 0; k < 3; k++) {
		start(&model);
		part(&model, (vec3){0, 0, 0}, (vec3){k == 0 ? 12.6 : 12.4, k == 1 ? 10.1 : 9.9, k == 2 ? 5.1 : 4.9});
		ck_assert(!(too_small(&model) > 0));
		model_release(&model);
	}
}
END_TEST

/* If another part is in the blank, a part that is nowhere near it may have a blank of its own. */
START_TEST(several_parts)
{
	struct model model;
	int beside, inside;

	start(&model);
	beside = part(&model, (vec3){100, 0, 0}, (vec3){120, 20, 20});
	ck_assert_double_eq_tol(out_of(&model, beside), 70, 1e-3);
	inside = part(&model, (vec3){-30, -30, 5}, (vec3){30, 30, 35});
	ck_assert(!(out_of(&model, beside) > 0));
	model.bodies[inside].role = ROLE_FIXTURE;
	ck_assert_double_eq_tol(out_of(&model, beside), 70, 1e-3);
	/* Without a blank there is no doubt. */
	model.bodies[0].role = ROLE_FIXTURE;
	ck_assert(!(out_of(&model, beside) > 0));
	model_release(&model);
}
END_TEST

int main(void)
{
	const TTest *const tests[] = {both_sides_of_a_millimetre, what_is_known_of_the_blank, an_eighth_of_the_blank,
				      several_parts};

	return RUN_TESTS("stock_fit", tests);
}
