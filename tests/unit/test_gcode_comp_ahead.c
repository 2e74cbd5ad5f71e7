/*
 * test_gcode_comp_ahead.c - cutter compensation of controls that look ahead (Fanuc B-62764EN, 15.4 and 15.5; Haas,
 * "Cutter Compensation"): closed forms, coverage of every possible path, faults.
 */
#include "gcode_case.h"

static const struct radius_offset radii[] = {{1, 2}, {2, -2}, {3, 0}, {4, 40}};

static void init(struct gcode_case *c, const struct dialect *dialect, enum comp_start start, enum comp_corner_form corner)
{
	case_init(c);
	c->config.dialect = dialect;
	c->config.radii = radii;
	c->config.radius_count = COUNT(radii);
	c->config.controller.comp_start = start;
	c->config.controller.comp_corner = corner;
	c->show_spread = true;
}

static void run(enum comp_start start, enum comp_corner_form corner, const char *program, const char *moves)
{
	struct gcode_case c;

	init(&c, &dialect_fanuc, start, corner);
	case_expect(&c, program, moves);
}

#define A COMP_START_A
#define B COMP_START_B
#define LINEAR COMP_CORNER_LINEAR
#define CIRCULAR COMP_CORNER_CIRCULAR
#define SQUARE "G94 F9 G1 G41 D1 X10 Y0\nY20\nX30\nY0\nG40 X40\nM30\n"

START_TEST(square)
{
	run(A, LINEAR, SQUARE,
	    "feed 8 0 0 0 0\nfeed 8 22 0 0 0\nfeed 32 22 0 0 0\nfeed 32 0 0 0 0\nfeed 40 0 0 0 0\n");
	run(A, CIRCULAR, SQUARE,
	    "feed 8 0 0 0 0\nfeed 8 20 0 0 0\narc 10 22 0 0 0 centre 10 20 0 normal 0 0 1 sweep -90\nfeed 30 22 0 0 0\n"
	    "arc 32 20 0 0 0 centre 30 20 0 normal 0 0 1 sweep -90\nfeed 32 0 0 0 0\nfeed 40 0 0 0 0\n");
	/*
	 * D2 is negative: compensation on the other side, where all corners, also the first one, are inside corners.
	 * Both types go straight.
	 */
	run(B, LINEAR, "G94 F9 G1 G41 D2 X10 Y0\nY20\nX30\nY0\nG40 X40\nM30\n",
	    "feed 12 -2 0 0 0\nfeed 12 18 0 0 0\nfeed 28 18 0 0 0\nfeed 28 -2 0 0 0\nfeed 40 0 0 0 0\n");
	/* A D of 0 compensates nothing. */
	run(A, LINEAR, "G94 F9 G1 G41 D3 X10 Y0\nY20\nG40 X40\nM30\n",
	    "feed 10 0 0 0 0\nfeed 10 20 0 0 0\nfeed 40 20 0 0 0\n");
	run(A, LINEAR, "G94 F9 G1 G42 D0 X10 Y0\nY20\nG40 X40\nM30\n",
	    "feed 10 0 0 0 0\nfeed 10 20 0 0 0\nfeed 40 20 0 0 0\n");
}
END_TEST

