/*
 * test_tcp.c - TCP against values computed by hand, and against the machine's forward kinematics: the tip keeps its
 * place in the workpiece.
 */

#include "motion/path.h"
#include "motion/tcp.h"
#include "motion_rig.h"
#include "suite.h"

static const struct srcloc here = {"part.nc", 7, 3};

/* -------------------------------------------------------------- by hand */

static void assert_linear(axis_values q, double x, double y, double z)
{
	ck_assert_double_eq_tol(q.v[SLOT_X], x, 1e-9);
	ck_assert_double_eq_tol(q.v[SLOT_Y], y, 1e-9);
	ck_assert_double_eq_tol(q.v[SLOT_Z], z, 1e-9);
}

/* Without a rotary axis a vertical spindle rises by the length of the tool, as with G43. */
START_TEST(length_lifts_a_vertical_spindle)
{
	struct machine machine = rig_three_axes();
	struct kinematics_tcp state = {.on = true, .length = 130};
	struct tcp tcp = rig_tcp(&machine, &state);
	axis_values p = {{10, 20, -300}}, q = tcp_to_machine(&tcp, &p);

	assert_linear(q, 10, 20, -170);
	assert_linear(tcp_from_machine(&tcp, &q), 10, 20, -300);
}
END_TEST

/*
 * The trunnion turns about -X through (0, *, 120). At zero the gauge point is at (0, 0, 520) + (x, y, z); p = (5, 30,
 * -340) is the workpiece point (5, 30, 180), 60 above the axis of A. A = 90 degrees turns +Z about -X to +Y, and +Y to
 * -Z: the point is then at (5, 60, 90), and with C = 180 before that at (-5, 60, 150).
 */
START_TEST(trunnion_by_hand)
{
	struct machine machine = rig_trunnion();
	struct kinematics_tcp state = {.on = true, .length = 100};
	struct tcp tcp = rig_tcp(&machine, &state);
	axis_values p = {{5, 30, -340, radians(90)}};

	assert_linear(tcp_to_machine(&tcp, &p), 5, 60, 90 + 100 - 520);
	p.v[SLOT_C] = PI;
	assert_linear(tcp_to_machine(&tcp, &p), -5, 60, 150 + 100 - 520);
}
END_TEST

/*
 * A head that tilts about Y at z = 700, with its gauge point 180 below and a tool of 100: at B = 90 degrees (+Z turns
 * to +X, so -Z to -X) the tip is 280 to the left of the pivot, at its height. To keep the tip in place, X moves by
 * +280, and Z down by 280 minus the length of the tool.
 */
START_TEST(head_by_hand)
{
	struct machine machine = rig_three_axes();
	struct kinematics_tcp state = {.on = true, .length = 100};
	struct tcp tcp;
	axis_values p = {{0, 0, 0, 0, radians(90)}};

	machine.spindle.link = rig_axis(&machine, SLOT_B, machine.spindle.link, rig_y, (vec3){0, 0, 700});
	tcp = rig_tcp(&machine, &state);
	assert_linear(tcp_to_machine(&tcp, &p), 280, 0, 100 - 280);
}
END_TEST

/* Rotary zero at C = 90 degrees: there positions are literal. */
START_TEST(rotary_zero_is_where_positions_are_literal)
{
	struct machine machine = rig_trunnion();
	struct kinematics_tcp state = {.on = true, .length = 100, .rotary_zero = {{0, 0, 0, 0.3, 0, PI / 2}}};
	struct tcp tcp = rig_tcp(&machine, &state);
	axis_values p = {{5, 30, -340, 0.3, 0, PI / 2}};

	assert_linear(tcp_to_machine(&tcp, &p), 5, 30, -240);
}
END_TEST

/* ---------------------------------------------------- forward kinematics */

/* The tip in the zero-pose coordinates of the workpiece, by the poses of the machine. */
static vec3 tip_in_workpiece(const struct machine *machine, const axis_values *q, double length)
{
	xform table = machine_pose(machine, machine->workholding.link, q);
	xform head = machine_pose(machine, machine->spindle.link, q), inverse = xform_inverse(&table);
	vec3 tip = vec3_mad(machine->spindle.location, length, machine->spindle.direction);

	return xform_apply(&inverse, xform_apply(&head, tip));
}

