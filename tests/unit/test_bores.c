/*
 * test_bores.c - bores that shift the tool aside in an unknown direction (G76, G87, Haas G77), from text to steps:
 * whichever way a control chooses, the steps cover every position of the tool. The same holds for circular pockets
 * (Haas G12, G13).
 */

#include "base/strbuf.h"
#include "control/dialects.h"
#include "machine/setup.h"
#include "motion/motion.h"
#include "motion_rig.h"
#include "suite.h"

#define STEPS 3000
#define ROUNDING 1e-9

struct run {
	struct motion_step steps[STEPS];	/* of the cycle's line */
	int count;
	struct rig_messages messages;
};

static bool on_event(void *context, const struct motion_event *event)
{
	struct run *run = context;

	if (event->kind == MOTION_STEP && event->of.step.line == 3) {
		ck_assert_int_lt(run->count, STEPS);
		run->steps[run->count++] = event->of.step;
	}
	return true;
}

static bool carry_out(struct run *run, const char *dialect, const char *text)
{
	struct machine machine = rig_three_axes();
	struct setup setup = {0};
	struct motion_options options = {.flatness = 0.01};
	struct motion_sink sink = {run, on_event};
	struct motion_summary summary;
	FILE *in = fmemopen((char *)text, strlen(text), "r");
	bool good;

	machine.controller.dialect = dialect_row_find(dialect);
	machine.controller.cycle_axis = CYCLE_AXIS_ACROSS;
	rig_listen(&run->messages);
	ck_assert_ptr_nonnull(in);
	good = motion_run(&machine, &setup, &options, in, "p.nc", &sink, &run->messages.diag, &summary);
	fclose(in);
	return good;
}

/* Is there a place on the step with the point in its box? */
static bool covers(const struct motion_step *step, const double p[3], double slack)
{
	double least = 0, most = 1;

	for (int i = 0; i < 3; i++) {
		double from = step->span.q0.v[i], way = step->span.q1.v[i] - from;
		double low = p[i] - step->tolerance.v[i] - slack - from;
		double high = p[i] + step->tolerance.v[i] + slack - from;

		if (fabs(way) < 1e-12) {
			if (low > 0 || high < 0)
				return false;
			continue;
		}
		least = fmax(least, way > 0 ? low / way : high / way);
		most = fmin(most, way > 0 ? high / way : low / way);
	}
	return least <= most;
}

/* A cycle, and one of the ways in which a control may carry it out. */
struct bore {
	int plane;	/* 17, 18, 19 */
	double over[2];	/* of the axis of the hole, in the plane's axes */
	double level, r, z, q, turn;	/* degrees of G68 */
	bool to_r;	/* G99 */
	double aside[2];
};

/* In the program's coordinates, turned by G68 about the origin in the plane. */
static void place(const struct bore *bore, bool aside, double height, double p[3])
{
	static const int axes[3][3] = {{0, 1, 2}, {2, 0, 1}, {1, 2, 0}};
	const int *axis = axes[bore->plane - 17];
	double a = bore->over[0] + (aside ? bore->aside[0] : 0), b = bore->over[1] + (aside ? bore->aside[1] : 0);
	double c = cos(radians(bore->turn)), s = sin(radians(bore->turn));

	p[axis[0]] = c * a - s * b;
	p[axis[1]] = s * a + c * b;
	p[axis[2]] = height;
}

static void expect_covered(const struct run *run, const struct bore *bore, const double corners[][2], int count,
			   const char *text)
{
	for (int i = 0; i + 1 < count; i++) {
		double from[3], to[3];

		place(bore, corners[i][0] > 0, corners[i][1], from);
		place(bore, corners[i + 1][0] > 0, corners[i + 1][1], to);
		for (int k = 0; k <= 10; k++) {
			double p[3];
			bool found = false;

			for (int j = 0; j < 3; j++)
				p[j] = from[j] + (to[j] - from[j]) * k / 10;
			for (int j = 0; j < run->count && !found; j++)
				found = covers(&run->steps[j], p, ROUNDING);
			ck_assert_msg(found, "(%.9g %.9g %.9g) is not covered, leg %d of\n%s", p[0], p[1], p[2], i, text);
		}
	}
}

static void choose(struct bore *bore, uint64_t *random, bool back)
{
	double angle = rig_random(random, 0, 360), radius;

	*bore = (struct bore){.plane = 17 + rig_pick(random, 3), .level = 50, .to_r = rig_pick(random, 2)};
	bore->over[0] = round(rig_random(random, -40, 40) * 1e3) / 1e3;
	bore->over[1] = round(rig_random(random, -40, 40) * 1e3) / 1e3;
	bore->r = round(rig_random(random, -20, 20) * 1e3) / 1e3;
	bore->z = bore->r + (back ? 1 : -1) * round(rig_random(random, 1, 20) * 1e3) / 1e3;
	/* In some cases R and Z are exchanged. */
	if (rig_pick(random, 4) == 0)
		bore->z = 2 * bore->r - bore->z;
	bore->q = round(rig_random(random, 0.05, 5) * 1e3) / 1e3;
	bore->turn = rig_pick(random, 2) && bore->plane == 17 ? round(rig_random(random, 5, 355)) : 0;
	/* In most cases along an axis and as far as Q says. */
	if (rig_pick(random, 2))
		angle = 90 * rig_pick(random, 4);
	radius = rig_pick(random, 4) ? bore->q : rig_random(random, 0, bore->q);
	bore->aside[0] = radius * cos(radians(angle));
	bore->aside[1] = radius * sin(radians(angle));
}

