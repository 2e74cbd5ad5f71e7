/* test_canon_to_spans.c - the converter, fed by hand with canonical moves: times, breaks, tools, clocks, against hand computation. */

#include "motion_record.h"
#include "suite.h"

/* ----------------------------------------------------------------- timing */

START_TEST(feeds)
{
	struct machine machine = rig_trunnion();
	struct record record;
	struct canon_move move;

	rig_axis(&machine, SLOT_W, 3, rig_z, rig_origin);
	start(&record, &machine);
	/* 5 mm of X and Y at 20 mm/s, whatever else moves. */
	go(&record, move_to(CANON_FEED, (axis_values){{3, 4, 0, 0, 0, 0.01, 0, 0, 100}}));
	ck_assert_double_eq_tol(record.steps[0].seconds, 100 / 500.0 > 5 / 20.0 ? 0.2 : 0.25, 1e-12);
	/* W alone. */
	go(&record, move_to(CANON_FEED, (axis_values){{3, 4, 0, 0, 0, 0.01, 0, 0, 110}}));
	ck_assert_double_eq_tol(record.steps[1].seconds, 0.5, 1e-12);
	/* Degrees: 3 and 4 at 30 a second. */
	go(&record, move_to(CANON_FEED, (axis_values){{3, 4, 0, radians(3), 0, 0.01 + radians(4), 0, 0, 110}}));
	ck_assert_double_eq_tol(record.steps[2].seconds, 5 / 30.0, 1e-12);
	/* G93. */
	move = move_to(CANON_FEED, (axis_values){{13, 4, 0, radians(3), 0, 0.01 + radians(4), 0, 0, 110}});
	move.feed = (struct canon_feed){.inverse_time = true, .seconds = 3};
	go(&record, move);
	ck_assert_double_eq_tol(record.steps[3].seconds, 3, 1e-12);
	/* A feed faster than the axis: Z makes 500 mm/s, C 90 degrees/s. */
	move = move_to(CANON_FEED, (axis_values){{13, 4, 250, radians(3), 0, 0.01 + radians(4 + 180), 0, 0, 110}});
	move.feed.linear = 1e6;
	go(&record, move);
	ck_assert_double_eq_tol(record.steps[4].seconds, 2, 1e-12);
	ck_assert_int_eq(record.step_count, 5);
	ck_assert_int_eq((int)record.summary.moves, 5);
	ck_assert_double_eq_tol(record.summary.seconds, 0.25 + 0.5 + 5 / 30.0 + 3 + 2, 1e-12);
}
END_TEST

START_TEST(rapids)
{
	struct machine machine = rig_trunnion();
	struct record record;

	rig_find(&machine, SLOT_Z)->rate_max = 100;
	start(&record, &machine);
	go(&record, move_to(CANON_RAPID, (axis_values){{300, 250, -80, radians(45)}}));
	/* Z: 80 mm at 100 mm/s. */
	ck_assert_double_eq_tol(record.steps[0].seconds, 0.8, 1e-12);
	ck_assert_int_eq(record.steps[0].span.path->kind, PATH_STRAIGHT);
	go(&record, move_to(CANON_RAPID, (axis_values){{300, 250, -80, radians(-45)}}));
	ck_assert_double_eq_tol(record.steps[1].seconds, 1, 1e-12);
	ck_assert_double_eq_tol(record.steps[1].time, 0.8, 1e-12);
}
END_TEST

START_TEST(arcs_take_their_length)
{
	struct machine machine = rig_three_axes();
	struct record record;
	struct canon_move move = move_to(CANON_ARC, (axis_values){{0, 0, 30}});

	/* Full circle of radius 40 with a rise of 30, at 20 mm/s. */
	move.arc = (struct canon_arc){{-40, 0, 0}, {0, 0, 1}, -2 * PI};
	start(&record, &machine);
	go(&record, move);
	ck_assert_double_eq_tol(record.travelled, hypot(80 * PI, 30) / 20, 1e-9);
	ck_assert_int_gt(record.step_count, 100);
	ck_assert_double_le(record.worst_rate, 1);
	/* Faster than the axes: X and Y both reach their rate somewhere, the whole keeps its even pace. */
	move.end.v[SLOT_Z] = 0;
	move.feed.linear = 1e5;
	record.travelled = record.worst_rate = 0;
	go(&record, move);
	ck_assert_double_le(record.worst_rate, 1 + 1e-9);
	ck_assert_double_ge(record.worst_rate, 1 - 1e-9);
	ck_assert_double_eq_tol(record.travelled, 80 * PI / 500, 80 * PI / 500 * 1e-3);
}
END_TEST

