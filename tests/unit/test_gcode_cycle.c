/* test_gcode_cycle.c - canned cycles, tapping and probing as moves; tool change and reference moves; faults of each. */
#include "gcode_refusal.h"

static void run(const struct dialect *dialect, const char *program, const char *moves)
{
	struct gcode_case c;

	case_init(&c);
	c.config.dialect = dialect;
	case_expect(&c, program, moves);
}

/* LinuxCNC's manual, "G81 Drilling Cycle", its examples 1 to 3. */
START_TEST(drilling)
{
	run(&dialect_linuxcnc, "F9 G0 X1 Y2 Z3\nG90 G81 G98 X4 Y5 Z1.5 R2.8\nM2\n",
	    "rapid 1 2 3 0 0\nrapid 4 5 3 0 0\nrapid 4 5 2.8 0 0\nfeed 4 5 1.5 0 0\nrapid 4 5 3 0 0\n");
	run(&dialect_linuxcnc, "F9 G0 X1 Y2 Z3\nG91 G81 G98 X4 Y5 Z-0.6 R1.8 L3\nM2\n",
	    "rapid 1 2 3 0 0\n"
	    "rapid 1 2 4.8 0 0\nrapid 5 7 4.8 0 0\nfeed 5 7 4.2 0 0\nrapid 5 7 4.8 0 0\n"
	    "rapid 9 12 4.8 0 0\nfeed 9 12 4.2 0 0\nrapid 9 12 4.8 0 0\n"
	    "rapid 13 17 4.8 0 0\nfeed 13 17 4.2 0 0\nrapid 13 17 4.8 0 0\n");
	run(&dialect_linuxcnc, "F9\nG90 G98 G81 X4 Y5 Z1.5 R2.8\nM2\n",
	    "rapid 0 0 2.8 0 0\nrapid 4 5 2.8 0 0\nfeed 4 5 1.5 0 0\nrapid 4 5 2.8 0 0\n");
}
END_TEST

/*
 * Haas mill operator's manual, "Looping Canned Cycles": "G81 Z-1.5 F15. R.1", then "G91 X1.0 L2" and so on drill a grid at
 * one depth. LinuxCNC reads the kept words anew (its manual, "Canned Cycle Words").
 */
START_TEST(grid)
{
	static const char program[] = "F9. G0 X1. Y-1. Z5.\nG99 G81 Z-2. R1.\nG91 X10. %c2\nY-1.\nG90 G80\nM30\n";
	static const char moves[] =
		"rapid 1 -1 5 0 0\nrapid 1 -1 5 0 0\nrapid 1 -1 1 0 0\nfeed 1 -1 -2 0 0\nrapid 1 -1 1 0 0\n"
		"rapid 11 -1 1 0 0\nrapid 11 -1 1 0 0\nfeed 11 -1 -2 0 0\nrapid 11 -1 1 0 0\n"
		"rapid 21 -1 1 0 0\nrapid 21 -1 1 0 0\nfeed 21 -1 -2 0 0\nrapid 21 -1 1 0 0\n"
		"rapid 21 -2 1 0 0\nrapid 21 -2 1 0 0\nfeed 21 -2 -2 0 0\nrapid 21 -2 1 0 0\n";
	char text[128];
	struct gcode_case c;

	case_init(&c);
	c.config.dialect = &dialect_fanuc;
	ck_assert(!case_run(&c, "F9\nG91 G81 X1. Z-2. R-1.\nG90 X5.\n"));
	ck_assert_str_eq(strbuf_text(&c.messages),
			 "p.nc:3:5: error: R of G81 was given as an increment (G91); controls differ in what it means "
			 "in G90; write it again\n    G90 X5.\n        ^\n");
	case_release(&c);
	snprintf(text, sizeof(text), program, 'L');
	run(&dialect_haas, text, moves);
	snprintf(text, sizeof(text), program, 'K');
	run(&dialect_fanuc, text, moves);
}
END_TEST

/*
 * Haas mill operator's manual, "G70 Bolt Hole Circle": L holes evenly on a circle of radius I, the first at J degrees
 * from three o'clock counter-clockwise; "G71 Bolt Hole Arc": K degrees apart. The tool stands in the centre before.
 */
