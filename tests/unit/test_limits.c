/* test_limits.c - where moves leave the travel of the axes: against closed forms and dense samples. */

#include "motion_record.h"
#include "suite.h"

START_TEST(straight_moves_past_a_limit)
{
	struct machine machine = rig_three_axes();
	struct record record;

	rig_find(&machine, SLOT_X)->limit_max = 250;
	rig_find(&machine, SLOT_Z)->limit_min = -100;
	start(&record, &machine);
	go(&record, move_to(CANON_FEED, (axis_values){{250 + 0.9e-6, 0, -100}}));
	ck_assert_int_eq(record.limit_count, 0);
	ck_assert(!record.steps[0].outside);
	go(&record, move_to(CANON_FEED, (axis_values){{0, 0, 0}}));
	/* X passes its limit at 5/6 of the move, Z at 1/2: the reports are in the order of time. */
	record.clock = record.converter.time = 100;
	go(&record, move_to(CANON_FEED, (axis_values){{300, 0, -200}}));
	ck_assert_int_eq(record.limit_count, 2);
	ck_assert_int_eq(record.steps_before_limit, 2);
	ck_assert_int_eq(record.limits[0].travel.slot, SLOT_Z);
	ck_assert_double_eq(record.limits[0].travel.bound, -100);
	ck_assert(record.limits[0].travel.length_acts && !record.limits[1].travel.length_acts);
	ck_assert_double_eq_tol(record.limits[0].position.v[SLOT_Z], -100, 1e-6);
	ck_assert_double_eq_tol(record.limits[0].position.v[SLOT_X], 150, 1e-6);
	ck_assert_int_eq(record.limits[1].travel.slot, SLOT_X);
	ck_assert_double_eq_tol(record.limits[1].position.v[SLOT_X], 250, 1e-6);
	ck_assert_double_eq_tol(record.limits[1].time, 100 + 5 / 6.0 * record.steps[2].seconds, 1e-6);
	ck_assert_int_eq((int)record.limits[1].line, 12);
	ck_assert(record.steps[2].outside);
	/* The way back starts outside. */
	go(&record, move_to(CANON_FEED, (axis_values){{0, 0, 0}}));
	ck_assert_int_eq(record.limit_count, 4);
	ck_assert_int_eq(record.limits[2].travel.slot, SLOT_X);
	ck_assert_int_eq(record.limits[3].travel.slot, SLOT_Z);
	ck_assert_double_eq_tol(record.limits[3].time, record.steps[3].time, 1e-12);
	/* The next move stays inside. */
	go(&record, move_to(CANON_FEED, (axis_values){{1, 0, 0}}));
	ck_assert_int_eq(record.limit_count, 4);
	ck_assert(!record.steps[4].outside);
}
END_TEST

/* An arc with both ends inside bulges out: x = 100 sin(a) passes 99 at a = asin(0.99) of the half circle. */
START_TEST(an_arc_bulges_past_a_limit)
{
	struct machine machine = rig_three_axes();
	struct record record;
	struct canon_move move = move_to(CANON_ARC, (axis_values){{0, 200, 0}});

	move.arc = (struct canon_arc){{0, 100, 0}, {0, 0, 1}, PI};
	rig_find(&machine, SLOT_X)->limit_max = 99;
	start(&record, &machine);
	go(&record, move);
	ck_assert_int_eq(record.limit_count, 1);
	ck_assert_double_eq_tol(record.limits[0].position.v[SLOT_X], 99, 3e-6);
	ck_assert_double_eq_tol(record.limits[0].time, asin(0.99) / PI * record.travelled, 1e-6);
	ck_assert(record.steps[0].outside);
	/* A touch: half a micrometre, within the tolerance, is inside; twice as much is outside. */
	for (int i = 0; i < 2; i++) {
		rig_find(&machine, SLOT_X)->limit_max = 100 - (i ? 2e-6 : 0.5e-6);
		start(&record, &machine);
		go(&record, move);
		ck_assert_int_eq(record.limit_count, i);
	}
	ck_assert_double_eq_tol(record.limits[0].position.v[SLOT_X], 100, 3e-6);
}
END_TEST

