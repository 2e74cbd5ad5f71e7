/* test_gcode_klartext.c - Klartext: words, tools, presets, settings, against moves worked out by hand. */
#include "klartext_case.h"

/* Words, units, increments, tools, presets. */
static const struct klartext_program lexis[] = {
	{"L X+10 Y-3 R0 FMAX\n",
	 "rapid 10 -3 0 0 0\n"},
	{"12 L X+10,5 Y-3,25 R0 FMAX M3\n",
	 "rapid 10.5 -3.25 0 0 0\n"},
	{"L X10.5 Y.5 Z-,5 F MAX\n",
	 "rapid 10.5 0.5 -0.5 0 0\n"},
	{"L  X+1  Y+2 FMAX ; a comment L X+9\nL F100 Z+1\n",
	 "rapid 1 2 0 0 0\nfeed 1 2 1 0 0\n"},
	{"L X+1 FMAX\n; L X+5\n* - a section\n\n5 ; only a comment\nL X+2 FMAX\n",
	 "rapid 1 0 0 0 0\nrapid 2 0 0 0 0\n"},
	{"l x+1 y+2 r0 fmax m3\n",
	 "rapid 1 2 0 0 0\n"},
	{"X+5 R0 FMAX\nY+3 F100\nIX-1\n",
	 "rapid 5 0 0 0 0\nfeed 5 3 0 0 0\nfeed 4 3 0 0 0\n"},
	{"L X+1 R F100 M\nL Y+1 R F M\n",
	 "feed 1 0 0 0 0\nfeed 1 1 0 0 0\n"},
	{"F250\nS1000 M3\nL X+1\n",
	 "feed 1 0 0 0 0\n"},
	{"M3\nM8 M9\nL M5\nL X+1 FMAX\n",
	 "rapid 1 0 0 0 0\n"},
	{"/L X+1 FMAX\nL X+2 FMAX\n",
	 "rapid 1 0 0 0 0\nrapid 2 0 0 0 0\n"},
	/* M118 without limits ends handwheel moves. */
	{"L X+1 FMAX M118\nM118 X0 Y0\n", "rapid 1 0 0 0 0\n"},
	{"MONITORING HEATMAP START FOR \"SPINDLE\"\nL X+1 FMAX\nMONITORING HEATMAP STOP\n", "rapid 1 0 0 0 0\n"},
	{"SECTION MONITORING START AS \"roughing\"\nL X+1 FMAX\nSECTION MONITORING STOP\n", "rapid 1 0 0 0 0\n"},
	{"FUNCTION FEED DWELL D-TIME0.5 F-TIME5\nFUNCTION RESET FEED DWELL\nL X+1 FMAX\n", "rapid 1 0 0 0 0\n"},
	{"FUNCTION COUNT RESET\nFUNCTION COUNT TARGET10\nL X+1 FMAX\nFUNCTION COUNT INC\n", "rapid 1 0 0 0 0\n"},
	{"7 /L X+1 FMAX\n8 / L X+2 FMAX\n/ 9 L X+3 FMAX\n",
	 "rapid 1 0 0 0 0\nrapid 2 0 0 0 0\nrapid 3 0 0 0 0\n"},
	{"BLK FORM 0.1 Z X+0 Y+0 Z-20\nBLK FORM 0.2 X+100 Y+100 Z+0\nL X+1 FMAX\n",
	 "rapid 1 0 0 0 0\n"},
	{"STOP M57\nL X+1 FMAX\n",
	 "rapid 1 0 0 0 0\n"},
	{"L X+1 FMAX M57\nM60\n",
	 "rapid 1 0 0 0 0\n"},
	{"L X+99999.123456789012345 FMAX\n",
	 "rapid 99999.1235 0 0 0 0\n"},
	{"L X1 FMAX\nL X-1.5 F1,5\n",
	 "rapid 1 0 0 0 0\nfeed -1.5 0 0 0 0\n"},
	{"L X+10 Y+10 FMAX\nL IX+5 IY-3 F100\nL IZ-2\n",
	 "rapid 10 10 0 0 0\nfeed 15 7 0 0 0\nfeed 15 7 -2 0 0\n"},
	{"L IX+1 FMAX\nL IX+1 FMAX\nL X+1 FMAX\n",
	 "rapid 1 0 0 0 0\nrapid 2 0 0 0 0\nrapid 1 0 0 0 0\n"},
	{"L X+1 F100\nL Y+1\nL Z+1 FMAX\nL X+2\n",
	 "feed 1 0 0 0 0\nfeed 1 1 0 0 0\nrapid 1 1 1 0 0\nfeed 2 1 1 0 0\n"},
	{"L C+90 FMAX\nL IC+45 FMAX\nL A-30 F500\n",
	 "rapid 0 0 0 0 90\nrapid 0 0 0 0 135\nfeed 0 0 0 -30 135\n"},
	{"L X+1 A+10 C+20 FMAX\n",
	 "rapid 1 0 0 10 20\n"},
	{"TOOL CALL 1 Z S1000\nL Z+50 FMAX\n",
	 "tool 1\nrapid 0 0 150 0 0\n"},
	{"TOOL CALL \"DRILL 5\" Z S500 F200\nL Z+0 F AUTO\n",
	 "tool 2\nfeed 0 0 40 0 0\n"},
	{"TOOL CALL 1 Z S1000 DL+0.5 DR-0.1\nL Z+0 FMAX\n",
	 "tool 1\nrapid 0 0 100.5 0 0\n"},
	{"TOOL CALL 1 Z\nL Z+0 FMAX\nTOOL CALL 2 Z\nL Z+0 FMAX\nTOOL CALL 0 Z\nL Z+0 FMAX\n",
	 "tool 1\nrapid 0 0 100 0 0\ntool 2\nrapid 0 0 40 0 0\ntool 0\nrapid 0 0 0 0 0\n"},
	/* The second set of data of tool 1. */
	{"TOOL CALL 1.2 Z S100\nL Z+0 FMAX\nTOOL CALL 1 Z\nTOOL CALL 1,2 Z\nL Z+1 FMAX\n",
	 "tool 6\nrapid 0 0 30 0 0\ntool 1\ntool 6\nrapid 0 0 31 0 0\n"},
	{"TOOL DEF 2\nTOOL CALL 1 Z S100\nM6\nL X+1 FMAX\n",
	 "tool 1\nrapid 1 0 0 0 0\n"},
	{"TOOL DEF 1 L100 R5\nTOOL CALL 1 Z\n",
	 "tool 1\n"},
	{"TOOL CALL 1 Z S100\nTOOL CALL S200\nTOOL CALL Z S300\nL Z+0 F100\n",
	 "tool 1\nfeed 0 0 100 0 0\n"},
	{"TOOL CALL 'MILL 10' Z\nL X+0 FMAX\n",
	 "tool 1\nrapid 0 0 0 0 0\n"},
	{"L X+1 FMAX\n",
	 "rapid 1 0 0 0 0\n"},
	{"CYCL DEF 247 DATUM SETTING ~\n Q339=+1 ;DATUM NUMBER\nL X+1 FMAX\n",
	 "rapid 1 0 0 0 0\n"},
	{"CYCL DEF 247 DATUM SETTING Q339=1\nL X+1 FMAX\n",
	 "rapid 1 0 0 0 0\n"},
	/* Posts that write blanks behind a sign. */
	{"Q13=20\nQL1=4\nL X + Q13 Y - QL1 FMAX\nL X + Q13 IY -  Q13 FMAX\n", "rapid 20 -4 0 0 0\nrapid 20 -24 0 0 0\n"},
	{"L X + 10 Y- 5,5 IZ - 2 FMAX\nCYCL DEF 7.0\nCYCL DEF 7.1 X + 5\nL X+0 FMAX\n",
	 "rapid 10 -5.5 -2 0 0\nrapid 5 -5.5 -2 0 0\n"},
};