START_TEST(guided_moves_are_held_to_rates)
{
	struct machine machine = rig_trunnion();
	struct record record;
	struct canon_move move = move_to(CANON_FEED, (axis_values){{0, 0, 0, 0, 0, radians(180)}});

	start(&record, &machine);
	go(&record, move_to(CANON_RAPID, (axis_values){{100, 0, 0}}));
	guide(&record, 50);
	move.tcp = true;
	move.end.v[SLOT_X] = 100;
	move.end.v[SLOT_Z] = -100;
	/* 50 mm of tip in the workpiece at 20 mm/s: 2.5 s; a half turn takes 2 s. */
	record.travelled = 0;
	go(&record, move);
	ck_assert_double_eq_tol(record.travelled, 2.5, 1e-9);
	/* Back as a rapid: the table's 2 s, for X at 50 pi a second is still slower than its rate. */
	move.kind = CANON_RAPID;
	move.end.v[SLOT_C] = 0;
	record.travelled = record.worst_rate = 0;
	go(&record, move);
	ck_assert_double_eq_tol(record.travelled, 2, 1e-9);
	ck_assert_double_eq_tol(record.worst_rate, 1, 1e-9);
	/* With a slow Y that has to swing from 0 to +-100 and back, Y decides: 100 pi / 2 over the rate. */
	rig_find(&machine, SLOT_Y)->rate_max = 10;
	move.end.v[SLOT_C] = radians(180);
	record.travelled = record.worst_rate = 0;
	go(&record, move);
	ck_assert_double_eq_tol(record.travelled, 100 * PI / 10, 0.1);
	ck_assert_double_eq_tol(record.worst_rate, 1, 1e-9);
}
END_TEST

/* ------------------------------------------------------------ kinds of rapid */

START_TEST(dogleg_breaks_where_axes_arrive)
{
	struct machine machine = rig_trunnion();
	struct record record;
	const struct span *spans[3];

	machine.controller.rapid = RAPID_DOGLEG;
	start(&record, &machine);
	/* Arrivals: X and Y 0.2 s, Z 0.1 s, C 0.5 s. */
	go(&record, move_to(CANON_RAPID, (axis_values){{100, -100, 50, 0, 0, radians(45)}}));
	ck_assert_int_eq(record.step_count, 3);
	for (int i = 0; i < 3; i++)
		spans[i] = &record.steps[i].span;
	ck_assert_double_eq_tol(spans[0]->q1.v[SLOT_X], 50, 1e-12);
	ck_assert_double_eq_tol(spans[0]->q1.v[SLOT_Y], -50, 1e-12);
	ck_assert_double_eq(spans[0]->q1.v[SLOT_Z], 50);
	ck_assert_double_eq_tol(spans[0]->q1.v[SLOT_C], radians(9), 1e-15);
	ck_assert_double_eq(spans[1]->q1.v[SLOT_X], 100);
	ck_assert_double_eq(spans[1]->q1.v[SLOT_Y], -100);
	ck_assert_double_eq_tol(spans[1]->q1.v[SLOT_C], radians(18), 1e-15);
	ck_assert_double_eq(spans[2]->q1.v[SLOT_C], radians(45));
	ck_assert_double_eq_tol(record.steps[1].time, 0.1, 1e-12);
	ck_assert_double_eq_tol(record.steps[1].seconds, 0.1, 1e-12);
	ck_assert_double_eq_tol(record.steps[2].seconds, 0.3, 1e-12);
	ck_assert_int_eq((int)record.summary.moves, 1);
	/* A feed is straight all the same. */
	go(&record, move_to(CANON_FEED, (axis_values){{0, 0, 0}}));
	ck_assert_int_eq(record.step_count, 4);
}
END_TEST