/* "Start-up" and "Offset mode cancel": type B goes round an outside corner, type A never does. */
START_TEST(start_and_end)
{
	/* From the left to a wall that goes down, on its left: an outside corner of 90 degrees at both ends. */
	run(A, LINEAR, "G94 F9 G1 G41 D1 X10 Y0\nY-20\nG40 X0\nM30\n",
	    "feed 12 0 0 0 0\nfeed 12 -20 0 0 0\nfeed 0 -20 0 0 0\n");
	run(B, LINEAR, "G94 F9 G1 G41 D1 X10 Y0\nY-20\nG40 X0\nM30\n",
	    "feed 12 2 0 0 0\nfeed 12 -22 0 0 0\nfeed 0 -20 0 0 0\n");
	run(B, CIRCULAR, "G94 F9 G1 G41 D1 X10 Y0\nY-20\nG40 X0\nM30\n",
	    "feed 10 2 0 0 0\narc 12 0 0 0 0 centre 10 0 0 normal 0 0 1 sweep -90\nfeed 12 -20 0 0 0\n"
	    "arc 10 -22 0 0 0 centre 10 -20 0 normal 0 0 1 sweep -90\nfeed 0 -20 0 0 0\n");
	/* The type is not known: everything within 2 sqrt 2 of the path of type B is covered. */
	run(COMP_START_UNKNOWN, LINEAR, "G94 F9 G1 G41 D1 X10 Y0\nY-20\nG40 X0\nM30\n",
	    "feed 12 2 0 0 0 spread 2 2 0\nfeed 12 0 0 0 0 spread 2 2 0\nfeed 12 -20 0 0 0\n"
	    "feed 12 -22 0 0 0 spread 2 2 0\nfeed 0 -20 0 0 0 spread 2 2 0\n");
	/* G41 alone waits for the next move; Z moves before and between; D is modal, and G41 may be repeated. */
	run(A, LINEAR, "G94 F9 G41 D1\nG1 Z5\nX10 Y0\nZ0\nG41 Y-20\nG40 X0\nM30\n",
	    "feed 0 0 5 0 0\nfeed 12 0 5 0 0\nfeed 12 0 0 0 0\nfeed 12 -20 0 0 0\nfeed 0 -20 0 0 0\n");
}
END_TEST

/* Corners of more than 90 degrees are cut off at the radius on both sides. */
START_TEST(acute)
{
	run(A, LINEAR, "G94 F9 G1 G41 D1 X10 Y0\nX30\nX20 Y-10\nG40 X0\nM30\n",
	    "feed 10 2 0 0 0\nfeed 32 2 0 0 0\nfeed 32.8284271 0 0 0 0\nfeed 21.4142136 -11.4142136 0 0 0\nfeed 0 -10 0 0 0\n");
}
END_TEST

/* Arcs: 3-4-5 crossings inside, tangents outside. */
START_TEST(arcs)
{
	run(A, LINEAR, "G94 F9 G1 G41 D1 X5 Y0\nX10\nG2 X30 Y0 I10 J0\nG1 X40\nG40 X60\nM30\n",
	    "feed 5 2 0 0 0\nfeed 8.16784043 2 0 0 0\narc 31.8321596 2 0 0 0 centre 20 0 0 normal 0 0 1 sweep -160.811864\n"
	    "feed 40 2 0 0 0\nfeed 60 0 0 0 0\n");
	run(A, LINEAR, "G94 F9 G1 G42 D1 X5 Y0\nX10\nG2 X30 Y0 I10 J0\nG1 X40\nG40 X60\nM30\n",
	    "feed 5 -2 0 0 0\nfeed 12 -2 0 0 0\nfeed 12 0 0 0 0\narc 28 0 0 0 0 centre 20 0 0 normal 0 0 1 sweep -180\n"
	    "feed 28 -2 0 0 0\nfeed 40 -2 0 0 0\nfeed 60 0 0 0 0\n");
	/* Tangent: no corner. */
	run(A, LINEAR, "G94 F9 G1 G41 D1 X5 Y0\nX10\nG3 X20 Y10 I0 J10\nG1 Y20\nG40 X60\nM30\n",
	    "feed 5 2 0 0 0\nfeed 10 2 0 0 0\narc 18 10 0 0 0 centre 10 10 0 normal 0 0 1 sweep 90\nfeed 18 20 0 0 0\n"
	    "feed 60 20 0 0 0\n");
}
END_TEST

