/* test_cutter_approach.c - how near cutters come at feed, in closed forms, and against dense looks along the way. */
#include "check/cutter_approach.h"

#include "model_case.h"
#include "step_program.h"
#include "suite.h"

/* A cutter of radius 10, from 60 to 100 mm below the gauge line. */
static const struct tool_section section = {40, 20, 20};
static const struct tool_solid cutter = {.sections = &section, .count = 1, .top = -60};

/* Its tip is at 0 0 200 when all axes are at 0; the part is 80 x 60 x 20 on the workholding. */
static void start(struct model *model)
{
	model_init(model);
	model_tool(model, 1, 100);
	model_piece(model, ROLE_CUTTER, 1, &cutter);
	model_box(model, ROLE_PART, LINK_C, (vec3){-40, -30, 0}, (vec3){40, 30, 20});
}

static axis_values at(double x, double y, double z, double c)
{
	axis_values q = {{0}};

	q.v[SLOT_X] = x;
	q.v[SLOT_Y] = y;
	q.v[SLOT_Z] = z;
	q.v[SLOT_C] = c;
	return q;
}

static void look(struct cutter_approach *approach, int tool, enum step_class class, long line, axis_values q0,
		 axis_values q1)
{
	const struct path path = path_between(&q0, &q1, PATH_STRAIGHT);
	struct motion_step step = step_on(&path);

	step.tool = tool;
	step.step_class = class;
	step.line = line;
	step.file = line < 1000 ? "p.nc" : "sub.nc";
	cutter_approach_step(approach, &step);
}

/* One step of tool 1 at feed. */
static struct far_cutters after_step(struct model *model, axis_values q0, axis_values q1)
{
	struct cutter_approach approach;
	struct far_cutters result;

	cutter_approach_init(&approach, model->scene, "p.nc");
	look(&approach, 1, STEP_FEED_TURNING, 7, q0, q1);
	result = cutter_approach_result(&approach);
	cutter_approach_release(&approach);
	return result;
}

static void expect(struct far_cutters found, double distance)
{
	ck_assert_int_eq(found.fed, 1);
	ck_assert_int_eq(found.far, distance > 0);
	if (found.far) {
		require(found.distance >= distance - 1e-9 && found.distance <= 1.12 * distance, "%.12g mm, not %.12g",
			found.distance, distance);
		ck_assert_int_eq(found.tool, 1);
		ck_assert_int_eq(found.line, 7);
		ck_assert(!found.in_subprogram);
	}
}

START_TEST(both_sides_of_near)
{
	struct model model;

	start(&model);
	/* The tip is 37 mm above the part; the part is 20 mm high. Near is the cutter's radius: 10 mm. */
	expect(after_step(&model, at(0, 0, 0, 0), at(0, 0, -143, 0)), 37);
	expect(after_step(&model, at(0, 0, 0, 0), at(0, 0, -169, 0)), 11);
	expect(after_step(&model, at(0, 0, 0, 0), at(0, 0, -169.8, 0)), 10.2);
	expect(after_step(&model, at(0, 0, 0, 0), at(0, 0, -170.2, 0)), 0);
	/* Beside it, at its height: the part turned by C reaches 50 mm far. Y moves the part the other way. */
	expect(after_step(&model, at(80, 0, -190, 0), at(70, 0, -190, 0)), 20);
	expect(after_step(&model, at(0, 80, -190, 0), at(0, 60, -190, 0)), 20);
	expect(after_step(&model, at(70, 0, -190, PI / 2), at(66, 0, -190, PI / 2)), 26);
	/* In the part, and through it. */
	expect(after_step(&model, at(0, 0, -195, 0), at(0, 0, -195, 0)), 0);
	expect(after_step(&model, at(-200, 0, -190, 0), at(200, 0, -190, 0)), 0);
	expect(after_step(&model, at(-200, 0, -171, 0), at(200, 0, -169, 0)), 0);
	/* The corner of the part passes the cutter, or the cutter passes the corner. */
	expect(after_step(&model, at(72, 0, -190, 0), at(72, 0, -190, 40)), 12);
	expect(after_step(&model, at(69, 0, -190, 0), at(69, 0, -190, 40)), 0);
	expect(after_step(&model, at(-200, 75, -190, 0), at(200, 75, -190, 0)), 35);
	model_release(&model);
}
END_TEST