/* All nine axes, each with its own arrival. */
START_TEST(dogleg_of_all_axes)
{
	struct machine machine = rig_machine();
	struct record record;
	axis_values end;
	int link = 0;

	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		link = rig_axis(&machine, slot, link, rig_x, rig_origin);
		machine.axes[slot].rate_max = slot + 1;
		end.v[slot] = slot % 2 ? 100 : -100;
	}
	machine.controller.rapid = RAPID_DOGLEG;
	start(&record, &machine);
	go(&record, move_to(CANON_RAPID, end));
	ck_assert_int_eq(record.step_count, 9);
	ck_assert_mem_eq(&record.last, &end, sizeof(end));
	ck_assert_double_eq_tol(record.clock, 100, 1e-9);
	ck_assert_double_le(record.worst_rate, 1 + 1e-9);
}
END_TEST

/* The machine's rapids are straight, but these axes move by themselves. */
START_TEST(axes_apart_are_boxes)
{
	struct machine machine = rig_trunnion();
	struct canon_move move = move_to(CANON_RAPID, (axis_values){{100, 0, 0, 0.5}});
	struct record record;

	machine.controller.rapid = RAPID_LINEAR;
	move.apart = true;
	start(&record, &machine);
	go(&record, move);
	ck_assert_int_eq(record.steps[0].span.path->kind, PATH_BOX);
	move.end.v[SLOT_X] = 0;
	go(&record, move);
	ck_assert_int_eq(record.steps[1].span.path->kind, PATH_STRAIGHT);
}
END_TEST

START_TEST(unknown_rapids_are_boxes)
{
	struct machine machine = rig_trunnion();
	struct record record;

	machine.controller.rapid = RAPID_ANY;
	start(&record, &machine);
	go(&record, move_to(CANON_RAPID, (axis_values){{100, -100}}));
	ck_assert_int_eq(record.steps[0].span.path->kind, PATH_BOX);
	/* One axis alone has no choice. */
	go(&record, move_to(CANON_RAPID, (axis_values){{100, 100}}));
	ck_assert_int_eq(record.steps[1].span.path->kind, PATH_STRAIGHT);
	go(&record, move_to(CANON_FEED, (axis_values){{0, 0}}));
	ck_assert_int_eq(record.steps[2].span.path->kind, PATH_STRAIGHT);
}
END_TEST

/* ---------------------------------------------------------- tcp and the rest */

/*
 * A rapid under TCP keeps the tip on a line only where rapids are linear. Elsewhere every position between the axes'
 * ends is possible, and, as the tip may be kept on its line all the same, the positions of that line, too.
 */
START_TEST(rapids_under_tcp_go_as_the_axes_like)
{
	static const enum rapid kinds[] = {RAPID_DOGLEG, RAPID_ANY};

	for (size_t i = 0; i < 2; i++) {
		struct machine machine = rig_trunnion();
		struct record line, free;
		struct canon_move move = move_to(CANON_RAPID, (axis_values){{60, 0, 0, 0, 0, radians(180)}});
		axis_values low = {{0}}, high = {{0}};

		move.tcp = true;
		start(&line, &machine);
		line.converter.flatness = 0.5;
		guide(&line, 100);
		go(&line, move);
		ck_assert_int_eq(line.steps[0].span.path->kind, PATH_TCP);
		machine.controller.rapid = kinds[i];
		start(&free, &machine);
		guide(&free, 100);
		go(&free, move);
		ck_assert_int_eq(free.step_count, 1);
		ck_assert_int_eq(free.steps[0].span.path->kind, PATH_BOX);
		for (int slot = 0; slot < SLOT_COUNT; slot++) {
			const struct motion_step *box = &free.steps[0];

			ck_assert_double_eq_tol(free.last.v[slot], line.last.v[slot], 1e-9);
			low.v[slot] = fmin(box->span.q0.v[slot], box->span.q1.v[slot]) - box->tolerance.v[slot];
			high.v[slot] = fmax(box->span.q0.v[slot], box->span.q1.v[slot]) + box->tolerance.v[slot];
			ck_assert_double_lt(box->tolerance.v[slot], 100);
		}
		/* The tip goes along X at 60 mm in half a turn: Y swings out. */
		ck_assert_double_gt(free.steps[0].tolerance.v[SLOT_Y], 20);
		ck_assert_int_le(line.step_count, EVENTS);
		for (int k = 0; k < line.step_count; k++) {
			for (int slot = 0; slot < SLOT_COUNT; slot++) {
				ck_assert_double_ge(line.steps[k].span.q1.v[slot], low.v[slot] - 1e-9);
				ck_assert_double_le(line.steps[k].span.q1.v[slot], high.v[slot] + 1e-9);
			}
		}
		/* While the rotary axes stand still, a rapid is what it is without TCP. */
		move.end.v[SLOT_X] = 80;
		move.end.v[SLOT_Y] = 15;
		go(&free, move);
		ck_assert_int_eq(free.steps[1].span.path->kind, kinds[i] == RAPID_ANY ? PATH_BOX : PATH_STRAIGHT);
		ck_assert_int_eq(free.step_count, kinds[i] == RAPID_ANY ? 2 : 3);
	}
}
END_TEST