START_TEST(planes)
{
	run(A, LINEAR, "G94 F9 G18 G1 G41 D1 Z10 X0\nX20\nZ30\nG40 X40\nM30\n",
	    "feed 0 0 8 0 0\nfeed 22 0 8 0 0\nfeed 22 0 30 0 0\nfeed 40 0 30 0 0\n");
	run(A, LINEAR, "G94 F9 G19 G1 G41 D1 Y10 Z0\nZ20\nY30\nG40 Z40\nM30\n",
	    "feed 0 8 0 0 0\nfeed 0 8 22 0 0\nfeed 0 30 22 0 0\nfeed 0 30 40 0 0\n");
}
END_TEST

/*
 * Fanuc B-64484EN, tilted working plane indexing: compensation works in the tilted plane, here with X' = -X and Y' = Z
 * from (10, 20, 30), and the tool stays at Y 0. The corners are those of `square`.
 */
START_TEST(on_a_tilted_plane)
{
	run(A, LINEAR, "G68.2 X10 Y20 Z30 I180 J90 K0\nG53.1\n" SQUARE,
	    "orient 0 1 0\nrapid 0 0 0 90 0\ntcp on length 0 zero A0 C0\nfeed 2 0 30 90 0 tcp\nfeed 2 0 52 90 0 tcp\n"
	    "feed -22 0 52 90 0 tcp\nfeed -22 0 30 90 0 tcp\nfeed -30 0 30 90 0 tcp\n");
	run(A, CIRCULAR, "G68.2 X10 Y20 Z30 I180 J90 K0\nG53.1\nG94 F9 G1 G41 D1 X10 Y0\nY20\nX30\nG40 Y40\nG69\nM30\n",
	    "orient 0 1 0\nrapid 0 0 0 90 0\ntcp on length 0 zero A0 C0\nfeed 2 0 30 90 0 tcp\nfeed 2 0 50 90 0 tcp\n"
	    "arc 0 0 52 90 0 centre 0 0 50 normal 0 1 0 sweep -90 tcp\nfeed -20 0 52 90 0 tcp\n"
	    "feed -20 0 70 90 0 tcp\ntcp off length 0 zero A0 C0\n");
}
END_TEST

/* G40 alone: the tool stays beside the end until axes of the plane move again, whatever else moves before. */
START_TEST(cancel_alone)
{
	run(A, LINEAR, "G94 F9 G1 G41 D1 X10 Y0\nY20\nG40\nZ50\nX0\nZ60\nY0\nZ70\nM30\n",
	    "feed 8 0 0 0 0\nfeed 8 20 0 0 0\nfeed 10 20 0 0 0 spread 2 2 0\nfeed 10 20 50 0 0 spread 2 2 0\n"
	    "feed 0 20 50 0 0 spread 2 2 0\nfeed 0 20 60 0 0 spread 0 2 0\nfeed 0 0 60 0 0 spread 0 2 0\nfeed 0 0 70 0 0\n");
	/* X of a dwell moves nothing. */
	run(A, LINEAR, "G94 F9 G1 G41 D1 X10 Y0\nY20\nG40\nG4 X1.\nZ50\nM30\n",
	    "feed 8 0 0 0 0\nfeed 8 20 0 0 0\nfeed 10 20 0 0 0 spread 2 2 0\ndwell 1 spread 2 2 0\n"
	    "feed 10 20 50 0 0 spread 2 2 0\n");
}
END_TEST

/* ------------------------------------------------------- every way is covered */

struct piece {
	double from[2], to[2], centre[2], sweep, spread;
};

/* The moves that a case has written down. */
static int pieces_of(struct gcode_case *c, struct piece pieces[64])
{
	double at[2] = {0, 0};
	int count = 0;

	for (char *line = strtok(c->moves.text, "\n"); line; line = strtok(NULL, "\n")) {
		struct piece *piece = &pieces[count++];
		const char *spread = strstr(line, "spread "), *centre = strstr(line, "centre ");

		ck_assert_int_lt(count, 64);
		*piece = (struct piece){{at[0], at[1]}, {0}, {0}, 0, 0};
		ck_assert(sscanf(strchr(line, ' '), "%lf %lf", &piece->to[0], &piece->to[1]) == 2);
		if (centre)
			ck_assert(sscanf(centre, "centre %lf %lf 0 normal 0 0 1 sweep %lf", &piece->centre[0],
					 &piece->centre[1], &piece->sweep) == 3);
		if (spread)
			ck_assert(sscanf(spread, "spread %lf", &piece->spread) == 1);
		memcpy(at, piece->to, sizeof(at));
	}
	return count;
}

