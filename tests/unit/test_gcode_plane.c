/* test_gcode_plane.c - turned coordinates, tilted planes, additional offsets, least input increments: closed forms. */
#include "gcode_refusal.h"

static const struct length_offset lengths[] = {{1, 100}};
static const struct mcode mcodes[] = {{428, MCODE_TCP_ON}, {429, MCODE_TCP_OFF}};

static void plane_case(struct gcode_case *c, const struct dialect *dialect)
{
	case_init(c);
	c->config.dialect = dialect;
	c->config.controller.length_moves = ANSWER_NO;
	c->config.lengths = lengths;
	c->config.length_count = 1;
	c->config.controller.mcodes = mcodes;
	c->config.controller.mcode_count = 2;
}

static void run(const struct dialect *dialect, const char *program, const char *moves)
{
	struct gcode_case c;

	plane_case(&c, dialect);
	case_expect(&c, program, moves);
}

/* Fanuc B-64484EN, coordinate system rotation (G68, G69); Haas, "G68 Rotation (Group 16)". */
START_TEST(rotation)
{
	/* By 90 degrees about (10, 0): (11, 0) goes to (10, 1). */
	run(&dialect_fanuc, "G0 X1. Y1.\nG68 X10. Y0. R90.\nX11. Y0.\nG91 X1.\nG90 Y5.\nG69\nX0.\nM30\n",
	    "rapid 1 1 0 0 0\nrapid 10 1 0 0 0\nrapid 10 2 0 0 0\nrapid 5 2 0 0 0\nrapid 0 2 0 0 0\n");
	/* Without a centre the tool stands on it; work offsets stay where they are. */
	run(&dialect_haas, "G10 L2 P1 X100. Y0.\nG54 G0 X1. Y1.\nG68 R-90.\nX2. Y1.\nG69\nM30\n",
	    "rapid 101 1 0 0 0\nrapid 101 0 0 0 0\n");
	/* Fanuc 15i (B-63324EN), the same section: increments before an absolute move turn about the tool. */
	run(&dialect_fanuc,
	    "G0 X5. Y5.\nG68 X0. Y0. R90.\nG91 X1.\nY1. Z1.\nG90 X1. Y0.\nX2.\nG69\nX0.\nY0.\nG91 X1. Y1.\nM30\n",
	    "rapid 5 5 0 0 0\nrapid 5 6 0 0 0\nrapid 4 6 1 0 0\nrapid 0 1 1 0 0\nrapid 0 2 1 0 0\n"
	    "rapid 0 2 1 0 0\nrapid 0 0 1 0 0\nrapid 1 1 1 0 0\n");
	/* Zero increments on the way to reference positions, and machine coordinates, are allowed. */
	run(&dialect_fanuc, "G0 X5. Y5.\nG68 X0. Y0. R90.\nX5. Y5.\nG69\nG91 G28 X0. Y0.\nM30\n",
	    "rapid 5 5 0 0 0\nrapid -5 5 0 0 0\nrapid -5 5 0 0 0\nrapid 0 0 0 0 0\n");
	run(&dialect_haas, "G0 X5. Y5.\nG68 X0. Y0. R90.\nX5. Y5.\nG53 Z3.\nG69 G53 X1. Y1.\nG91 X1. Y1.\nM30\n",
	    "rapid 5 5 0 0 0\nrapid -5 5 0 0 0\nrapid -5 5 3 0 0\nrapid 1 1 3 0 0\nrapid 2 2 3 0 0\n");
	run(&dialect_fanuc, "G18 G68 X0. Z0. R90.\nG0 X1. Z0.\nG69\nG19 G68 Y0. Z0. R90.\nG0 Y1. Z0. X0.\nM30\n",
	    "rapid 0 0 -1 0 0\nrapid 0 0 1 0 0\n");
}
END_TEST

START_TEST(rotated_arcs_and_cycles)
{
	run(&dialect_fanuc, "F9 G68 X0. Y0. R90.\nG2 X10. Y10. I10. J0.\nG3 X0. Y0. R10.\nG81 G99 X5. Y0. R-1. "
	    "Z-2.\nM30\n",
	    "arc -10 10 0 0 0 centre 0 10 0 normal 0 0 1 sweep -90\n"
	    "arc 0 0 0 0 0 centre 0 10 0 normal 0 0 1 sweep 90\n"
	    "rapid 0 5 0 0 0\nrapid 0 5 -1 0 0\nfeed 0 5 -2 0 0\nrapid 0 5 -1 0 0\n");
}
END_TEST