START_TEST(lexis_table)
{
	klartext_expect(&lexis[_i], false);
}
END_TEST

/* Inches, called programs, presets, no setup: cases that need another control than the tables. */
START_TEST(units)
{
	struct gcode_case c;

	klartext_case(&c);
	c.show_feed = true;
	case_expect(&c, "BEGIN PGM T INCH\nL X+1 Y-.5 FMAX\nL X+2 C+90 F100\nL C+0\nEND PGM T INCH\n",
		    "rapid 25.4 -12.7 0 0 0\nfeed 50.8 -12.7 0 0 90 at 4.23333333 1.66666667\n"
		    "feed 50.8 -12.7 0 0 0 at 4.23333333 1.66666667\n");
	klartext_case(&c);
	c.show_feed = true;
	case_expect(&c, "BEGIN PGM T MM\nTOOL CALL 1 Z S60 F300\nL X+1 F60\nL X+2 F AUTO\nEND PGM T MM\n",
		    "tool 1 at 0 0\nfeed 1 0 0 0 0 at 1 1\nfeed 2 0 0 0 0 at 5 5\n");
	/* FU: mm a turn, of 60 turns a minute. */
	klartext_case(&c);
	c.show_feed = true;
	case_expect(&c, "BEGIN PGM T MM\nTOOL CALL 1 Z FU2 S60\nL X+1\nEND PGM T MM\n",
		    "tool 1 at 0 0\nfeed 1 0 0 0 0 at 2 2\n");
}
END_TEST

