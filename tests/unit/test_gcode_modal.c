/* test_gcode_modal.c - modal groups and modal words as Fanuc and Haas controls have them. */
#include "gcode_refusal.h"

static const struct dialect *const dialects[] = {&dialect_fanuc, &dialect_haas};

static void modal_case(struct gcode_case *c, const struct dialect *dialect)
{
	static const struct length_offset lengths[] = {{1, 100}, {2, 40}};

	case_init(c);
	c->config.dialect = dialect;
	c->config.lengths = lengths;
	c->config.length_count = 2;
	c->config.controller.length_moves = ANSWER_NO;
}

static void run(const struct dialect *dialect, const char *program, const char *moves)
{
	struct gcode_case c;

	modal_case(&c, dialect);
	case_expect(&c, program, moves);
}

/* The last line of the program is at fault. */
static void refuse(const struct dialect *dialect, const char *program, int column, const char *message)
{
	struct gcode_case c;

	modal_case(&c, dialect);
	case_refuses_last(&c, column, message, "%s", program);
}

/*
 * Fanuc 30i-B operator's manual (B-64484EN), G code list: G28 and G30 are of group 00, G0 to G3 of group 01, so that
 * both stand in one block, and the motion holds from there on. Haas mill operator's manual, G-codes: the same groups.
 */
START_TEST(motion_beside_reference)
{
	static const char *const orders[] = {"G00 G91 G28 Z0.\n", "G91 G28 G00 Z0.\n", "G28 G91 Z0. G0\n",
					     "G80 G0 G91 G28 Z0.\n"};

	for (int i = 0; i < 2; i++) {
		for (size_t k = 0; k < COUNT(orders); k++) {
			struct strbuf program = {0};

			strbuf_addf(&program, "G1 F9. Z5.\n%sG90 X1.\nM30\n", orders[k]);
			run(dialects[i], program.text,
			    "feed 0 0 5 0 0\nrapid 0 0 5 0 0\nrapid 0 0 0 0 0\nrapid 1 0 0 0 0\n");
			strbuf_release(&program);
		}
		/* G28 itself goes at the rapid rate, whichever motion stands beside it. */
		run(dialects[i], "G0 Z5.\nF9. G1 G28 Z7.\nX1.\nM30\n",
		    "rapid 0 0 5 0 0\nrapid 0 0 7 0 0\nrapid 0 0 0 0 0\nfeed 1 0 0 0 0\n");
		run(dialects[i], "G10 L2 P1 X5.\nG0 G52 X1.\nX0.\nM30\n", "rapid 6 0 0 0 0\n");
		/* G0 ends a cycle there, too. */
		run(dialects[i], "F9. G0 Z5.\nG81 Z-1. R1.\nG0 G91 G28 Z0.\nG90 X1.\nM30\n",
		    "rapid 0 0 5 0 0\nrapid 0 0 5 0 0\nrapid 0 0 1 0 0\nfeed 0 0 -1 0 0\nrapid 0 0 5 0 0\n"
		    "rapid 0 0 5 0 0\nrapid 0 0 0 0 0\nrapid 1 0 0 0 0\n");
		refuse(dialects[i], "G28 G81 Z0. R1.\n", 5,
		       "G81 and G28 both need the axis words of the block; write two blocks");
	}
}
END_TEST

/*
 * The same lists: cycles and G80 are of group 09, so that G80 leaves G0 to G3; B-64484EN, canned cycles for drilling,
 * "Cancel": G80 or a code of group 01 cancels them.
 */
START_TEST(cycles_apart)
{
	for (int i = 0; i < 2; i++) {
		run(dialects[i], "F9. G0 Z5.\nG81 X1. Z-1. R1.\nG80\nX2.\nM30\n",
		    "rapid 0 0 5 0 0\nrapid 1 0 5 0 0\nrapid 1 0 1 0 0\nfeed 1 0 -1 0 0\nrapid 1 0 5 0 0\n"
		    "rapid 2 0 5 0 0\n");
		run(dialects[i], "F9. G1 Z5.\nG81 X1. Z-1. R1.\nG80 X2.\nX3.\nG40 G80 G90\nX4.\nM30\n",
		    "feed 0 0 5 0 0\nrapid 1 0 5 0 0\nrapid 1 0 1 0 0\nfeed 1 0 -1 0 0\nrapid 1 0 5 0 0\n"
		    "feed 2 0 5 0 0\nfeed 3 0 5 0 0\nfeed 4 0 5 0 0\n");
		run(dialects[i], "F9. G0 Z5.\nG81 X1. Z-1. R1.\nG1 X2.\nX3.\nG80 G0 X4.\nM30\n",
		    "rapid 0 0 5 0 0\nrapid 1 0 5 0 0\nrapid 1 0 1 0 0\nfeed 1 0 -1 0 0\nrapid 1 0 5 0 0\n"
		    "feed 2 0 5 0 0\nfeed 3 0 5 0 0\nrapid 4 0 5 0 0\n");
		/* The control decides which motion is in force at power-on. */
		refuse(dialects[i], "G80\nX1.\n", 1,
		       "axis words without an active motion code (G0, G1, G2, G3); set power_on_motion=\"rapid\" or "
		       "\"feed\" (the motion code at power-on) in the machine file's <controller>");
	}
	refuse(&dialect_linuxcnc, "G0 X1\nG80\nX2\n", 1, "axis words without an active motion code (G0, G1, G2, G3)");
}
END_TEST

