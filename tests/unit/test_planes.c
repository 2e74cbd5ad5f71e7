/*
 * test_planes.c - programs with tilted planes and TCP, from the text to the machine axes, on five kinematics: formulas
 * of the test itself compute tool and workpiece from the axes, and must give what the program says.
 */
#include <stdarg.h>

#include "base/strbuf.h"
#include "control/dialects.h"
#include "machine/setup.h"
#include "motion/motion.h"
#include "motion_rig.h"
#include "suite.h"

#define GAUGE 520.0
#define LENGTH 87.5
#define LINES 32

/* ----------------------------------------------------- the test's kinematics */

/* Plain rotations of plain numbers, without geom/. */
struct v {
	double x, y, z;
};

static struct v add(struct v a, struct v b)
{
	return (struct v){a.x + b.x, a.y + b.y, a.z + b.z};
}

static struct v less(struct v a, struct v b)
{
	return (struct v){a.x - b.x, a.y - b.y, a.z - b.z};
}

static double distance(struct v a, struct v b)
{
	return sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z));
}

static struct v about_x(double degrees_, struct v p)
{
	double c = cos(radians(degrees_)), s = sin(radians(degrees_));

	return (struct v){p.x, c * p.y - s * p.z, s * p.y + c * p.z};
}

static struct v about_y(double degrees_, struct v p)
{
	double c = cos(radians(degrees_)), s = sin(radians(degrees_));

	return (struct v){c * p.x + s * p.z, p.y, c * p.z - s * p.x};
}

static struct v about_z(double degrees_, struct v p)
{
	double c = cos(radians(degrees_)), s = sin(radians(degrees_));

	return (struct v){c * p.x - s * p.y, s * p.x + c * p.y, p.z};
}

/* A turn about (0, 1, 1): to the frame where this is Z, and back. */
static struct v about_yz(double degrees_, struct v p)
{
	return about_x(-45, about_z(degrees_, about_x(45, p)));
}

/* Fanuc B-64484EN, tilted working plane indexing: about Z by I, about X' by J, about Z'' by K. */
static struct v euler(const double ijk[3], struct v p)
{
	return about_z(ijk[0], about_x(ijk[1], about_z(ijk[2], p)));
}

enum kind { AC_TABLE, BC_TABLE, CB_HEAD, B_HEAD_C_TABLE, NUTATING_HEAD, KINDS };

/* Points on the axes: of A or B, and of C. */
static const struct v tilt_at = {12, -7, 150}, turn_at = {-31, 22, 160};

static struct v tilted(enum kind kind, double angle, struct v p)
{
	p = less(p, tilt_at);
	p = kind == AC_TABLE ? about_x(-angle, p)
	    : kind == BC_TABLE ? about_y(-angle, p)
	    : kind == NUTATING_HEAD ? about_yz(angle, p)
				    : about_y(angle, p);
	return add(p, tilt_at);
}

static struct v untilted(enum kind kind, double angle, struct v p)
{
	return tilted(kind, -angle, p);
}

static struct v turned(double angle, struct v p)
{
	return add(about_z(angle, less(p, turn_at)), turn_at);
}

/*
 * A point of the spindle at the zero pose, moved to the axis positions q, in the frame of the workpiece at the zero
 * pose.
 */
static struct v in_workpiece(enum kind kind, const double q[5], struct v p)
{
	if (kind == CB_HEAD || kind == NUTATING_HEAD)
		p = turned(q[4], tilted(kind, q[3], p));
	else if (kind == B_HEAD_C_TABLE)
		p = tilted(kind, q[3], p);
	p = add(p, (struct v){q[0], q[1], q[2]});
	if (kind == AC_TABLE || kind == BC_TABLE)
		return turned(q[4], untilted(kind, q[3], p));
	return kind == B_HEAD_C_TABLE ? turned(q[4], p) : p;
}

static struct v tip(enum kind kind, const double q[5], double length)
{
	return in_workpiece(kind, q, (struct v){0, 0, GAUGE - length});
}

static struct v tool_direction(enum kind kind, const double q[5])
{
	return less(in_workpiece(kind, q, (struct v){0, 0, 1}), in_workpiece(kind, q, (struct v){0, 0, 0}));
}

