/* test_motion.c - whole programs through the interpreter and canon_to_spans, compared with values computed by hand. */

#include "machine/chain.h"
#include "motion/motion.h"
#include "motion_record.h"
#include "suite.h"

static bool run_with(const struct motion_options *options, struct record *record, const struct machine *machine,
		     const struct setup *setup, const char *program, struct motion_summary *summary)
{
	FILE *in = fmemopen((void *)(uintptr_t)program, strlen(program), "r");
	bool ok;

	ck_assert_ptr_nonnull(in);
	listen(record);
	ok = motion_run(machine, setup, options, in, "part.nc", &record->sink, &record->messages.diag,
			summary);
	fclose(in);
	return ok;
}

static bool run(struct record *record, const struct machine *machine, const struct setup *setup, const char *program,
		struct motion_summary *summary)
{
	const struct motion_options options = {.flatness = 0.001};

	return run_with(&options, record, machine, setup, program, summary);
}

/* A feed in mm/min, a work offset, a tool with its length, a dwell, and a return home by G53. */
START_TEST(a_program)
{
	static const char program[] = "G21 G90 G54\n"
				      "T3 M6\n"
				      "G43 H3\n"
				      "G0 X10 Y0 Z5\n"
				      "G1 Z-5 F600\n"
				      "G4 P2\n"
				      "G2 X20 I5\n"
				      "G53 G0 Z0\n"
				      "M30\n";
	struct machine machine = rig_three_axes();
	struct work_offset offset = {.name = "G54", .value = {{100, 0, -300}}};
	struct tool tool = {.number = 3, .name = "", .length = 80, .diameter = 6, .length_offset = 80};
	struct length_offset length = {3, 80};
	struct setup setup = {.offsets = &offset, .offset_count = 1, .tools = &tool, .tool_count = 1,
			      .lengths = &length, .length_count = 1};
	struct motion_summary summary;
	struct record record;

	machine.controller.mcodes = &(const struct mcode){428, MCODE_IGNORE};
	machine.controller.mcode_count = 1;
	ck_assert_msg(run(&record, &machine, &setup, program, &summary), "%ld: %s", record.messages.loc.line,
		      record.messages.text);
	ck_assert_int_eq((int)summary.moves, 4);
	ck_assert_int_eq((int)summary.blocks, record.blocks);
	ck_assert_int_eq((int)summary.spans, record.step_count);
	ck_assert_int_ge((int)summary.lines, 9);
	ck_assert_int_eq(record.tool, 3);
	/* G0 to (10, 0, 5) in the work offset, and 80 higher because of the tool. */
	ck_assert_double_eq_tol(record.steps[0].span.q1.v[SLOT_X], 110, 1e-12);
	ck_assert_double_eq_tol(record.steps[0].span.q1.v[SLOT_Z], -300 + 5 + 80, 1e-12);
	ck_assert_int_eq(record.steps[0].tool, 3);
	ck_assert_int_eq((int)record.steps[0].line, 4);
	ck_assert_double_eq_tol(record.steps[0].seconds, 215 / 500.0, 1e-12);
	ck_assert_double_eq_tol(record.steps[1].seconds, 1, 1e-12);
	ck_assert_double_eq_tol(record.steps[2].time, 0.43 + 1 + 2, 1e-12);
	ck_assert_double_eq_tol(summary.seconds, 0.43 + 1 + 2 + 5 * PI / 10 + 225 / 500.0, 1e-9);
	ck_assert_double_eq(record.last.v[SLOT_Z], 0);
	ck_assert_double_eq_tol(record.last.v[SLOT_X], 120, 1e-12);
}
END_TEST