START_TEST(tcp_on_and_off_moves_nothing)
{
	struct machine machine = rig_trunnion();
	struct kinematics_tcp on = {.on = true, .length = 100}, off = {.on = false};
	axis_values position = {{5, 30, -340, radians(90)}};
	struct canon_move move;
	struct record record;

	start(&record, &machine);
	go(&record, move_to(CANON_RAPID, position));
	ck_assert(switch_tcp(&record.converter, &on, (struct srcloc){NULL, 0, 0}, &position));
	/* The tip is at (5, 30, 80): A = 90 back, +Y from the axis is up, -Z is +Y. */
	ck_assert_double_eq_tol(position.v[SLOT_X], 5, 1e-12);
	ck_assert_double_eq_tol(position.v[SLOT_Y], 40, 1e-9);
	ck_assert_double_eq_tol(position.v[SLOT_Z], 120 + 30 - 520, 1e-9);
	/* A guided move to where it stands is none. */
	move = move_to(CANON_FEED, position);
	move.tcp = true;
	go(&record, move);
	ck_assert_int_eq(record.step_count, 1);
	move.end.v[SLOT_X] += 1;
	go(&record, move);
	ck_assert_int_eq(record.step_count, 2);
	/* An unguided move in between, as G53 makes one, is in machine positions. */
	go(&record, move_to(CANON_RAPID, (axis_values){{6, 30, 0, radians(90)}}));
	go(&record, move);
	ck_assert_double_eq_tol(record.last.v[SLOT_Z], -340, 1e-9);
	ck_assert(switch_tcp(&record.converter, &off, (struct srcloc){NULL, 0, 0}, &position));
	ck_assert_mem_eq(&position, &record.last, sizeof(position));
	go(&record, move_to(CANON_RAPID, (axis_values){{0}}));
	ck_assert_int_eq(record.steps[record.step_count - 1].span.path->kind, PATH_STRAIGHT);
}
END_TEST

/* A spread in Y of the workpiece is one in Z of the machine where A stands at 90 degrees; while C turns, it is anywhere. */
START_TEST(spread_turns_with_the_table)
{
	struct machine machine = rig_trunnion();
	struct canon_move move = move_to(CANON_FEED, (axis_values){{0, 0, 0, radians(90)}});
	struct record record;

	start(&record, &machine);
	go(&record, move);
	guide(&record, 50);
	move = move_to(CANON_FEED, (axis_values){{1, 0, 0, radians(90)}});
	move.tcp = true;
	move.spread[SLOT_Y] = 10;
	record.step_count = 0;
	go(&record, move);
	ck_assert_double_eq_tol(record.steps[0].tolerance.v[SLOT_X], 0, 1e-9);
	ck_assert_double_eq_tol(record.steps[0].tolerance.v[SLOT_Y], 0, 1e-9);
	ck_assert_double_eq_tol(record.steps[0].tolerance.v[SLOT_Z], 10, 1e-9);
	move.end.v[SLOT_C] = radians(90);
	record.step_count = 0;
	go(&record, move);
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++)
		ck_assert_double_ge(record.steps[0].tolerance.v[slot], 10);
}
END_TEST