static struct machine machine_of(enum kind kind)
{
	bool table = kind == AC_TABLE || kind == BC_TABLE, head = kind == CB_HEAD || kind == NUTATING_HEAD;
	vec3 at = {tilt_at.x, tilt_at.y, tilt_at.z}, c_at = {turn_at.x, turn_at.y, turn_at.z};
	struct machine machine = rig_three_axes();
	int slot = kind == AC_TABLE ? SLOT_A : SLOT_B;

	machine.controller.dialect = dialect_row_find("fanuc");
	machine.controller.length_moves = ANSWER_NO;
	machine.controller.power_on_units = POWER_ON_MM;
	machine.controller.power_on_distance = POWER_ON_ABSOLUTE;
	machine.controller.power_on_plane = POWER_ON_XY;
	machine.controller.least_input = 1;
	if (table) {
		vec3 direction = kind == AC_TABLE ? rig_minus_x : (vec3){0, -1, 0};

		machine.workholding.link = rig_axis(&machine, slot, 0, direction, at);
		machine.workholding.link = rig_axis(&machine, SLOT_C, machine.workholding.link, rig_minus_z, c_at);
		return machine;
	}
	if (head)
		machine.spindle.link = rig_axis(&machine, SLOT_C, machine.spindle.link, rig_z, c_at);
	machine.spindle.link = rig_axis(&machine, slot, machine.spindle.link,
					kind == NUTATING_HEAD ? (vec3){0, 1, 1} : rig_y, at);
	if (!head)
		machine.workholding.link = rig_axis(&machine, SLOT_C, 0, rig_minus_z, c_at);
	return machine;
}

/* -------------------------------------------------------------- a program */

struct run {
	enum kind kind;
	struct strbuf text;
	struct rig_messages messages;
	double now[5];
	double ends[LINES][5];	/* the positions of the axes after each line */
	int lines;
	/* Each step of the line `watch` is passed to the callback. */
	int watch;
	void (*watcher)(const struct run *run, double u, const double q[5]);
	const void *told;
};

static void read_axes(enum kind kind, const axis_values *values, double q[5])
{
	q[0] = values->v[SLOT_X];
	q[1] = values->v[SLOT_Y];
	q[2] = values->v[SLOT_Z];
	q[3] = degrees(values->v[kind == AC_TABLE ? SLOT_A : SLOT_B]);
	q[4] = degrees(values->v[SLOT_C]);
}

static void on_step(struct run *run, const struct motion_step *step)
{
	read_axes(run->kind, &step->span.q1, run->now);
	if (run->watcher && step->line == run->watch)
		run->watcher(run, step->span.u1, run->now);
}

static bool on_event(void *context, const struct motion_event *event)
{
	struct run *run = context;

	if (event->kind == MOTION_STEP)
		on_step(run, &event->of.step);
	if (event->kind == MOTION_BLOCK) {
		ck_assert_int_lt(event->of.block.line, LINES);
		memcpy(run->ends[event->of.block.line], run->now, sizeof(run->now));
	}
	return true;
}

static void start(struct run *run, enum kind kind)
{
	*run = (struct run){.kind = kind};
	rig_listen(&run->messages);
}

/* Adds a line to the program. The value is its number. */
static int say(struct run *run, const char *format, ...)
{
	char line[256];
	va_list arguments;

	va_start(arguments, format);
	vsnprintf(line, sizeof(line), format, arguments);
	va_end(arguments);
	strbuf_addf(&run->text, "%s\n", line);
	return ++run->lines;
}

static bool carry_out(struct run *run, const struct machine *machine)
{
	struct length_offset lengths[] = {{1, LENGTH}};
	struct setup setup = {.lengths = lengths, .length_count = 1};
	struct motion_options options = {.flatness = 0.01};
	struct motion_sink sink = {run, on_event};
	struct motion_summary summary;
	FILE *in = fmemopen(run->text.text, strlen(run->text.text), "r");
	bool good;

	ck_assert_ptr_nonnull(in);
	good = motion_run(machine, &setup, &options, in, "p.nc", &sink, &run->messages.diag, &summary);
	fclose(in);
	return good;
}

