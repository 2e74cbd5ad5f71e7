/* test_placement_check.c - bodies that are drawn twice, and rotations that are given in radians. */
#include "scene/placement_check.h"

#include "base/units.h"
#include "model_case.h"
#include "suite.h"

static size_t count(struct model *model, enum doubt_kind kind)
{
	struct doubts doubts = {0};
	size_t found = 0;

	placement_check(model->scene, &doubts);
	for (size_t i = 0; i < doubts.count; i++)
		found += doubts.items[i].kind == kind;
	doubts_release(&doubts);
	return found;
}

static int box(struct model *model, enum body_role role, int link, double size)
{
	return model_box(model, role, link, (vec3){-size, -50, 0}, (vec3){size, 50, 80});
}

/* One mesh that is twice in the same place is doubted on all links, unless a body is marked as checked. */
START_TEST(twice)
{
	static const enum body_role roles[] = {ROLE_MACHINE, ROLE_FIXTURE, ROLE_PART};

	for (int i = 0; i < COUNT(roles); i++) {
		struct model model;
		int body;

		model_init(&model);
		box(&model, ROLE_MACHINE, LINK_BASE, 60);
		box(&model, ROLE_MACHINE, LINK_X, 61);
		ck_assert_uint_eq(count(&model, DOUBT_TWICE), 0);
		body = box(&model, roles[i], LINK_C, 60);
		ck_assert_uint_eq(count(&model, DOUBT_TWICE), 1);
		model.bodies[body].checked = "two halves";
		ck_assert_uint_eq(count(&model, DOUBT_TWICE), 0);
		model_release(&model);
	}
}
END_TEST

/* A machine may have two bearings with the same mesh, and a blank may have the shape of the part. */
START_TEST(not_twice)
{
	struct model model;
	int body;

	model_init(&model);
	box(&model, ROLE_MACHINE, LINK_BASE, 60);
	body = box(&model, ROLE_MACHINE, LINK_BASE, 60);
	model.bodies[body].placement.translation.x = 0.01;
	box(&model, ROLE_STOCK, LINK_C, 60);
	ck_assert_uint_eq(count(&model, DOUBT_TWICE), 0);
	/* Turned by 180 degrees the mesh is in the same place, but its corners are not. */
	model.bodies[body].placement = xform_turn((vec3){0, 0, 0}, (vec3){0, 0, 1}, radians(180));
	ck_assert_uint_eq(count(&model, DOUBT_TWICE), 0);
	model.bodies[body].placement = xform_identity();
	ck_assert_uint_eq(count(&model, DOUBT_TWICE), 1);
	model_release(&model);
}
END_TEST

/* Quarters and eighths of a turn in radians, and angles that really are degrees. */
START_TEST(rotation)
{
	static const struct {
		double angle;
		bool doubted;
	} cases[] = {{1.5707963, true}, {1.571, true}, {1.57, true}, {-1.5708, true}, {0.7854, true}, {0.785, true},
		     {3.14159, true}, {3.14, true}, {2.356, true}, {4.712, true}, {6.2832, true}, {0, false}, {1, false},
		     {1.5, false}, {1.6, false}, {3, false}, {5, false}, {30, false}, {45, false}, {90, false},
		     {180, false}, {-90, false}, {359, false}};
	struct random random = random_case(1, 0);

	for (int i = 0; i < COUNT(cases); i++) {
		const xform turned = xform_turn((vec3){0, 0, 0}, random_unit(&random), radians(cases[i].angle));
		const xform held = random_place(&random, 500);
		struct model model;
		int body;

		model_init(&model);
		body = box(&model, ROLE_MACHINE, LINK_X, 60);
		model.bodies[body].placement.rotation = turned.rotation;
		ck_assert_uint_eq(count(&model, DOUBT_ROTATION), cases[i].doubted);
		model.bodies[body].checked = "measured";
		/* The part is rotated together with the workholding. */
		body = box(&model, ROLE_PART, LINK_C, 60);
		model.machine.workholding.frame = held;
		model.bodies[body].placement = xform_mul(&held, &turned);
		ck_assert_uint_eq(count(&model, DOUBT_ROTATION), cases[i].doubted);
		ck_assert_uint_eq(count(&model, DOUBT_WORKHOLDING_ROTATION), 0);
		model.machine.workholding.frame = turned;
		ck_assert_uint_eq(count(&model, DOUBT_WORKHOLDING_ROTATION), cases[i].doubted);
		model.machine.workholding.checked = "measured";
		ck_assert_uint_eq(count(&model, DOUBT_WORKHOLDING_ROTATION), 0);
		model_release(&model);
	}
}
END_TEST

int main(void)
{
	const TTest *const tests[] = {twice, not_twice, rotation};

	return RUN_TESTS("placement_check", tests);
}
