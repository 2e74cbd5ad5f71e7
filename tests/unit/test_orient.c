/* test_orient.c - the rotary positions of G53.1: closed forms, forward kinematics of random machines, limits. */

#include "machine/chain.h"
#include "motion/orient.h"
#include "motion_rig.h"
#include "suite.h"

static const struct srcloc place = {"part.nc", 7, 3};

static vec3 euler_normal(double i, double j)
{
	return (vec3){sin(radians(i)) * sin(radians(j)), -cos(radians(i)) * sin(radians(j)), cos(radians(j))};
}

/* Starts with these positions of two slots (degrees) and expects these results. */
static void expect_turn(const struct machine *machine, vec3 direction, int s1, double h1, int s2, double h2, double e1,
			double e2)
{
	struct kinematics_orientation orientation = {.direction = direction};
	struct rig_messages messages;

	rig_listen(&messages);
	orientation.rotary.v[s1] = radians(h1);
	orientation.rotary.v[s2] = radians(h2);
	ck_assert_msg(orient_tool(machine, place, &messages.diag, &orientation), "%s", messages.text);
	ck_assert_double_eq_tol(degrees(orientation.rotary.v[s1]), e1, 1e-9);
	ck_assert_double_eq_tol(degrees(orientation.rotary.v[s2]), e2, 1e-9);
}

/* n = Rz(I) Rx(J) z: on the trunnion this is A = J, C = I, or A = -J, C = I + 180. */
START_TEST(trunnion_closed_form)
{
	struct machine machine = rig_trunnion();
	uint64_t random = 11;

	for (int k = 0; k < 1000; k++) {
		double i = rig_random(&random, -89, 89), j = rig_random(&random, 1, 120);

		expect_turn(&machine, euler_normal(i, j), SLOT_A, j, SLOT_C, i + 5, j, i);
		expect_turn(&machine, euler_normal(i, j), SLOT_A, -j, SLOT_C, i + 175, -j, i + 180);
		expect_turn(&machine, euler_normal(i, j), SLOT_A, j, SLOT_C, i + 725, j, i + 720);
	}
	expect_turn(&machine, (vec3){0, 0, 1}, SLOT_A, 30, SLOT_C, 77, 0, 77);
}
END_TEST

/* C carries B, both in the head: n = Rz(C) Ry(B) z. */
START_TEST(head_closed_form)
{
	struct machine machine = rig_machine();
	uint64_t random = 12;
	int link = 0;

	for (int slot = SLOT_X; slot <= SLOT_Z; slot++)
		link = rig_axis(&machine, slot, link,
				slot == SLOT_X	 ? rig_x
				: slot == SLOT_Y ? rig_y
						 : rig_z,
				rig_origin);
	link = rig_axis(&machine, SLOT_C, link, rig_z, (vec3){3, 4, 500});
	machine.spindle.link = rig_axis(&machine, SLOT_B, link, rig_y, (vec3){0, 0, 700});
	for (int k = 0; k < 1000; k++) {
		double i = rig_random(&random, -89, 89), j = rig_random(&random, 1, 120);

		expect_turn(&machine, euler_normal(i, j), SLOT_B, j, SLOT_C, i - 90, j, i - 90);
		expect_turn(&machine, euler_normal(i, j), SLOT_B, -j, SLOT_C, i + 90, -j, i + 90);
	}
}
END_TEST

/* B tilts the head and C turns the table: again n = Rz(C) Ry(B) z. */
START_TEST(mixed_closed_form)
{
	struct machine machine = rig_three_axes();
	uint64_t random = 13;

	machine.spindle.link = rig_axis(&machine, SLOT_B, machine.spindle.link, rig_y, (vec3){0, 0, 600});
	machine.workholding.link = rig_axis(&machine, SLOT_C, 0, rig_minus_z, (vec3){10, 20, 0});
	for (int k = 0; k < 1000; k++) {
		double i = rig_random(&random, -89, 89), j = rig_random(&random, 1, 120);

		expect_turn(&machine, euler_normal(i, j), SLOT_B, j, SLOT_C, i - 90, j, i - 90);
	}
}
END_TEST

