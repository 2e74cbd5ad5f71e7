#include "check/course.h"

#include <check.h>
#include <stdlib.h>

#include "motion/span.h"

/* Three blocks of one step each to x, the second with C at `turn`; they are `blocks` many. */
static void travel(struct course *course, double x, double turn, int tool, long blocks)
{
	for (long i = 0; i < blocks; i++) {
		struct motion_step step = {.line = i + 1};

		step.span.q1.v[SLOT_X] = x + 10 * (double)i;
		step.span.q1.v[SLOT_C] = i == 1 ? turn : 0;
		course_step(course, &step);
		course_block(course, i + 1, tool, &step.span.q1);
	}
}

static bool is_same(struct course *course, double x, double turn, int tool, long blocks, double way)
{
	course_compare(course);
	travel(course, x, turn, tool, blocks);
	course_end(course);
	ck_assert(!course->lost);
	ck_assert_double_eq_tol(course->way, way, 1e-12);
	return course->same;
}

START_TEST(runs_are_compared)
{
	struct course course;
	uint64_t x, y;

	ck_assert(course_init(&course));
	course_record(&course);
	travel(&course, 5, 1, 2, 3);
	x = course.ways[SLOT_X];
	y = course.ways[SLOT_Y];
	ck_assert(is_same(&course, 5, 1, 2, 3, 0));
	ck_assert(course.ways[SLOT_X] == x && course.ways[SLOT_Y] == y);
	/* Farther along X: still the same course. */
	ck_assert(is_same(&course, 5.25, 1, 2, 3, 0.25));
	ck_assert(course.ways[SLOT_X] != x && course.ways[SLOT_Y] == y);
	/* Another turn, another tool, less, more. */
	ck_assert(!is_same(&course, 5, 1 + 1e-6, 2, 3, 0));
	ck_assert(!is_same(&course, 5, 1, 3, 3, 0));
	ck_assert(!is_same(&course, 5, 1, 2, 2, 0));
	ck_assert(!is_same(&course, 5, 1, 2, 4, 0));
	/* What was recorded is not changed by that. */
	ck_assert(is_same(&course, 4, 1, 2, 3, 1));
	course_release(&course);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("course");
	TCase *tcase = tcase_create("runs");
	SRunner *runner = srunner_create(suite);
	int failed;

	tcase_add_test(tcase, runs_are_compared);
	suite_add_tcase(suite, tcase);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