static void point_of(const struct piece *piece, double s, double p[2])
{
	double turn = radians(piece->sweep) * s, x = piece->from[0] - piece->centre[0], y = piece->from[1] - piece->centre[1];

	for (int i = 0; i < 2; i++)
		p[i] = piece->from[i] + s * (piece->to[i] - piece->from[i]);
	if (piece->sweep < 0 || piece->sweep > 0) {
		p[0] = piece->centre[0] + cos(turn) * x - sin(turn) * y;
		p[1] = piece->centre[1] + sin(turn) * x + cos(turn) * y;
	}
}

/*
 * The distance of a point from what the pieces cover; 0 or less: the point is covered. Sampled finely along the pieces.
 */
static double outside(const struct piece *pieces, int count, const double p[2])
{
	double least = INFINITY, q[2];

	for (int i = 0; i < count; i++) {
		for (int k = 0; k <= 400; k++) {
			point_of(&pieces[i], k / 400.0, q);
			least = fmin(least, fmax(fabs(p[0] - q[0]), fabs(p[1] - q[1])) - pieces[i].spread);
		}
	}
	return least;
}

/*
 * Random contours of lines and arcs: each path that a control may choose lies in what is proved for the unknown type.
 */
START_TEST(every_way_is_covered)
{
	unsigned seed = 20251122;
	int compared = 0;

	for (int round = 0; round < 60; round++) {
		struct piece all[64], one[64];
		struct strbuf program = {0};
		struct gcode_case c;
		double heading = 0, x = 0, y = 0;
		int count;

		strbuf_addf(&program, "G94 F9 G1 G%s D1 X%d Y0\n", round % 2 ? "41" : "42", 10);
		x = 10;
		for (int i = 0; i < 4; i++) {
			heading += radians((double)(rand_r(&seed) % 300) - 150);
			x += 40 * cos(heading);
			y += 40 * sin(heading);
			if (rand_r(&seed) % 3 || i == 3)
				strbuf_addf(&program, "G1 X%.4f Y%.4f\n", x, y);
			else
				strbuf_addf(&program, "G%d X%.4f Y%.4f R%d\n", rand_r(&seed) % 2 ? 2 : 3, x, y, 30);
		}
		heading += radians((double)(rand_r(&seed) % 300) - 150);
		strbuf_addf(&program, "G1 G40 X%.4f Y%.4f\nM30\n", x + 30 * cos(heading), y + 30 * sin(heading));
		init(&c, round % 3 ? &dialect_fanuc : &dialect_haas, COMP_START_UNKNOWN, COMP_CORNER_UNKNOWN);
		if (!case_run(&c, program.text)) {
			/* The tool does not fit, so there is no path. */
			ck_assert_ptr_nonnull(strstr(strbuf_text(&c.messages), "which would gouge"));
			case_release(&c);
			strbuf_release(&program);
			continue;
		}
		count = pieces_of(&c, all);
		case_release(&c);
		for (int way = 0; way < 4; way++) {
			int pieces;

			init(&c, &dialect_fanuc, way & 1 ? A : B, way & 2 ? LINEAR : CIRCULAR);
			if (!case_run(&c, program.text))
				ck_abort_msg("%s%s", program.text, strbuf_text(&c.messages));
			pieces = pieces_of(&c, one);
			for (int i = 0; i < pieces; i++) {
				double p[2];

				for (int k = 0; k <= 20; k++, compared++) {
					point_of(&one[i], k / 20.0, p);
					/* 0.2: half of the distance between samples of the pieces. */
					if (outside(all, count, p) > 0.2)
						ck_abort_msg("%.6f %.6f lies %.6f outside:\n%s", p[0], p[1],
							     outside(all, count, p), program.text);
				}
			}
			case_release(&c);
		}
		strbuf_release(&program);
	}
	ck_assert_int_gt(compared, 20000);
}
END_TEST

