/* test_gcode.c - motion: straight moves, arcs, coordinates, feeds, in the words of LinuxCNC's manual. */
#include "gcode_case.h"

START_TEST(straight_moves)
{
	expect_moves("G0 X10 Y-2.5\nG1 Z3 F60\nA45\nX.5C-90\nM2\n",
		     "rapid 10 -2.5 0 0 0\nfeed 10 -2.5 3 0 0\nfeed 10 -2.5 3 45 0\nfeed 0.5 -2.5 3 45 -90\n");
	/* A motion code without axis words is a move of length 0. */
	expect_moves("G0\nM2\n", "rapid 0 0 0 0 0\n");
}
END_TEST

START_TEST(other_axes)
{
	struct gcode_case c;

	case_init(&c);
	c.config.has_axis[SLOT_B] = c.config.has_axis[SLOT_W] = true;
	case_expect(&c, "G20 G52 W1\nG0 W1 B10\nG91 W-1 B5\nM2\n",
		    "rapid 0 0 0 0 10 0 50.8\nrapid 0 0 0 0 15 0 25.4\n");
}
END_TEST

START_TEST(words_are_free_in_form)
{
	expect_moves("n10 g0x1 0 .5 y - 2\n/g 0 1 z+3.f100 (comment) ; more G0 X99\nM2\n",
		     "rapid 10.5 -2 0 0 0\nfeed 10.5 -2 3 0 0\n");
	expect_moves("%\nG00(X5)X1\n%\nthis is not read\n", "rapid 1 0 0 0 0\n");
	expect_moves("\n \t\n%\t\nG0 X1\n%", "rapid 1 0 0 0 0\n");
	expect_moves("G0.0 X1\nM30\nM99999\n%%%\n", "rapid 1 0 0 0 0\n");
}
END_TEST

START_TEST(block_delete)
{
	struct gcode_case c;

	case_init(&c);
	c.config.read.block_delete = true;
	case_expect(&c, "/G0 X1 Q7\nG0 Y1\n /G0 Z9\nM2\n", "rapid 0 1 0 0 0\n");
}
END_TEST

START_TEST(incremental_and_units)
{
	expect_moves("G20 G91 G0 X1 A10\nX1 A10\nG21 X1\nG90 X1\nM2\n",
		     "rapid 25.4 0 0 10 0\nrapid 50.8 0 0 20 0\nrapid 51.8 0 0 20 0\nrapid 1 0 0 20 0\n");
}
END_TEST

START_TEST(order_of_execution)
{
	/* Units, offset and distance mode act before the motion of their own block; the dwell before all of them. */
	expect_moves("G10 L2 P2 X100\nG0 X1 G20 G55\nX1 G91\nG4 P.5 G90 G54 X0\nM2\n",
		     "rapid 125.4 0 0 0 0\nrapid 150.8 0 0 0 0\ndwell 0.5\nrapid 0 0 0 0 0\n");
	/* The tool is changed before the block moves. */
	expect_moves("G0 X1 M6 T3\nM6 T0\nM2\n", "tool 3\nrapid 1 0 0 0 0\ntool 0\n");
}
END_TEST

START_TEST(group_zero_suspends_motion)
{
	expect_moves("G0 X1\nG92 X0\nX1\nG92.1 X5\nM2\n", "rapid 1 0 0 0 0\nrapid 2 0 0 0 0\nrapid 5 0 0 0 0\n");
	expect_moves("G0 G80 X1\nG80 G0 X2\nM2\n", "rapid 1 0 0 0 0\nrapid 2 0 0 0 0\n");
}
END_TEST

START_TEST(work_offsets)
{
	expect_moves("G10 L2 P1 X10 A30\nG0 X1 A1\nG10 L2 P0 X20\nX1\nG10 L20 P1 X5\nX5\nG59.3 X5\n"
		     "G10 L20 P3 Z-7\nG56 Z0\nM2\n",
		     "rapid 11 0 0 31 0\nrapid 21 0 0 31 0\nrapid 21 0 0 31 0\nrapid 5 0 0 31 0\nrapid 5 0 7 31 0\n");
}
END_TEST