START_TEST(tcp_without_the_kinematics_is_an_error)
{
	struct machine machine = rig_trunnion();
	struct kinematics_tcp on = {.on = true};
	axis_values position = {{0}};
	struct record record;

	machine.workholding.present = false;
	start(&record, &machine);
	ck_assert(!switch_tcp(&record.converter, &on, (struct srcloc){"part.nc", 4, 9}, &position));
	ck_assert_uint_eq(record.messages.diag.errors, 1);
	ck_assert_int_eq(record.messages.loc.line, 4);
}
END_TEST

START_TEST(dwells_tools_and_blocks)
{
	struct machine machine = rig_three_axes();
	const struct canon_block done = {"part.nc", 12, "G1 X30", 2, NULL, 17};
	const struct canon_event block = {CANON_BLOCK, .of.block = &done};
	struct record record;

	start(&record, &machine);
	go(&record, move_to(CANON_FEED, (axis_values){{10}}));
	go(&record, (struct canon_move){.kind = CANON_DWELL, .seconds = 4});
	record.clock += 4;
	go(&record, (struct canon_move){.kind = CANON_TOOL_CHANGE, .tool = 7});
	ck_assert_int_eq(record.tool, 7);
	ck_assert_double_eq(record.tool_position.v[SLOT_X], 10);
	go(&record, move_to(CANON_FEED, (axis_values){{30}}));
	ck_assert_int_eq(record.steps[0].tool, 0);
	ck_assert_int_eq(record.steps[1].tool, 7);
	ck_assert_double_eq_tol(record.steps[1].time, 4.5, 1e-12);
	ck_assert_double_eq_tol(record.steps[1].block_time, 0.5, 1e-12);
	ck_assert(canon_to_spans_event(&record.converter, &block));
	ck_assert_double_eq_tol(record.block_seconds, 1.5, 1e-12);
	ck_assert_int_eq(record.block_moves, 2);
	ck_assert_str_eq(record.block_text, "G1 X30");
	go(&record, move_to(CANON_FEED, (axis_values){{50}}));
	ck_assert_double_eq_tol(record.steps[2].block_time, 0, 1e-15);
	ck_assert_double_eq_tol(record.summary.seconds, 6.5, 1e-12);
	ck_assert_int_eq((int)record.summary.blocks, 1);
	ck_assert_int_eq((int)record.summary.lines, 17);
	ck_assert_int_eq((int)record.summary.spans, 3);
}
END_TEST

/* What is left of a number after offsets went on and off is no motion. */
START_TEST(moves_of_no_length_make_no_step)
{
	struct machine machine = rig_three_axes();
	struct canon_move full = move_to(CANON_ARC, (axis_values){{0.1 + 0.2}});
	struct record record;

	start(&record, &machine);
	go(&record, move_to(CANON_FEED, (axis_values){{0.3}}));
	go(&record, move_to(CANON_FEED, (axis_values){{0.1 + 0.2}}));
	ck_assert_int_eq(record.step_count, 1);
	ck_assert_int_eq((int)record.summary.moves, 1);
	/* A full circle ends where it starts and is a move. */
	full.arc = (struct canon_arc){{10, 0, 0}, {0, 0, 1}, 2 * PI};
	go(&record, full);
	ck_assert_int_eq((int)record.summary.moves, 2);
}
END_TEST

START_TEST(blending)
{
	struct machine machine = rig_trunnion();
	struct canon_move move = move_to(CANON_FEED, (axis_values){{10}});
	struct record record;

	start(&record, &machine);
	go(&record, move);
	ck_assert(!(record.steps[0].tolerance.v[SLOT_X] > 0));
	ck_assert(!record.summary.blend_unbounded);
	move.blend = true;
	move.blend_tolerance = 0.05;
	move.end.v[SLOT_X] = 20;
	go(&record, move);
	ck_assert_double_eq_tol(record.steps[1].tolerance.v[SLOT_Z], 0.05, 1e-15);
	ck_assert_double_eq_tol(record.steps[1].tolerance.v[SLOT_A], radians(0.05), 1e-15);
	ck_assert(!(record.steps[1].tolerance.v[SLOT_W] > 0));
	ck_assert(!record.summary.blend_unbounded);
	machine.controller.path_tolerance = 0.02;
	start(&record, &machine);
	move.end.v[SLOT_X] = 30;
	go(&record, move);
	ck_assert_double_eq_tol(record.steps[0].tolerance.v[SLOT_Z], 0.05, 1e-15);
	ck_assert_double_eq_tol(record.steps[0].tolerance.v[SLOT_A], radians(0.02), 1e-15);
	move.blend = false;
	move.end.v[SLOT_X] = 40;
	go(&record, move);
	ck_assert_double_eq_tol(record.steps[1].tolerance.v[SLOT_Z], 0.02, 1e-15);
	ck_assert_double_eq_tol(record.steps[1].tolerance.v[SLOT_A], radians(0.02), 1e-15);
	ck_assert(!record.summary.blend_unbounded);
	machine.controller.path_tolerance = 0;
	start(&record, &machine);
	move.blend = true;
	move.blend_tolerance = 0;
	move.end.v[SLOT_X] = 50;
	go(&record, move);
	ck_assert(record.summary.blend_unbounded);
}
END_TEST