/* C turns by 180 degrees with the tip at radius 100: Y goes to 100 and back, and is 0 at both ends. */
START_TEST(a_guided_move_bulges_past_a_limit)
{
	struct machine machine = rig_trunnion();
	struct record record;
	struct canon_move move = move_to(CANON_FEED, (axis_values){{100, 0, 0, 0, 0, -PI}});

	rig_find(&machine, SLOT_Y)->limit_max = 50;
	rig_find(&machine, SLOT_Y)->limit_min = -50;
	start(&record, &machine);
	go(&record, move_to(CANON_RAPID, (axis_values){{100, 0, 0}}));
	guide(&record, 50);
	move.tcp = true;
	record.travelled = 0;
	go(&record, move);
	ck_assert_int_eq(record.limit_count, 1);
	ck_assert_int_eq(record.limits[0].travel.slot, SLOT_Y);
	ck_assert_double_eq(record.limits[0].travel.bound, 50);
	/* 100 sin(angle) = 50 at 30 of 180 degrees. */
	ck_assert_double_eq_tol(record.limits[0].block_time - 0.2, record.travelled / 6, 1e-6);
	ck_assert_double_eq_tol(record.limits[0].position.v[SLOT_Y], 50, 3e-6);
	ck_assert_double_eq_tol(record.limits[0].position.v[SLOT_C], radians(-30), 1e-7);
}
END_TEST

START_TEST(a_dogleg_reports_an_axis_once)
{
	struct machine machine = rig_three_axes();
	struct record record;

	machine.controller.rapid = RAPID_DOGLEG;
	rig_find(&machine, SLOT_X)->limit_max = 10;
	rig_find(&machine, SLOT_Y)->limit_max = 150;
	start(&record, &machine);
	go(&record, move_to(CANON_RAPID, (axis_values){{300, 200, 50}}));
	ck_assert_int_eq(record.limit_count, 2);
	ck_assert_int_eq(record.limits[0].travel.slot, SLOT_X);
	ck_assert_double_eq_tol(record.limits[0].time, 10 / 500.0, 1e-9);
	ck_assert_int_eq(record.limits[1].travel.slot, SLOT_Y);
	ck_assert_double_eq_tol(record.limits[1].time, 150 / 500.0, 1e-9);
	/* Commanded were the ends of the whole rapid. */
	ck_assert_double_eq(record.limits[0].travel.target, 300);
	ck_assert_double_eq(record.limits[1].travel.target, 200);
	ck_assert_int_eq(record.step_count, 3);
	ck_assert(record.steps[0].outside && record.steps[2].outside);
}
END_TEST

/* Against dense samples: the bisection finds that an axis leaves its travel exactly where the samples do. */
START_TEST(limits_agree_with_samples)
{
	uint64_t random = 12;
	int crossed = 0;

	for (int i = 0; i < 1500; i++) {
		struct machine machine = rig_random_machine(&random, (enum rig_family)(i % RIG_FAMILIES));
		struct canon_move move = move_to(CANON_FEED, (axis_values){{0}});
		int slot = rig_pick(&random, 3);
		double bound = rig_random(&random, 0, 400), first = 2;
		struct record record;
		struct path path;

		start(&record, &machine);
		guide(&record, 100);
		move.tcp = true;
		for (size_t k = 0; k < machine.axis_count; k++) {
			double size = machine.axes[k].rotary ? 3 : 100;

			move.end.v[machine.axes[k].slot] = rig_random(&random, -size, size);
		}
		path = (struct path){.kind = PATH_TCP, .start = record.converter.controller, .end = move.end,
				     .tcp = &record.converter.tcp};
		for (int k = 0; k <= 2000 && first > 1; k++)
			if (path_position(&path, k / 2000.0).v[slot] > bound)
				first = k / 2000.0;
		rig_find(&machine, slot)->limit_max = bound;
		go(&record, move);
		if (first <= 1) {
			ck_assert_int_eq(record.limit_count, 1);
			ck_assert_double_le(record.limits[0].time, first * record.travelled + 1e-9);
			ck_assert_double_ge(record.limits[0].time, (first - 1 / 2000.0) * record.travelled - 1e-9);
			ck_assert_double_eq_tol(record.limits[0].position.v[slot], bound, 3e-6);
			crossed++;
		} else if (record.limit_count) {
			/* The axis is outside only between two samples. */
			ck_assert_double_eq_tol(record.limits[0].position.v[slot], bound, 3e-6);
		}
	}
	ck_assert_int_gt(crossed, 200);
}
END_TEST