START_TEST(setup_offsets)
{
	const struct work_offset offsets[] = {{.name = "G54", .value = {{1, 2, 3, radians(30)}}}, {.name = "G59.1", .value = {{10}}}};
	struct gcode_case c;

	case_init(&c);
	c.config.has_setup = true;
	c.config.work_offsets = offsets;
	c.config.work_offset_count = 2;
	case_expect(&c, "G0 X0 Y0 Z0 A60\nG59.1 X1 A60\nM2\n", "rapid 1 2 3 90 0\nrapid 11 2 3 60 0\n");
	/* Without a setup no offset is known and none is missing; the verdict says that there was no setup. */
	case_init(&c);
	case_expect(&c, "G57 G0 X1\nM2\n", "rapid 1 0 0 0 0\n");
}
END_TEST

START_TEST(shifts)
{
	/* G92 X7 at 4 makes the shift -3; G52 sets it outright; both write the same shift in LinuxCNC. */
	expect_moves("G0 X4\nG92 X7\nX0\nG92.2\nX0\nG92.3\nX0\nG92.1\nG92.3\nX0\nG52 X2 Y1\nX0 Y0\nG52 X0\nX0\nM2\n",
		     "rapid 4 0 0 0 0\nrapid -3 0 0 0 0\nrapid 0 0 0 0 0\nrapid -3 0 0 0 0\nrapid 0 0 0 0 0\n"
		     "rapid 2 1 0 0 0\nrapid 0 1 0 0 0\n");
	/* It shifts every coordinate system. */
	expect_moves("G10 L2 P2 X10\nG52 X1\nG55 G0 X0\nM2\n", "rapid 11 0 0 0 0\n");
}
END_TEST

START_TEST(machine_coordinates)
{
	expect_moves("G10 L2 P1 X10 Y10\nG92 Z5\nG20\nG53 G0 X1 Z-1\nX0\nG53 G1 Y1 F5\nM2\n",
		     "rapid 25.4 0 -25.4 0 0\nrapid 10 0 -25.4 0 0\nfeed 10 25.4 -25.4 0 0\n");
}
END_TEST

START_TEST(reference_moves)
{
	struct gcode_case c;

	case_init(&c);
	c.config.home = (axis_values){{1, 2, 3, 0, 0, radians(-90)}};
	case_expect(
	    &c, "G10 L2 P1 X100\nG0 X0\nG28 Z10\nG28\nG91 G30 X1 Y1\nG90 G0 X5\nG28.1\nG28 C0\nG0 X0\nG28\nG30\nM2\n",
	    "rapid 100 2 3 0 -90\n"
	    "rapid 100 2 10 0 -90\nrapid 100 2 3 0 -90\n"
	    "rapid 1 2 3 0 -90\n"
	    "rapid 2 3 3 0 -90\nrapid 1 2 3 0 -90\n"
	    "rapid 105 2 3 0 -90\n"
	    "rapid 105 2 3 0 0\nrapid 105 2 3 0 -90\n"
	    "rapid 100 2 3 0 -90\nrapid 105 2 3 0 -90\nrapid 1 2 3 0 -90\n");
}
END_TEST

START_TEST(tool_length)
{
	const struct tool tools[] = {{.number = 1, .length_offset = 100, .diameter = 10},
				      {.number = 2, .length_offset = 50, .diameter = 6}};
	const struct length_offset lengths[] = {{1, 100}, {2, 50}, {7, 33}};
	struct gcode_case c;

	case_init(&c);
	c.config.has_setup = true;
	c.config.initial_tool = 2;
	c.config.tools = tools;
	c.config.tool_count = 2;
	c.config.lengths = lengths;
	c.config.length_count = 3;
	/* H0 stands for the tool in the spindle, as rs274 has it. */
	case_expect(
	    &c,
	    "G43 G0 Z0\nT1 M6\nZ0\nG43 Z1\nG43 H7 Z1\nG43 H0 Z1\nG49 Z1\nG43 H1 G53 Z-5\nG91 Z1\nG90 Z0\n"
	    "T0 M6 G43 Z0\nM2\n",
	    "rapid 0 0 50 0 0\ntool 1\nrapid 0 0 50 0 0\nrapid 0 0 101 0 0\nrapid 0 0 34 0 0\nrapid 0 0 101 0 0\n"
	    "rapid 0 0 1 0 0\nrapid 0 0 -5 0 0\nrapid 0 0 -4 0 0\nrapid 0 0 100 0 0\ntool 0\nrapid 0 0 0 0 0\n");
}
END_TEST