START_TEST(presets)
{
	struct gcode_case c;

	klartext_case(&c);
	c.config.work_offsets = &klartext_presets[1];
	/* The only preset is in force. */
	ck_assert(klartext_run(&c, "L X+1 Y+1 Z+1 FMAX\n"));
	ck_assert_str_eq(strbuf_text(&c.moves), "rapid 11 21 31 0 0\n");
	case_release(&c);
	klartext_case(&c);
	c.config.work_offset_count = 2;
	ck_assert(klartext_run(&c, "CYCL DEF 247 Q339=2\nL X+1 FMAX\nCYCL DEF 247 Q339=1\nL X+1 FMAX\n"));
	ck_assert_str_eq(strbuf_text(&c.moves), "rapid 11 0 0 0 0\nrapid 1 0 0 0 0\n");
	case_release(&c);
	klartext_case(&c);
	c.config.work_offset_count = 2;
	ck_assert(!klartext_run(&c, "L X+1 FMAX\n"));
	ck_assert_ptr_nonnull(
	    strstr(strbuf_text(&c.messages), "the setup has 2 presets, and the program does not say"));
	case_release(&c);
}
END_TEST

/* The setup's only preset holds without CYCL DEF 247: an axis that is not named stays where it is. */
START_TEST(only_preset)
{
	struct gcode_case c;

	klartext_case(&c);
	c.config.work_offsets = &klartext_presets[1];
	ck_assert(klartext_run(&c, "L X+1 FMAX\nL IY+1 FMAX\nL Z+1 FMAX\n"));
	ck_assert_str_eq(strbuf_text(&c.moves), "rapid 11 0 0 0 0\nrapid 11 1 0 0 0\nrapid 11 1 31 0 0\n");
	case_release(&c);
}
END_TEST

/* A row of the datum table shifts all axes at once, from the preset. */
START_TEST(datum_row)
{
	static const struct work_offset offsets[] = {
	    {.name = "G54.1 P1", .value = {{100, 0, 0}}}, {.name = "#0"}, {.name = "#12", .value = {{1, 2, 3, 0, 0, PI / 2}}}};
	struct gcode_case c;

	klartext_case(&c);
	c.config.work_offsets = offsets;
	c.config.work_offset_count = 3;
	ck_assert_msg(klartext_run(&c, "SEL TABLE \"TNC:\\NUL.D\"\nQ1=12\nCYCL DEF 7.0 DATUM\nCYCL DEF 7.1 #Q1\n"
				       "L X+0 Y+0 Z+0 C+10 FMAX\nCYCL DEF 7.0\nCYCL DEF 7.1 X+5\nL X+0 Y+0 FMAX\n"
				       "CYCL DEF 7.0\nCYCL DEF 7.1 #0\nL X+0 Y+0 Z+0 C+10 FMAX\n"
				       "TRANS DATUM TABLE TABLINE12 \"TNC:\\NUL.D\"\nL X+2 Y+2 Z+2 C+0 FMAX\n"
				       "TRANS DATUM RESET\nTRANS DATUM TABLE TABLINE Q1\nL X+3 FMAX\n"),
		      "%s", strbuf_text(&c.messages));
	ck_assert_str_eq(strbuf_text(&c.moves),
			 "rapid 101 2 3 0 100\nrapid 105 2 3 0 100\nrapid 100 0 0 0 10\n"
			 "rapid 103 4 5 0 90\nrapid 104 4 5 0 90\n");
	case_release(&c);
}
END_TEST