START_TEST(small_cutters_and_stock)
{
	const struct tool_section thin = {40, 2, 2};
	const struct tool_solid drill = {.sections = &thin, .count = 1, .top = -60};
	struct model model;

	start(&model);
	model.bodies[0].profile = &drill;
	expect(after_step(&model, at(0, 0, 0, 0), at(0, 0, -174.8, 0)), 5.2);
	expect(after_step(&model, at(0, 0, 0, 0), at(0, 0, -175.2, 0)), 0);
	/* The blank is 3 mm higher than the part. */
	model_box(&model, ROLE_STOCK, LINK_C, (vec3){-45, -35, 0}, (vec3){45, 35, 23});
	expect(after_step(&model, at(0, 0, 0, 0), at(0, 0, -175.2, 0)), 1.8);
	expect(after_step(&model, at(0, 0, 0, 0), at(0, 0, -176.2, 0)), 0);
	model_release(&model);
}
END_TEST

START_TEST(tool_by_tool)
{
	struct cutter_approach approach;
	struct far_cutters found;
	struct model model;

	start(&model);
	for (int number = 2; number <= 4; number++) {
		model_tool(&model, number, 100);
		model_piece(&model, ROLE_CUTTER, number, &cutter);
	}
	cutter_approach_init(&approach, model.scene, "p.nc");
	ck_assert_int_eq(cutter_approach_result(&approach).fed, 0);
	look(&approach, 1, STEP_FEED_TURNING, 5, at(0, 0, 0, 0), at(0, 0, -190, 0));
	look(&approach, 2, STEP_FEED_TURNING, 6, at(0, 0, 0, 0), at(0, 0, -100, 0));
	look(&approach, 3, STEP_FEED_TURNING, 7, at(0, 0, 0, 0), at(0, 0, -140, 0));
	look(&approach, 2, STEP_FEED_TURNING, 1008, at(0, 0, 0, 0), at(0, 0, -150, 0));
	/* Neither rapids nor standing spindles nor unknown tools count. */
	look(&approach, 3, STEP_RAPID, 9, at(0, 0, 0, 0), at(0, 0, -190, 0));
	look(&approach, 3, STEP_FEED_STANDING, 9, at(0, 0, 0, 0), at(0, 0, -190, 0));
	look(&approach, 3, STEP_FEED_REVERSED, 9, at(0, 0, 0, 0), at(0, 0, -190, 0));
	look(&approach, 9, STEP_FEED_TURNING, 9, at(0, 0, 0, 0), at(0, 0, -190, 0));
	look(&approach, 0, STEP_FEED_TURNING, 9, at(0, 0, 0, 0), at(0, 0, -190, 0));
	look(&approach, 4, STEP_RAPID, 9, at(0, 0, 0, 0), at(0, 0, -10, 0));
	look(&approach, 1, STEP_FEED_TURNING, 10, at(0, 0, 0, 0), at(0, 0, -10, 0));
	found = cutter_approach_result(&approach);
	ck_assert_int_eq(found.fed, 3);
	ck_assert_int_eq(found.far, 2);
	ck_assert_int_eq(found.tool, 2);
	ck_assert_int_eq(found.line, 1008);
	ck_assert(found.in_subprogram);
	ck_assert_int_eq(found.body, 1);
	ck_assert_double_eq_tol(found.distance, 30, 0.3);
	cutter_approach_release(&approach);
	model_release(&model);
}
END_TEST