START_TEST(arcs_by_centre)
{
	/* G2 is clockwise seen from the positive end of the plane's normal: G17 +Z, G18 +Y, G19 +X. */
	expect_moves("F60 G2 X10 I5\nG3 X0 I-5\nG2 I5 J0\nG3 X5 Y5 Z7 I5 P3\nM2\n",
		     "arc 10 0 0 0 0 centre 5 0 0 normal 0 0 1 sweep -180\n"
		     "arc 0 0 0 0 0 centre 5 0 0 normal 0 0 1 sweep 180\n"
		     "arc 0 0 0 0 0 centre 5 0 0 normal 0 0 1 sweep -360\n"
		     "arc 5 5 7 0 0 centre 5 0 0 normal 0 0 1 sweep 990\n");
	/* Z to X is the positive quarter turn about +Y: from (z,x) = (1,0) about 0 to (0,1). */
	expect_moves("F60 G0 Z1\nG18 G3 X1 Z0 K-1 Y4\nG0 X0 Y1 Z0\nG19 G2 Y0 Z1 J-1\nM2\n",
		     "rapid 0 0 1 0 0\narc 1 4 0 0 0 centre 0 0 0 normal 0 1 0 sweep 90\n"
		     "rapid 0 1 0 0 0\narc 0 0 1 0 0 centre 0 0 0 normal 1 0 0 sweep -270\n");
	/* Only I in a block under G2: a full circle. */
	expect_moves("F60 G2 X10 I5\nI-5\nM2\n", "arc 10 0 0 0 0 centre 5 0 0 normal 0 0 1 sweep -180\n"
						 "arc 10 0 0 0 0 centre 5 0 0 normal 0 0 1 sweep -360\n");
}
END_TEST

START_TEST(arcs_with_absolute_centre)
{
	expect_moves(
	    "G10 L2 P1 X100 Z10\nG52 Y1\nG0 X0 Y0 Z0\nF60 G90.1 G2 X10 I5 J0\nG20 G91.1 G91 G3 X-.2 I-.1 A2\nM2\n",
	    "rapid 100 1 10 0 0\narc 110 1 10 0 0 centre 105 1 10 normal 0 0 1 sweep -180\n"
	    "arc 104.92 1 10 2 0 centre 107.46 1 10 normal 0 0 1 sweep 180\n");
}
END_TEST

START_TEST(arcs_by_radius)
{
	/* Chord 2, radius sqrt 2: a quarter by the short way, its centre 1 off the chord; the rest by the long way. */
	expect_moves("F60 G2 X2 R1.414213562373095\nX0 R-1.414213562373095\nG3 X2 R1.414213562373095\nX0 "
		     "R-1.414213562373095\nM2\n",
		     "arc 2 0 0 0 0 centre 1 -1 0 normal 0 0 1 sweep -90\n"
		     "arc 0 0 0 0 0 centre 1 -1 0 normal 0 0 1 sweep -270\n"
		     "arc 2 0 0 0 0 centre 1 1 0 normal 0 0 1 sweep 90\n"
		     "arc 0 0 0 0 0 centre 1 1 0 normal 0 0 1 sweep 270\n");
	/* Half a circle whose radius is a little short of half the chord. */
	expect_moves("F60 G2 X10 R4.9999\nG18 G3 X8 Z4 R10\nM2\n",
		     "arc 10 0 0 0 0 centre 5 0 0 normal 0 0 1 sweep -180\n"
		     "arc 8 0 4 0 0 centre 17.7177979 0 6.35889894 normal 0 1 0 sweep 25.8419328\n");
}
END_TEST

START_TEST(arc_tolerances)
{
	/* LinuxCNC: radii may differ by 0.0283 mm, or by 0.1 % if that is more. */
	expect_moves("F60 G2 X10.028 I5\nM2\n", "arc 10.028 0 0 0 0 centre 5 0 0 normal 0 0 1 sweep -180\n");
	expect_moves("F60 G2 X200.099 I100\nM2\n", "arc 200.099 0 0 0 0 centre 100 0 0 normal 0 0 1 sweep -180\n");
}
END_TEST