/* A move of which only a set of paths is known may leave the travel; the report gives what is known. */
START_TEST(the_whole_set_is_held_to_the_limits)
{
	struct machine machine = rig_three_axes();
	struct canon_move move = move_to(CANON_FEED, (axis_values){{199, 10, 0}});
	struct record record;

	rig_find(&machine, SLOT_X)->limit_max = 200;
	rig_find(&machine, SLOT_Y)->limit_min = -2;
	start(&record, &machine);
	move.spread[0] = 1;
	go(&record, move);
	ck_assert_int_eq(record.limit_count, 0);
	ck_assert(!record.steps[0].outside);
	/* X: 199 + 1.5 is 0.5 too far, from 198.5 on. Y starts at 0 and may be 3 beside it: below -2 from the start. */
	start(&record, &machine);
	move.spread[0] = 1.5;
	move.spread[1] = 3;
	go(&record, move);
	ck_assert_int_eq(record.limit_count, 2);
	ck_assert_int_eq(record.limits[0].travel.slot, SLOT_Y);
	ck_assert_double_eq_tol(record.limits[0].travel.excess, 1, 1e-9);
	ck_assert_double_eq(record.limits[0].travel.bound, -2);
	ck_assert_double_eq(record.limits[0].time, 0);
	ck_assert_int_eq(record.limits[1].travel.slot, SLOT_X);
	ck_assert_double_eq(record.limits[1].travel.bound, 200);
	ck_assert_double_eq_tol(record.limits[1].travel.excess, 0.5, 1e-9);
	ck_assert_double_eq(record.limits[1].travel.path_tolerance, 1.5);
	ck_assert_double_eq_tol(record.limits[1].position.v[SLOT_X], 198.5, 1e-6);
	ck_assert_double_eq_tol(record.limits[1].time, 198.5 / 199 * record.travelled, 1e-6);
	ck_assert(record.steps[0].outside);
	/* The programmed path itself passes the limit: the report is about the path, without the spread. */
	start(&record, &machine);
	move.end.v[SLOT_X] = 210;
	move.spread[1] = 0;
	go(&record, move);
	ck_assert_int_eq(record.limit_count, 1);
	ck_assert_double_eq(record.limits[0].travel.path_tolerance, 0);
	ck_assert_double_eq_tol(record.limits[0].travel.excess, 10, 1e-9);
	ck_assert_double_eq_tol(record.limits[0].position.v[SLOT_X], 200, 1e-6);
}
END_TEST

/* Between places that other moves cover, an axis is not farther out than these places; an arc still bulges. */
START_TEST(spread_between_covered_places)
{
	struct machine machine = rig_three_axes();
	struct canon_move move = move_to(CANON_RAPID, (axis_values){{199, 0, 0}});
	struct record record;

	rig_find(&machine, SLOT_X)->limit_max = 200;
	start(&record, &machine);
	move.spread[0] = 5;
	move.between[0] = true;
	go(&record, move);
	ck_assert_int_eq(record.limit_count, 0);
	ck_assert_double_eq(record.steps[0].tolerance.v[SLOT_X], 5);
	move = move_to(CANON_ARC, (axis_values){{199, 20, 0}});
	move.arc = (struct canon_arc){{199, 10, 0}, {0, 0, 1}, -PI};
	move.spread[0] = 5;
	move.between[0] = true;
	go(&record, move);
	ck_assert_int_eq(record.limit_count, 1);
	ck_assert_double_eq_tol(record.limits[0].travel.excess, 4, 1e-9);
}
END_TEST