/* If this part of the model is missing or marked, no statement is made about a cutter that is 180 mm away. */
START_TEST(nothing_to_say)
{
	struct model model;

	start(&model);
	for (int i = 0; i < 8; i++) {
		struct model changed = model;

		changed.scene->machine = &changed.machine;
		changed.scene->setup = i == 0 ? NULL : &changed.setup;
		changed.setup.tools = changed.tools;
		changed.machine.spindle.present = i != 1;
		changed.machine.workholding.present = i != 2;
		changed.tools[0].kind = i == 3 ? TOOL_STANDS : i == 4 ? TOOL_PROBES : TOOL_TURNS;
		changed.tools[0].checked = i == 5 ? "r" : NULL;
		model.bodies[1].checked = i == 6 ? "r" : NULL;
		model.bodies[1].role = i == 7 ? ROLE_FIXTURE : ROLE_PART;
		require(after_step(&changed, at(0, 0, 0, 0), at(1, 0, 0, 0)).fed == 0, "case %d", i);
	}
	model.scene->machine = &model.machine;
	model.scene->setup = &model.setup;
	model.bodies[1].role = ROLE_PART;
	expect(after_step(&model, at(0, 0, 0, 0), at(1, 0, 0, 0)), 180);
	/* Both a marked part and the part beside it count. */
	model.bodies[1].checked = "r";
	model_box(&model, ROLE_PART, LINK_C, (vec3){400, 0, 0}, (vec3){410, 10, 10});
	expect(after_step(&model, at(0, 0, 0, 0), at(1, 0, 0, 0)), 180);
	model_release(&model);
}
END_TEST

/* mm: the least distance at many places of the way. */
static double dense(const axis_values *q0, const axis_values *q1)
{
	const struct solid_box part = {{0, 0, 10}, {40, 30, 10}};
	double least = INFINITY;

	for (int i = 0; i <= 2000; i++) {
		axis_values q;
		xform back;
		struct cylinder cylinder = {{0, 0, 240}, {0, 0, -1}, 40, 10};

		for (int k = 0; k < SLOT_COUNT; k++)
			q.v[k] = q0->v[k] + i / 2000.0 * (q1->v[k] - q0->v[k]);
		/* The tool moves by X, Y and Z relative to the work, then turns back about C. */
		cylinder.base = vec3_add(cylinder.base, (vec3){q.v[SLOT_X], q.v[SLOT_Y], q.v[SLOT_Z]});
		back = xform_turn((vec3){0, 0, 0}, (vec3){0, 0, 1}, q.v[SLOT_C]);
		cylinder.base = xform_apply(&back, cylinder.base);
		least = fmin(least, cylinder_box_distance(&cylinder, &part, 0));
	}
	return least;
}

START_TEST(random_steps)
{
	const long cases = random_cases(300);
	long far = 0;

	for (long n = 0; n < cases; n++) {
		struct random random = random_case(1, n);
		const double y = random_in(&random, -150, 150), z = random_in(&random, -200, -100);
		const axis_values q0 = at(random_in(&random, -150, 150), y, z, random_in(&random, -4, 4));
		const double u = random_in(&random, -150, 150), v = random_in(&random, -150, 150);
		const axis_values q1 = at(u, v, random_in(&random, -200, -100), random_in(&random, -4, 4));
		const xform by = random_place(&random, 1000);
		struct far_cutters found, moved;
		struct model model;
		double truth;

		start(&model);
		truth = dense(&q0, &q1);
		found = after_step(&model, q0, q1);
		model_move(&model, &by);
		moved = after_step(&model, q0, q1);
		model_release(&model);
		/* Near 10 mm both answers are correct, because the measurement has an error of a tenth. */
		if (truth > 9 && truth < 11)
			continue;
		require(found.far == (truth > 10) && moved.far == found.far, "case %ld: %g mm", n, truth);
		far += found.far;
		require(!found.far || (found.distance > 0.98 * truth && found.distance < 1.2 * truth),
			"case %ld: %g mm, not %g", n, found.distance, truth);
		require(!found.far || fabs(moved.distance - found.distance) < 1e-3 + 0.1 * found.distance,
			"case %ld: moved %g mm, not %g", n, moved.distance, found.distance);
	}
	require(far > cases / 10 && far < cases, "%ld far", far);
}
END_TEST

/* An axis that turns a million times in one step takes no time. */
START_TEST(ends)
{
	struct model model;

	start(&model);
	expect(after_step(&model, at(70, 0, -140, 0), at(70, 0, -140, 1e7)), sqrt(40 * 40 + 10 * 10));
	model_release(&model);
}
END_TEST

int main(void)
{
	const TTest *const tests[] = {both_sides_of_near, small_cutters_and_stock, tool_by_tool,
				      nothing_to_say, random_steps, ends};

	return RUN_TESTS("cutter_approach", tests);
}