START_TEST(full_circle_in_spite_of_rounding)
{
	/* Ten steps of 0.1 do not add up to 1 in floating point; the arc back to X1 is still a full circle. */
	struct gcode_case c;

	case_init(&c);
	ck_assert(
	    case_run(&c, "G91 G0 X.1\nX.1\nX.1\nX.1\nX.1\nX.1\nX.1\nX.1\nX.1\nX.1\nG90 F9 G2 X1 I1\nG3 X1 I1\nM2\n"));
	ck_assert_ptr_nonnull(
	    strstr(strbuf_text(&c.moves), "sweep -360\narc 1 0 0 0 0 centre 2 0 0 normal 0 0 1 sweep 360\n"));
	case_release(&c);
}
END_TEST

START_TEST(no_drift)
{
	/* After a thousand changes of offset an axis without a word has exactly its old position. */
	struct strbuf program = {0}, moves = {0};

	strbuf_addf(&program, "G10 L2 P2 X.1 Y.7 A.3\nG0 X.3 Y.2 A.1\n");
	strbuf_addf(&moves, "rapid 0.3 0.2 0 0.1 0\n");
	for (int i = 0; i < 1000; i++)
		strbuf_addf(&program, "G5%d\nG52 X.%03d Y.1 A.7\n", 4 + i % 2, i);
	strbuf_addf(&program, "G0 Z1\nM2\n");
	strbuf_addf(&moves, "rapid 0.3 0.2 1 0.1 0\n");
	expect_moves(program.text, moves.text);
	strbuf_release(&program);
	strbuf_release(&moves);
}
END_TEST

START_TEST(feeds)
{
	struct gcode_case c;

	case_init(&c);
	c.show_feed = true;
	/* 600 mm/min is 10 mm/s; the same number is degrees for rotary axes. Inches scale the length only. */
	case_expect(&c, "G1 X1 F600\nG20 X1\nF6 X2\nG93 X1 F30\nG2 I.1 F2\nG94 F3 G1 X0\nG95 S1200 F.5 G21 X0\nM2\n",
		    "feed 1 0 0 0 0 at 10 10\nfeed 25.4 0 0 0 0 at 10 10\nfeed 50.8 0 0 0 0 at 2.54 0.1\n"
		    "feed 25.4 0 0 0 0 in 2 s\narc 25.4 0 0 0 0 centre 27.94 0 0 normal 0 0 1 sweep -360 in 30 s\n"
		    "feed 0 0 0 0 0 at 1.27 0.05\nfeed 0 0 0 0 0 at 254 10\n");
}
END_TEST

START_TEST(path_control)
{
	struct gcode_case c;

	case_init(&c);
	c.show_blend = true;
	case_expect(&c, "G0 X1\nG64 X2\nG64 P.1 Q.2 X3\nG20 G64 P.1 X0\nG61 X1\nG64\nX2\nG61.1 X3\nM2\n",
		    "rapid 1 0 0 0 0 blend 0\nrapid 2 0 0 0 0 blend 0\nrapid 3 0 0 0 0 blend 0.1\n"
		    "rapid 0 0 0 0 0 blend 2.54\nrapid 25.4 0 0 0 0 exact\nrapid 50.8 0 0 0 0 blend 0\n"
		    "rapid 76.2 0 0 0 0 exact\n");
}
END_TEST