START_TEST(bolt_holes)
{
	run(&dialect_haas, "F9. G0 X10. Y5. Z5.\nG99 G81 Z-1. R1. L0\nG70 I2. J90. L4\nG0 X0.\nM30\n",
	    "rapid 10 5 5 0 0\n"
	    "rapid 10 7 5 0 0\nrapid 10 7 1 0 0\nfeed 10 7 -1 0 0\nrapid 10 7 1 0 0\n"
	    "rapid 8 5 1 0 0\nrapid 8 5 1 0 0\nfeed 8 5 -1 0 0\nrapid 8 5 1 0 0\n"
	    "rapid 10 3 1 0 0\nrapid 10 3 1 0 0\nfeed 10 3 -1 0 0\nrapid 10 3 1 0 0\n"
	    "rapid 12 5 1 0 0\nrapid 12 5 1 0 0\nfeed 12 5 -1 0 0\nrapid 12 5 1 0 0\n"
	    "rapid 0 5 1 0 0\n");
	/* In inches, with a work offset, and G98; a negative K goes clockwise. */
	run(&dialect_haas,
	    "G20 G10 L2 P1 X1. Y0.\nF9. G0 G54 X1. Y0. Z1.\nG98 G81 Z-1. R.5 L0\nG71 I1. J180. K-90. L2\nG80\nM30\n",
	    "rapid 50.8 0 25.4 0 0\n"
	    "rapid 25.4 0 25.4 0 0\nrapid 25.4 0 12.7 0 0\nfeed 25.4 0 -25.4 0 0\nrapid 25.4 0 25.4 0 0\n"
	    "rapid 50.8 25.4 25.4 0 0\nrapid 50.8 25.4 12.7 0 0\nfeed 50.8 25.4 -25.4 0 0\nrapid 50.8 25.4 25.4 0 0\n");
}
END_TEST

/* Haas mill operator's manual, "G76 Fine Boring Canned Cycle": I and J say which way and how far the tool steps aside. */
START_TEST(fine_boring)
{
	run(&dialect_haas, "F9. G0 Z5.\nG98 G76 X10. Y0. Z-8. R2. I0.5 J-0.25 P1.\nX20.\nG80\nM30\n",
	    "rapid 0 0 5 0 0\n"
	    "rapid 10 0 5 0 0\nrapid 10 0 2 0 0\nfeed 10 0 -8 0 0\ndwell 1\n"
	    "rapid 10.5 -0.25 -8 0 0\nrapid 10.5 -0.25 5 0 0\nrapid 10 0 5 0 0\n"
	    "rapid 20 0 5 0 0\nrapid 20 0 2 0 0\nfeed 20 0 -8 0 0\ndwell 1\n"
	    "rapid 20.5 -0.25 -8 0 0\nrapid 20.5 -0.25 5 0 0\nrapid 20 0 5 0 0\n");
}
END_TEST

/* Fanuc B-64484EN, "Boring Cycle (G88)"; Haas, "G87 Bore In and Manual Retract", "G88 Bore In, Dwell, Manual Retract". */
START_TEST(boring_by_hand)
{
	static const struct {
		const struct dialect *dialect;
		const char *code, *dwell;
	} bores[] = {{&dialect_fanuc, "G88", "dwell 2\n"}, {&dialect_haas, "G88", "dwell 2\n"}, {&dialect_haas, "G87", ""}};

	for (size_t i = 0; i < COUNT(bores); i++) {
		struct strbuf program = {0}, moves = {0}, messages = {0};
		struct gcode_case c;

		case_init(&c);
		c.config.dialect = bores[i].dialect;
		strbuf_addf(&program, "F9. G0 Z5.\nG99 %s X1. Z-8. R2. P2.\nX2.\nG80\nM30\n", bores[i].code);
		strbuf_addf(&moves,
			    "rapid 0 0 5 0 0\nrapid 1 0 5 0 0\nrapid 1 0 2 0 0\nfeed 1 0 -8 0 0\n%srapid 1 0 2 0 0\n"
			    "rapid 2 0 2 0 0\nrapid 2 0 2 0 0\nfeed 2 0 -8 0 0\n%srapid 2 0 2 0 0\n",
			    bores[i].dwell, bores[i].dwell);
		/* The caution comes once in a program. */
		strbuf_addf(&messages,
			    "p.nc:2:5: warning: %s: the operator retracts the tool by hand; only a retract straight up is "
			    "checked, here and further on\n    G99 %s X1. Z-8. R2. P2.\n        ^\n",
			    bores[i].code, bores[i].code);
		ck_assert(case_run(&c, program.text));
		ck_assert_str_eq(strbuf_text(&c.moves), moves.text);
		ck_assert_str_eq(strbuf_text(&c.messages), messages.text);
		case_release(&c);
		strbuf_release(&program);
		strbuf_release(&moves);
		strbuf_release(&messages);
	}
}
END_TEST

