/*
 * test_kinematics.c - doubts about the motions of a machine, against forward kinematics of the tool tip and the work.
 */
#include "machine/kinematics_check.h"

#include <math.h>

#include "machine/chain.h"
#include "machine/value_check.h"
#include "random.h"
#include "suite.h"

/*
 * Axes X Y Z A C, each with a link of its own. The axes in `tool` (bits) carry the spindle, in this order; the others
 * carry the work.
 */
static struct machine five_axes(unsigned tool)
{
	static const char *const names[] = {"X", "Y", "Z", "A", "C"};
	static const int slots[] = {SLOT_X, SLOT_Y, SLOT_Z, SLOT_A, SLOT_C};
	static const vec3 along[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {0, 0, 1}};
	struct machine machine = {.axis_count = 5};
	int ends[2] = {0, 0};

	for (int i = 0; i < 5; i++) {
		bool on_tool = tool >> i & 1;

		machine.axes[i] = (struct axis){
			.name = names[i], .slot = slots[i], .rotary = i > 2, .parent = ends[on_tool],
			.direction = vec3_scale(on_tool ? 1 : -1, along[i]), .limit_min = i > 2 ? -INFINITY : -500,
			.limit_max = i > 2 ? INFINITY : 500, .rate_max = 100,
			/*
			 * C is beside the spindle's line; on the line it would only turn the tool about itself when A
			 * is at 0.
			 */
			.location = {i == 4 ? 40 : 0, 0, 0},
		};
		ends[on_tool] = i + 1;
	}
	machine.spindle = (struct spindle){
		.present = true, .link = ends[1], .location = {0, 0, 300}, .direction = {0, 0, -1},
	};
	machine.workholding = (struct workholding){.present = true, .link = ends[0], .frame = xform_identity()};
	return machine;
}

static size_t count_by(void (*check)(const struct machine *, struct doubts *), const struct machine *machine,
		       enum doubt_kind kind)
{
	struct doubts doubts = {0};
	size_t found = 0;

	check(machine, &doubts);
	for (size_t i = 0; i < doubts.count; i++)
		found += doubts.items[i].kind == kind;
	doubts_release(&doubts);
	return found;
}

static size_t count(const struct machine *machine, enum doubt_kind kind)
{
	return count_by(kinematics_check, machine, kind);
}

static size_t count_values(const struct machine *machine, enum doubt_kind kind)
{
	return count_by(value_check, machine, kind);
}

static size_t count_all(const struct machine *machine)
{
	struct doubts doubts = {0};
	size_t found;

	kinematics_check(machine, &doubts);
	found = doubts.count;
	doubts_release(&doubts);
	return found;
}

/* The pose of the tool's link relative to the work. */
static xform relative(const struct machine *machine, const axis_values *q)
{
	xform tool = machine_pose(machine, machine->spindle.link, q);
	xform work = machine_pose(machine, machine->workholding.link, q);
	xform back = xform_inverse(&work);

	return xform_mul(&back, &tool);
}

/* For every assignment of axes to tool and work there is no doubt, and each direction is that of forward kinematics. */
START_TEST(all_arrangements)
{
	for (unsigned tool = 0; tool < 32; tool++) {
		struct machine machine = five_axes(tool);

		ck_assert_uint_eq(count_all(&machine), 0);
		for (size_t i = 0; i < machine.axis_count; i++) {
			const struct axis *axis = &machine.axes[i];
			vec3 said = kinematics_direction(&machine, axis), moved;
			axis_values q = {{0}};
			xform pose;

			q.v[axis->slot] = 1e-3;
			pose = relative(&machine, &q);
			if (axis->rotary) {
				/* A right-handed turn by 1e-3 about `said` moves the point r by 1e-3 said x r. */
				vec3 r = {0.3, 0.5, 0.7}, turned = mat3_apply(&pose.rotation, r);

				moved = vec3_scale(1e3, vec3_sub(turned, r));
				ck_assert_double_le(vec3_norm(vec3_sub(moved, vec3_cross(said, r))), 2e-3);
			} else {
				moved = vec3_scale(1e3, pose.translation);
				ck_assert_double_le(vec3_norm(vec3_sub(moved, said)), 1e-9);
			}
		}
	}
}
END_TEST