/* The point that a controller position means: the tip with the rotary axes at rotary zero and no tool. */
static vec3 meant(const struct machine *machine, const struct kinematics_tcp *state, axis_values p)
{
	for (int slot = SLOT_A; slot <= SLOT_C; slot++)
		p.v[slot] = state->rotary_zero.v[slot];
	return tip_in_workpiece(machine, &p, 0);
}

START_TEST(tip_keeps_its_place)
{
	uint64_t random = 4711;
	double worst = 0;

	for (int i = 0; i < 9000; i++) {
		struct machine machine = rig_random_machine(&random, (enum rig_family)(i % RIG_FAMILIES));
		struct kinematics_tcp state = rig_tcp_state(&machine, &random);
		struct tcp tcp = rig_tcp(&machine, &state);
		struct path path = {.kind = PATH_TCP, .start = rig_position(&machine, &random),
				    .end = rig_position(&machine, &random), .tcp = &tcp};

		for (int k = 0; k <= 4; k++) {
			axis_values q = path_position(&path, k / 4.0), p;
			vec3 is = tip_in_workpiece(&machine, &q, state.length), should;

			for (int slot = 0; slot < SLOT_COUNT; slot++)
				p.v[slot] = (1 - k / 4.0) * path.start.v[slot] + k / 4.0 * path.end.v[slot];
			should = meant(&machine, &state, p);
			worst = fmax(worst, vec3_norm(vec3_sub(is, should)));
			for (int slot = SLOT_A; slot < SLOT_COUNT; slot++)
				ck_assert_double_eq_tol(q.v[slot], p.v[slot], 1e-12);
		}
	}
	printf("tcp: tip strays from its place by at most %.3g mm\n", worst);
	ck_assert_double_lt(worst, 1e-9);
}
END_TEST

START_TEST(round_trip)
{
	uint64_t random = 99;

	for (int i = 0; i < 9000; i++) {
		struct machine machine = rig_random_machine(&random, (enum rig_family)(i % RIG_FAMILIES));
		struct kinematics_tcp state = rig_tcp_state(&machine, &random);
		struct tcp tcp = rig_tcp(&machine, &state);
		axis_values p = rig_position(&machine, &random), q = tcp_to_machine(&tcp, &p);
		axis_values back = tcp_from_machine(&tcp, &q), again = tcp_to_machine(&tcp, &back);

		for (int slot = 0; slot < SLOT_COUNT; slot++) {
			ck_assert_double_eq_tol(back.v[slot], p.v[slot], 1e-9);
			ck_assert_double_eq_tol(again.v[slot], q.v[slot], 1e-9);
		}
	}
}
END_TEST

/* ----------------------------------------------------------------- errors */

static void assert_refused(const struct machine *machine, const char *part)
{
	struct kinematics_tcp state = {.on = true};
	struct rig_messages messages;
	struct tcp tcp;

	rig_listen(&messages);
	ck_assert(!tcp_init(&tcp, machine, &state, here, &messages.diag));
	ck_assert_uint_eq(messages.diag.errors, 1);
	ck_assert_msg(strstr(messages.text, part), "%s", messages.text);
	ck_assert_int_eq(messages.loc.line, here.line);
	ck_assert_int_eq(messages.loc.column, here.column);
}

START_TEST(machines_without_tcp)
{
	struct machine machine = rig_trunnion();

	machine.spindle.present = false;
	assert_refused(&machine, "<spindle>");
	machine = rig_trunnion();
	machine.workholding.present = false;
	assert_refused(&machine, "<workholding>");
	machine = rig_trunnion();
	machine.workholding.link = rig_axis(&machine, SLOT_W, machine.workholding.link, rig_z, rig_origin);
	assert_refused(&machine, "linear axis W is carried by rotary axis C");
	machine = rig_trunnion();
	machine.axes[2].direction = rig_normalised((vec3){1, 1, 0});
	assert_refused(&machine, "one plane");
	machine = rig_trunnion();
	machine.spindle.link = 2;
	assert_refused(&machine, "no such axis Z");
}
END_TEST

