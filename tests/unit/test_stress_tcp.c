/*
 * test_stress_tcp.c - two rotary axes under TCP near the singular pose, where the tool is nearly parallel to the other
 * axis and a small tilt comes with large turns: whole programs on machines with these axes in the table, in the head,
 * and in both. The linear axes follow the tip, and a body that only they carry meets a wall across X. The truth is the
 * formula of this axis, in long double.
 */
#include <stdlib.h>

#include "stress_case.h"
#include "suite.h"

typedef long double real;

#define LENGTH 60	/* of the tool, mm */
#define PIVOT 140	/* of the head's tilt axis above the gauge point, mm */
#define HALF 4	/* of the edge of the slide, a cube: mm */
#define HEIGHT 400	/* of slide and wall, away from the tool: mm */

enum family { TABLE_TABLE, HEAD_HEAD, HEAD_TABLE };

/* A motion: large turns and small tilts, in degrees, from and to. `gap`: mm from the slide to the wall at the start. */
struct approach {
	const char *name;
	enum family family;
	double tilt[2], turn[2];
	double reach;	/* of the tip from the axis of the turns, along -X at the start */
	double gap;
	double tolerance;
};

static const struct approach approaches[] = {
	{"half a turn while A passes 0", TABLE_TABLE, {-1e-4, 1e-4}, {0, 180}, 64, 100, 1e-5},
	{"half a turn at A 0", TABLE_TABLE, {0, 0}, {-90, 90}, 64, 63.9, 1e-5},
	{"a turn that grazes by 1e-6", TABLE_TABLE, {-1e-6, 1e-6}, {0, 360}, 64, 128 - 1e-6, 1e-8},
	{"a turn that misses by 1e-6", TABLE_TABLE, {-1e-6, 1e-6}, {0, 360}, 64, 128 + 1e-6, 1e-8},
	{"a hundred turns, the last of which meets", TABLE_TABLE, {0, 1}, {0, 36000}, 64, 128.02, 1e-5},
	{"a head that swivels over a still tip", HEAD_HEAD, {-0.001, 0.001}, {0, 180}, 0, 0.003, 1e-6},
	{"a head that widens its circle", HEAD_HEAD, {0, 0.02}, {0, 3600}, 0, 0.06, 1e-6},
	{"a head whose circle stays too small", HEAD_HEAD, {0, 0.02}, {0, 3600}, 0, 0.07, 1e-6},
	{"a head that tilts while the table turns", HEAD_TABLE, {-0.01, 0.01}, {0, 180}, 64, 100, 1e-5},
	{"a head that tilts out of the way", HEAD_TABLE, {0.01, -0.01}, {0, 180}, 64, 128, 1e-6},
};

/* The position of X at the share s, minus its start. */
static real x_at(const struct approach *d, real s)
{
	const real degree = acosl(-1) / 180, arm = PIVOT + LENGTH;
	real tilt0 = d->tilt[0] * degree, turn0 = d->turn[0] * degree;
	real tilt = (1 - s) * tilt0 + s * d->tilt[1] * degree, turn = (1 - s) * turn0 + s * d->turn[1] * degree;

	switch (d->family) {
	case TABLE_TABLE:
		/* The tip starts at the height of A's axis, and A does not change X. */
		return d->reach * (1 - cosl(turn - turn0));
	case HEAD_HEAD:
		/* Tilted about X, then turned about Z: the head leans toward sin(turn) X. */
		return arm * (sinl(tilt) * sinl(turn) - sinl(tilt0) * sinl(turn0));
	case HEAD_TABLE:
		/* The head is drawn upright: its first tilt moves the tip outward. */
		return (d->reach + arm * sinl(tilt0)) * (1 - cosl(turn - turn0)) + arm * (sinl(tilt) - sinl(tilt0));
	}
	return 0;
}

/* The first share at which X has moved this far, or NEVER: by samples much finer than a turn, then by bisection. */
static double first_at(const struct approach *d, real way)
{
	const long looks = 200000;

	for (long k = 0; k <= looks; k++) {
		real low = (real)(k - 1) / looks, high = (real)k / looks;

		if (x_at(d, high) < way)
			continue;
		for (int i = 0; i < 60 && k; i++) {
			real middle = (low + high) / 2;

			if (x_at(d, middle) < way)
				low = middle;
			else
				high = middle;
		}
		return (double)high;
	}
	return NEVER;
}

/* ------------------------------------------------------------------ files */

static void open_axis(FILE *xml, char name, const char *direction, double x, double z, double home)
{
	fprintf(xml, "<axis name='%c' type='%s' direction='%s' location='%g 0 %g' rate_max='1e9' home='%.17g'>\n", name,
		name < 'X' ? "rotary" : "linear", direction, x, z, home);
}