/* A P that is the number of no additional offset is not that of G54. */
START_TEST(p_beside_g54)
{
	run(&dialect_fanuc, "G0 Z5.\nG54 G98 G82 X1. Y2. Z-1. R3. P500 F60.\nM30\n",
	    "rapid 0 0 5 0 0\nrapid 1 2 5 0 0\nrapid 1 2 3 0 0\nfeed 1 2 -1 0 0\ndwell 0.5\nrapid 1 2 5 0 0\n");
	run(&dialect_fanuc, "G54 G4 P500\nM30\n", "dwell 0.5\n");
}
END_TEST

/*
 * Fanuc B-64484EN, tilted working plane indexing: Z-X'-Z'' by I, J, K. The
 * case's control has TCP on a table C; its G53.1 gives A = 20 here and leaves C.
 * With I 180: n = Rz(180) Rx(J) z = (0, sin J, cos J).
 */
START_TEST(tilted)
{
	struct gcode_case c;

	plane_case(&c, &dialect_fanuc);
	case_expect(&c,
		    "G0 Z50.\nG68.2 X10. Y20. Z30. I180. J90. K0.\nG53.1\nG43 H1\nG0 X1. Y2. Z3.\nG91 Z1.\nG90 "
		    "G53 Z0.\n"
		    "G43 H1 X0. Y0. Z0.\nG28 Z5.\nG43 H1 G69\nG0 X0. Z0.\nM30\n",
		    "rapid 0 0 50 0 0\norient 0 1 0\nrapid 0 0 50 90 0\n"
		    "tcp on length 0 zero A0 C0\n"
		    "tcp on length 100 zero A0 C0\n"
		    /* X' = -X, Y' = Z, Z' = Y */
		    "rapid 9 23 32 90 0 tcp\nrapid 9 24 32 90 0 tcp\n"
		    "tcp off length 100 zero A0 C0\nrapid 9 24 0 90 0\ntcp on length 100 zero A0 C0\n"
		    "rapid 10 20 30 90 0 tcp\n"
		    "rapid 10 25 30 90 0 tcp\n"
		    "tcp off length 100 zero A0 C0\nrapid 10 25 0 90 0\ntcp on length 100 zero A0 C0\n"
		    "tcp off length 100 zero A0 C0\nrapid 0 25 100 90 0\n");
}
END_TEST

/*
 * The same planes by roll, pitch and yaw, by points and by directions: they lead the same way as Euler's angles. Here
 * Z is n = (0, sin 30, cos 30), X is -X.
 */
