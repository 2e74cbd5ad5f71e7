/*
 * test_tcp_bound.c - the bounds of TCP moves for chord error, second derivative and rounding, against dense samples in
 * long double.
 */

#include "motion/path.h"
#include "motion/tcp.h"
#include "motion_rig.h"
#include "suite.h"

typedef long double real;

static void real_vec(vec3 v, real out[3])
{
	out[0] = v.x;
	out[1] = v.y;
	out[2] = v.z;
}

/* Turns p about the joint, by Rodrigues' formula. */
static void real_turn(const struct joint *joint, real angle, real p[3])
{
	real d[3], l[3], r[3], along = 0, c = cosl(angle), s = sinl(angle);

	real_vec(joint->direction, d);
	real_vec(joint->location, l);
	for (int i = 0; i < 3; i++) {
		r[i] = p[i] - l[i];
		along += d[i] * r[i];
	}
	for (int i = 0; i < 3; i++) {
		int j = (i + 1) % 3, k = (i + 2) % 3;

		p[i] = l[i] + c * r[i] + s * (d[j] * r[k] - d[k] * r[j]) + (1 - c) * along * d[i];
	}
}

static void real_chain(const struct chain *chain, const real q[SLOT_COUNT], real p[3])
{
	for (size_t k = chain->count; k-- > 0;)
		real_turn(&chain->joints[k], q[chain->joints[k].slot], p);
}

static real determinant(real a[3], real b[3], real c[3])
{
	return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
	       a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/* X Y Z of the machine for the controller position p, by the formula in tcp.h and Cramer's rule. */
static void real_to_machine(const struct tcp *tcp, const real p[SLOT_COUNT], real out[3])
{
	real zero[SLOT_COUNT], columns[3][3], at[3], tip[3], others[3] = {0, 0, 0}, whole;

	real_vec(tcp->matrix.x, columns[0]);
	real_vec(tcp->matrix.y, columns[1]);
	real_vec(tcp->matrix.z, columns[2]);
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		real other[3];

		zero[slot] = tcp->state.rotary_zero.v[slot];
		real_vec(tcp->others[slot], other);
		for (int i = 0; i < 3; i++)
			others[i] += p[slot] * other[i];
	}
	real_vec(vec3_mad(tcp->tip, -tcp->state.length, (vec3){0, 0, -1}), at);
	real_chain(&tcp->head, zero, at);
	for (int i = 0; i < 3; i++)
		at[i] += others[i] + p[0] * columns[0][i] + p[1] * columns[1][i] + p[2] * columns[2][i];
	/* T(theta0)^-1: the outermost turn is reversed first. */
	for (size_t k = 0; k < tcp->table.count; k++)
		real_turn(&tcp->table.joints[k], -zero[tcp->table.joints[k].slot], at);
	real_chain(&tcp->table, p, at);
	real_vec(tcp->tip, tip);
	real_chain(&tcp->head, p, tip);
	for (int i = 0; i < 3; i++)
		at[i] -= tip[i] + others[i];
	whole = determinant(columns[0], columns[1], columns[2]);
	out[0] = determinant(at, columns[1], columns[2]) / whole;
	out[1] = determinant(columns[0], at, columns[2]) / whole;
	out[2] = determinant(columns[0], columns[1], at) / whole;
}

/* The controller's arc in X and Y, from its definition. */
static void real_arc(const struct path *path, real u, real p[SLOT_COUNT])
{
	real cx = path->arc.centre.x, cy = path->arc.centre.y, x = path->start.v[0] - cx, y = path->start.v[1] - cy;
	real c = cosl(path->arc.sweep * u), s = sinl(path->arc.sweep * u);

	p[0] = cx + c * x - s * y;
	p[1] = cy + s * x + c * y;
}

static void real_position(const struct path *path, real u, real out[3])
{
	real p[SLOT_COUNT];

	for (int slot = 0; slot < SLOT_COUNT; slot++)
		p[slot] = path->start.v[slot] + u * ((real)path->end.v[slot] - path->start.v[slot]);
	if (path->circular)
		real_arc(path, u, p);
	real_to_machine(path->tcp, p, out);
}

static double worst_ratio(const struct path *path, double u0, double u1, int samples)
{
	axis_values q0 = path_position(path, u0), q1 = path_position(path, u1);
	axis_values bound = path_chord_error(path, u0, u1);
	double worst = 0;

	for (int k = 0; k <= samples; k++) {
		real s = (real)k / samples, at[3];

		real_position(path, u0 + s * ((real)u1 - u0), at);
		for (int slot = 0; slot < 3; slot++) {
			real off = fabsl(at[slot] - ((1 - s) * q0.v[slot] + s * q1.v[slot]));

			worst = fmax(worst, (double)(off / bound.v[slot]));
		}
	}
	return worst;
}

/* The largest ratio of a second difference within [u0, u1], which is a mean of the second derivative, to its bound. */
static double worst_bend(const struct path *path, double u0, double u1, int samples)
{
	axis_values bound = path_second_derivative(path, u0, u1);
	real step = ((real)u1 - u0) / 500, rounding = 1e-15L / (step * step);
	double worst = 0;

	for (int k = 0; k <= samples; k++) {
		real u = u0 + step + k * (u1 - u0 - 2 * step) / samples, before[3], at[3], after[3];

		real_position(path, u - step, before);
		real_position(path, u, at);
		real_position(path, u + step, after);
		for (int slot = 0; slot < 3; slot++) {
			real bend = fabsl(before[slot] - 2 * at[slot] + after[slot]) / (step * step);

			worst = fmax(worst, (double)((bend - rounding) / (bound.v[slot] + rounding)));
		}
	}
	return worst;
}

