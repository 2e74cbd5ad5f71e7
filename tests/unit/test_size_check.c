/* test_size_check.c - sizes of bodies and links that are just small enough for a doubt, or just too large. */
#include "scene/size_check.h"

#include "machine/kinematics_check.h"
#include "model_case.h"
#include "suite.h"

/* A bed, a slide of X, and a cube on Z with this side. The value is the number of the cube. */
static int start(struct model *model, double side)
{
	model_init(model);
	model_box(model, ROLE_MACHINE, LINK_BASE, (vec3){-300, -200, 0}, (vec3){300, 200, 100});
	model_box(model, ROLE_MACHINE, LINK_X, (vec3){-50, -50, 100}, (vec3){50, 50, 200});
	return model_box(model, ROLE_MACHINE, LINK_Z, (vec3){0, 0, 200}, (vec3){side, side, 200 + side});
}

static void expect(struct model *model, int body, double size)
{
	struct doubts doubts = {0};
	const struct doubt *doubt;

	size_check(model->scene, &doubts);
	doubt = model_doubt(&doubts, DOUBT_BODY_SMALL);
	ck_assert_uint_eq(doubts.count, body >= 0);
	if (doubt) {
		ck_assert_int_eq(doubt->body, body);
		ck_assert_double_eq_tol(doubt->value, size, 1e-3);
		ck_assert_double_eq(doubt->limit, kinematics_longest_travel(&model->machine));
	}
	doubts_release(&doubts);
}

/*
 * The bodies of a link together may be as small as a fortieth of the longest travel, one body beside others as small as
 * a thousandth.
 */
START_TEST(both_sides)
{
	static const double shares[] = {0.0009, 0.0011, 0.024, 0.026};
	struct model model;

	for (int i = 0; i < COUNT(shares); i++) {
		int cube = start(&model, 1);
		const double size = shares[i] * kinematics_longest_travel(&model.machine);

		model_release(&model);
		cube = start(&model, size);
		expect(&model, shares[i] < 0.025 ? cube : -1, size);
		model_box(&model, ROLE_MACHINE, LINK_Z, (vec3){0, 0, 210}, (vec3){100, 100, 300});
		expect(&model, shares[i] < 0.001 ? cube : -1, size);
		model_release(&model);
	}
}
END_TEST

/* If all bodies are too small for the travels, there is one doubt about all of them, and none about each. */
START_TEST(all_too_small)
{
	struct doubts doubts = {0};
	struct model model;

	model_init(&model);
	model_box(&model, ROLE_MACHINE, LINK_BASE, (vec3){0, 0, 0}, (vec3){0.3, 0.2, 0.1});
	model_box(&model, ROLE_MACHINE, LINK_X, (vec3){0, 0, 0.2}, (vec3){0.1, 0.1, 0.3});
	model_box(&model, ROLE_MACHINE, LINK_Z, (vec3){0, 0, 0.4}, (vec3){0.1, 0.1, 0.5});
	size_check(model.scene, &doubts);
	ck_assert_uint_eq(doubts.count, 1);
	ck_assert_int_eq(doubts.items[0].kind, DOUBT_BODIES_SMALL);
	doubts_release(&doubts);
	model_release(&model);
}
END_TEST

int main(void)
{
	const TTest *const tests[] = {both_sides, all_too_small};

	return RUN_TESTS("size_check", tests);
}