static void close_axes(FILE *xml, int count)
{
	while (count--)
		fprintf(xml, "</axis>\n");
}

/* Writes the rotary axes of the head, or those of the table. */
static void write_rotaries(FILE *xml, const struct approach *d, bool head)
{
	int count = 0;

	if (d->family == TABLE_TABLE && !head) {
		open_axis(xml, 'A', "1 0 0", 0, 0, d->tilt[0]);
		open_axis(xml, 'C', "0 0 1", 0, 0, d->turn[0]);
		count = 2;
	} else if (d->family == HEAD_HEAD && head) {
		open_axis(xml, 'C', "0 0 1", 0, 0, d->turn[0]);
		open_axis(xml, 'A', "1 0 0", 0, LENGTH + PIVOT, d->tilt[0]);
		count = 2;
	} else if (d->family == HEAD_TABLE) {
		if (head)
			open_axis(xml, 'B', "0 1 0", -d->reach, LENGTH + PIVOT, d->tilt[0]);
		else
			open_axis(xml, 'C', "0 0 1", 0, 0, d->turn[0]);
		count = 1;
	}
	/* The tip is at the height of a table's tilt axis, or below that of a head. */
	if (head)
		fprintf(xml, "<spindle location='%.17g 0 %d' direction='0 0 -1'/>\n", -d->reach, LENGTH);
	else
		fprintf(xml, "<workholding location='0 0 0'/>\n");
	close_axes(xml, count);
}

static void write_box(const char *path, vec3 half)
{
	struct mesh box = {0};

	solid_box(&box, half);
	stress_write_stl(path, &box);
	mesh_release(&box);
}

static void write_approach(const struct approach *d)
{
	FILE *xml = fopen("m.xml", "w"), *nc = fopen("p.nc", "w");
	char tilt = d->family == HEAD_TABLE ? 'B' : 'A';

	require(xml && nc, "cannot write here");
	write_box("a.stl", (vec3){8, 256, 256});
	write_box("b.stl", (vec3){HALF, HALF, HALF});
	fprintf(xml, "<machine version='1' units='mm'>\n<base>\n");
	stress_write_body(xml, 'a', (vec3){HALF + d->gap + 8, 0, HEIGHT});
	open_axis(xml, 'X', "1 0 0", 0, 0, 0);
	open_axis(xml, 'Y', "0 1 0", 0, 0, 0);
	open_axis(xml, 'Z', "0 0 1", 0, 0, 0);
	stress_write_body(xml, 'b', (vec3){0, 0, HEIGHT});
	write_rotaries(xml, d, true);
	close_axes(xml, 3);
	write_rotaries(xml, d, false);
	fprintf(xml, "</base>\n<pairs><pair a='a' b='b' check='always'/></pairs>\n"
		     "<setup version='1' units='mm' initial_tool='1'><tool number='1' length='%d'><cutter>"
		     "<section length='%d' diameter='1'/></cutter></tool></setup>\n</machine>\n", LENGTH, LENGTH);
	/* Without X Y Z the tip keeps its place in the workpiece. */
	fprintf(nc, "G21 G90 G94 F1000\nG43.4 H1\nG1 %c%.12f C%.12f\nM2\n", tilt, d->tilt[1], d->turn[1]);
	require(!fclose(xml) && !fclose(nc), "cannot write here");
}

START_TEST(near_the_singular_pose)
{
	const struct approach *d = &approaches[_i];
	const real e = 1.01L * d->tolerance;
	double early = first_at(d, d->gap - e), late = first_at(d, d->gap);
	struct stress_found found;
	bool on_time;

	write_approach(d);
	found = stress_run(d->tolerance, d->name, "under TCP");
	if (early < 0) {
		require(!found.count, "%s: a false alarm at %.12g, %.12g apart", d->name, found.s, found.distance);
		return;
	}
	/* Between the two bounds either answer would be right; no case of the table may be there. */
	require(late >= 0, "%s: an approach that proves nothing", d->name);
	require(found.count == 1, "%s: missed at %.12g", d->name, late);
	/* Later by no more than a motion of e, and not in a later turn. */
	on_time = found.s <= late || (found.s < late + 1e-3 && fabsl(x_at(d, found.s) - d->gap) <= e);
	require(found.s >= early && on_time, "%s: at %.15g, not from %.15g to %.15g", d->name, found.s, early, late);
	require(found.distance <= d->tolerance * (1 + 1e-9), "%s: %.12g apart", d->name, found.distance);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("closed forms");

	tcase_add_checked_fixture(tcase, stress_enter, stress_leave);
	tcase_add_loop_test(tcase, near_the_singular_pose, 0, COUNT(approaches));
	return run_suite("stress_tcp", tcase);
}