START_TEST(tilted_in_every_form)
{
	static const char *const planes[] = {
		"G68.2 X1. Y2. Z3. I180. J30. K0.\n",
		/* Rz(180) after Rx(30) */
		"G68.2 P1 X1. Y2. Z3. I30. K180.\n",
		"G68.2 P1 Q123 X1. Y2. Z3. I30. J0. K180.\n",
		/* Rx(-30) after Rz(180) */
		"G68.2 P1 Q321 X1. Y2. Z3. I-30. J0. K180.\n",
		"G68.2 P2 Q1 X1. Y2. Z3.\nG68.2 P2 Q2 X-9. Y2. Z3.\nG68.2 P2 Q3 X-4. Y-6.66025404 Z8.\n",
		/* The zero is shifted by 10 along the new X. */
		("G68.2 P2 Q0 X10. Y0. Z0. R0\nG68.2 P2 Q1 X11. Y2. Z3.\nG68.2 P2 Q2 X1. Y2. Z3.\n"
		 "G68.2 P2 Q3 X11. Y-6.66025404 Z8.\n"),
		/* Turned by 90 about the new Z. */
		"G68.2 P2 Q1 X1. Y2. Z3. R90.\nG68.2 P2 Q2 X1. Y10.66025404 Z-2.\nG68.2 P2 Q3 X-4. Y2. Z3.\n",
		"G68.2 P3 Q1 X1. Y2. Z3. I-2. J0. K0.\nG68.2 P3 Q2 I0. J.5 K.8660254\n",
		"G68.2 P3 Q1 X1. Y2. Z3. I0. J.8660254 K-.5 R90.\nG68.2 P3 Q2 I0. J.5 K.8660254\n",
	};

	for (size_t i = 0; i < COUNT(planes); i++) {
		struct gcode_case c;
		struct strbuf text = {0};
		const char *found;
		double x = 0, y = 0, z = 0, a = 0;

		plane_case(&c, &dialect_fanuc);
		strbuf_addf(&text, "%sG53.1\nG0 X4. Y5. Z6.\nM30\n", planes[i]);
		ck_assert_msg(case_run(&c, text.text), "%s\n%s", text.text, strbuf_text(&c.messages));
		found = strstr(strbuf_text(&c.moves), "tcp on length 0 zero A0 C0\nrapid ");
		ck_assert_ptr_nonnull(found);
		found = strchr(found, '\n');
		ck_assert_int_eq(sscanf(found, " rapid %lf %lf %lf %lf", &x, &y, &z, &a), 4);
		ck_assert_msg(fabs(x - (1 - 4)) < 1e-6 && fabs(y - (2 - 5 * cos(radians(30)) + 6 * sin(radians(30)))) < 1e-6 &&
				  fabs(z - (3 + 5 * sin(radians(30)) + 6 * cos(radians(30)))) < 1e-6 && fabs(a - 30) < 1e-6,
			      "%.9g %.9g %.9g %.9g of\n%s", x, y, z, a, text.text);
		strbuf_release(&text);
		case_release(&c);
	}
}
END_TEST

/* "Tool Axis Direction Control (Tool Centre Point Retention Type)": G53.6 turns about the tip, under TCP. */
START_TEST(keeps_tip)
{
	struct gcode_case c;

	plane_case(&c, &dialect_fanuc);
	case_expect(&c, "G0 X7. Y8. Z50.\nG43 H1 Z50.\nG68.2 X10. Y20. Z30. I180. J90. K0.\nG53.6\nG0 X1. Y2. Z3.\nG69\nM30\n",
		    "rapid 7 8 50 0 0\nrapid 7 8 150 0 0\norient 0 1 0\ntcp on length 100 zero A0 C0\n"
		    "rapid 7 8 50 90 0 tcp\ntcp on length 100 zero A0 C0\nrapid 9 23 32 90 0 tcp\n"
		    "tcp off length 100 zero A0 C0\n");
}
END_TEST

/* The same manual, additional workpiece coordinate systems; Haas, G110-G129, G154, G10 L20. */
START_TEST(additional_offsets)
{
	static const struct work_offset offsets[] = {{.name = "G54.1 P2", .value = {{7}}}, {.name = "G54.1 P48", .value = {{9}}}};
	struct gcode_case c;

	plane_case(&c, &dialect_fanuc);
	c.config.work_offsets = offsets;
	c.config.work_offset_count = 2;
	case_expect(&c, "G54.1 P2 G0 X1.\nG54.1 P48 X1.\nG10 L20 P3 X40.\nG54.1 P3 X1.\nG54 X1.\nM30\n",
		    "rapid 8 0 0 0 0\nrapid 10 0 0 0 0\nrapid 41 0 0 0 0\nrapid 1 0 0 0 0\n");
	/* G54 with P is the same; G52 shifts whichever system is in force, and G92 all of them. */
	plane_case(&c, &dialect_fanuc);
	c.config.work_offsets = offsets;
	c.config.work_offset_count = 2;
	case_expect(&c,
		    "G54 P2 G0 X1.\nG52 X100.\nX1.\nG54.1 P48 X1.\nG52 X0.\nX1.\nG92 X5.\nG54 P2 X0.\nG54 X0.\nM30\n",
		    "rapid 8 0 0 0 0\nrapid 108 0 0 0 0\nrapid 110 0 0 0 0\nrapid 10 0 0 0 0\n"
		    "rapid 3 0 0 0 0\nrapid -4 0 0 0 0\n");
	/* The same manual, changing workpiece coordinate system; Haas, G10: with G91 the words are added. */
	plane_case(&c, &dialect_haas);
	c.config.work_offsets = offsets;
	c.config.work_offset_count = 2;
	case_expect(&c,
		    "G91 G10 L20 P2 X60.\nG90 G154 P2 G0 X0.\nG91 G10 L2 P1 Y-1.\nG90 G10 L2 P1 X3.\nG54 X0. Y0.\n"
		    "G91 X1.\nG10 L2 P1 X1.\nG90 X0.\nM30\n",
		    "rapid 67 0 0 0 0\nrapid 3 -1 0 0 0\nrapid 4 -1 0 0 0\nrapid 4 -1 0 0 0\n");
	plane_case(&c, &dialect_haas);
	c.config.work_offsets = offsets;
	c.config.work_offset_count = 2;
	case_expect(&c, "G111 G0 X1.\nG154 P48 X1.\nG154 P2 X2.\nG129 X3.\nM30\n",
		    "rapid 8 0 0 0 0\nrapid 10 0 0 0 0\nrapid 9 0 0 0 0\nrapid 3 0 0 0 0\n");
}
END_TEST