START_TEST(every_sign)
{
	for (unsigned tool = 0; tool < 32; tool++) {
		for (int i = 0; i < 5; i++) {
			struct machine machine = five_axes(tool);

			machine.axes[i].direction = vec3_scale(-1, machine.axes[i].direction);
			ck_assert_uint_eq(count(&machine, i > 2 ? DOUBT_ROTARY_SIGN : DOUBT_SIGN), 1);
			ck_assert_uint_eq(count(&machine, DOUBT_LEFT_HANDED), i < 3);
			ck_assert_uint_eq(count(&machine, DOUBT_SPINDLE_TOWARD), i == 2);
			machine.axes[i].checked = "the maker says so";
			ck_assert_uint_eq(count_all(&machine), 0);
		}
	}
}
END_TEST

START_TEST(letters_and_lines)
{
	struct machine machine = five_axes(7);
	const vec3 keep = machine.axes[0].direction;

	machine.axes[0].direction = machine.axes[1].direction;
	ck_assert_uint_eq(count(&machine, DOUBT_PARALLEL), 1);
	ck_assert_uint_eq(count(&machine, DOUBT_LETTER), 1);
	machine.axes[1].direction = keep;
	ck_assert_uint_eq(count(&machine, DOUBT_PARALLEL), 0);
	ck_assert_uint_eq(count(&machine, DOUBT_LETTER), 2);
	ck_assert_uint_eq(count(&machine, DOUBT_LEFT_HANDED), 1);

	/* U along X is usual. */
	machine = five_axes(7);
	machine.axes[1].name = "U";
	machine.axes[1].slot = SLOT_U;
	machine.axes[1].direction = keep;
	ck_assert_uint_eq(count_all(&machine), 0);

	/* The whole frame is turned: Z is horizontal, along -Y of the drawing, and so are the rotary axes. */
	machine = five_axes(7);
	machine.axes[1].direction = (vec3){0, 0, 1};
	machine.axes[2].direction = (vec3){0, -1, 0};
	machine.axes[4].direction = (vec3){0, 1, 0};
	machine.spindle.direction = (vec3){0, 1, 0};
	machine.spindle.location = (vec3){0, -300, 0};
	ck_assert_uint_eq(count(&machine, DOUBT_TURNED), 1);
	ck_assert_uint_eq(count_all(&machine), 1);
	machine.axes[4].direction = (vec3){0, -1, 0};
	ck_assert_uint_eq(count(&machine, DOUBT_ROTARY_SIGN), 1);
}
END_TEST

START_TEST(spindles)
{
	struct machine machine = five_axes(7);

	machine.spindle.direction = (vec3){1, 0, 0};
	ck_assert_uint_eq(count(&machine, DOUBT_SPINDLE_ACROSS), 1);
	machine.spindle.direction = (vec3){0, 0, 1};
	ck_assert_uint_eq(count(&machine, DOUBT_SPINDLE_TOWARD), 1);
	ck_assert_uint_eq(count(&machine, DOUBT_SPINDLE_AWAY), 0);
	machine.axes[2].limit_min = -200;
	ck_assert_uint_eq(count(&machine, DOUBT_SPINDLE_AWAY), 1);
	machine.spindle.checked = "it is";
	ck_assert_uint_eq(count_all(&machine), 0);
	machine = five_axes(7);
	machine.workholding.frame.translation = (vec3){1100, 0, 0};
	ck_assert_uint_eq(count(&machine, DOUBT_WORKHOLDING_BESIDE), 1);
	machine.workholding.present = false;
	machine.spindle.present = false;
	ck_assert_uint_eq(count_all(&machine), 0);
}
END_TEST