/* A move of random size: sometimes of the tip alone, of the rotary axes alone, or along an arc. */
static struct path random_move(const struct machine *machine, const struct tcp *tcp, uint64_t *random)
{
	struct path path = {.kind = PATH_TCP, .tcp = tcp, .start = rig_position(machine, random)};
	double linear = exp(rig_random(random, -4, 6)), rotary = exp(rig_random(random, -7, 2));

	path.end = path.start;
	for (size_t i = 0; i < machine->axis_count; i++) {
		double size = machine->axes[i].rotary ? rotary : linear;

		if (rig_pick(random, 4))
			path.end.v[machine->axes[i].slot] += rig_random(random, -size, size);
	}
	path.circular = rig_pick(random, 4) == 0;
	if (path.circular) {
		double angle = rig_random(random, -4, 4), x = rig_random(random, -50, 50), y = 20;
		vec3 start = {path.start.v[SLOT_X], path.start.v[SLOT_Y], path.start.v[SLOT_Z]};

		path.arc = (struct canon_arc){{start.x - x, start.y - y, start.z}, {0, 0, 1}, angle};
		path.end.v[SLOT_X] = start.x - x + cos(angle) * x - sin(angle) * y;
		path.end.v[SLOT_Y] = start.y - y + sin(angle) * x + cos(angle) * y;
	}
	return path;
}

START_TEST(chord_bound_holds_and_is_tight)
{
	uint64_t random = 31337;
	double worst[RIG_FAMILIES] = {0};

	for (int i = 0; i < 45000; i++) {
		enum rig_family family = (enum rig_family)(i % RIG_FAMILIES);
		struct machine machine = rig_random_machine(&random, family);
		struct kinematics_tcp state = rig_tcp_state(&machine, &random);
		struct tcp tcp = rig_tcp(&machine, &state);
		struct path path = random_move(&machine, &tcp, &random);
		double h = exp(rig_random(&random, -5, 0)), u0 = rig_random(&random, 0, 1 - h);
		double ratio = worst_ratio(&path, u0, u0 + h, 16);

		ck_assert_msg(ratio <= 1, "case %d: %.17g times the bound over %g", i, ratio, h);
		worst[family] = fmax(worst[family], ratio);
	}
	for (int i = 0; i < RIG_FAMILIES; i++)
		printf("tcp: family %d: largest deviation / bound %.6f\n", i, worst[i]);
	ck_assert_double_gt(worst[RIG_C_TABLE], 0.9);
	ck_assert_double_gt(worst[RIG_B_HEAD], 0.9);
}
END_TEST

/*
 * The chord averages. A bound that is too small somewhere in the interval is visible in the second derivative itself:
 * for tips that pass near an axis, or swing far, in the middle.
 */
START_TEST(second_derivative_bound_holds)
{
	uint64_t random = 271828;
	double worst = 0;

	for (int i = 0; i < 45000; i++) {
		struct machine machine = rig_random_machine(&random, (enum rig_family)(i % RIG_FAMILIES));
		struct kinematics_tcp state = rig_tcp_state(&machine, &random);
		struct tcp tcp = rig_tcp(&machine, &state);
		struct path path = random_move(&machine, &tcp, &random);
		double h = exp(rig_random(&random, -3, 0)), u0 = rig_random(&random, 0, 1 - h), ratio;

		ratio = worst_bend(&path, u0, u0 + h, 4);
		ck_assert_msg(ratio <= 1, "case %d: %.17g times the bound over %g", i, ratio, h);
		worst = fmax(worst, ratio);
	}
	printf("tcp: largest second derivative / bound %.6f\n", worst);
}
END_TEST

/* An axis along which no rotary axis moves the tip has no chord error: Z over a C table. */
START_TEST(an_axis_along_the_turn_is_exact)
{
	uint64_t random = 5;

	for (int i = 0; i < 100; i++) {
		struct machine machine = rig_random_machine(&random, RIG_C_TABLE);
		struct kinematics_tcp state = rig_tcp_state(&machine, &random);
		struct tcp tcp = rig_tcp(&machine, &state);
		struct path path = random_move(&machine, &tcp, &random);

		path.circular = false;
		ck_assert_double_lt(path_chord_error(&path, 0, 1).v[SLOT_Z], 1e-9);
	}
}
END_TEST

START_TEST(rounding_is_inside)
{
	uint64_t random = 8;
	double worst = 0;

	for (int i = 0; i < 36000; i++) {
		struct machine machine = rig_random_machine(&random, (enum rig_family)(i % RIG_FAMILIES));
		struct kinematics_tcp state = rig_tcp_state(&machine, &random);
		struct tcp tcp = rig_tcp(&machine, &state);
		struct path path = random_move(&machine, &tcp, &random);
		double u0 = rig_random(&random, 0, 1), ratio = worst_ratio(&path, u0, u0 + 1e-12, 2);

		ck_assert_msg(ratio <= 1, "case %d: %.17g times the bound", i, ratio);
		worst = fmax(worst, ratio);
	}
	printf("tcp: largest rounding / bound %.6f\n", worst);
	ck_assert_double_lt(worst, 0.1);
}
END_TEST

int main(void)
{
	TCase *tests = tcase_create("tcp_bound");

	tcase_add_test(tests, chord_bound_holds_and_is_tight);
	tcase_add_test(tests, second_derivative_bound_holds);
	tcase_add_test(tests, an_axis_along_the_turn_is_exact);
	tcase_add_test(tests, rounding_is_inside);
	return run_suite("tcp_bound", tests);
}