/* The axis B is inclined by 45 degrees from Z to Y: for the tilt J of the tool, cos J = (1 + cos B) / 2. */
START_TEST(nutating_closed_form)
{
	struct machine machine = rig_three_axes();
	uint64_t random = 14;

	machine.spindle.link = rig_axis(&machine, SLOT_B, machine.spindle.link, (vec3){0, 1, 1}, (vec3){0, 0, 600});
	machine.workholding.link = rig_axis(&machine, SLOT_C, 0, rig_minus_z, rig_origin);
	for (int k = 0; k < 1000; k++) {
		double i = rig_random(&random, -180, 180), j = rig_random(&random, 1, 89);
		double b = acos(2 * cos(radians(j)) - 1);
		/* Rodrigues: z rotated by b about (0, 1, 1) / sqrt 2. */
		double x = sin(b) / sqrt(2), y = (1 - cos(b)) / 2;
		double c = i - 90 - degrees(atan2(y, x));

		expect_turn(&machine, euler_normal(i, j), SLOT_B, degrees(b), SLOT_C, c, degrees(b), c);
	}
}
END_TEST

/* Forward kinematics: the direction of the tool in the workpiece at this position of the axes. */
static vec3 tool_in_workpiece(const struct machine *machine, const axis_values *q)
{
	xform head = machine_pose(machine, machine->spindle.link, q);
	xform table = machine_pose(machine, machine->workholding.link, q);

	return mat3_apply_transposed(&table.rotation,
				     mat3_apply(&head.rotation, vec3_scale(-1, machine->spindle.direction)));
}

/* The controller's form of a direction in the workpiece, by the definition of rotary zero. */
START_TEST(random_machines)
{
	uint64_t random = 15;

	for (int k = 0; k < 20000; k++) {
		struct machine machine = rig_three_axes();
		struct kinematics_orientation orientation = {.direction = {0, 0, 1}};
		vec3 first = rig_unit(&random), second = rig_unit(&random), wanted, there;
		struct rig_messages messages;
		axis_values truth = {{0}};
		double first_way, first_best, second_way, second_best;
		int one, two;
		int family = rig_pick(&random, 3);

		if (vec3_norm(vec3_cross(first, second)) < 0.05)
			continue;
		machine.spindle.direction = rig_unit(&random);
		if (family == 0) {
			machine.workholding.link = rig_axis(&machine, SLOT_A, 0, first, rig_point(&random, 100));
			machine.workholding.link =
			    rig_axis(&machine, SLOT_C, machine.workholding.link, second, rig_point(&random, 100));
		} else if (family == 1) {
			machine.spindle.link = rig_axis(&machine, SLOT_C, machine.spindle.link, first, rig_origin);
			machine.spindle.link = rig_axis(&machine, SLOT_A, machine.spindle.link, second, rig_origin);
		} else {
			machine.spindle.link = rig_axis(&machine, SLOT_A, machine.spindle.link, first, rig_origin);
			machine.workholding.link = rig_axis(&machine, SLOT_C, 0, second, rig_origin);
		}
		for (int slot = SLOT_A; slot <= SLOT_C; slot += 2) {
			truth.v[slot] = rig_random(&random, -7, 7);
			orientation.rotary.v[slot] = rig_random(&random, -7, 7);
			orientation.rotary_zero.v[slot] = rig_random(&random, -2, 2);
		}
		one = family == 0 ? SLOT_A : SLOT_C;
		two = family == 0 ? SLOT_C : SLOT_A;
		first_best = fabs(truth.v[one] - orientation.rotary.v[one]);
		second_best = fabs(truth.v[two] - orientation.rotary.v[two]);
		wanted = tool_in_workpiece(&machine, &truth);
		{
			xform zero = machine_pose(&machine, machine.workholding.link, &orientation.rotary_zero);

			orientation.direction = mat3_apply(&zero.rotation, wanted);
		}
		rig_listen(&messages);
		truth = orientation.rotary;
		ck_assert_msg(orient_tool(&machine, place, &messages.diag, &orientation), "%s", messages.text);
		there = tool_in_workpiece(&machine, &orientation.rotary);
		ck_assert_double_le(vec3_norm(vec3_sub(there, wanted)), 3e-6);
		/* The true position is one of the candidates: none may be better than the chosen one. */
		first_way = fabs(orientation.rotary.v[one] - truth.v[one]);
		second_way = fabs(orientation.rotary.v[two] - truth.v[two]);
		ck_assert_double_le(first_way, first_best + 1e-5);
		if (first_way > first_best - 1e-5)
			ck_assert_double_le(second_way, second_best + 1e-5);
	}
}
END_TEST