/*
 * G99 stays at R; the level of G98 is that before the first of the cycles; words
 * are kept (LinuxCNC's manual, "Canned Cycles"; Fanuc B-64484EN, canned cycle for
 * drilling, drilling data, return point level G98/G99).
 */
START_TEST(retract)
{
	run(&dialect_linuxcnc, "F9 G0 Z10\nG99 G81 X1 Z-1 R2\nX2\nG98 X3\nG80\nM2\n",
	    "rapid 0 0 10 0 0\n"
	    "rapid 1 0 10 0 0\nrapid 1 0 2 0 0\nfeed 1 0 -1 0 0\nrapid 1 0 2 0 0\n"
	    "rapid 2 0 2 0 0\nfeed 2 0 -1 0 0\nrapid 2 0 2 0 0\n"
	    /* LinuxCNC rises on the way, others over the hole. */
	    "rapid 3 0 10 0 0\nrapid 3 0 2 0 0\nfeed 3 0 -1 0 0\nrapid 3 0 10 0 0\n");
	run(&dialect_fanuc, "F9 G0 Z10.\nG99 G81 X1. Z-1. R2.\nX2.\nG98 X3.\nG80\nM30\n",
	    "rapid 0 0 10 0 0\n"
	    "rapid 1 0 10 0 0\nrapid 1 0 2 0 0\nfeed 1 0 -1 0 0\nrapid 1 0 2 0 0\n"
	    "rapid 2 0 2 0 0\nrapid 2 0 2 0 0\nfeed 2 0 -1 0 0\nrapid 2 0 2 0 0\n"
	    "rapid 3 0 2 0 0\nrapid 3 0 2 0 0\nfeed 3 0 -1 0 0\nrapid 3 0 10 0 0\n");
}
END_TEST

/* LinuxCNC 2.9 comes back to 0.254 mm above the last peck. */
START_TEST(pecking)
{
	run(&dialect_linuxcnc, "F9 G0 Z3\nG98 G83 X1 Z-4 R1 Q2\nG73 X2 Z-2 R1 Q2\nM2\n",
	    "rapid 0 0 3 0 0\n"
	    "rapid 1 0 3 0 0\nrapid 1 0 1 0 0\nfeed 1 0 -1 0 0\nrapid 1 0 1 0 0\nrapid 1 0 -0.746 0 0\n"
	    "feed 1 0 -3 0 0\nrapid 1 0 1 0 0\nrapid 1 0 -2.746 0 0\nfeed 1 0 -4 0 0\nrapid 1 0 3 0 0\n"
	    "rapid 2 0 3 0 0\nrapid 2 0 1 0 0\nfeed 2 0 -1 0 0\nrapid 2 0 -0.746 0 0\nfeed 2 0 -2 0 0\n"
	    "rapid 2 0 3 0 0\n");
}
END_TEST

START_TEST(dwell_and_feed_out)
{
	run(&dialect_linuxcnc, "F9 G0 Z3 M3 S9\nG98 G82 X1 Z-1 R1 P.5\nG85 X2 Z-1 R1\nG89 X3 Z-1 R1 P1\nG84 X4 Z-1 "
	    "R1\nM2\n",
	    "rapid 0 0 3 0 0\n"
	    "rapid 1 0 3 0 0\nrapid 1 0 1 0 0\nfeed 1 0 -1 0 0\ndwell 0.5\nrapid 1 0 3 0 0\n"
	    "rapid 2 0 3 0 0\nrapid 2 0 1 0 0\nfeed 2 0 -1 0 0\nfeed 2 0 1 0 0\nrapid 2 0 3 0 0\n"
	    "rapid 3 0 3 0 0\nrapid 3 0 1 0 0\nfeed 3 0 -1 0 0\ndwell 1\nfeed 3 0 3 0 0\n"
	    "rapid 4 0 3 0 0\nrapid 4 0 1 0 0\nfeed 4 0 -1 0 0\ndwell 1\nfeed 4 0 3 0 0\n");
	/* Fanuc B-64484EN, tapping cycle (G84), drilling cycle, counter boring (G82): P in ms; feeds end at R. */
	run(&dialect_fanuc, "F9 G0 Z3.\nG98 G82 X1. Z-1. R1. P500\nG84 X2.\nG89 X3.\nM30\n",
	    "rapid 0 0 3 0 0\n"
	    "rapid 1 0 3 0 0\nrapid 1 0 1 0 0\nfeed 1 0 -1 0 0\ndwell 0.5\nrapid 1 0 3 0 0\n"
	    "rapid 2 0 3 0 0\nrapid 2 0 1 0 0\nfeed 2 0 -1 0 0\ndwell 0.5\nfeed 2 0 1 0 0\nrapid 2 0 3 0 0\n"
	    "rapid 3 0 3 0 0\nrapid 3 0 1 0 0\nfeed 3 0 -1 0 0\ndwell 0.5\nfeed 3 0 1 0 0\nrapid 3 0 3 0 0\n");
}
END_TEST