/*
 * Does the position of C at the preset count for M128? The machine file says so; without an answer the program is
 * refused.
 */
static bool turn_about(struct gcode_case *c, enum answer given, bool offset, const char *blocks)
{
	static const struct work_offset preset = {.name = "G54.1 P1", .value = {{0, 0, 0, 0, 0, PI / 6}}};

	klartext_case(c);
	c->config.work_offsets = &preset;
	c->config.controller.tcp_zero_given = given;
	c->config.controller.tcp_zero_offset = offset;
	return klartext_run(c, blocks);
}

START_TEST(rotary_zero)
{
	static const char m128[] = "L C+10 FMAX\nM128\nL X+10 FMAX\n";
	static const char *const asked[] = {m128, "PLANE SPATIAL SPA-30 SPB+0 SPC+0 TURN FMAX\n",
					    "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS\n",
					    "CYCL DEF 19.0\nCYCL DEF 19.1 A-30 B+0 C+0\n"};
	struct gcode_case c;

	for (size_t i = 0; i < sizeof(asked) / sizeof(asked[0]); i++) {
		ck_assert(!turn_about(&c, ANSWER_UNKNOWN, false, asked[i]));
		ck_assert(strstr(strbuf_text(&c.messages), "tcp_zero=\"machine\" or \"offset\""));
		case_release(&c);
	}
	ck_assert(turn_about(&c, ANSWER_YES, false, m128));
	ck_assert_str_eq(strbuf_text(&c.moves), "rapid 0 0 0 0 40\ntcp on length 0 zero A0 C0\nrapid 10 0 0 0 40 tcp\n");
	case_release(&c);
	ck_assert(turn_about(&c, ANSWER_YES, true, m128));
	ck_assert_str_eq(strbuf_text(&c.moves), "rapid 0 0 0 0 40\ntcp on length 0 zero A0 C30\nrapid 10 0 0 0 40 tcp\n");
	case_release(&c);
	ck_assert(turn_about(&c, ANSWER_UNKNOWN, false, "L C+10 FMAX\nPLANE RESET STAY\nM129\nL X+10 FMAX\n"));
	case_release(&c);
	/* A datum shift counts where the preset does. */
	ck_assert(!turn_about(&c, ANSWER_YES, false, "M128\nCYCL DEF 7.0\nCYCL DEF 7.1 C+5\n"));
	ck_assert(strstr(strbuf_text(&c.messages), "a datum shift of C with M128"));
	case_release(&c);
	ck_assert(turn_about(&c, ANSWER_YES, true, "M128\nCYCL DEF 7.0\nCYCL DEF 7.1 C+5\nL C+0 FMAX\n"));
	case_release(&c);
}
END_TEST

/* M92 counts from the machine's <reference number="1">, without offsets and the tool's length. */
START_TEST(builder_point)
{
	struct gcode_case c;

	klartext_case(&c);
	c.config.work_offsets = &klartext_presets[1];
	c.config.controller.references[0] =
	    (struct control_place){.given = true, .has = {true, true, true}, .value = {{-300, 0, -5}}};
	ck_assert_msg(klartext_run(&c, "TOOL CALL 1 Z S100\nL Z+0 R0 FMAX M92\nL X+1 IY+2 FMAX M92\nL X+1 FMAX\n"), "%s",
		      strbuf_text(&c.messages));
	ck_assert_str_eq(strbuf_text(&c.moves),
			 "tool 1\nrapid 0 0 -5 0 0\nrapid -299 2 -5 0 0\nrapid 11 2 -5 0 0\n");
	case_release(&c);
}
END_TEST