/* B-64484EN, "Tool Length Offset": where G43 is in force, the length changes with H, H0 is none, and H is modal. */
START_TEST(modal_h)
{
	run(&dialect_fanuc, "G0 Z9.\nG43 H1\nZ5.\nZ6. H2\nH01 Z7.\nZ1. H00\nG49\nH2 X1.\nG43 Z3.\nG49 H1\nG43 Z4.\nM30\n",
	    "rapid 0 0 9 0 0\nrapid 0 0 105 0 0\nrapid 0 0 46 0 0\nrapid 0 0 107 0 0\nrapid 0 0 1 0 0\n"
	    "rapid 1 0 1 0 0\nrapid 1 0 43 0 0\nrapid 1 0 104 0 0\n");
	/* Alone, and where G28 has taken the length back: the machine file has axes stand when it changes. */
	run(&dialect_fanuc, "G0 G43 H1 Z5.\nH2\nZ6.\nG91 G28 Z0. H0\nG90 Z7.\nZ8. H1\nM30\n",
	    "rapid 0 0 105 0 0\nrapid 0 0 46 0 0\nrapid 0 0 46 0 0\nrapid 0 0 0 0 0\nrapid 0 0 7 0 0\n"
	    "rapid 0 0 108 0 0\n");
	/* Under G43.4 it is the length of that. */
	run(&dialect_fanuc, "G0 G43.4 H1 X0. Y0. Z5.\nZ6. H2\nM30\n",
	    "tcp on length 0 zero A0 C0\ntcp on length 100 zero A0 C0\nrapid 0 0 5 0 0 tcp\n"
	    "tcp on length 40 zero A0 C0\nrapid 0 0 6 0 0 tcp\n");
	refuse(&dialect_fanuc, "G0 G43 H1 Z5.\nZ6. H3\n", 5,
	       "H3: no length offsets are defined, because there is no setup");
	/* Haas mill operator's manual, "G49": H0 cancels the length, too. */
	run(&dialect_haas, "G0 G43 H1 Z5.\nZ6. H00\nG43 H2 Z5.\nG91 G28 Z0. H0\nG90 Z7.\nM30\n",
	    "rapid 0 0 105 0 0\nrapid 0 0 6 0 0\nrapid 0 0 45 0 0\nrapid 0 0 45 0 0\nrapid 0 0 0 0 0\n"
	    "rapid 0 0 7 0 0\n");
	refuse(&dialect_haas, "G0 G43 H1 Z5.\nZ6. H2\n", 5,
	       "H2 without G43: controls differ in whether it changes the length; write G43 H2");
}
END_TEST

/* B-64484EN, tool length offset and cutter compensation: D is modal, and G43 does not use it. */
START_TEST(modal_d)
{
	for (int i = 0; i < 2; i++)
		run(dialects[i], "G0 G43 H1 D31 Z5.\nD2\nX1. D3\nM30\n", "rapid 0 0 105 0 0\nrapid 1 0 105 0 0\n");
	refuse(&dialect_linuxcnc, "D2\n", 1, "no code in the block uses the word D");
}
END_TEST

static void run_after(const struct dialect *dialect, enum length_after_reference answer, const char *program,
		      const char *moves)
{
	struct gcode_case c;

	modal_case(&c, dialect);
	c.config.controller.length_after_reference = answer;
	c.config.controller.references[1].given = true;
	case_expect(&c, program, moves);
}

/*
 * Fanuc 0i-MB operator's manual (B-63844EN), "G53, G28, and G30 commands in tool length offset mode", parameter 5001#6
 * (EVO). The machine's home is at 0.
 */