START_TEST(planes)
{
	run(&dialect_linuxcnc, "F9 G18 G98 G81 X1 Z2 Y-3 R1\nG19 G81 Y4 Z5 X-1 R2\nM2\n",
	    "rapid 0 1 0 0 0\nrapid 1 1 2 0 0\nfeed 1 -3 2 0 0\nrapid 1 1 2 0 0\n"
	    "rapid 2 1 2 0 0\nrapid 2 4 5 0 0\nfeed -1 4 5 0 0\nrapid 2 4 5 0 0\n");
}
END_TEST

/* B-63534EN, "Canned cycle": parameter 5101#0 (FXY) says whether the axis across the plane drills, or always Z. */
START_TEST(drilling_axis)
{
	static const char *const moves[] = {
		[CYCLE_AXIS_ACROSS] = "rapid 1 0 -3 0 0\nrapid 1 1 -3 0 0\nfeed 1 -2 -3 0 0\nrapid 1 0 -3 0 0\n",
		[CYCLE_AXIS_Z] = "rapid 1 -2 0 0 0\nrapid 1 -2 1 0 0\nfeed 1 -2 -3 0 0\nrapid 1 -2 0 0 0\n",
	};

	for (int axis = CYCLE_AXIS_ACROSS; axis <= CYCLE_AXIS_Z; axis++) {
		struct gcode_case c;

		case_init(&c);
		c.config.dialect = &dialect_fanuc;
		c.config.controller.cycle_axis = (enum cycle_axis)axis;
		case_expect(&c, "F9. G18 G98 G81 X1. Y-2. Z-3. R1.\nM30\n", moves[axis]);
	}
}
END_TEST

/* LinuxCNC: interp_cycles.cc, convert_cycle_g87. */
START_TEST(back_boring)
{
	run(&dialect_linuxcnc, "F9 G0 Z5 M3 S1\nG98 G87 X10 Z-8 R2 I1 J2 K-3\nM2\n",
	    "rapid 0 0 5 0 0\n"
	    "rapid 10 0 5 0 0\nrapid 10 0 2 0 0\nrapid 11 2 2 0 0\nrapid 11 2 -8 0 0\nrapid 10 0 -8 0 0\n"
	    "feed 10 0 -3 0 0\nfeed 10 0 -8 0 0\nrapid 11 2 -8 0 0\nrapid 11 2 5 0 0\nrapid 10 0 5 0 0\n");
}
END_TEST

/*
 * Fanuc B-64484EN, canned cycle for drilling, repeat: K holes; K0 keeps the
 * words; rotary axes go to the hole with the rest. Haas mill operator's manual,
 * canned cycles: L, and L0 likewise.
 */
START_TEST(repeats)
{
	run(&dialect_fanuc, "F9 G0 Z3.\nG91 G99 G81 X1. C90. Z-2. R-1. K2\nM30\n",
	    "rapid 0 0 3 0 0\n"
	    "rapid 1 0 3 0 90\nrapid 1 0 2 0 90\nfeed 1 0 0 0 90\nrapid 1 0 2 0 90\n"
	    "rapid 2 0 2 0 180\nrapid 2 0 2 0 180\nfeed 2 0 0 0 180\nrapid 2 0 2 0 180\n");
	run(&dialect_haas, "F9 G0 Z3.\nG98 G81 Z-1. R1. L0\nX4.\nM30\n",
	    "rapid 0 0 3 0 0\nrapid 4 0 3 0 0\nrapid 4 0 1 0 0\nfeed 4 0 -1 0 0\nrapid 4 0 3 0 0\n");
}
END_TEST