/* LinuxCNC's manual, "WRAPPED_ROTARY"; Fanuc B-63534EN, "Rotary axis roll-over": G90 the shorter way, G91 literal. */
START_TEST(wrapped_axes)
{
	struct gcode_case c;

	case_init(&c);
	c.config.wrap[SLOT_A] = WRAP_SIGN;
	c.config.wrap[SLOT_C] = WRAP_SHORTEST;
	/* A: the sign is the direction; -0 turns back to 0. C: the shorter way round, beyond one turn too. */
	case_expect(
	    &c,
	    "G0 A90\nA-80\nA-80\nA-0\nA350\nA10\nG91 A-720\nG90 A-350\nC350\nC200\nC100\nG91 C300\nG90 C0\nC725\nM2\n",
	    "rapid 0 0 0 90 0\nrapid 0 0 0 80 0\nrapid 0 0 0 80 0\nrapid 0 0 0 0 0\nrapid 0 0 0 350 0\n"
	    "rapid 0 0 0 370 0\nrapid 0 0 0 -350 0\nrapid 0 0 0 -370 0\nrapid 0 0 0 -370 -10\n"
	    "rapid 0 0 0 -370 -160\nrapid 0 0 0 -370 -260\nrapid 0 0 0 -370 40\nrapid 0 0 0 -370 0\n"
	    "rapid 0 0 0 -370 5\n");
	case_init(&c);
	c.config.wrap[SLOT_C] = WRAP_SHORTEST;
	ck_assert(!case_run(&c, "G0 C-180\nC0\nM2\n"));
	ck_assert_str_eq(strbuf_text(&c.messages),
			 "p.nc:1:4: error: half a turn of C is equally short in both directions: set "
			 "half_turn=\"positive\" or \"negative\" for this axis in the machine file\n    G0 C-180\n     "
			 "  ^\n");
	case_release(&c);
	for (int way = -1; way <= 1; way += 2) {
		case_init(&c);
		c.config.wrap[SLOT_C] = WRAP_SHORTEST;
		c.config.half_turn[SLOT_C] = way;
		case_expect(&c, "G0 C-180\nC0\nC90\nC-90\nM2\n",
			    way > 0 ? "rapid 0 0 0 0 180\nrapid 0 0 0 0 360\nrapid 0 0 0 0 450\nrapid 0 0 0 0 630\n"
				    : "rapid 0 0 0 0 -180\nrapid 0 0 0 0 -360\nrapid 0 0 0 0 -270\nrapid 0 0 0 "
				        "0 -450\n");
	}
}
END_TEST

START_TEST(blocks_and_numbers)
{
	struct gcode_case c;

	case_init(&c);
	c.config.initial_tool = 4;
	ck_assert(case_run(&c, "%\n(only a comment)\n  G28 X1 ; by way of X1\n\nN20\nM3 S100\nM6 T1 G0 X1\nm30"));
	ck_assert_str_eq(strbuf_text(&c.blocks),
			 "3:2:  G28 X1 ; by way of X1\n5:0:N20\n6:0:M3 S100\n7:2:M6 T1 G0 X1\n8:0:m30\n");
	ck_assert_int_eq(c.lines, 8);
	case_release(&c);
}
END_TEST

START_TEST(sink_stops)
{
	struct gcode_case c;

	case_init(&c);
	c.stop_at = 2;
	ck_assert(!case_run(&c, "G0 X1\nX2\nX3\nM2\n"));
	ck_assert_str_eq(strbuf_text(&c.moves), "rapid 1 0 0 0 0\nrapid 2 0 0 0 0\n");
	ck_assert_str_eq(strbuf_text(&c.blocks), "1:1:G0 X1\n");
	ck_assert_uint_eq(c.diag.errors, 0);
	case_release(&c);
}
END_TEST

START_TEST(paper_block)
{
	struct gcode_case c;

	case_init(&c);
	ck_assert(!case_run(&c, "G01 X300 Y-200 Z-200 A-3 Z-3 F15000\n"));
	ck_assert_str_eq(strbuf_text(&c.messages),
			 "p.nc:1:26: error: the word Z occurs twice in the block, at columns 16 and 26\n"
			 "    G01 X300 Y-200 Z-200 A-3 Z-3 F15000\n                             ^\n");
	case_release(&c);
}
END_TEST

START_TEST(last_duplicate_wins)
{
	struct gcode_case c;

	case_init(&c);
	c.config.read.last_duplicate_wins = true;
	ck_assert(case_run(&c, "G01 X300 Y-200 Z-200 A-3 Z-3 F15000\nX1 X2 X3\nM2\n"));
	ck_assert_str_eq(strbuf_text(&c.moves), "feed 300 -200 -3 -3 0\nfeed 3 -200 -3 -3 0\n");
	ck_assert_uint_eq(c.diag.warnings, 1);
	case_release(&c);
}
END_TEST