START_TEST(limits_choose)
{
	struct machine machine = rig_trunnion();

	/* A from -120 to 30: of A60 C0 and A-60 C180 only the second one is inside the limits. */
	rig_find(&machine, SLOT_A)->limit_min = radians(-120);
	rig_find(&machine, SLOT_A)->limit_max = radians(30);
	expect_turn(&machine, euler_normal(0, 60), SLOT_A, 0, SLOT_C, 10, -60, 180);
	expect_turn(&machine, euler_normal(0, 60), SLOT_A, 0, SLOT_C, -10, -60, -180);
	/* Exactly at the limit. */
	expect_turn(&machine, euler_normal(5, 30), SLOT_A, 0, SLOT_C, 0, 30, 5);
}
END_TEST

/*
 * Fanuc 16i/18i-B operator's manual (B-63534EN), tool axis direction control, "Angle of rotation axis", output
 * judgement conditions <1> to <4>. On the trunnion A carries C, so the travel of A decides, however far C has to move.
 */
START_TEST(first_axis_decides)
{
	struct machine machine = rig_trunnion();

	/* A20 C0 or A-20 C180: A moves by 10 or 30, C by 170 or 10. */
	expect_turn(&machine, euler_normal(0, 20), SLOT_A, 10, SLOT_C, 170, 20, 0);
	expect_turn(&machine, euler_normal(0, 20), SLOT_A, -10, SLOT_C, 10, -20, 180);
	/* <2> From A0 both solutions move A equally far. */
	expect_turn(&machine, euler_normal(0, 20), SLOT_A, 0, SLOT_C, 95, -20, 180);
	/*
	 * <4> A20 C30 or A-20 C210 from A0 C120: equal distances, and 20 is as near to 0 as -20; 30 is nearer to 0 than
	 * 210.
	 */
	expect_turn(&machine, euler_normal(30, 20), SLOT_A, 0, SLOT_C, 120 - 1e-9, 20, 30);
}
END_TEST

/* Mixed type: the table has precedence. B tilts the head, C turns the table: B20 C-90 or B-20 C90. */
START_TEST(table_decides_before_head)
{
	struct machine machine = rig_three_axes();

	machine.spindle.link = rig_axis(&machine, SLOT_B, machine.spindle.link, rig_y, (vec3){0, 0, 600});
	machine.workholding.link = rig_axis(&machine, SLOT_C, 0, rig_minus_z, (vec3){10, 20, 0});
	expect_turn(&machine, euler_normal(0, 20), SLOT_B, 60, SLOT_C, 5, -20, 90);
	expect_turn(&machine, euler_normal(0, 20), SLOT_B, -60, SLOT_C, -5, 20, -90);
}
END_TEST

/* C carries B in the head: C has precedence. */
START_TEST(carrier_decides_in_head)
{
	struct machine machine = rig_machine();
	int link = 0;

	for (int slot = SLOT_X; slot <= SLOT_Z; slot++)
		link = rig_axis(&machine, slot, link,
				slot == SLOT_X	 ? rig_x
				: slot == SLOT_Y ? rig_y
						 : rig_z,
				rig_origin);
	link = rig_axis(&machine, SLOT_C, link, rig_z, (vec3){3, 4, 500});
	machine.spindle.link = rig_axis(&machine, SLOT_B, link, rig_y, (vec3){0, 0, 700});
	expect_turn(&machine, euler_normal(0, 20), SLOT_B, 60, SLOT_C, 5, -20, 90);
	expect_turn(&machine, euler_normal(0, 20), SLOT_B, -60, SLOT_C, -5, 20, -90);
	/* <3> B20 C-60 or B-20 C120 from B0 C30: the distances are equal; -60 is nearer to 0 than 120. */
	expect_turn(&machine, euler_normal(30, 20), SLOT_B, 0, SLOT_C, 30 + 1e-9, 20, -60);
}
END_TEST