START_TEST(threads_and_probes)
{
	struct gcode_case c;

	case_init(&c);
	c.show_feed = true;
	case_expect(&c, "M3 S120\nG33 Z-5 K1.5\nG33.1 Z5 K2 I3\nM5 F60 G38.2 X7\nM2\n",
		    "feed 0 0 -5 0 0 at 3 3\n"
		    "feed 0 0 5 0 0 at 4 4\nfeed 0 0 -5 0 0 at 12 4\n"
		    "feed 7 0 -5 0 0 at 1 1\n");
}
END_TEST

/* The default is G99 in LinuxCNC's interpreter, but its machines may have a startup code. */
START_TEST(default_retract)
{
	struct gcode_case c;

	case_init(&c);
	ck_assert(case_run(&c, "F9 G0 Z3\nG81 X1 Z-1 R1\nX2\nM2\n"));
	ck_assert_str_eq(strbuf_text(&c.moves),
			 "rapid 0 0 3 0 0\nrapid 1 0 3 0 0\nrapid 1 0 1 0 0\nfeed 1 0 -1 0 0\nrapid 1 0 1 0 0\n"
			 "rapid 2 0 1 0 0\nfeed 2 0 -1 0 0\nrapid 2 0 1 0 0\n");
	ck_assert_str_eq(strbuf_text(&c.messages),
			 "p.nc:2:1: warning: a cycle before any G98 or G99: it is assumed that the tool retracts to R "
			 "(G99), which RS274NGC_STARTUP_CODE of the machine can change\n    G81 X1 Z-1 R1\n    ^\n");
	case_release(&c);
}
END_TEST

static struct control_place place_at(double x, double y, double z)
{
	return (struct control_place){.given = true, .has = {true, true, true}, .value = {{x, y, z}}};
}

/* Z first, then X, then Y; work offsets and lengths do not matter. */
START_TEST(tool_change_moves)
{
	struct gcode_case c;

	case_init(&c);
	c.config.controller.tool_change = place_at(100, 50, 300);
	c.config.controller.tool_change.order[0] = SLOT_Z;
	c.config.controller.tool_change.order[1] = SLOT_X;
	c.config.controller.tool_change.order[2] = SLOT_Y;
	c.config.controller.tool_change.order_count = 3;
	case_expect(&c, "G10 L2 P1 X7 Z9\nG0 X0 Y0\nT3 M6\nG0 X1\nM2\n",
		    "rapid 7 0 0 0 0\n"
		    "rapid 7 0 300 0 0\nrapid 100 0 300 0 0\nrapid 100 50 300 0 0\ntool 3\n"
		    "rapid 8 50 300 0 0\n");
}
END_TEST

/* Fanuc B-64484EN, reference position return (G28), 2nd, 3rd, and 4th reference position return (G30). */
START_TEST(reference_positions)
{
	struct gcode_case c;

	case_init(&c);
	c.config.dialect = &dialect_fanuc;
	c.config.controller.references[0] = place_at(1, 2, 3);
	c.config.controller.references[1] = place_at(10, 20, 30);
	c.config.controller.references[2] = place_at(100, 200, 300);
	c.config.controller.references[1].order[0] = SLOT_Z;
	c.config.controller.references[1].order_count = 1;
	case_expect(&c, "G28 X5. Z6.\nG30 X0. Y0. Z0.\nG91 G30 P3 Z0.\nM30\n",
		    "rapid 5 0 6 0 0\nrapid 1 0 3 0 0\n"
		    "rapid 0 0 0 0 0\nrapid 0 0 30 0 0\nrapid 10 20 30 0 0\n"
		    "rapid 10 20 30 0 0\nrapid 10 20 300 0 0\n");
	/* LinuxCNC's G28.1 takes the place of the file's position. */
	case_init(&c);
	c.config.controller.references[0] = place_at(1, 2, 3);
	case_expect(&c, "G28\nG0 X9\nG28.1\nG0 X0\nG28\nM2\n",
		    "rapid 1 2 3 0 0\nrapid 9 2 3 0 0\nrapid 0 2 3 0 0\nrapid 9 2 3 0 0\n");
}
END_TEST