/* An axis that carries both table and head moves neither relative to the other, even a rotary axis below them. */
START_TEST(common_carrier_does_not_count)
{
	struct machine machine = rig_machine();
	struct kinematics_tcp state = {.on = true, .length = 10};
	int base = rig_axis(&machine, SLOT_A, 0, rig_x, rig_origin);
	int link = rig_axis(&machine, SLOT_X, base, rig_x, rig_origin);
	axis_values p = {{1, 2, 3, 0.7, 0, 0.4}}, q;
	struct tcp tcp;

	link = rig_axis(&machine, SLOT_Y, link, rig_y, rig_origin);
	machine.spindle.link = rig_axis(&machine, SLOT_Z, link, rig_z, rig_origin);
	machine.workholding.link = rig_axis(&machine, SLOT_C, base, rig_z, (vec3){50, 0, 0});
	tcp = rig_tcp(&machine, &state);
	q = tcp_to_machine(&tcp, &p);
	ck_assert_double_lt(
		vec3_norm(vec3_sub(tip_in_workpiece(&machine, &q, 10), meant(&machine, &state, p))), 1e-12);
}
END_TEST

/*
 * While the rotary axes stand still, a step along the rotated X, Y or Z of the workpiece is the head's rotation of a
 * step along X, Y or Z of the machine, and the tool points along the rotated Z if the spindle is vertical.
 */
START_TEST(turn_of_coordinates)
{
	const axis_values places[] = {{{1, 2, 3, 0.7, 0, 0.4}}, {{0, 0, 0, -0.3, 0.9, 2}}, {{5, 0, 0, 0, 0, 0}}};
	struct machine machines[] = {rig_trunnion(), rig_three_axes()};
	int link = rig_axis(&machines[1], SLOT_C, machines[1].spindle.link, rig_z, (vec3){3, 4, 0});

	machines[1].spindle.link = rig_axis(&machines[1], SLOT_B, link, rig_y, (vec3){0, 0, 700});
	for (size_t m = 0; m < 2; m++) {
		const struct kinematics_tcp state = {.on = true, .length = 10, .rotary_zero = {{0}}};
		struct tcp tcp = rig_tcp(&machines[m], &state);

		for (size_t i = 0; i < 3; i++) {
			struct kinematics_turn turn = {.rotary = places[i]};
			const axis_values start = tcp_to_machine(&tcp, &places[i]);
			const mat3 head = chain_pose(&tcp.head, &places[i]).rotation;

			tcp_turn(&tcp, &turn);
			for (int k = 0; k < 3; k++) {
				const vec3 side = k == 0 ? turn.turn.x : k == 1 ? turn.turn.y : turn.turn.z;
				const vec3 expected = k == 0 ? head.x : k == 1 ? head.y : head.z;
				axis_values moved = places[i], end;

				moved.v[SLOT_X] += side.x;
				moved.v[SLOT_Y] += side.y;
				moved.v[SLOT_Z] += side.z;
				end = tcp_to_machine(&tcp, &moved);
				ck_assert_double_eq_tol(end.v[SLOT_X] - start.v[SLOT_X], expected.x, 1e-9);
				ck_assert_double_eq_tol(end.v[SLOT_Y] - start.v[SLOT_Y], expected.y, 1e-9);
				ck_assert_double_eq_tol(end.v[SLOT_Z] - start.v[SLOT_Z], expected.z, 1e-9);
			}
			ck_assert_double_lt(vec3_norm(vec3_sub(turn.tool, turn.turn.z)), 1e-12);
		}
	}
}
END_TEST

int main(void)
{
	TCase *tests = tcase_create("tcp");

	tcase_add_test(tests, length_lifts_a_vertical_spindle);
	tcase_add_test(tests, trunnion_by_hand);
	tcase_add_test(tests, head_by_hand);
	tcase_add_test(tests, rotary_zero_is_where_positions_are_literal);
	tcase_add_test(tests, tip_keeps_its_place);
	tcase_add_test(tests, round_trip);
	tcase_add_test(tests, machines_without_tcp);
	tcase_add_test(tests, common_carrier_does_not_count);
	tcase_add_test(tests, turn_of_coordinates);
	return run_suite("tcp", tests);
}