static const struct {
	const struct dialect *dialect;
	const char *program, *message;
} bads[] = {
	{&dialect_fanuc, "F9 G1 G41 X5\n", "G41 needs D (number of the radius)"},
	{&dialect_fanuc, "F9 G1 G41 D9 X5\n", "D9: the setup has no such radius; add <offset number=\"9\" radius=\"\"/>"},
	{&dialect_fanuc, "F9 G1 G41 D1 X5\nG42 D1 X9\n", "another side or radius of cutter compensation while it is on"},
	{&dialect_fanuc, "F9 G1 G41 D1 X5\nX9 D4\n", "another D while cutter compensation is on"},
	{&dialect_fanuc, "F9 G41 D1\nG2 X5 R9\n",
	 "cutter compensation must start and end with G0 or G1, not with an arc"},
	{&dialect_fanuc, "F9 G1 G41 D1 X5\nX9\nG40 G2 X20 R9\n", "cutter compensation must start and end with G0 or G1"},
	{&dialect_fanuc, "F9 G1 G41 D1 X5\nX9\nZ1\nZ2\nY9\n",
	 "2 blocks without a move in the plane of cutter compensation before this block, and a parameter of the control "
	 "(19625, less 2) decides how many it looks past: set cutter_comp_idle_blocks=\"\""},
	{&dialect_haas, "F9 G1 G41 D1 X5\nX9\nZ1\nZ2\nY9\n", "write at most 1 such blocks in a row"},
	{&dialect_fanuc, "F9 G1 G41 D1 X5\nX9\nZ1\nM8 M98 P2\nY9\nM30\nO2\nM99\n", "3 blocks without a move in the plane"},
	{&dialect_fanuc, "F9 G1 G41 D1 X5\nX9\nM0\n", "the program stops under cutter compensation"},
	{&dialect_fanuc, "F9 G1 G41 D1 X5\nX9\nX5\n", "the path turns back on itself under cutter compensation"},
	{&dialect_fanuc, "F9 G1 G41 D1 X5\nX9\nX20 A9\n", "A under cutter compensation is not supported"},
	{&dialect_fanuc, "F9 G1 G41 D1 X5\nX9\nG3 X11 Y2 R1.5\n", "is not greater than the compensation radius"},
	{&dialect_fanuc, "F9 G1 G41 D1 X5\nX9\nY1\nX0\n", "which would gouge"},
	{&dialect_fanuc, "F9 G1 G41 D1 X5\nX9\nG40\nG92 X0\n", "G92 after G40 before X has moved"},
	{&dialect_fanuc, "F9 G1 G41 D1 X5\nX9\nG40\nG2 X5 Y5 R9\n", "the first move after cutter compensation (G40) must be straight"},
};

START_TEST(faults)
{
	for (size_t i = 0; i < COUNT(bads); i++) {
		struct gcode_case c;

		init(&c, bads[i].dialect, A, LINEAR);
		ck_assert(!case_run(&c, bads[i].program));
		if (!strstr(strbuf_text(&c.messages), bads[i].message))
			ck_abort_msg("%s%s", bads[i].program, strbuf_text(&c.messages));
		case_release(&c);
	}
}
END_TEST