/*
 * Fanuc B-64484EN and Haas, canned cycles: the level of G98 is the height of the tool before the first cycle. The
 * manuals do not say whether that is a coordinate or a position.
 */
START_TEST(level_is_kept)
{
	static const char *const changes[] = {"G55", "G52 Z1.", "G92 Z9.", "G43 H1", "G20", "G10 L2 P1 Z1.",
					      "G68 R90.", "G68 R90.\nG69"};
	static const struct length_offset lengths[] = {{1, 100}};
	static const struct work_offset offsets[] = {{.name = "G54", .value = {{0}}}, {.name = "G55", .value = {{1, 1, 1}}}};

	for (int i = 0; i < 16; i++) {
		struct gcode_case c;

		case_init(&c);
		c.config.dialect = i % 2 ? &dialect_haas : &dialect_fanuc;
		c.config.controller.length_moves = ANSWER_NO;
		c.config.lengths = lengths;
		c.config.length_count = 1;
		c.config.work_offsets = offsets;
		c.config.work_offset_count = 2;
		case_refuses(&c,
			     ":1: error: the coordinates have changed since the first cycle, and the control decides "
			     "whether the initial level and the words change with them; write G80 first\n    X2. Y2.\n",
			     "F9 G0 Z3.\nG98 G81 X1. Z-1. R1.\n%s\nX2. Y2.\n", changes[i / 2]);
	}
	/* Blocks that do not use the level, or in which another cycle begins. */
	run(&dialect_fanuc, "F9 G0 Z3.\nG99 G81 X1. Z-1. R1.\nG52 Z1.\nX2.\nG80\nG98 G81 X3. Z-1. R1.\nM30\n",
	    "rapid 0 0 3 0 0\nrapid 1 0 3 0 0\nrapid 1 0 1 0 0\nfeed 1 0 -1 0 0\nrapid 1 0 1 0 0\n"
	    "rapid 2 0 1 0 0\nrapid 2 0 2 0 0\nfeed 2 0 0 0 0\nrapid 2 0 2 0 0\n"
	    "rapid 3 0 2 0 0\nrapid 3 0 2 0 0\nfeed 3 0 0 0 0\nrapid 3 0 2 0 0\n");
}
END_TEST

/* A block without an axis word drills nothing; a block with R is not certain. */
START_TEST(drills_where_an_axis_is_named)
{
	struct gcode_case c;

	run(&dialect_fanuc, "F9 G0 Z3.\nG98 G81 Z-1. R1. K0\nG82 P500\nX1.\nM30\n",
	    "rapid 0 0 3 0 0\n"
	    "rapid 1 0 3 0 0\nrapid 1 0 1 0 0\nfeed 1 0 -1 0 0\ndwell 0.5\nrapid 1 0 3 0 0\n");
	case_init(&c);
	c.config.dialect = &dialect_fanuc;
	ck_assert(!case_run(&c, "F9 G0 Z3.\nG98 G81 Z-1. R1. K0\nG82 R2.\nM30\n"));
	ck_assert_str_eq(strbuf_text(&c.messages),
			 "p.nc:3:5: error: R of G82 without an axis word: controls differ in whether they drill at the "
			 "present position; write an axis word\n    G82 R2.\n        ^\n");
	case_release(&c);
}
END_TEST

struct bad {
	const struct dialect *dialect;
	const char *block;
	int column;
	const char *message;
};

#define BESIDE_G70 \
	"G70 beside a cycle, G80 or a motion code is not supported, because their order is not known; write separate " \
	"blocks"
#define ORDER_OF_M6                                                                                                   \
	"M6 in a block with motion: the machine builder decides whether it comes before or after the move: set "      \
	"m6_with_move=\"after\" or \"before\" in the machine file's <controller>, or write two blocks"

static const struct mcode mcodes[] = {{428, MCODE_TCP_ON}};

