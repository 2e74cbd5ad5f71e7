/*
 * test_table_point.c - the work zero of G254, against closed forms and forward kinematics, and machines that have none.
 */

#include "machine/chain.h"
#include "motion/table_point.h"
#include "motion_rig.h"
#include "suite.h"

static const struct srcloc here = {"part.nc", 7, 3};

static axis_values carried(const struct machine *machine, axis_values place)
{
	struct rig_messages messages;

	rig_listen(&messages);
	ck_assert_msg(table_point_find(machine, here, &messages.diag, &place), "%s", messages.text);
	return place;
}

static void assert_place(const axis_values *place, double x, double y, double z)
{
	ck_assert_double_eq_tol(place->v[SLOT_X], x, 1e-9);
	ck_assert_double_eq_tol(place->v[SLOT_Y], y, 1e-9);
	ck_assert_double_eq_tol(place->v[SLOT_Z], z, 1e-9);
}

/*
 * Haas mill operator's manual (NGC), "G254 Dynamic Work Offset": about the centres of rotation. Those of the trunnion
 * are 400 below the gauge point; its table turns by C about -Z, and A turns both about -X.
 */
START_TEST(trunnion_closed_form)
{
	struct machine machine = rig_trunnion();
	uint64_t random = 21;

	for (int k = 0; k < 1000; k++) {
		double a = rig_random(&random, -2, 2), c = rig_random(&random, -9, 9);
		vec3 p = rig_point(&random, 300);
		double x = cos(c) * p.x + sin(c) * p.y, y = cos(c) * p.y - sin(c) * p.x, z = p.z + 400;
		axis_values place = carried(&machine, (axis_values){{p.x, p.y, p.z, a, 0, c}});

		assert_place(&place, x, cos(a) * y + sin(a) * z, cos(a) * z - sin(a) * y - 400);
		ck_assert(place.v[SLOT_A] >= a && place.v[SLOT_A] <= a);
		ck_assert(place.v[SLOT_C] >= c && place.v[SLOT_C] <= c);
	}
}
END_TEST

/*
 * B about +Y through X = 5, Z = 80 carries C about +Z through X = 30, Y = 40; X moves the table, so its direction is
 * reversed.
 */
START_TEST(tilting_table_closed_form)
{
	struct machine machine = rig_machine();
	uint64_t random = 22;
	int link = rig_axis(&machine, SLOT_X, 0, rig_minus_x, rig_origin);

	link = rig_axis(&machine, SLOT_B, link, rig_y, (vec3){5, 99, 80});
	machine.workholding.link = rig_axis(&machine, SLOT_C, link, rig_z, (vec3){30, 40, -7});
	machine.spindle.link = rig_axis(&machine, SLOT_Z, rig_axis(&machine, SLOT_Y, 0, rig_y, rig_origin), rig_z,
					rig_origin);
	for (int k = 0; k < 1000; k++) {
		double b = rig_random(&random, -2, 2), c = rig_random(&random, -9, 9);
		vec3 p = rig_point(&random, 300), v = {p.x - 30, p.y - 40, 0};
		double x = cos(c) * v.x - sin(c) * v.y + 30 - 5, y = sin(c) * v.x + cos(c) * v.y + 40;
		double z = p.z + 520 - 80;
		axis_values place = carried(&machine, (axis_values){{p.x, p.y, p.z, 0, b, c}});

		assert_place(&place, cos(b) * x + sin(b) * z + 5, y, cos(b) * z - sin(b) * x + 80 - 520);
	}
}
END_TEST

static vec3 gauge_on_table(const struct machine *machine, const axis_values *q)
{
	xform table = machine_pose(machine, machine->workholding.link, q);
	xform head = machine_pose(machine, machine->spindle.link, q);

	table = xform_inverse(&table);
	return xform_apply(&table, xform_apply(&head, machine->spindle.location));
}

/* For every family with a fixed head: the gauge point is at the same point of the table as at rotary zero. */
START_TEST(forward_kinematics)
{
	static const enum rig_family families[] = {RIG_AC_TABLE, RIG_BC_TABLE, RIG_NUTATING_TABLE, RIG_C_TABLE};
	uint64_t random = 23;

	for (int k = 0; k < 4000; k++) {
		struct machine machine = rig_random_machine(&random, families[k % 4]);
		axis_values place = rig_position(&machine, &random), zero = place, now;
		vec3 then, is;

		for (int slot = SLOT_A; slot <= SLOT_C; slot++)
			zero.v[slot] = 0;
		now = carried(&machine, place);
		then = gauge_on_table(&machine, &zero);
		is = gauge_on_table(&machine, &now);
		ck_assert_double_lt(vec3_norm(vec3_sub(is, then)), 1e-9);
	}
}
END_TEST

/* Three axes: nothing turns, so the zero stays. */
START_TEST(nothing_turns)
{
	struct machine machine = rig_three_axes();
	axis_values place = carried(&machine, (axis_values){{1, 2, 3}});

	assert_place(&place, 1, 2, 3);
}
END_TEST

static void assert_refused(const struct machine *machine, const char *message)
{
	struct rig_messages messages;
	axis_values place = {{1, 2, 3, 0.4, 0.5, 0.6}};

	rig_listen(&messages);
	ck_assert(!table_point_find(machine, here, &messages.diag, &place));
	ck_assert_str_eq(messages.text, message);
	ck_assert_int_eq(messages.loc.line, here.line);
	ck_assert_int_eq(messages.loc.column, here.column);
	assert_place(&place, 1, 2, 3);
}

START_TEST(refused)
{
	uint64_t random = 24;
	struct machine machine = rig_random_machine(&random, RIG_CB_HEAD);

	assert_refused(&machine,
		       "G254 works only if the rotary axes turn the table; on this machine C turns the spindle");
	machine = rig_random_machine(&random, RIG_B_HEAD_C_TABLE);
	assert_refused(&machine,
		       "G254 works only if the rotary axes turn the table; on this machine B turns the spindle");
	machine = rig_trunnion();
	machine.workholding.present = false;
	assert_refused(&machine, "tool centre point control needs a <workholding> in the machine file");
}
END_TEST

int main(void)
{
	TCase *tests = tcase_create("table_point");

	tcase_add_test(tests, trunnion_closed_form);
	tcase_add_test(tests, tilting_table_closed_form);
	tcase_add_test(tests, forward_kinematics);
	tcase_add_test(tests, nothing_turns);
	tcase_add_test(tests, refused);
	return run_suite("table_point", tests);
}