/* The number of teeth changes only the feed; one caution says so. */
START_TEST(feed_per_tooth)
{
	struct gcode_case c;

	klartext_case(&c);
	c.show_feed = true;
	ck_assert(klartext_run(&c, "S600\nL X+1 FZ0.1\nL X+2 FZ0.2\n"));
	ck_assert_str_eq(strbuf_text(&c.moves), "feed 1 0 0 0 0 at 1 1\nfeed 2 0 0 0 0 at 2 2\n");
	ck_assert_ptr_nonnull(strstr(strbuf_text(&c.messages), "p.nc:3:7: warning: FZ counts as the feed of one tooth"));
	ck_assert_ptr_null(strstr(strbuf_text(&c.messages), "p.nc:4"));
	case_release(&c);
}
END_TEST

/* CYCLE is read as CYCL, also in the lines of an older cycle; one caution says so. */
START_TEST(cycle_in_full)
{
	struct gcode_case c;

	klartext_case(&c);
	ck_assert(klartext_run(&c, "CYCLE DEF 7.0 SHIFT\nCYCLE DEF 7.1 X+10\nCYCLE DEF 7.2 Y+20\nL X+1 Y+2 FMAX\n"));
	ck_assert_str_eq(strbuf_text(&c.moves), "rapid 11 22 0 0 0\n");
	ck_assert_uint_eq(c.diag.warnings, 1);
	ck_assert_ptr_nonnull(strstr(strbuf_text(&c.messages), "p.nc:2:1: warning: CYCLE is read as CYCL"));
	case_release(&c);
}
END_TEST

/* Text after END PGM gives one caution; blank lines, comments and the end of a transmission give none. */
START_TEST(behind_end)
{
	struct gcode_case c;

	klartext_case(&c);
	ck_assert(case_run(&c, "BEGIN PGM T MM\nL X+1 FMAX\nEND PGM T MM\n\n; comment\n%\nL X+2 FMAX\nL X+3 FMAX\n"));
	ck_assert_str_eq(strbuf_text(&c.moves), "rapid 1 0 0 0 0\n");
	ck_assert_uint_eq(c.diag.warnings, 1);
	ck_assert_ptr_nonnull(strstr(strbuf_text(&c.messages), "p.nc:7:1: warning: text behind END PGM: the control reads "
							       "none of it"));
	case_release(&c);
}
END_TEST

/* A caution says that files may change; the moves do not depend on it. */
START_TEST(files)
{
	static const char *const blocks[] = {"FUNCTION FILECOPY \"TNC:\\A.H\" TO \"TNC:\\B.H\"\n",
					     "FUNCTION FILEMOVE \"TNC:\\A.H\" TO \"TNC:\\B.H\"\n",
					     "FUNCTION FILEDELETE \"TNC:\\A.H\"\n",
					     "FUNCTION FILE COPY \"TNC:\\A.H\" TO \"TNC:\\B.H\"\n"};

	for (size_t i = 0; i < sizeof(blocks) / sizeof(blocks[0]); i++) {
		struct gcode_case c;

		klartext_case(&c);
		ck_assert(klartext_run(&c, blocks[i]));
		ck_assert_uint_eq(c.diag.warnings, 1);
		ck_assert_ptr_nonnull(strstr(strbuf_text(&c.messages), "is not carried out: called programs are read as "
								       "they are now"));
		case_release(&c);
	}
}
END_TEST

/* The setup names the tool that is in the spindle before the first TOOL CALL. */
START_TEST(first_tool)
{
	struct gcode_case c;

	klartext_case(&c);
	c.config.initial_tool = 2;
	ck_assert_msg(klartext_run(&c, "FN 18: SYSREAD Q1 = ID20 NR1\nL X+Q1 FMAX\n"), "%s", strbuf_text(&c.messages));
	ck_assert_str_eq(strbuf_text(&c.moves), "rapid 2 0 0 0 0\n");
	case_release(&c);
}
END_TEST

/* An ignored M118 takes its axis words with it. */
START_TEST(handwheel)
{
	static const struct mcode ignored = {118, MCODE_IGNORE};
	struct gcode_case c;

	klartext_case(&c);
	c.config.controller.mcodes = &ignored;
	c.config.controller.mcode_count = 1;
	ck_assert(klartext_run(&c, "L X+1 FMAX M118 X2 Y3 Z4\n"));
	ck_assert_str_eq(strbuf_text(&c.moves), "rapid 1 0 0 0 0\n");
	case_release(&c);
}
END_TEST