static const struct bad bads[] = {
    {&dialect_linuxcnc, "G81 X1 Z-1", 1, "G81 needs R"},
    {&dialect_linuxcnc, "G81 X1 R1", 1, "G81 needs Z (depth)"},
    {&dialect_linuxcnc, "G18 G81 X1 Z1 R1", 5, "G81 needs Y (depth)"},
    {&dialect_linuxcnc, "G81 R1", 1, "G81 without an axis word"},
    {&dialect_linuxcnc, "G81 X1 Z-1 R-2", 1, "R of G81, -2 mm, is below the depth, -1 mm"},
    {&dialect_linuxcnc, "G81 X1 Z-1 R1 L0", 15, "G81 must not be repeated 0 times"},
    {&dialect_linuxcnc, "G81 X1 Z-1 R1 L1.5", 15, "L1.5 must be a whole number from 0 to 1000000"},
    {&dialect_linuxcnc, "G81 X1 Z-1 R1 P1", 15, "no code in the block uses the word P"},
    {&dialect_linuxcnc, "G81 X1 Z-1 R1 Q1", 15, "no code in the block uses the word Q"},
    {&dialect_linuxcnc, "G81 X1 Z-1 R1 A5", 15, "A in a canned cycle, which moves only X, Y and Z"},
    {&dialect_linuxcnc, "G82 X1 Z-1 R1", 1, "G82 needs P"},
    {&dialect_linuxcnc, "G82 X1 Z-1 R1 P-1", 15, "a dwell must not be negative"},
    {&dialect_linuxcnc, "G83 X1 Z-1 R1", 1, "G83 needs Q"},
    {&dialect_linuxcnc, "G83 X1 Z-1 R1 Q0", 15, "Q of G83 must be greater than 0"},
    {&dialect_linuxcnc, "G73 X1 Z-1 R1 Q-1", 15, "Q of G73 must be greater than 0"},
    {&dialect_linuxcnc, "G83 X1 Z-1 R1 Q.0000001", 15, "Q1e-07 of G83 makes more than 1000000 pecks"},
    /* A peck below half a unit in the last place would never end. */
    {&dialect_linuxcnc, "G83 X1 Z9999999 R9999999.0005 Q.0000000009", 31,
     "Q9e-10 of G83 is too small for the number format at this height"},
    {&dialect_linuxcnc, "G84 X1 Z-1 R1", 1, "G84 with a stopped spindle"},
    {&dialect_linuxcnc, "M4 G84 X1 Z-1 R1 S1", 4, "G84 while the spindle runs counter-clockwise"},
    {&dialect_linuxcnc, "M3 G74 X1 Z-1 R1 S1", 4, "G74 while the spindle runs clockwise"},
    {&dialect_linuxcnc, "M3 G18 G84 X1 Z1 Y-1 R1 S1", 8,
     "G84 in the plane of G18: this control mixes up the axes and moves elsewhere; use G33.1"},
    {&dialect_linuxcnc, "G86 X1 Z-1 R1 P1", 1, "G86 with a stopped spindle"},
    {&dialect_linuxcnc, "M3 G87 X1 Z-1 R1 I1 J1 S1", 4, "G87 needs K"},
    {&dialect_linuxcnc, "G88 X1 Z-1 R1 P1", 1,
     "G88: boring cycle in which the operator retracts the tool by hand is not supported; post the program without it"},
    {&dialect_linuxcnc, "G76 Z-1 P1 I1 J1 K1", 1, "G76: multi-pass threading cycle is not supported; "
    "post the program without it"},
    {&dialect_linuxcnc, "G93 G81 X1 Z-1 R1", 5, "G81 in inverse time mode (G93); write G94 or G95 first"},
    {&dialect_linuxcnc, "G94 G81 X1 Z-1 R1", 5, "G81 without a feed rate (F)"},
    {&dialect_linuxcnc, "G53 G81 X1 Z-1 R1", 1, "G53 needs G0 or G1"},
    {&dialect_linuxcnc, "G92 G81 X1 Z-1 R1", 5, "G81 and G92 both need the axis words of the block; write two blocks"},
    {&dialect_linuxcnc, "G33 Z-1", 1, "G33 needs K (pitch)"},
    {&dialect_linuxcnc, "G33 Z-1 K1", 1, "G33 with a stopped spindle"},
    {&dialect_linuxcnc, "M3 S9 G33 Z-1 K1 F1", 18,
     "F with G33: the feed is the pitch times the spindle speed; remove F"},
    {&dialect_linuxcnc, "M3 S9 G33 Z-1 K0", 15, "the pitch is 0"},
    {&dialect_linuxcnc, "M3 S9 G33.1 A1 K1", 13, "A with G33.1, which moves only X, Y and Z"},
    {&dialect_linuxcnc, "G38.2", 1, "G38.2 without an axis word"},
    {&dialect_linuxcnc, "G38.2 X0", 1, "G38.2 ends where the probe already stands, and does not move it"},
    {&dialect_linuxcnc, "S9 G95 F1 G38.3 X1", 11, "G38.3 in feed per revolution (G95); write G94 first"},
    /* Fanuc B-64484EN, canned cycle for drilling, repeat, fine boring cycle (G76); Haas, G87. */
    {&dialect_fanuc, "G81 X1. Z-1. R1. K0", 18,
     "K0 with a position: controls differ in whether the tool moves there; remove one of them"},
    {&dialect_fanuc, "G81 X1. Z-1. R1. L2", 18,
     "L in a canned cycle: K repeats the cycle, unless a parameter of the control assigns this to L: if so, set "
     "cycle_repeats=\"L\" in the machine file's <controller>"},
    {&dialect_fanuc, "G19 G81 X-1. R1.", 5,
     "a parameter of the control (5101#0, FXY) decides whether G81 drills along X or Z in the plane of G19: set "
     "cycle_axis=\"plane\" or \"z\" in the machine file's <controller>"},
    {&dialect_fanuc, "G76 X1. Z-1. R1. I1.", 18, "no code in the block uses the word I"},
    {&dialect_fanuc, "G76 X1. Z0. R0. Q1.", 1, "the retract of G76 does not rise from the bottom"},
    {&dialect_haas, "G18 G76 Y-1. R1. I1.", 5, "G76 with I and J is supported only in the plane of G17; give Q"},
    /* B-64484EN, 2nd, 3rd, and 4th reference position return (G30): P2 to P4. */
    {&dialect_fanuc, "G30 P3 X0.", 5,
     "the machine file has no reference position 3: set <reference number=\"3\" X=\"\" .../> in its <controller>"},
    {&dialect_fanuc, "G30 P5 X0.", 5, "P5 must be a whole number from 2 to 4"},
    {&dialect_fanuc, "G28 P2 X0.", 5, "no code in the block uses the word P"},
    /* Which comes first, the tool or the move? */
    {&dialect_haas, "G1 X5. T2 M6", 11, ORDER_OF_M6},
    {&dialect_fanuc, "G91 G28 Z0. T2 M6", 16, ORDER_OF_M6},
    {&dialect_haas, "T2 M6 G28", 4, ORDER_OF_M6},
    {&dialect_haas, "G70 I2. J0. L4", 1, "G70 needs an active canned cycle that makes the holes"},
    {&dialect_haas, "G81 G98 G70 Z-1. R1. I2. J0. L4", 30,
     "L can belong to G70 or to G81, and it is not known to which; write two blocks"},
    {&dialect_haas, "G70 I2. J0. L4 G80", 1, BESIDE_G70},
    {&dialect_fanuc, "G0 X5. M428", 8,
     "an M-code that switches TCP in a block with motion: controls differ in whether it comes before or after the "
     "move; write two blocks"},
};