static void write_program(const struct bore *bore, const char *code, struct strbuf *text)
{
	static const char *const letters[] = {"XYZ", "ZXY", "YZX"};
	const char *letter = letters[bore->plane - 17];

	strbuf_addf(text, "G%d G21 G90 G94 F100. ", bore->plane);
	if (bore->turn > 0)
		strbuf_addf(text, "G68 X0. Y0. R%.3f", bore->turn);
	strbuf_addf(text, "\nG0 %c%.3f\nG9%d G%s %c%.3f %c%.3f %c%.3f R%.3f Q%.3f\nM30\n", letter[2], bore->level,
		    bore->to_r ? 9 : 8, code, letter[0], bore->over[0], letter[1], bore->over[1], letter[2], bore->z, bore->r,
		    bore->q);
}

/*
 * Fanuc B-64484EN, "Fine Boring Cycle (G76)", "Back Boring Cycle (G87)"; Haas mill operator's manual, "G76 Fine Boring
 * Canned Cycle", "G77 Back Bore Canned Cycle". Members of the set at random: none outside, and the set is no larger.
 */
START_TEST(any_direction)
{
	static const struct {
		const char *dialect, *code;
		bool back;
	} cycles[] = {{"fanuc", "76", false}, {"haas", "76", false}, {"fanuc", "87", true}, {"haas", "77", true}};
	uint64_t random = 77 + (uint64_t)_i;

	for (int trial = 0; trial < 500; trial++) {
		double clear, most = 0;
		struct strbuf text = {0};
		struct bore bore;
		static struct run run;
		bool back = cycles[_i].back;

		run.count = 0;
		choose(&bore, &random, back);
		clear = bore.to_r && !back ? bore.r : bore.level;
		write_program(&bore, cycles[_i].code, &text);
		ck_assert_msg(carry_out(&run, cycles[_i].dialect, text.text), "%s\n%s", run.messages.text, text.text);
		if (back) {
			const double out_from_z[][2] = {{0, bore.level}, {1, bore.level}, {1, bore.r}, {0, bore.r},
							{0, bore.z},     {1, bore.z},     {1, clear},  {0, clear}};
			const double out_from_r[][2] = {{0, bore.z}, {0, bore.r}, {1, bore.r}, {1, clear}};

			expect_covered(&run, &bore, out_from_z, 8, text.text);
			expect_covered(&run, &bore, out_from_r, 4, text.text);
		} else {
			const double way[][2] = {{0, bore.level}, {0, bore.r}, {0, bore.z},
						 {1, bore.z},     {1, clear},  {0, clear}};

			expect_covered(&run, &bore, way, 6, text.text);
		}
		for (int i = 0; i < run.count; i++)
			for (int k = 0; k < 3; k++)
				most = fmax(most, run.steps[i].tolerance.v[k]);
		ck_assert_double_eq_tol(most, bore.q, ROUNDING);
		strbuf_release(&text);
	}
}
END_TEST

/*
 * Haas mill operator's manual, "G12 Circular Pocket Milling CW / G13 Circular Pocket Milling CCW": places of the cylinder
 * at random, none outside what is proved, and that is not much larger.
 */
START_TEST(pocket)
{
	uint64_t random = 12;

	for (int trial = 0; trial < 40; trial++) {
		static struct run run;
		struct strbuf text = {0};
		double x = round(rig_random(&random, -20, 20)), y = round(rig_random(&random, -20, 20));
		double radius = round(rig_random(&random, 1, 25) * 100) / 100, top = 5, z = round(rig_random(&random, -20, 4));
		bool clockwise = rig_pick(&random, 2), deeper = rig_pick(&random, 2);

		run.count = 0;
		strbuf_addf(&text, "G17 G21 G90 G94 F100. G0 Z%.3f\nX%.3f Y%.3f\n", top, x, y);
		strbuf_addf(&text, deeper ? "G91 G%d I1. K%.3f Q1. Z%.3f L2\nM30\n" : "G90 G%d I%.3f Z%.3f\nM30\n",
			    clockwise ? 12 : 13, radius, deeper ? (z - top) / 2 : z);
		ck_assert_msg(carry_out(&run, "haas", text.text), "%s\n%s", run.messages.text, text.text);
		ck_assert_int_gt(run.count, 16);
		for (int i = 0; i < 300; i++) {
			double angle = rig_random(&random, 0, 2 * PI), part = sqrt(rig_random(&random, 0, 1));
			double p[3] = {x + part * radius * cos(angle), y + part * radius * sin(angle),
				       rig_random(&random, z, top)};
			bool found = false;

			for (int j = 0; j < run.count && !found; j++)
				found = covers(&run.steps[j], p, 0.011);
			ck_assert_msg(found, "(%.9g %.9g %.9g) is not covered by\n%s", p[0], p[1], p[2], text.text);
		}
		for (int j = 0; j < run.count; j++) {
			const struct motion_step *step = &run.steps[j];
			double far = hypot(step->span.q1.v[0] - x, step->span.q1.v[1] - y) +
				     hypot(step->tolerance.v[0], step->tolerance.v[1]);

			ck_assert_double_le(far, 1.03 * radius + 0.03);
			ck_assert_double_ge(step->span.q1.v[2] - step->tolerance.v[2], z - 0.03);
		}
		ck_assert_double_eq_tol(run.steps[run.count - 1].span.q1.v[2], z, 1e-9);
		strbuf_release(&text);
	}
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("bores");

	tcase_add_loop_test(tcase, any_direction, 0, 4);
	tcase_add_test(tcase, pocket);
	return run_suite("bores", tcase);
}