/* The same manual, "Decimal point programming"; increments of an inch are ten times as fine in their unit. */
START_TEST(least_input)
{
	struct gcode_case c;

	plane_case(&c, &dialect_fanuc);
	c.config.controller.least_input = 0.001;
	case_expect(&c,
		    "G0 X1000 Y1. C90000\nG1 F9 X2000\nG2 X0 I-1000 J0\nG91 G99 G81 X1000 Z-1000 R-1000 K2 F100\n"
		    "G80\nG4 X500\nG90 G20 G0 X10000\nM30\n",
		    "rapid 1 1 0 0 90\nfeed 2 1 0 0 90\n"
		    "arc 0 1 0 0 90 centre 1 1 0 normal 0 0 1 sweep -180\n"
		    "rapid 1 1 0 0 90\nrapid 1 1 -1 0 90\nfeed 1 1 -2 0 90\nrapid 1 1 -1 0 90\n"
		    "rapid 2 1 -1 0 90\nrapid 2 1 -1 0 90\nfeed 2 1 -2 0 90\nrapid 2 1 -1 0 90\n"
		    "dwell 0.5\nrapid 25.4 1 -1 0 90\n");
}
END_TEST

/*
 * B-64484EN, decimal point programming, appendix range of command value: pecks, arc radii, offsets, shifts and ways
 * by reference positions count increments, and so do angles, in G20 as well; P of dwells is in ms, F in mm/min.
 */
START_TEST(least_input_by_address)
{
	struct gcode_case c;

	plane_case(&c, &dialect_fanuc);
	c.config.controller.least_input = 0.001;
	c.show_feed = true;
	case_expect(&c,
		    "G10 L2 P1 X10000\nG0 X0\nG52 Y2000\nG1 Y0 F60\nG52 Y0\nG2 X2000 Y2000 R1000 F60.\nG28 X1000\n"
		    "G99 G83 X0 Y0 Z-2000 R0 Q1000 F60\nG80\nG4 P1500\nG68 X0 Y0 R90000\nG0 X1000 Y0\nM30\n",
		    "rapid 10 0 0 0 0\nfeed 10 2 0 0 0 at 1 1\n"
		    "arc 12 2 0 0 0 centre 11 2 0 normal 0 0 1 sweep -180 at 1 1\n"
		    "rapid 11 2 0 0 0\nrapid 0 2 0 0 0\n"
		    "rapid 10 0 0 0 0\nrapid 10 0 0 0 0\nfeed 10 0 -1 0 0 at 1 1\nrapid 10 0 0 0 0\n"
		    "rapid 10 0 -0.746 0 0\nfeed 10 0 -2 0 0 at 1 1\nrapid 10 0 0 0 0\n"
		    "dwell 1.5 at 0 0\nrapid 10 1 0 0 0\n");
	plane_case(&c, &dialect_fanuc);
	c.config.controller.least_input = 0.001;
	case_expect(&c, "G20\nG68.2 X10000 I180000 J90000\nG53.1\nG0 X0 Y0 Z1.\nM30\n",
		    "orient 0 1 0\nrapid 0 0 0 90 0\ntcp on length 0 zero A0 C0\nrapid 25.4 25.4 0 90 0 tcp\n");
}
END_TEST