static void expect_near(struct v is, struct v wanted, double tolerance, const struct run *run, int line)
{
	ck_assert_msg(distance(is, wanted) <= tolerance, "kind %d, line %d: (%.9g %.9g %.9g), not (%.9g %.9g %.9g)\n%s",
		      run->kind, line, is.x, is.y, is.z, wanted.x, wanted.y, wanted.z, run->text.text);
}

/* A random number with six decimals, as in programs. */
static double number(uint64_t *random, double least, double most)
{
	return round(rig_random(random, least, most) * 1e6) / 1e6;
}

static struct v point(uint64_t *random, double size)
{
	return (struct v){number(random, -size, size), number(random, -size, size), number(random, -size, size)};
}

/* ------------------------------------------------------------ G53.1 alone */

/* The two solutions, in degrees: the tool tilts by J toward the direction I - 90 in the X Y plane. */
static void closed_form(enum kind kind, const double ijk[3], double pairs[2][2])
{
	double i = ijk[0], j = ijk[1];

	for (int k = 0; k < 2; k++) {
		double sign = k ? -1 : 1;

		pairs[k][0] = sign * j;
		pairs[k][1] = kind == AC_TABLE ? i + 180 * k : i - 90 + 180 * k;
		if (kind == NUTATING_HEAD) {
			/* z rotated about (0, 1, 1) by b: (sin b / sqrt 2, (1 - cos b) / 2, (1 + cos b) / 2). */
			double b = sign * acos(2 * cos(radians(j)) - 1);

			pairs[k][0] = degrees(b);
			pairs[k][1] = i - 90 - degrees(atan2((1 - cos(b)) / 2, sin(b) / sqrt(2)));
		}
	}
}

/* The shortest distance to the angle, with whole turns added or removed. */
static double shortest_way(double angle, double here)
{
	return fabs(remainder(angle - here, 360));
}

/* B-63534EN, "Angle of rotation axis": the carrying axis decides, or the table before the head; C is carried. */
static int preferred(enum kind kind, double pairs[2][2], const double here[2])
{
	int first = kind == AC_TABLE || kind == BC_TABLE ? 0 : 1;

	return shortest_way(pairs[0][first], here[first]) < shortest_way(pairs[1][first], here[first]) ? 0 : 1;
}

static char tilt_letter(enum kind kind)
{
	return kind == AC_TABLE ? 'A' : 'B';
}

START_TEST(both_solutions)
{
	uint64_t random = 77;

	for (int n = 0; n < 600; n++) {
		enum kind kind = (enum kind)(n % KINDS);
		double ijk[3] = {number(&random, -200, 200), number(&random, 1, 85), number(&random, -200, 200)};
		double here[2] = {number(&random, -80, 80), number(&random, -500, 500)}, pairs[2][2];
		int choice;

		closed_form(kind, ijk, pairs);
		choice = preferred(kind, pairs, here);
		for (int other = 0; other < 2; other++) {
			struct machine machine = machine_of(kind);
			struct axis *axis = rig_find(&machine, kind == AC_TABLE ? SLOT_A : SLOT_B);
			int wanted = other ? 1 - choice : choice, line;
			struct run run;

			/* The limits exclude the preferred solution. */
			if (other) {
				axis->limit_min = wanted ? -PI : 0;
				axis->limit_max = wanted ? 0 : PI;
			}
			start(&run, kind);
			say(&run, "G0 X10. Y20. Z30. %c%.6f C%.6f", tilt_letter(kind), here[0], here[1]);
			say(&run, "G68.2 X1. Y2. Z3. I%.6f J%.6f K%.6f", ijk[0], ijk[1], ijk[2]);
			line = say(&run, "G53.1");
			ck_assert_msg(carry_out(&run, &machine), "%s", run.messages.text);
			expect_near(tool_direction(kind, run.ends[line]), euler(ijk, (struct v){0, 0, 1}), 1e-9, &run,
				    line);
			ck_assert_double_le(fabs(remainder(run.ends[line][3] - pairs[wanted][0], 360)), 1e-7);
			ck_assert_double_le(fabs(remainder(run.ends[line][4] - pairs[wanted][1], 360)), 1e-7);
			/* The linear axes do not move. */
			expect_near((struct v){run.ends[line][0], run.ends[line][1], run.ends[line][2]},
				    (struct v){10, 20, 30}, 1e-9, &run, line);
			strbuf_release(&run.text);
		}
	}
}
END_TEST