START_TEST(refused)
{
	const struct bad *bad = &bads[_i];
	struct gcode_case c;

	case_init(&c);
	c.config.dialect = bad->dialect;
	c.config.controller.tool_change.given = true;
	c.config.controller.mcodes = mcodes;
	c.config.controller.mcode_count = 1;
	case_refuses_last(&c, bad->column, bad->message, "F9\n%s\n", bad->block);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("programs");

	tcase_add_test(tcase, drilling);
	tcase_add_test(tcase, grid);
	tcase_add_test(tcase, bolt_holes);
	tcase_add_test(tcase, fine_boring);
	tcase_add_test(tcase, boring_by_hand);
	tcase_add_test(tcase, retract);
	tcase_add_test(tcase, pecking);
	tcase_add_test(tcase, dwell_and_feed_out);
	tcase_add_test(tcase, planes);
	tcase_add_test(tcase, drilling_axis);
	tcase_add_test(tcase, back_boring);
	tcase_add_test(tcase, repeats);
	tcase_add_test(tcase, threads_and_probes);
	tcase_add_test(tcase, default_retract);
	tcase_add_test(tcase, tool_change_moves);
	tcase_add_test(tcase, reference_positions);
	tcase_add_test(tcase, level_is_kept);
	tcase_add_test(tcase, drills_where_an_axis_is_named);
	tcase_add_loop_test(tcase, refused, 0, COUNT(bads));
	return run_suite("gcode_cycle", tcase);
}