START_TEST(nesting)
{
	struct machine machine = five_axes(31);

	/* C is next to the tool, on the spindle's line: it turns the tool only about itself. */
	machine.axes[4].location = (vec3){0, 0, 900};
	ck_assert_uint_eq(count(&machine, DOUBT_TURNS_ITSELF), 1);
	machine.axes[4].location = (vec3){0.5, 0, 0};
	ck_assert_uint_eq(count(&machine, DOUBT_TURNS_ITSELF), 0);
	machine.axes[4].location = (vec3){0, 0, 900};
	machine.axes[4].checked = "the spindle turns the work";
	ck_assert_uint_eq(count(&machine, DOUBT_TURNS_ITSELF), 0);

	/* Only C carries the head, as for angle heads; A carries the table. */
	machine = five_axes(23);
	machine.axes[4].location = (vec3){0, 0, 0};
	ck_assert_uint_eq(count_all(&machine), 0);

	/* Y is beside X instead of below it. */
	machine = five_axes(7);
	machine.axes[2].parent = 1;
	ck_assert_uint_eq(count(&machine, DOUBT_IDLE), 1);
	machine.axes[1].slot = SLOT_V;
	ck_assert_uint_eq(count(&machine, DOUBT_IDLE), 0);
}
END_TEST

/* Rates are per second inside: 100 mm/s are 6 m/min. */
START_TEST(values)
{
	struct machine machine = five_axes(7);

	ck_assert_uint_eq(count_values(&machine, DOUBT_RATE_LOW), 0);
	machine.axes[0].rate_max = 30.0 / 60;
	machine.axes[3].rate_max = 20 * (acos(-1) / 180) / 60;
	ck_assert_uint_eq(count_values(&machine, DOUBT_RATE_LOW), 2);
	machine.axes[0].checked = "a crane";
	ck_assert_uint_eq(count_values(&machine, DOUBT_RATE_LOW), 1);

	/* Limits of -360 to 360 degrees in radians, read as degrees; then real degrees, 15. */
	ck_assert_uint_eq(count_values(&machine, DOUBT_RADIANS), 0);
	machine.axes[4].limit_max = 2 * acos(-1) * acos(-1) / 180;
	machine.axes[4].limit_min = -machine.axes[4].limit_max;
	ck_assert_uint_eq(count_values(&machine, DOUBT_RADIANS), 1);
	machine.axes[4].limit_max = 15 * acos(-1) / 180;
	ck_assert_uint_eq(count_values(&machine, DOUBT_RADIANS), 0);
}
END_TEST

/*
 * Directions that are straight to the precision of floats, nutating axes and slanted beds are right; a small angle is a
 * mistake, for axes and for the spindle.
 */
START_TEST(tilts)
{
	static const struct {
		double angle;
		bool doubted;
	} cases[] = {{0, false}, {1e-5, false}, {0.01, false}, {0.046, true}, {1, true}, {9, true},
		     {15, false}, {30, false}, {45, false}};

	for (int i = 0; i < COUNT(cases); i++) {
		const double angle = cases[i].angle * acos(-1) / 180;
		struct machine machine = five_axes(7);

		machine.axes[3].direction = (vec3){-cos(angle), 0, sin(angle)};
		ck_assert_uint_eq(count_values(&machine, DOUBT_TILTED), cases[i].doubted);
		machine.axes[3].checked = "measured";
		ck_assert_uint_eq(count_values(&machine, DOUBT_TILTED), 0);
		machine.spindle.direction = (vec3){0, sin(angle), -cos(angle)};
		ck_assert_uint_eq(count_values(&machine, DOUBT_SPINDLE_TILTED), cases[i].doubted);
		machine.spindle.checked = "measured";
		ck_assert_uint_eq(count_values(&machine, DOUBT_SPINDLE_TILTED), 0);
	}
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("core");

	tcase_add_test(tcase, all_arrangements);
	tcase_add_test(tcase, every_sign);
	tcase_add_test(tcase, letters_and_lines);
	tcase_add_test(tcase, spindles);
	tcase_add_test(tcase, nesting);
	tcase_add_test(tcase, values);
	tcase_add_test(tcase, tilts);
	return run_suite("kinematics", tcase);
}