START_TEST(length_after_reference)
{
	static const char *const goes[] = {"G91 G28 Z0.\n", "G53 Z0.\n", "G91 G30 Z0.\n", "G91 G28 X0. Z0.\n"};
	static const char *const ways[] = {"rapid 0 0 105 0 0\n", "", "rapid 0 0 105 0 0\n", "rapid 0 0 105 0 0\n"};

	for (size_t i = 0; i < COUNT(goes); i++) {
		struct strbuf program = {0}, kept = {0}, gone = {0};

		strbuf_addf(&program, "G0 G43 H1 Z5.\n%sG90 Z7.\nH2 Z8.\nM30\n", goes[i]);
		strbuf_addf(&kept, "rapid 0 0 105 0 0\n%srapid 0 0 0 0 0\nrapid 0 0 107 0 0\nrapid 0 0 48 0 0\n", ways[i]);
		strbuf_addf(&gone, "rapid 0 0 105 0 0\n%srapid 0 0 0 0 0\nrapid 0 0 7 0 0\nrapid 0 0 48 0 0\n", ways[i]);
		run_after(&dialect_fanuc, LENGTH_AFTER_REFERENCE_KEPT, program.text, kept.text);
		run_after(&dialect_fanuc, LENGTH_AFTER_REFERENCE_GONE, program.text, gone.text);
		strbuf_release(&program);
		strbuf_release(&kept);
		strbuf_release(&gone);
	}
	/* Haas mill operator's manual, "G28": Z loses its length there, whatever is said of other codes. */
	run_after(&dialect_haas, LENGTH_AFTER_REFERENCE_KEPT, "G0 G43 H1 Z5.\nG91 G28 Z0.\nG90 Z7.\nM30\n",
		  "rapid 0 0 105 0 0\nrapid 0 0 105 0 0\nrapid 0 0 0 0 0\nrapid 0 0 7 0 0\n");
	run_after(&dialect_haas, LENGTH_AFTER_REFERENCE_KEPT, "G0 G43 H1 Z5.\nG91 G30 Z0.\nG90 Z7.\nM30\n",
		  "rapid 0 0 105 0 0\nrapid 0 0 105 0 0\nrapid 0 0 0 0 0\nrapid 0 0 107 0 0\n");
	refuse(&dialect_fanuc, "G0 G43 H1 Z5.\nG91 G28 Z0.\nG90 Z7.\n", 5,
	       "G28 may have cancelled the tool length compensation, so the position of Z depends on the control; "
	       "write G43, G43.4 or G49 again first, or set length_after_reference=\"keeps\" or \"cancels\" in the "
	       "machine file's <controller>");
}
END_TEST

static bool note_turning(void *context, const struct canon_event *event)
{
	struct strbuf *turns = context;

	if (event->kind != CANON_MOVE)
		return true;
	if (event->of.move->kind == CANON_SPINDLE_STOP)
		strbuf_addf(turns, ".");
	else
		strbuf_addf(turns, "%d", event->of.move->spindle_turns);
	return true;
}

/*
 * Haas mill operator's manual, "M19 Orient Spindle": the spindle stands in its orientation; P and R are its angle.
 * LinuxCNC's manual, "M19": R is the angle, P the direction, Q a time.
 */
START_TEST(oriented_stop)
{
	static const char turns_and_stands[] =
	    "G0 X1. M3 S1\nX2.\nM19\nX3.\nM4\nX4.\nM19 R90\nX5.\nM3\nX6.\nM19 P45.\nX7.\nM30\n";
	static const char with_time[] =
	    "G61 G0 X1. M3 S1\nX2.\nM19 R0\nX3.\nM4\nX4.\nM19 R90 Q2 P1\nX5.\nM3\nX6.\nM19 R5 P2\nX7.\nM30\n";
	const struct dialect *const controls[] = {dialects[0], dialects[1], &dialect_linuxcnc};

	for (int i = 0; i < 3; i++) {
		const char *program = i == 2 ? with_time : turns_and_stands;
		struct strbuf turns = {0};
		struct gcode_case c;
		struct canon_sink sink = {&turns, note_turning};
		struct kinematics kinematics = case_kinematics(&c);
		struct interp *interp;
		FILE *in = fmemopen((char *)program, strlen(program), "r");

		modal_case(&c, controls[i]);
		c.diag.context = &c;
		ck_assert_ptr_nonnull(in);
		interp = interp_new(&c.config, &kinematics, &sink, &c.diag);
		ck_assert(interp_run(interp, in, "p.nc"));
		ck_assert_str_eq(strbuf_text(&c.messages), "");
		ck_assert_str_eq(strbuf_text(&turns), "11.01.01.0");
		interp_free(interp);
		fclose(in);
		strbuf_release(&turns);
		case_release(&c);
	}
	refuse(&dialect_haas, "M19 R90 Q3\n", 9, "no code in the block uses the word Q");
}
END_TEST