/* A parameter says what the angles of cycle 19 are. */
START_TEST(cycle_19)
{
	static const char program[] = "CYCL DEF 19.0\nCYCL DEF 19.1 A-45\n";
	struct gcode_case c;

	klartext_case(&c);
	c.config.controller.cycle_19_angles = CYCLE_19_ANGLES_UNKNOWN;
	ck_assert(!klartext_run(&c, program));
	ck_assert_ptr_nonnull(strstr(strbuf_text(&c.messages), "cycle_19_angles=\"spatial\" or \"axes\""));
	case_release(&c);
	/* Angles as positions of the axes; positions of axes that the machine lacks may be 0. */
	klartext_case(&c);
	c.config.controller.cycle_19_angles = CYCLE_19_ANGLES_AXES;
	ck_assert(klartext_run(&c, "CYCL DEF 19.0\nCYCL DEF 19.1 A+30 B+0 C+0\nL A+30 C+0 FMAX\nL Y+10 FMAX\n"));
	ck_assert_str_eq(strbuf_text(&c.moves),
			 "rapid 0 0 0 30 0\ntcp on length 0 zero A0 C0\nrapid 0 8.66025404 -5 30 0 tcp\n");
	case_release(&c);
	klartext_case(&c);
	c.config.controller.cycle_19_angles = CYCLE_19_ANGLES_AXES;
	ck_assert(!klartext_run(&c, "CYCL DEF 19.0\nCYCL DEF 19.1 B+30\n"));
	ck_assert_ptr_nonnull(strstr(strbuf_text(&c.messages), "the machine has no B axis"));
	case_release(&c);
}
END_TEST

/* A machine parameter says whether cycle 11 scales Z, too. */
START_TEST(cycle_11)
{
	static const struct {
		enum cycle_11_axes axes;
		const char *moves;
	} cases[] = {{CYCLE_11_AXES_PLANE, "rapid 2 4 3 0 0\nrapid 1 2 3 0 0\nrapid 0.5 1 3 0 0\nrapid 7 14 21 0 0\n"},
		     {CYCLE_11_AXES_ALL, "rapid 2 4 6 0 0\nrapid 1 2 3 0 0\nrapid 0.5 1 1.5 0 0\nrapid 7 14 21 0 0\n"}};

	for (size_t i = 0; i < COUNT(cases); i++) {
		struct gcode_case c;

		klartext_case(&c);
		c.config.controller.cycle_11_axes = cases[i].axes;
		ck_assert_msg(klartext_run(&c, "CYCL DEF 11.0\nCYCL DEF 11.1 SCL 2\nL X+1 Y+2 Z+3 FMAX\nTRANS SCALE RESET\n"
					       "L X+1 Y+2 Z+3 FMAX\nTRANS SCALE SCL0.5\nL X+1 Y+2 Z+3 FMAX\n"
					       "CYCL DEF 11.0\nCYCL DEF 11.1 SCL 1\nCYCL DEF 26.0\nCYCL DEF 26.1 X7 Y7 Z7\n"
					       "L X+1 Y+2 Z+3 FMAX\n"),
			      "%s", strbuf_text(&c.messages));
		ck_assert_str_eq(strbuf_text(&c.moves), cases[i].moves);
		case_release(&c);
	}
}
END_TEST

/* The machine file says that increments count from the position of the axis: 1 + 5, turned; M140 ended at 150. */
START_TEST(increments_after_shift)
{
	struct gcode_case c;

	klartext_case(&c);
	c.config.controller.increments_after_shift = INCREMENTS_FROM_POSITION;
	ck_assert_msg(klartext_run(&c, "L X+1 Y+2 Z+3 FMAX\nCYCL DEF 7.0\nCYCL DEF 7.1 X+10\nCYCL DEF 7.2 C+10\n"
				       "L IX+5 IC+20 FMAX\nCYCL DEF 10.0\nCYCL DEF 10.1 ROT+90\nL IX+5 FMAX\n"
				       "CC IX+0 IY+3\nLP PR+0 PA+0 FMAX\n"),
		      "%s", strbuf_text(&c.messages));
	ck_assert_str_eq(strbuf_text(&c.moves),
			 "rapid 1 2 3 0 0\nrapid 6 2 3 0 20\nrapid 6 7 3 0 20\nrapid 3 7 3 0 20\n");
	case_release(&c);
}
END_TEST

