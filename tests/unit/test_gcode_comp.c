/* test_gcode_comp.c - cutter compensation: closed forms, the tool's distance from the path, blocks in order, faults. */
#include "gcode_refusal.h"

static void run(const char *program, const char *moves)
{
	expect_moves(program, moves);
}

/* Right of a counter-clockwise square the corners are rounded, left of it the ways are cut off. */
START_TEST(square)
{
	run("F9 G42.1 D4\nG1 X10 Y0\nX30\nY20\nG40 G1 X50\nM2\n",
	    "feed 10 -2 0 0 0\nfeed 30 -2 0 0 0\n"
	    "arc 32 0 0 0 0 centre 30 0 0 normal 0 0 1 sweep 90\nfeed 32 20 0 0 0\n"
	    "feed 50 20 0 0 0\n");
	run("F9 G41.1 D4\nG1 X10 Y0\nX30\nY20\nX10\nG40 G1 X0\nM2\n",
	    "feed 10 2 0 0 0\nfeed 28 2 0 0 0\nfeed 28 18 0 0 0\nfeed 10 18 0 0 0\nfeed 0 20 0 0 0\n");
}
END_TEST

/* Line to arc, radius 10 about (20, 0), tool of radius 2 left: 3-4-5 triangles at the crossings. */
START_TEST(crossings)
{
	/* The tool's line y = 2 meets its circle of radius 12 at x = 20 - sqrt(140). */
	run("F9 G41.1 D4\nG1 X5 Y0\nX10\nG2 X30 Y0 I10 J0\nG1 X40\nG40 X60\nM2\n",
	    "feed 5 2 0 0 0\nfeed 8.16784043 2 0 0 0\n"
	    "arc 31.8321596 2 0 0 0 centre 20 0 0 normal 0 0 1 sweep -160.811864\n"
	    "feed 40 2 0 0 0\nfeed 60 0 0 0 0\n");
}
END_TEST

START_TEST(plane_of_x_and_z)
{
	run("F9 G18 G41.1 D4\nG1 Z10 X0\nZ30\nX20\nG40 Z50\nM2\n",
	    "feed 2 0 10 0 0\nfeed 2 0 28 0 0\nfeed 20 0 28 0 0\nfeed 20 0 50 0 0\n");
}
END_TEST

/* A delayed move is sent with its own line, and the end of its block follows it. */
START_TEST(blocks_in_order)
{
	struct gcode_case c;

	case_init(&c);
	ck_assert(case_run(&c, "F9 G41.1 D4\nG1 X10 Y0\nX30\nZ-1\nG4 P1\n(nothing)\nY20\nG40\nM2\n"));
	ck_assert_str_eq(strbuf_text(&c.messages), "");
	ck_assert_str_eq(strbuf_text(&c.moves),
			 "feed 10 2 0 0 0\nfeed 28 2 0 0 0\nfeed 28 2 -1 0 0\ndwell 1\nfeed 28 20 -1 0 0\n");
	ck_assert_str_eq(strbuf_text(&c.blocks),
			 "1:0:F9 G41.1 D4\n2:1:G1 X10 Y0\n3:1:X30\n4:1:Z-1\n5:1:G4 P1\n7:1:Y20\n8:0:G40\n9:0:M2\n");
	case_release(&c);
}
END_TEST

/* Outside a polygon the tool's centre stays at its radius from every side: sampled. */
START_TEST(distance_from_polygon)
{
	static const double corners[][2] = {{20, 0}, {60, -10}, {90, 30}, {55, 70}, {10, 50}, {20, 0}};
	struct strbuf program = {0};
	struct gcode_case c;
	double x = 0, y = 0;
	int checked = 0;

	strbuf_addf(&program, "F9 G0 X15 Y20\nG42.1 D6\n");
	for (size_t i = 0; i < COUNT(corners); i++)
		strbuf_addf(&program, "G1 X%g Y%g\n", corners[i][0], corners[i][1]);
	strbuf_addf(&program, "M2\n");
	case_init(&c);
	ck_assert(case_run(&c, program.text));
	for (char *line = strtok(c.moves.text, "\n"); line; line = strtok(NULL, "\n")) {
		double ex, ey, cx = 0, cy = 0, sweep = 0;
		bool arc = sscanf(line, "arc %lf %lf 0 0 0 centre %lf %lf 0 normal 0 0 1 sweep %lf", &ex, &ey, &cx, &cy,
				  &sweep) == 5;

		if (sscanf(line, "rapid %lf %lf", &x, &y) == 2)
			continue;
		ck_assert(arc || sscanf(line, "feed %lf %lf", &ex, &ey) == 2);
		for (int k = 0; k <= 100 && checked; k++) {
			double s = k / 100.0, turn = radians(sweep) * s, px = x + s * (ex - x), py = y + s * (ey - y);
			double least = INFINITY;

			if (arc) {
				px = cx + cos(turn) * (x - cx) - sin(turn) * (y - cy);
				py = cy + sin(turn) * (x - cx) + cos(turn) * (y - cy);
			}
			for (size_t i = 0; i + 1 < COUNT(corners); i++) {
				double dx = corners[i + 1][0] - corners[i][0], dy = corners[i + 1][1] - corners[i][1];
				double along = (px - corners[i][0]) * dx + (py - corners[i][1]) * dy;
				double t = along / (dx * dx + dy * dy);

				t = fmin(fmax(t, 0), 1);
				least = fmin(least, hypot(px - corners[i][0] - t * dx, py - corners[i][1] - t * dy));
			}
			ck_assert_double_eq_tol(least, 3, 1e-6);
		}
		checked++;
		x = ex;
		y = ey;
	}
	/* The entry, five sides, five corners. */
	ck_assert_int_eq(checked, 11);
	strbuf_release(&program);
	case_release(&c);
}
END_TEST