/* Haas, "M06 Tool Change": Z goes home by itself; on Fanuc controls it is the machine builder's choice. */
static void change_without_place(const struct dialect *dialect)
{
	struct gcode_case c;

	plane_case(&c, dialect);
	ck_assert(!case_run(&c, "G0 Z5.\nT1 M6\nM30\n"));
	ck_assert_str_eq(strbuf_text(&c.moves), "rapid 0 0 5 0 0\n");
	ck_assert_str_eq(strbuf_text(&c.messages),
			 "p.nc:2:4: error: it is not known where M6 moves the axes: set <tool_change Z=\"\" .../>, or "
			 "<tool_change/> if it moves none, in the machine file's <controller>\n"
			 "    T1 M6\n       ^\n");
	case_release(&c);
	plane_case(&c, dialect);
	c.config.controller.tool_change.given = true;
	case_expect(&c, "G0 Z5.\nT1 M6\nM30\n", "rapid 0 0 5 0 0\ntool 1\n");
	plane_case(&c, dialect);
	c.config.controller.tool_change = (struct control_place){.given = true, .has[SLOT_Z] = true, .order = {SLOT_Z},
						    .order_count = 1};
	case_expect(&c, "G0 X1. Z5.\nT1 M6\nM30\n", "rapid 1 0 5 0 0\nrapid 1 0 0 0 0\ntool 1\n");
}

START_TEST(tool_change_without_place)
{
	change_without_place(&dialect_haas);
	change_without_place(&dialect_fanuc);
}
END_TEST

/* A position with a rotary axis would turn the tool away from its plane. */
START_TEST(tool_change_on_a_plane)
{
	struct gcode_case c;

	plane_case(&c, &dialect_fanuc);
	c.config.controller.tool_change = (struct control_place){.given = true, .has[SLOT_A] = true};
	ck_assert(!case_run(&c, "G68.2 X0. I180. J90.\nG53.1\nT1 M6\n"));
	ck_assert_ptr_nonnull(strstr(strbuf_text(&c.messages),
				     "p.nc:3:4: error: M6 while G68.2 is active turns A away from its plane; write G69 "
				     "first\n"));
	case_release(&c);
}
END_TEST

/* Haas, "G234 Tool Center Point Control". */
START_TEST(haas_tool_centre)
{
	run(&dialect_haas, "G234 H1\nG0 X1.\nG49\nM30\n",
	    "tcp on length 0 zero A0 C0\ntcp on length 100 zero A0 C0\nrapid 1 0 -100 0 0 tcp\n"
	    "tcp on length 0 zero A0 C0\ntcp off length 0 zero A0 C0\n");
}
END_TEST

struct bad {
	const struct dialect *dialect;
	const char *before, *block;
	int column;
	const char *message;
};

#define BY_MACHINE(what)                                                                                              \
	what " while G68 is active: controls differ in whether the path and the coordinates after it are rotated; "   \
	     "write G69 first"

#define TILT "G68.2 X0. I180. J90."