/* Under TCP the places turn with the table, so the spread counts at its ends, too. */
START_TEST(spread_between_covered_places_under_tcp)
{
	struct machine machine = rig_trunnion();
	struct canon_move move = move_to(CANON_FEED, (axis_values){{199, 0, 0}});
	struct record record;

	rig_find(&machine, SLOT_X)->limit_max = 200;
	start(&record, &machine);
	guide(&record, 50);
	move.tcp = true;
	move.spread[0] = 5;
	move.between[0] = true;
	go(&record, move);
	ck_assert_int_eq(record.limit_count, 1);
	ck_assert_double_eq_tol(record.limits[0].travel.excess, 4, 1e-9);
	ck_assert(record.limits[0].travel.length_acts);
}
END_TEST

START_TEST(a_rotary_axis_may_turn_past_a_limit)
{
	struct machine machine = rig_trunnion();
	struct canon_move move = move_to(CANON_FEED, (axis_values){{0, 0, 0, 0, 0, 0.05}});
	struct record record;

	rig_find(&machine, SLOT_C)->limit_max = 0.1;
	start(&record, &machine);
	move.turn_spread[2] = 0.125;
	go(&record, move);
	ck_assert_int_eq(record.limit_count, 1);
	ck_assert_int_eq(record.limits[0].travel.slot, SLOT_C);
	ck_assert_double_eq_tol(record.limits[0].travel.excess, 0.075, 1e-9);
	ck_assert_double_eq(record.limits[0].travel.path_tolerance, 0.125);
	ck_assert(!record.limits[0].travel.length_acts);
}
END_TEST

/* If C is off by 0.01 with the tip held at radius 100, Y is off by 100 sin(0.01), X by 100 (1 - cos(0.01)) or more. */
START_TEST(linear_axes_follow_a_rotary_one)
{
	struct machine machine = rig_trunnion();
	struct canon_move move = move_to(CANON_FEED, (axis_values){{100, 1, -400}});
	struct record record;

	rig_find(&machine, SLOT_Y)->limit_max = 1.5;
	start(&record, &machine);
	go(&record, move_to(CANON_RAPID, (axis_values){{100, 0, -400}}));
	guide(&record, 50);
	move.tcp = true;
	record.step_count = 0;
	go(&record, move);
	ck_assert_int_eq(record.limit_count, 0);
	move.end.v[SLOT_Y] = 0.99;
	move.turn_spread[2] = 0.01;
	record.step_count = 0;
	go(&record, move);
	ck_assert_double_ge(record.steps[0].tolerance.v[SLOT_Y], 100 * sin(0.01));
	ck_assert_double_le(record.steps[0].tolerance.v[SLOT_Y], 1.1);
	ck_assert_double_ge(record.steps[0].tolerance.v[SLOT_X], 100 * (1 - cos(0.01)));
	ck_assert_int_eq(record.limit_count, 1);
	ck_assert_int_eq(record.limits[0].travel.slot, SLOT_Y);
	ck_assert_double_eq(record.limits[0].travel.path_tolerance, record.steps[0].tolerance.v[SLOT_Y]);
}
END_TEST

/* A move without length makes a step that takes no time if the axes may be beside their positions. */
START_TEST(a_spread_at_one_place)
{
	struct machine machine = rig_three_axes();
	struct canon_move move = move_to(CANON_FEED, (axis_values){{0, 0, 0}});
	struct record record;

	rig_find(&machine, SLOT_Z)->limit_max = 0.5;
	start(&record, &machine);
	go(&record, move);
	ck_assert_int_eq(record.step_count, 0);
	move.spread[2] = 2;
	move.feed.linear = 0;
	go(&record, move);
	ck_assert_int_eq(record.step_count, 1);
	ck_assert_double_eq(record.steps[0].seconds, 0);
	ck_assert_double_eq(record.steps[0].tolerance.v[SLOT_Z], 2);
	ck_assert_int_eq(record.limit_count, 1);
	ck_assert_double_eq_tol(record.limits[0].travel.excess, 1.5, 1e-9);
	ck_assert_double_eq(record.limits[0].travel.target, 0);
}
END_TEST