/* Blocks without a move, and calls, which are none, between the two sides of an outside corner of 90 degrees. */
START_TEST(idle_blocks)
{
	struct gcode_case c;

	init(&c, &dialect_fanuc, A, LINEAR);
	c.config.controller.comp_idle_blocks = 2;
	case_expect(&c, "G94 F9 G1 G41 D1 X10 Y0\nY20\nZ1\nM8\nX30\nG40 Y0\nM30\n",
		    "feed 8 0 0 0 0\nfeed 8 22 0 0 0\nfeed 8 22 1 0 0\nfeed 30 22 1 0 0\nfeed 30 0 1 0 0\n");
	run(A, LINEAR, "G94 F9 G1 G41 D1 X10 Y0\nY20\nM98 P2\nG40 Y0\nM30\nO2\nX30\nM99\n",
	    "feed 8 0 0 0 0\nfeed 8 22 0 0 0\nfeed 30 22 0 0 0\nfeed 30 0 0 0 0\n");
}
END_TEST

/* Without the parameter, a G41 alone is an error that asks for it on Fanuc; Haas waits for the next move. */
START_TEST(alone)
{
	struct gcode_case c;

	init(&c, &dialect_fanuc, COMP_START_UNKNOWN, LINEAR);
	ck_assert(!case_run(&c, "F9 G41 D1\nG1 X5\nX9\nM30\n"));
	ck_assert_ptr_nonnull(strstr(strbuf_text(&c.messages), "cutter_comp_start=\"A\" or \"B\""));
	case_release(&c);
	init(&c, &dialect_haas, COMP_START_UNKNOWN, LINEAR);
	case_expect(&c, "F9 G41 D1\nG1 X5\nX9\nG40\nG0 X0 Y0\nM30\n",
		    "feed 5 2 0 0 0\nfeed 9 2 0 0 0\nfeed 9 0 0 0 0 spread 2 2 0\nrapid 0 0 0 0 0 spread 2 2 0\n");
}
END_TEST

/* The degrees by which the arc about this centre turns; 0: there is none. */
static double sweep_about(const struct gcode_case *c, const char *centre)
{
	const char *at = strstr(strbuf_text(&c->moves), centre);

	at = at ? strstr(at, "sweep ") : NULL;
	return at ? strtod(at + strlen("sweep "), NULL) : 0;
}

/*
 * A clockwise circle that lacks `gap` radians between arcs that are tangent to it. With many radii of the tool rounding
 * places its compensated end behind its start.
 */
static void circle_stays(double gap, double tool_radius)
{
	const struct radius_offset radius = {1, tool_radius};
	struct strbuf program = {0};
	struct gcode_case c;

	strbuf_addf(&program, "G94 F9 G1 G41 D1 X-5 Y-5\nG3 X0 Y0 J5\nG2 X%.16f Y%.16f I50\n", 50 - 50 * cos(gap),
		    -50 * sin(gap));
	strbuf_addf(&program, "G3 X%.16f Y%.16f I%.16f J%.16f\nG1 G40 X-30\nM30\n",
		    50 - 55 * cos(gap) + 5 * sin(gap), 5 * cos(gap) - 55 * sin(gap), -5 * cos(gap), -5 * sin(gap));
	init(&c, &dialect_fanuc, A, CIRCULAR);
	c.config.radii = &radius;
	c.config.radius_count = 1;
	ck_assert_msg(case_run(&c, strbuf_text(&program)), "%s", strbuf_text(&c.messages));
	ck_assert_double_eq_tol(sweep_about(&c, "centre 50 0 0"), gap * 180 / PI - 360, 1e-5);
	case_release(&c);
	strbuf_release(&program);
}

START_TEST(nearly_whole_circles)
{
	for (int radius = 1; radius <= 40; radius++) {
		circle_stays(0, 0.1217 * radius);
		for (double gap = 1e-12; gap < 0.1; gap *= 10)
			circle_stays(gap, 0.1217 * radius);
	}
}
END_TEST

int main(void)
{
	const TTest *tests[] = {square, start_and_end, acute, arcs, planes, on_a_tilted_plane, cancel_alone, every_way_is_covered,
				faults, idle_blocks, alone, nearly_whole_circles};

	return RUN_TESTS("comp_ahead", tests);
}