/* ------------------------------------------------------- work in the plane */

struct plane {
	struct v offset, origin;
	double ijk[3];
	enum kind kind;
	double tilt, turn;	/* tcp_zero: coordinates are meant for these positions of the rotary axes */
};

/* The point of the plane in the workpiece: offset, origin, rotated by Euler's angles; the spindle must be there. */
static struct v on_plane(const struct plane *plane, struct v p)
{
	struct v at = add(add(plane->offset, plane->origin), euler(plane->ijk, p));

	return tip(plane->kind, (double[]){at.x, at.y, at.z, plane->tilt, plane->turn}, 0);
}

/* Checks every point of an arc about (20, 0) from (40, 0), at Z5 of the plane. */
static void watch_arc(const struct run *run, double u, const double q[5])
{
	const struct plane *plane = run->told;
	double angle = -1.5 * PI * u;
	struct v wanted = {20 + 20 * cos(angle), 20 * sin(angle), 5};

	ck_assert_double_le(distance(tip(run->kind, q, LENGTH), on_plane(plane, wanted)), 1e-7);
}

START_TEST(work_in_the_plane)
{
	uint64_t random = 78;

	for (int n = 0; n < 200; n++) {
		struct plane plane = {.offset = point(&random, 200), .origin = point(&random, 50)};
		struct v first = point(&random, 60), second = point(&random, 60);
		enum kind kind = (enum kind)(n % KINDS);
		struct machine machine = machine_of(kind);
		int bare, long_, next, up, hole, machine_z, again, off;
		struct run run;

		for (int k = 0; k < 3; k++)
			plane.ijk[k] = k == 1 ? number(&random, 1, 85) : number(&random, -200, 200);
		machine.controller.tcp_zero_offset = n % 2;
		plane.kind = kind;
		plane.tilt = n % 2 ? number(&random, -30, 30) : 0;
		plane.turn = n % 2 ? number(&random, -90, 90) : 0;
		start(&run, kind);
		say(&run, "G10 L2 P1 X%.6f Y%.6f Z%.6f %c%.6f C%.6f", plane.offset.x, plane.offset.y, plane.offset.z,
		    tilt_letter(kind), plane.tilt, plane.turn);
		say(&run, "G54 G0 X0. Y0. Z300. %c7. C%.6f F500.", tilt_letter(kind), number(&random, -170, 170));
		say(&run, "G68.2 X%.6f Y%.6f Z%.6f I%.6f J%.6f K%.6f", plane.origin.x, plane.origin.y, plane.origin.z,
		    plane.ijk[0], plane.ijk[1], plane.ijk[2]);
		say(&run, "G53.1");
		bare = say(&run, "X%.6f Y%.6f Z%.6f", first.x, first.y, first.z);
		long_ = say(&run, "G43 H1 X%.6f Y%.6f Z%.6f", first.x, first.y, first.z);
		next = say(&run, "G1 X%.6f Y%.6f Z%.6f", second.x, second.y, second.z);
		up = say(&run, "G91 G0 Z11.");
		say(&run, "G90 X40. Y0. Z5.");
		run.watch = say(&run, "G2 X20. Y20. I-20. J0.");
		hole = say(&run, "G99 G81 X3. Y4. Z-6. R2.");
		say(&run, "G80");
		machine_z = say(&run, "G0 G53 Z290.");
		again = say(&run, "G43 H1 X1. Y2. Z3.");
		off = say(&run, "G69 G49");
		run.watcher = watch_arc;
		run.told = &plane;
		ck_assert_msg(carry_out(&run, &machine), "%s", run.messages.text);
		expect_near(tip(kind, run.ends[bare], 0), on_plane(&plane, first), 1e-7, &run, bare);
		expect_near(tip(kind, run.ends[long_], LENGTH), on_plane(&plane, first), 1e-7, &run, long_);
		expect_near(tip(kind, run.ends[next], LENGTH), on_plane(&plane, second), 1e-7, &run, next);
		second.z += 11;
		expect_near(tip(kind, run.ends[up], LENGTH), on_plane(&plane, second), 1e-7, &run, up);
		expect_near(tip(kind, run.ends[hole], LENGTH), on_plane(&plane, (struct v){3, 4, 2}), 1e-7, &run, hole);
		/* Only Z moves, to its machine position. */
		expect_near((struct v){run.ends[machine_z][0], run.ends[machine_z][1], run.ends[machine_z][2]},
			    (struct v){run.ends[hole][0], run.ends[hole][1], 290}, 1e-7, &run, machine_z);
		expect_near(tip(kind, run.ends[again], LENGTH), on_plane(&plane, (struct v){1, 2, 3}), 1e-7, &run,
			    again);
		ck_assert_mem_eq(run.ends[off], run.ends[again], sizeof(run.ends[off]));
		strbuf_release(&run.text);
	}
}
END_TEST