/*
 * Fanuc B-64484EN, program configuration (O, N, /2), dwell (G04): P in ms, X
 * and U in s; machine coordinate system (G53): at the rapid rate, whatever the
 * motion; reference position return (G28). Haas mill operator's manual, setting
 * 162, default to float.
 */
START_TEST(fanuc_programs)
{
	struct gcode_case c;

	case_init(&c);
	c.config.dialect = &dialect_fanuc;
	c.config.controller.tool_change.given = true;
	case_expect(
	    &c,
	    "%\nO1234 (PART)\nN1 G90 G21 G53\n/2 G00 X1.\nG04 P500\nG04 X2.5\nG4 U1 ;\nG53 G01 X-5. F100\nX2.\n"
	    "G28 X3. Y0.\nM6 T2\nM30\n%\n",
	    "rapid 1 0 0 0 0\ndwell 0.5\ndwell 2.5\ndwell 1\nrapid -5 0 0 0 0\nfeed 2 0 0 0 0\nrapid 3 0 0 0 0\n"
	    "rapid 0 0 0 0 0\ntool 2\n");
	/* A mode that is not active may be cancelled. */
	case_init(&c);
	c.config.dialect = &dialect_fanuc;
	case_expect(&c, "G0 X1.\nG17 G21 G40 G49 G50 G50.1 G15 G69 G80 G90\nG0 X2.\nM30\n",
		    "rapid 1 0 0 0 0\nrapid 2 0 0 0 0\n");
	case_init(&c);
	c.config.dialect = &dialect_haas;
	case_expect(&c, "G17 G21 G40 G49 G50 G100 G69 G80 G90\nG0 X2.\nM30\n", "rapid 2 0 0 0 0\n");
	case_init(&c);
	c.config.dialect = &dialect_haas;
	ck_assert(case_run(&c, ":0002\nG0 X10 Y20\nZ30\nM30\n"));
	ck_assert_str_eq(strbuf_text(&c.moves), "rapid 10 20 0 0 0\nrapid 10 20 30 0 0\n");
	ck_assert_str_eq(strbuf_text(&c.messages), "");
	case_release(&c);
}
END_TEST

START_TEST(program_without_end)
{
	struct gcode_case c;

	case_init(&c);
	ck_assert(case_run(&c, "%\nG0 X1\n"));
	ck_assert_str_eq(strbuf_text(&c.messages),
			 "p.nc:2: warning: the program ends without M2, M30 or %; is the file complete?\n");
	case_release(&c);
	expect_moves("G0 X1\n", "rapid 1 0 0 0 0\n");
	expect_moves("G0 X1\nM2", "rapid 1 0 0 0 0\n");
	expect_moves("", "");
}
END_TEST

/* A last line X12 may be a cut off X120. */
START_TEST(program_cut_off)
{
	struct gcode_case c;

	case_init(&c);
	ck_assert(case_run(&c, "G0 X1\nG0 X12"));
	ck_assert_str_eq(strbuf_text(&c.moves), "rapid 1 0 0 0 0\nrapid 12 0 0 0 0\n");
	ck_assert_str_eq(strbuf_text(&c.messages),
			 "p.nc:2: warning: the file stops in the middle of this line, without M2 or M30 before: if the "
			 "file is incomplete, write it again; otherwise end it with M2 or M30, or end this line with a "
			 "line feed\n");
	case_release(&c);
}
END_TEST

int main(void)
{
	const TTest *const tests[] = {
	    straight_moves,
	    other_axes,
	    words_are_free_in_form,
	    block_delete,
	    incremental_and_units,
	    order_of_execution,
	    group_zero_suspends_motion,
	    work_offsets,
	    setup_offsets,
	    shifts,
	    machine_coordinates,
	    reference_moves,
	    tool_length,
	    arcs_by_centre,
	    arcs_with_absolute_centre,
	    arcs_by_radius,
	    arc_tolerances,
	    full_circle_in_spite_of_rounding,
	    no_drift,
	    feeds,
	    path_control,
	    wrapped_axes,
	    blocks_and_numbers,
	    sink_stops,
	    paper_block,
	    last_duplicate_wins,
	    fanuc_programs,
	    program_without_end,
	    program_cut_off,
	};

	return RUN_TESTS("gcode", tests);
}