static const struct bad bads[] = {
    {&dialect_linuxcnc, "", "G68 R5", 1, "G68: coordinate rotation (PathPilot, Mach3) is not supported; post the program without it"},
    {&dialect_fanuc, "", "G68 X0. Y0.", 1,
     "G68 needs R (angle); without R, the control takes the angle from a parameter or setting"},
    {&dialect_fanuc, "", "G68 X0. Z0. R5.", 9, "Z does not belong to the centre of G68 in the plane of G17"},
    {&dialect_haas, "", "G68 X0. R5.", 1,
     "G68 needs both words of its centre, or none for the present position"},
    {&dialect_haas, "", "G68 X0. Y0. Z0. I0. J0. K1. R5.", 1,
     "G68 with I, J, K: this control has no three-dimensional coordinate conversion"},
    {&dialect_fanuc, "G43.4 H1", "G68 R5.", 1,
     "G68 under tool centre point control; cancel tool centre point control first"},
    {&dialect_fanuc, "M428", "G68 R5.", 1,
     "G68 under tool centre point control; cancel tool centre point control first"},
    {&dialect_fanuc, "G68 R5.", "M428", 1, "tool centre point control while G68 is active; write G69 first"},
    {&dialect_haas, "G234 H1", "G68 R5.", 1,
     "G68 under tool centre point control; cancel tool centre point control first"},
    /* Fanuc B-62764EN, "Coordinate system rotation": no reference positions and no machine coordinates meanwhile. */
    {&dialect_fanuc, "G68 R5.", "G91 G28 Z0.", 5, "G28 while G68 is active; write G69 first"},
    {&dialect_fanuc, "G68 R5.", "G30 Z0.", 1, "G30 while G68 is active; write G69 first"},
    {&dialect_fanuc, "G0\nG68 R5.", "G53 Z0.", 1, "G53 while G68 is active; write G69 first"},
    {&dialect_haas, "G0\nG68 R5.", "G53 X0.", 1, BY_MACHINE("G53 with X")},
    {&dialect_haas, "G68 R5.", "G91 G28 Y0. Z0.", 5, BY_MACHINE("G28 with Y")},
    {&dialect_haas, "G68 R5.", "G28", 1, BY_MACHINE("G28 with X")},
    {&dialect_haas, "G18 G68 R5.", "G30 Z5.", 1, BY_MACHINE("G30 with Z")},
    /* The same: the first move after G69 is absolute. */
    {&dialect_fanuc, "G0 X5. Y5.\nG68 X0. Y0. R90.\nX5. Y7.\nG69", "G91 Y1.", 5,
     "increment in Y after G69: the first move must be absolute"},
    {&dialect_fanuc, "G0 X5. Y5.\nG68 X0. Y0. R90.\nX5. Y7.\nG69\nX0.", "G91 X1. Y1.", 9,
     "increment in Y after G69: the first move must be absolute"},
    {&dialect_fanuc, "G0 X5. Y5.\nG68 X0. Y0. R90.", "X1.", 1,
     "X without Y in the first absolute move after G68: controls differ in whether Y keeps its programmed or its "
     "rotated coordinate; write both"},
    {&dialect_haas, "G0 X5. Y5. Z9.\nG18 G68 X0. Z0. R90.\nG91 X1.", "G90 Y1. Z1.", 9,
     "Z without X in the first absolute move after G68: controls differ in whether X keeps its programmed or its "
     "rotated coordinate; write both"},
    {&dialect_fanuc, "G91", "G68 X0. R5.", 1, "G68 in incremental mode (G91) is not supported"},
    {&dialect_fanuc, "G68 R5.", "G68 R5.", 1, "the coordinates are already rotated; cancel this by G69 first"},
    {&dialect_fanuc, "G68 R5.", "G18", 1, "a change of the plane while G68 is active; write G69 first"},
    {&dialect_fanuc, "G68 R5.", "G55", 1, "a change of offsets while G68 is active is not supported; write G69 first"},
    {&dialect_fanuc, "G68 R5.", "G92 X0.", 1,
     "a change of offsets while G68 is active is not supported; write G69 first"},
    {&dialect_fanuc, "G68 R5.", "G43.4 H1", 1,
     "G43.4 (tool centre point control) while G68 is active is not supported; write G69 first"},
    {&dialect_fanuc, "", "G0 G68 X0. R5.", 1, "G68 needs a block without motion, offsets or a dwell"},
    {&dialect_fanuc, "", "G53.1", 1, "G53.1 needs a plane of G68.2 directly before it"},
    {&dialect_fanuc, TILT, "G53.1 X1.", 7,
     "axis words without an active motion code (G0, G1, G2, G3); set power_on_motion=\"rapid\" or \"feed\" (the motion "
     "code at power-on) in the machine file's <controller>"},
    {&dialect_fanuc, TILT, "G0 X1.", 1,
     "a move between G68.2 and G53.1 is not supported, because the tool does not yet stand on the plane"},
    {&dialect_fanuc, "G68.2 X0. Y0. Z0. I0. J0. K0.", "G53.1 P1", 7,
     "P of G53.1, which selects one of several positions of the rotary axes, is not supported: remove P, and turn the "
     "axes towards the intended position in a block before"},
    {&dialect_fanuc, TILT "\nG53.1 P1", "G53.1", 1, "G53.1 needs a plane of G68.2 directly before it"},
    {&dialect_fanuc, TILT "\nG53.1", "G0 C5.", 4,
     "C while G68.2 is active: the tool would leave the direction of the tilted plane"},
    {&dialect_fanuc, TILT "\nG53.1", "G53 G0 A0.", 8,
     "A while G68.2 is active: the tool would leave the direction of the tilted plane"},
    {&dialect_fanuc, TILT "\nG53.1", "G91 G28 A0. C0.", 9,
     "A while G68.2 is active: the tool would leave the direction of the tilted plane"},
    {&dialect_fanuc, "", "G68.3 X0. Y0. Z0.", 1,
     "G68.3: tilted working plane from the tool direction (write the plane as G68.2) is not supported; "
     "post the program without it"},
    {&dialect_fanuc, "", "G53.6", 1, "G53.6 needs a plane of G68.2 directly before it"},
    {&dialect_fanuc, TILT, "G53.6", 1,
     "G53.6 needs a tool length, because it keeps the tool tip in place; write G43 first"},
    /* B-64484EN, 2nd, 3rd, and 4th reference position return (G30): which places they are, parameters say. */
    {&dialect_fanuc, "", "G91 G30 Z0.", 5,
     "the machine file has no reference position 2: set <reference number=\"2\" X=\"\" .../> in its <controller>"},
    {&dialect_haas, "", "G91 G30 P3 Z0.", 9,
     "the machine file has no reference position 3: set <reference number=\"3\" X=\"\" .../> in its <controller>"},
    {&dialect_fanuc, TILT "\nG53.1", "G54", 1,
     "a change of offsets while G68.2 is active is not supported; write G69 first"},
    {&dialect_fanuc, TILT "\nG53.1", "G43.4 H1", 1,
     "G43.4 (tool centre point control) while G68.2 is active is not supported; for moves without rotary axes write G43 "
     "instead, else write G69 first"},
    {&dialect_fanuc, TILT, "G43.5 H1", 1, "G43.5 (tool centre point control) while G68.2 is active is not supported; "
     "for moves without rotary axes write G43 instead, else write G69 first"},
    {&dialect_fanuc, "", "G68.2 A5.", 7, "A does not belong to G68.2, whose origin is given by X, Y and Z"},
    {&dialect_fanuc, "", "G68.2 I5. R3.", 11, "R does not belong to this form of G68.2"},
    {&dialect_fanuc, "", "G68.2 P1 Q131 I5.", 10,
     "Q of G68.2 P1 is the order of the axes: 123, 132, 213, 231, 312 or 321"},
    {&dialect_fanuc, "", "G68.2 P2 X0. Y0. Z0.", 1,
     "G68.2 P2 and P3 need Q (which part of the plane the block gives)"},
    {&dialect_fanuc, "", "G68.2 P2 Q2 X0. Y0. Z0.", 10, "Q2 of G68.2 P2, but Q1 must come next"},
    {&dialect_fanuc, "G68.2 P2 Q1 X0. Y0. Z0.", "G68.2 P2 Q3 X0. Y0. Z0.", 10, "Q3 of G68.2 P2, but Q2 must come next"},
    {&dialect_fanuc, "G68.2 P2 Q1 X0. Y0. Z0.", "G68.2 P3 Q1 I1. J0. K0.", 1,
     "another form of G68.2 before the plane is complete"},
    {&dialect_fanuc, "G68.2 P2 Q1 X0. Y0. Z0.", "G0 X1.", 1,
     "the plane of G68.2 P2 is not complete: Q2 must come next"},
    {&dialect_fanuc, "G68.2 P2 Q1 X0. Y0. Z0.\nG68.2 P2 Q2 X1. Y0. Z0.", "G68.2 P2 Q3 X-3. Y0. Z0.", 1,
     "the three points of G68.2 P2 are on one line or coincide"},
    {&dialect_fanuc, "", "G68.2 P2 Q1 X0. Z0.", 1, "a point of G68.2 P2 needs X, Y and Z"},
    {&dialect_fanuc, "G68.2 P3 Q1 X0. I1. J0. K0.", "G68.2 P3 Q2 I1. J0. K1.", 1,
     "the two directions of G68.2 P3 are not at a right angle"},
    {&dialect_fanuc, "", "G68.2 P4 I5.", 1, "G68.2 P4 (projection angles) is not supported; use P1 or Euler angles"},
    {&dialect_fanuc, "G43.4 H1", "G68.2 I5.", 1,
     "G68.2 under tool centre point control; cancel tool centre point control first"},
    {&dialect_haas, "", "G68.2 I5.", 1, "G68.2: tilted working plane is not supported; post the program without it"},
    {&dialect_haas, "", "G43.5 H1", 1, "G43.5: tool centre point control with tool vectors is not supported; "
    "post the program without it"},
    {&dialect_fanuc, "", "G54.1", 1, "G54.1 needs P"},
    /* One P, and two codes that take one. */
    {&dialect_fanuc, "", "G54.1 P1 G68.2 X0. Y0. Z0. I0. J30. K0.", 7,
     "P can belong to G54.1 or to G68.2, and it is not known to which; write two blocks"},
    {&dialect_fanuc, "", "G54 G68.2 P1 J30.", 11,
     "P can belong to G54 or to G68.2, and it is not known to which; write two blocks"},
    {&dialect_fanuc, "", "G91 G54.1 P2 G30 Z0.", 11,
     "P can belong to G54.1 or to G30, and it is not known to which; write two blocks"},
    {&dialect_haas, "", "G154 P2 G51 X0. Y0.", 6,
     "P can belong to G154 or to G51, and it is not known to which; write two blocks"},
    {&dialect_fanuc, "", "G54 G82 X1. Y1. Z-1. R1. P48", 26,
     "P can belong to G54 or to G82, and it is not known to which; write two blocks"},
    {&dialect_fanuc, "", "G54 G4 P5", 8,
     "P can belong to G54 or to G4, and it is not known to which; write two blocks"},
    {&dialect_fanuc, "", "G5.1 Q1 G83 X1. Y1. Z-1. R1.", 6,
     "Q can belong to G83 or to G5.1, and it is not known to which; write two blocks"},
    {&dialect_haas, "", "G154 P2 G4", 6,
     "P can belong to G154 or to G4, and it is not known to which; write two blocks"},
    {&dialect_haas, "", "G187 P2 G82 X1. Y1. Z-1. R1.", 6,
     "P can belong to G82 or to G187, and it is not known to which; write two blocks"},
    {&dialect_fanuc, "", "G54.1 P301", 7, "P301 must be a whole number from 1 to 300"},
    {&dialect_haas, "", "G154 P100", 6, "P100 must be a whole number from 1 to 99"},
    {&dialect_fanuc, "", "G110", 1,
     "G110 is not a G-code of the fanuc dialect; if the machine builder made it, set <macro code=\"\"/> in the machine "
     "file's <controller>"},
    /* Older manuals have G112 among G110 to G129, newer ones among the interpolations. */
    {&dialect_haas, "", "G112", 1,
     "G112: XY to XC interpolation (on older controls additional work offset 3: write G154 P3) is not supported; "
     "post the program without it"},
    {&dialect_haas, "", "G234", 1, "G234 needs H"},
};