static void expect_message(const struct machine *machine, vec3 direction, bool good, size_t warnings, const char *text)
{
	struct kinematics_orientation orientation = {.direction = direction};
	struct rig_messages messages;

	rig_listen(&messages);
	ck_assert(orient_tool(machine, place, &messages.diag, &orientation) == good);
	ck_assert_str_eq(messages.text, text);
	ck_assert_uint_eq(messages.diag.warnings, warnings);
	ck_assert_uint_eq(messages.diag.errors, good ? 0 : 1);
}

START_TEST(messages)
{
	struct machine machine = rig_trunnion();

	expect_message(&machine, euler_normal(10, 20), true, 0,
		       "G53.1 turns to C10 A20; the other solution, C-170 A-20, needs a longer move of C");
	expect_message(
	    &machine, euler_normal(90, 20), false, 0,
	    "G53.1 could turn to C-90 A-20 or to C90 A20, which are equally near: turn the rotary axes towards the "
	    "intended position in a block before");
	rig_find(&machine, SLOT_A)->limit_min = radians(-20);
	rig_find(&machine, SLOT_A)->limit_max = radians(10);
	expect_message(&machine, euler_normal(10, 20), true, 0,
		       "G53.1 turns to C-170 A-20; the other solution, C10 A20, is outside the limits");
	rig_find(&machine, SLOT_A)->limit_min = radians(-10);
	expect_message(&machine, euler_normal(10, 20), false, 0,
		       "within their limits, the rotary axes cannot turn the tool perpendicular to this plane");
	/* Half a turn of C, in either direction. */
	rig_find(&machine, SLOT_A)->limit_min = radians(-90);
	expect_message(
	    &machine, euler_normal(0, 20), false, 0,
	    "G53.1 could turn to C180 A-20 or to C-180 A-20, which are equally near: turn the rotary axes towards the "
	    "intended position in a block before, or give half_turn to axis C in the machine file");
	/* The machine file gives the direction. */
	rig_find(&machine, SLOT_C)->half_turn = -1;
	expect_message(&machine, euler_normal(0, 20), true, 0,
		       "G53.1 turns to C-180 A-20; the other solution, C0 A20, is outside the limits");
	rig_find(&machine, SLOT_C)->half_turn = 1;
	expect_message(&machine, euler_normal(0, 20), true, 0,
		       "G53.1 turns to C180 A-20; the other solution, C0 A20, is outside the limits");
	rig_find(&machine, SLOT_C)->half_turn = 0;
	rig_find(&machine, SLOT_C)->limit_min = radians(-100);
	expect_message(&machine, euler_normal(0, 20), true, 0,
		       "G53.1 turns to C180 A-20; the other solution, C0 A20, is outside the limits");
	machine = rig_three_axes();
	expect_message(&machine, (vec3){0, 0, 1}, false, 0,
		       "G53.1 needs one or two rotary axes between the workpiece and the tool; this machine has 0");
	machine.workholding.link = rig_axis(&machine, SLOT_A, 0, rig_minus_x, rig_origin);
	expect_message(&machine, euler_normal(0, 35), true, 0, "G53.1 turns to A35");
	expect_message(&machine, euler_normal(1, 35), false, 0,
		       "the rotary axes of this machine cannot turn the tool perpendicular to this plane");
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("orient");

	tcase_add_test(tcase, trunnion_closed_form);
	tcase_add_test(tcase, head_closed_form);
	tcase_add_test(tcase, mixed_closed_form);
	tcase_add_test(tcase, nutating_closed_form);
	tcase_add_test(tcase, random_machines);
	tcase_add_test(tcase, limits_choose);
	tcase_add_test(tcase, first_axis_decides);
	tcase_add_test(tcase, table_decides_before_head);
	tcase_add_test(tcase, carrier_decides_in_head);
	tcase_add_test(tcase, messages);
	return run_suite("orient", tcase);
}