struct bad {
	const char *before, *block;
	int column;
	const char *message;
};

#define ON "G41.1 D4 G1 X10 Y0"

static const struct bad bads[] = {
    {"G19", "G41.1 D4", 1, "cutter compensation works only in the planes of G17 and G18"},
    {ON, "G42.1 D4", 1, "cutter compensation is already on; write G40 first"},
    {"", "G41.1", 1, "G41.1 needs D (tool diameter)"},
    {"", "G41 D5", 5, "the setup does not give the diameter of tool T5"},
    {"", "G41 D1.5", 5, "D1.5 must be a whole number from 0 to 1000000"},
    {"G18", "G41.1 D4 L2", 10, "L (orientation of a lathe tool) is not supported"},
    {"G41.1 D20", "G1 X10", 1, "the entry move of cutter compensation must be longer than the tool radius, 10 mm"},
    {"G41.1 D20", "G2 X5 Y5 R5", 1,
     "the entry arc of cutter compensation must end farther from its start than the tool radius, 10 mm"},
    {"G41.1 D20", "G3 X20 Y0 I5 J0", 1, "the radius of the arc is 5 mm at its start and 15 mm at its end"},
    {"G41.1 D20", "G3 X10.5 Y0 R6", 1, "the radius of the arc, 6 mm, is not greater than the tool radius, 10 mm"},
    {ON "\nX12", "Y20 X11", 1,
     "the straight feed of line 3 ends in an inside corner that is too narrow for the tool (radius 2 mm), which would "
     "gouge"},
    {ON, "G53 G0 X1", 1,
     "a code that moves or shifts the machine's axes while cutter compensation is on; write G40 first"},
    {ON, "G28", 1, "a code that moves or shifts the machine's axes while cutter compensation is on; write G40 first"},
    {ON, "G92 X0", 1,
     "a code that moves or shifts the machine's axes while cutter compensation is on; write G40 first"},
    {ON, "G18", 1, "a change of the plane while cutter compensation is on; write G40 first"},
    {ON, "G55", 1, "a change of the work offset while cutter compensation is on; write G40 first"},
    {ON, "G64", 1, "a change of the path mode while cutter compensation is on; write G40 first"},
    {ON, "G99", 1, "a change of the retract mode while cutter compensation is on; write G40 first"},
    {ON, "G49", 1, "a change of the tool length while cutter compensation is on; write G40 first"},
    {ON, "T1 M6", 4, "a tool change while cutter compensation is on; write G40 first"},
    {ON, "G81 X1 Z-1 R1", 1, "G81 while cutter compensation is on; write G40 first"},
    {ON, "G93 X20 F1", 5, "inverse time mode (G93) under cutter compensation is not supported"},
    {ON "\nX30\nM1", "Y20", 1,
     "an inside corner after a program stop under cutter compensation; the tool has already gone too far"},
    {ON "\nX30\nG40", "G2 X40 Y10 R10", 1,
     "the first move after cutter compensation (G40) must be straight, not an arc"},
    {ON "\nG3 X14 Y4 R4", "G1 X10 Y4", 1,
     "the arc of line 3 ends in an inside corner that is too narrow for the tool (radius 2 mm), which would gouge"},
};

START_TEST(refused)
{
	const struct bad *bad = &bads[_i];
	struct gcode_case c;

	case_init(&c);
	case_refuses_last(&c, bad->column, bad->message, "F9\n%s%s%s\n", bad->before, *bad->before ? "\n" : "",
			  bad->block);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("programs");

	tcase_add_test(tcase, square);
	tcase_add_test(tcase, crossings);
	tcase_add_test(tcase, plane_of_x_and_z);
	tcase_add_test(tcase, blocks_in_order);
	tcase_add_test(tcase, distance_from_polygon);
	tcase_add_loop_test(tcase, refused, 0, COUNT(bads));
	return run_suite("gcode_comp", tcase);
}