START_TEST(without_setup)
{
	struct gcode_case c;

	klartext_case(&c);
	c.config.has_setup = false;
	c.config.tool_count = 0;
	c.config.work_offset_count = 0;
	ck_assert(klartext_run(&c, "TOOL CALL 0 Z\nL X+1 FMAX\n"));
	case_release(&c);
	klartext_case(&c);
	c.config.has_setup = false;
	c.config.tool_count = 0;
	ck_assert(!klartext_run(&c, "TOOL CALL 1 Z\n"));
	ck_assert_ptr_nonnull(strstr(strbuf_text(&c.messages), "no setup was given that defines the tool's length"));
	case_release(&c);
	klartext_case(&c);
	c.config.controller.tool_change.given = false;
	ck_assert(!klartext_run(&c, "TOOL CALL 1 Z\n"));
	ck_assert_ptr_nonnull(strstr(strbuf_text(&c.messages), "<tool_change/> if it moves none"));
	case_release(&c);
}
END_TEST

/* Every block that is not a label, a jump or a comment is reported with its moves and its text. */
START_TEST(blocks)
{
	struct gcode_case c;

	klartext_case(&c);
	ck_assert(klartext_run(&c, "1 L X+1 F100\n2 RND R.2\n3 L Y+1\n; text\nLBL 1\n"));
	ck_assert_str_eq(strbuf_text(&c.blocks), "2:1:1 L X+1 F100\n3:0:2 RND R.2\n4:2:3 L Y+1\n");
	ck_assert_int_eq(c.lines, 7);
	case_release(&c);
}
END_TEST

START_TEST(block_limit)
{
	struct gcode_case c;

	klartext_case(&c);
	c.config.read.max_blocks = 50;
	ck_assert(!klartext_run(&c, "LBL 1\nL X+1 FMAX\nFN 9: IF 1 EQU 1 GOTO LBL 1\n"));
	ck_assert_ptr_nonnull(
	    strstr(strbuf_text(&c.messages), "50 blocks of loops and subprograms were executed"));
	case_release(&c);
}
END_TEST

/* The next line is not in the reader's buffer: RND is still found, and the current line keeps its text. */
START_TEST(long_program)
{
	struct strbuf text = {0}, moves = {0};
	struct gcode_case c;

	klartext_case(&c);
	for (int i = 1; i <= 40000; i++)
		strbuf_addf(&text, "L X+%d F100 ; %020d\n", i, i);
	strbuf_addf(&text, "L Y+5\nRND R1\nL IX+5\n");
	ck_assert(klartext_run(&c, strbuf_text(&text)));
	ck_assert_int_eq(c.count, 40003);
	strbuf_addf(&moves, "feed 40000 4 0 0 0\narc 40001 5 0 0 0 centre 40001 4 0 normal 0 0 1 sweep -90\n"
			    "feed 40005 5 0 0 0\n");
	ck_assert_str_eq(strbuf_text(&c.moves) + c.moves.length - moves.length, strbuf_text(&moves));
	case_release(&c);
	strbuf_release(&text);
	strbuf_release(&moves);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("gcode_klartext");

	tcase_add_loop_test(tcase, lexis_table, 0, COUNT(lexis));
	tcase_add_test(tcase, units);
	tcase_add_test(tcase, presets);
	tcase_add_test(tcase, only_preset);
	tcase_add_test(tcase, datum_row);
	tcase_add_test(tcase, rotary_zero);
	tcase_add_test(tcase, builder_point);
	tcase_add_test(tcase, feed_per_tooth);
	tcase_add_test(tcase, cycle_in_full);
	tcase_add_test(tcase, behind_end);
	tcase_add_test(tcase, files);
	tcase_add_test(tcase, first_tool);
	tcase_add_test(tcase, handwheel);
	tcase_add_test(tcase, cycle_19);
	tcase_add_test(tcase, cycle_11);
	tcase_add_test(tcase, increments_after_shift);
	tcase_add_test(tcase, without_setup);
	tcase_add_test(tcase, blocks);
	tcase_add_test(tcase, block_limit);
	tcase_add_test(tcase, long_program);
	return run_suite("gcode_klartext", tcase);
}