START_TEST(refused)
{
	const struct bad *bad = &bads[_i];
	struct gcode_case c;

	plane_case(&c, bad->dialect);
	case_refuses_last(&c, bad->column, bad->message, "%s%s%s\n", bad->before, *bad->before ? "\n" : "", bad->block);
}
END_TEST

START_TEST(plane_that_the_machine_cannot_reach)
{
	struct gcode_case c;

	plane_case(&c, &dialect_fanuc);
	case_refuses(&c, "p.nc:2:1: error: no such plane here\n", "G68.2 I90. J90.\nG53.1\n");
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("programs");

	tcase_add_test(tcase, rotation);
	tcase_add_test(tcase, rotated_arcs_and_cycles);
	tcase_add_test(tcase, p_beside_g54);
	tcase_add_test(tcase, tilted);
	tcase_add_test(tcase, tilted_in_every_form);
	tcase_add_test(tcase, keeps_tip);
	tcase_add_test(tcase, additional_offsets);
	tcase_add_test(tcase, least_input);
	tcase_add_test(tcase, least_input_by_address);
	tcase_add_test(tcase, tool_change_without_place);
	tcase_add_test(tcase, tool_change_on_a_plane);
	tcase_add_test(tcase, haas_tool_centre);
	tcase_add_test(tcase, plane_that_the_machine_cannot_reach);
	tcase_add_loop_test(tcase, refused, 0, COUNT(bads));
	return run_suite("gcode_plane", tcase);
}