/*
 * A rapid under TCP whose path is not known: C turns by 180 degrees with the tip at radius 100. If the tip stays on its
 * line, Y goes to 100; in the box of both ends Y is 0. X does not pass its ends in either case.
 */
START_TEST(a_rapid_under_tcp_may_swing_past_a_limit)
{
	struct machine machine = rig_trunnion();
	struct record record;
	struct canon_move move = move_to(CANON_RAPID, (axis_values){{100, 0, 0, 0, 0, -PI}});

	machine.controller.rapid = RAPID_ANY;
	rig_find(&machine, SLOT_X)->limit_max = 100;
	rig_find(&machine, SLOT_X)->limit_min = -100;
	rig_find(&machine, SLOT_Y)->limit_max = 70;
	start(&record, &machine);
	go(&record, move_to(CANON_RAPID, (axis_values){{100, 0, 0}}));
	guide(&record, 50);
	move.tcp = true;
	go(&record, move);
	ck_assert_int_eq(record.limit_count, 1);
	ck_assert_int_eq(record.limits[0].travel.slot, SLOT_Y);
	ck_assert_double_eq_tol(record.limits[0].travel.excess, 30, 1e-3);
	ck_assert_double_eq_tol(record.limits[0].travel.path_tolerance, 100, 0.1);
	ck_assert_double_eq_tol(record.limits[0].position.v[SLOT_Y], 70, 1e-5);
	ck_assert(record.limits[0].travel.length_acts);
	ck_assert(record.steps[record.step_count - 1].outside);
	/* X passes its limit at the end of the move: one report, about the end. */
	rig_find(&machine, SLOT_X)->limit_min = -90;
	start(&record, &machine);
	go(&record, move_to(CANON_RAPID, (axis_values){{100, 0, 0}}));
	guide(&record, 50);
	go(&record, move);
	ck_assert_int_eq(record.limit_count, 2);
	ck_assert_int_eq(record.limits[0].travel.slot, SLOT_X);
	ck_assert_double_eq(record.limits[0].travel.path_tolerance, 0);
	ck_assert_int_eq(record.limits[1].travel.slot, SLOT_Y);
}
END_TEST

/* A control that rounds a corner stays on its inner side, so the path tolerance takes no axis past its limit. */
START_TEST(path_tolerance_is_not_held_to_the_limits)
{
	struct machine machine = rig_three_axes();
	struct canon_move move = move_to(CANON_FEED, (axis_values){{200, 0, 0}});
	struct record record;

	machine.controller.path_tolerance = 0.05;
	rig_find(&machine, SLOT_X)->limit_max = 200;
	start(&record, &machine);
	move.blend = true;
	go(&record, move);
	go(&record, move_to(CANON_FEED, (axis_values){{0, 0, 0}}));
	ck_assert_int_eq(record.limit_count, 0);
	ck_assert_double_eq(record.steps[0].tolerance.v[SLOT_X], 0.05);
}
END_TEST

int main(void)
{
	TCase *tests = tcase_create("limits");

	tcase_add_test(tests, straight_moves_past_a_limit);
	tcase_add_test(tests, an_arc_bulges_past_a_limit);
	tcase_add_test(tests, a_guided_move_bulges_past_a_limit);
	tcase_add_test(tests, a_dogleg_reports_an_axis_once);
	tcase_add_test(tests, limits_agree_with_samples);
	tcase_add_test(tests, the_whole_set_is_held_to_the_limits);
	tcase_add_test(tests, spread_between_covered_places);
	tcase_add_test(tests, spread_between_covered_places_under_tcp);
	tcase_add_test(tests, a_rotary_axis_may_turn_past_a_limit);
	tcase_add_test(tests, linear_axes_follow_a_rotary_one);
	tcase_add_test(tests, a_spread_at_one_place);
	tcase_add_test(tests, a_rapid_under_tcp_may_swing_past_a_limit);
	tcase_add_test(tests, path_tolerance_is_not_held_to_the_limits);
	return run_suite("limits", tests);
}