/* -------------------------------------------------------------------- TCP */

struct way {
	struct v from, to;	/* in the workpiece */
};

/* The tip moves on a straight line in the workpiece, however the axes turn. */
static void watch_way(const struct run *run, double u, const double q[5])
{
	const struct way *way = run->told;
	struct v wanted = {way->from.x + u * (way->to.x - way->from.x), way->from.y + u * (way->to.y - way->from.y),
			   way->from.z + u * (way->to.z - way->from.z)};

	ck_assert_double_le(distance(tip(run->kind, q, LENGTH), wanted), 1e-7);
}

/* Fanuc B-64484EN, tool center point control (G43.4); Haas mill operator's manual, "G234 Tool Center Point Control". */
START_TEST(tool_centre_point)
{
	uint64_t random = 79;

	for (int n = 0; n < 200; n++) {
		struct v offset = point(&random, 200), first = point(&random, 60), second = point(&random, 60);
		struct v from = add(offset, first), to = add(offset, second);
		enum kind kind = (enum kind)(n % KINDS);
		struct machine machine = machine_of(kind);
		bool haas = n % 2, at_offset = n % 4 > 1;
		/* tcp_zero: coordinates are meant for the rotary axes at their offsets. */
		double tilt = at_offset ? number(&random, -30, 30) : 0, turn = at_offset ? number(&random, -90, 90) : 0;
		struct way way;
		struct run run;
		int begin, off;

		if (haas)
			machine.controller.dialect = dialect_row_find("haas");
		machine.controller.tcp_zero_offset = at_offset;
		way.from = tip(kind, (double[]){from.x, from.y, from.z, tilt, turn}, 0);
		way.to = tip(kind, (double[]){to.x, to.y, to.z, tilt, turn}, 0);
		start(&run, kind);
		say(&run, "G10 L2 P1 X%.6f Y%.6f Z%.6f %c%.6f C%.6f", offset.x, offset.y, offset.z, tilt_letter(kind),
		    tilt, turn);
		say(&run, "G54 G0 X0. Y0. Z300. F900.");
		begin = say(&run, "%s H1 X%.6f Y%.6f Z%.6f %c%.6f C%.6f", haas ? "G234" : "G43.4", first.x, first.y,
			    first.z, tilt_letter(kind), number(&random, -80, 80), number(&random, -300, 300));
		run.watch = say(&run, "G1 X%.6f Y%.6f Z%.6f %c%.6f C%.6f", second.x, second.y, second.z,
				tilt_letter(kind), number(&random, -80, 80), number(&random, -300, 300));
		off = say(&run, "G49");
		run.watcher = watch_way;
		run.told = &way;
		ck_assert_msg(carry_out(&run, &machine), "%s", run.messages.text);
		expect_near(tip(kind, run.ends[begin], LENGTH), way.from, 1e-7, &run, begin);
		expect_near(tip(kind, run.ends[off], LENGTH), way.to, 1e-7, &run, off);
		strbuf_release(&run.text);
	}
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("planes");

	tcase_add_test(tcase, both_solutions);
	tcase_add_test(tcase, work_in_the_plane);
	tcase_add_test(tcase, tool_centre_point);
	return run_suite("planes", tcase);
}