/* Blocks like those of the impeller: G43.4, then rotary words beside linear ones. */
START_TEST(a_guided_program)
{
	static const char program[] = "G21 G90 G54\n"
				      "G43.4 H3\n"
				      "G1 X30 Y0 Z0 A0 C0 F1000\n"
				      "G1 X30 Y0 Z0 A-20 C90\n"
				      "G49\n"
				      "M2\n";
	struct machine machine = rig_trunnion();
	struct tool tool = {.number = 3, .name = "", .length = 80, .length_offset = 80};
	struct length_offset length = {3, 80};
	struct work_offset offset = {.name = "G54", .value = {{0, 0, -400}}};
	struct setup setup = {.offsets = &offset, .offset_count = 1, .tools = &tool, .tool_count = 1,
			      .lengths = &length, .length_count = 1, .initial_tool = 3};
	struct motion_summary summary;
	struct record record;
	xform table, head, inverse;
	vec3 tip = {0, 0, 520 - 80};

	ck_assert_msg(run(&record, &machine, &setup, program, &summary), "%ld: %s", record.messages.loc.line,
		      record.messages.text);
	ck_assert_int_eq((int)summary.moves, 2);
	ck_assert_int_eq(record.steps[0].tool, 3);
	/* The workpiece point (30, 0, 120) is the table's centre plus 30 in X; the tip stays there. */
	table = machine_pose(&machine, machine.workholding.link, &record.last);
	head = machine_pose(&machine, machine.spindle.link, &record.last);
	inverse = xform_inverse(&table);
	tip = xform_apply(&inverse, xform_apply(&head, tip));
	ck_assert_double_lt(vec3_norm(vec3_sub(tip, (vec3){30, 0, 120})), 1e-9);
	ck_assert_double_eq_tol(record.last.v[SLOT_C], PI / 2, 1e-12);
}
END_TEST

START_TEST(a_faulty_program)
{
	struct machine machine = rig_three_axes();
	struct motion_summary summary;
	struct record record;

	ck_assert(!run(&record, &machine, NULL, "G0 X1\nG0 A5\n", &summary));
	ck_assert_uint_ge(record.messages.diag.errors, 1);
	ck_assert_int_eq((int)record.messages.loc.line, 2);
	ck_assert_int_eq((int)summary.moves, 1);
}
END_TEST

/* Steps that are not sent are counted; limits, blocks and the clock stay the same. */
START_TEST(steps_that_are_counted)
{
	static const char program[] = "G21 G90 G17 G1 F600 X10\nG2 X30 Y0 I10 J0\nG4 P2\nG0 X5000\nX0 Y0 Z0\nM2\n";
	const struct motion_options options = {.flatness = 0.001, .counts_steps = true};
	struct machine machine = rig_three_axes();
	struct motion_summary told, counted;
	struct record all, few;

	for (size_t i = 0; i < machine.axis_count; i++) {
		machine.axes[i].limit_min = -1000;
		machine.axes[i].limit_max = 1000;
	}
	ck_assert_msg(run(&all, &machine, NULL, program, &told), "%s", all.messages.text);
	ck_assert_msg(run_with(&options, &few, &machine, NULL, program, &counted), "%s", few.messages.text);
	ck_assert_int_gt(all.step_count, 20);
	ck_assert_int_eq(few.step_count, 0);
	ck_assert_int_eq((int)counted.spans, all.step_count);
	ck_assert_int_eq((int)counted.moves, (int)told.moves);
	ck_assert_double_eq(counted.seconds, told.seconds);
	ck_assert_int_eq(few.blocks, all.blocks);
	ck_assert_int_gt(all.limit_count, 0);
	ck_assert_int_eq(few.limit_count, all.limit_count);
	for (int i = 0; i < all.limit_count; i++) {
		ck_assert_int_eq((int)few.limits[i].line, (int)all.limits[i].line);
		ck_assert_double_eq(few.limits[i].time, all.limits[i].time);
		ck_assert_double_eq(few.limits[i].travel.excess, all.limits[i].travel.excess);
	}
}
END_TEST

int main(void)
{
	TCase *tests = tcase_create("motion");

	tcase_add_test(tests, a_program);
	tcase_add_test(tests, a_guided_program);
	tcase_add_test(tests, a_faulty_program);
	tcase_add_test(tests, steps_that_are_counted);
	return run_suite("motion", tests);
}