START_TEST(the_sink_can_stop)
{
	struct machine machine = rig_three_axes();
	struct canon_move move = move_to(CANON_FEED, (axis_values){{10}});
	struct record record;

	start(&record, &machine);
	record.stop_at = 1;
	ck_assert(!carry_out(&record, &move));
	ck_assert_uint_eq(record.messages.diag.errors, 0);
}
END_TEST

static void assert_refused(struct canon_move move, const char *part)
{
	struct machine machine = rig_trunnion();
	struct record record;

	start(&record, &machine);
	if (move.tcp)
		guide(&record, 100);
	ck_assert(!carry_out(&record, &move));
	ck_assert_uint_eq(record.messages.diag.errors, 1);
	ck_assert_msg(strstr(record.messages.text, part), "%s", record.messages.text);
	ck_assert_int_eq(record.messages.loc.line, 12);
	ck_assert_int_eq(record.step_count, 0);
}

START_TEST(absurd_moves_are_refused)
{
	struct canon_move move = move_to(CANON_FEED, (axis_values){{0, 0, 1e300}});

	assert_refused(move, "axis Z moves to 1e+300");
	move.end.v[SLOT_Z] = (double)NAN;
	assert_refused(move, "axis Z");
	move = move_to(CANON_ARC, (axis_values){{1}});
	move.arc = (struct canon_arc){{INFINITY, 0, 0}, {0, 0, 1}, 1};
	assert_refused(move, "arc");
	/* A million turns of a circle as large as a field. */
	move.arc = (struct canon_arc){{1e6, 0, 0}, {0, 0, 1}, 5e6};
	assert_refused(move, "fewer turns");
	move = move_to(CANON_FEED, (axis_values){{1000, 0, 0, 0, 0, 1e7}});
	move.tcp = true;
	assert_refused(move, "fewer turns");
	move = move_to(CANON_FEED, (axis_values){{1000}});
	move.feed.linear = 0;
	assert_refused(move, "feed");
	assert_refused((struct canon_move){.kind = CANON_DWELL, .line = 12, .seconds = 1e300}, "dwell");
}
END_TEST

int main(void)
{
	TCase *tests = tcase_create("converter");

	tcase_add_test(tests, feeds);
	tcase_add_test(tests, rapids);
	tcase_add_test(tests, arcs_take_their_length);
	tcase_add_test(tests, rapids_under_tcp_go_as_the_axes_like);
	tcase_add_test(tests, guided_moves_are_held_to_rates);
	tcase_add_test(tests, dogleg_breaks_where_axes_arrive);
	tcase_add_test(tests, dogleg_of_all_axes);
	tcase_add_test(tests, axes_apart_are_boxes);
	tcase_add_test(tests, unknown_rapids_are_boxes);
	tcase_add_test(tests, tcp_on_and_off_moves_nothing);
	tcase_add_test(tests, spread_turns_with_the_table);
	tcase_add_test(tests, tcp_without_the_kinematics_is_an_error);
	tcase_add_test(tests, dwells_tools_and_blocks);
	tcase_add_test(tests, moves_of_no_length_make_no_step);
	tcase_add_test(tests, blending);
	tcase_add_test(tests, the_sink_can_stop);
	tcase_add_test(tests, absurd_moves_are_refused);
	return run_suite("converter", tests);
}