static void run_g53(const struct dialect *dialect, enum g53_with_g91 answer, const char *program, const char *moves)
{
	struct gcode_case c;

	modal_case(&c, dialect);
	c.config.controller.g53_with_g91 = answer;
	case_expect(&c, program, moves);
}

/*
 * B-64484EN, "Machine Coordinate System (G53)": ignored in G91; Mitsubishi M700V programming manual, "Basic Machine
 * Coordinate System Selection; G53", (4): increments in the system that is selected.
 */
START_TEST(g53_in_g91)
{
	static const char program[] = "G10 L2 P1 X100.\nG90 G0 X5. Z9.\nG91 G53 X3. Z0.\nX1.\nM30\n";

	for (int i = 0; i < 2; i++) {
		run_g53(dialects[i], G53_WITH_G91_ABSOLUTE, program,
			"rapid 105 0 9 0 0\nrapid 3 0 0 0 0\nrapid 4 0 0 0 0\n");
		run_g53(dialects[i], G53_WITH_G91_INCREMENTAL, program,
			"rapid 105 0 9 0 0\nrapid 108 0 9 0 0\nrapid 109 0 9 0 0\n");
		refuse(dialects[i], "G91 G0 X5.\nG53 X0.\n", 1,
		       "G53 in incremental mode (G91) depends on the control: set g53_with_g91=\"absolute\" or "
		       "\"incremental\" in the machine file's <controller>");
	}
}
END_TEST

/* B-64484EN, "Machine Coordinate System (G53)": at the rapid rate; an arc that is in force stays so. */
START_TEST(g53_beside_arcs)
{
	run(&dialect_fanuc, "F9. G2 I5.\nG53 Z1.\nI5.\nM30\n",
	    "arc 0 0 0 0 0 centre 5 0 0 normal 0 0 1 sweep -360\nrapid 0 0 1 0 0\n"
	    "arc 0 0 1 0 0 centre 5 0 1 normal 0 0 1 sweep -360\n");
	refuse(&dialect_haas, "F9. G2 I5.\nG53 Z1.\n", 1, "G53 needs G0 or G1");
}
END_TEST

/* B-64484EN, cutting feed: G62 and G63 end the exact stops of G61, as G64 does. */
START_TEST(corners)
{
	struct gcode_case c;

	modal_case(&c, &dialect_fanuc);
	c.show_blend = true;
	case_expect(&c, "G61 G0 X1.\nG62 X2.\nG61 X3.\nG63 X4.\nM30\n",
		    "rapid 1 0 0 0 0 exact\nrapid 2 0 0 0 0 blend 0\nrapid 3 0 0 0 0 exact\nrapid 4 0 0 0 0 blend 0\n");
}
END_TEST

/* B-64484EN, "Preparatory Function (G Function)": of one group in one block, the last one is valid. */
START_TEST(last_of_group)
{
	run_g53(&dialect_fanuc, G53_WITH_G91_ABSOLUTE, "G0 G1 G0 Z5.\nG90 G91 G28 G53 Z1.\nG90 G17 G18 G17 X1.\nM30\n",
		"rapid 0 0 5 0 0\nrapid 0 0 1 0 0\nrapid 1 0 1 0 0\n");
	run(&dialect_fanuc, "G0 Z5.\nG53 G28 Z7.\nM30\n", "rapid 0 0 5 0 0\nrapid 0 0 7 0 0\nrapid 0 0 0 0 0\n");
	refuse(&dialect_fanuc, "F9. G81 G0 Z1. R2.\n", 9,
	       "G0 and the G-code at column 5 belong to the same modal group; a block can have only one of them");
	refuse(&dialect_fanuc, "G0 Z5.\nG91 G28 Z0. G90\n", 13,
	       "G90 and G91 in one block, with axis words before the second one: controls differ in which of them "
	       "applies to these words; write two blocks");
	refuse(&dialect_haas, "G28 G53 Z1.\n", 5,
	       "G53 and the G-code at column 1 belong to the same modal group; a block can have only one of them");
}
END_TEST

int main(void)
{
	const TTest *const tests[] = {motion_beside_reference, cycles_apart, modal_h, modal_d,
				      length_after_reference, oriented_stop, g53_in_g91, g53_beside_arcs,
				      corners, last_of_group};

	return RUN_TESTS("gcode_modal", tests);
}
