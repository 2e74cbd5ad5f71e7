/*
 * test_gcode_klartext_builder.c - Klartext: cycles and programs of the machine's builder, whose effect the machine file
 * describes.
 */
#include "klartext_case.h"

#define DRILL "CYCL DEF 200 DRILLING Q200=2 Q201=-10 Q206=150 Q202=10 Q203=+0 Q204=20\n"

/* A probing cycle that the machine file describes: it moves around its place, and what it measures is not known. */
START_TEST(probe_cycle)
{
	static const struct builder_macro macros[] = {
		{413, 0, MACRO_AROUND, {5, 20, 10}, NULL},
		{483, 0, MACRO_NONE, {0}, NULL},
		{420, 0, MACRO_MOVE, {0}, NULL}};
	struct gcode_case c;

	klartext_case(&c);
	c.config.controller.macros = macros;
	c.config.controller.macro_count = 3;
	c.show_spread = true;
	ck_assert_msg(klartext_run(&c, "L X+10 FMAX\n6 TCH PROBE 413 DATUM OUTSIDE ~\n   Q321=+50 ;CENTRE ~\n   Q322=+50\n"
				       "7 L X+11 FMAX\nL Z+9 FMAX\nTCH PROBE 483 TOOL Q340=1\nL X+12 Y+3 FMAX\n"
				       "L Z+2 FMAX\n"),
		      "%s", strbuf_text(&c.messages));
	ck_assert_str_eq(strbuf_text(&c.moves), "rapid 10 0 0 0 0\nrapid 10 -20 0 0 0 spread 5 0 10\n"
						"rapid 10 20 0 0 0 spread 5 0 10\nrapid 10 0 0 0 0 spread 5 0 10\n"
						/* The point above which the probe has stopped is not known. */
						"rapid 11 0 0 0 0 spread 5 20 10\nrapid 11 0 9 0 0 spread 5 20 10\n"
						"rapid 12 3 9 0 0 spread 5 20 0\nrapid 12 3 2 0 0\n");
	ck_assert_ptr_nonnull(strstr(strbuf_text(&c.messages), "warning: touch probe cycle 413: datum and tools count as"));
	case_release(&c);
	/* Turned by 90 degrees it goes 20 mm along X. */
	klartext_case(&c);
	c.config.controller.macros = macros;
	c.config.controller.macro_count = 3;
	c.show_spread = true;
	ck_assert_msg(klartext_run(&c, "CYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 ROT+90\nTCH PROBE 413 X Q321=1\n"), "%s",
		      strbuf_text(&c.messages));
	ck_assert_str_eq(strbuf_text(&c.moves), "rapid -20 0 0 0 0 spread 0 20 10\nrapid 20 0 0 0 0 spread 0 20 10\n"
						"rapid 0 0 0 0 0 spread 0 20 10\n");
	case_release(&c);
	for (int i = 0; i < 4; i++) {
		static const char *const blocks[] = {"TCH PROBE 413 X Q321=1\nL X+Q151 FMAX\n", "M128\nTCH PROBE 413 X Q321=1\nM129\n",
						     "TCH PROBE 420 X Q321=1\n",
						     "CYCL DEF 26.0\nCYCL DEF 26.1 X2 Y2\nTCH PROBE 413 X Q321=1\n"};
		static const char *const said[] = {"Q151 is a value of the control that is not known here",
						   "cycle 413 moves around its place while the tool centre point is controlled",
						   "touch probe cycle 420: where the probe stops is not known",
						   "coordinates are scaled or the radius is compensated"};

		klartext_case(&c);
		c.config.controller.macros = macros;
		c.config.controller.macro_count = 3;
		ck_assert(!klartext_run(&c, blocks[i]));
		ck_assert_msg(strstr(strbuf_text(&c.messages), said[i]) != NULL, "%s", strbuf_text(&c.messages));
		case_release(&c);
	}
}
END_TEST

/* CALL PGM of a program that the builder made and that has no file: the machine file says what it does. */
START_TEST(builder_program)
{
	static const struct builder_macro macros[] = {{0, 0, MACRO_NONE, {0}, "RESET_2"}, {0, 0, MACRO_AROUND, {5, 20, 10}, "WASH"}};
	struct gcode_case c;

	klartext_case(&c);
	c.config.controller.macros = macros;
	c.config.controller.macro_count = 2;
	c.show_spread = true;
	ck_assert_msg(klartext_run(&c, "L X+10 FMAX\nCALL PGM TNC:\\OEM\\Reset_2.H\nCALL PGM wash\nSEL PGM \"WASH.H\"\n"
				       "CYCL DEF 12.0 PGM CALL\nCYCL DEF 12.1 PGM RESET_2.H\nL X+11 FMAX M99\n"),
		      "%s", strbuf_text(&c.messages));
	ck_assert_str_eq(strbuf_text(&c.moves), "rapid 10 0 0 0 0\nrapid 10 -20 0 0 0 spread 5 0 10\n"
						"rapid 10 20 0 0 0 spread 5 0 10\nrapid 10 0 0 0 0 spread 5 0 10\n"
						"rapid 11 0 0 0 0\n");
	case_release(&c);
	for (int i = 0; i < 3; i++) {
		static const char *const blocks[] = {"M128\nCALL PGM WASH\nM129\n", "CALL PGM TNC:\\RESET.H\n",
						     "CALL PGM TNC:\\3.H\n"};
		static const char *const said[] = {
			"program WASH moves around its place while the tool centre point is controlled",
			("there is no file of the program TNC:\\RESET.H; if the machine's builder made it and it "
			 "moves no axis, set <macro program=\"RESET\" action=\"none\"/> in the machine file's "
			 "<controller>"),
			"there is no file of the program TNC:\\3.H\n"};

		klartext_case(&c);
		c.config.controller.macros = macros;
		c.config.controller.macro_count = 2;
		ck_assert(!klartext_run(&c, blocks[i]));
		ck_assert_msg(strstr(strbuf_text(&c.messages), said[i]) != NULL, "%s", strbuf_text(&c.messages));
		case_release(&c);
	}
}
END_TEST

/* The position where a cycle of the control has left the tool is uncertain until X, Y and Z are commanded. */
START_TEST(left_by_cycle)
{
	static const struct builder_macro macro = {225, 0, MACRO_AROUND, {5, 20, 10}, NULL};
	struct gcode_case c;

	klartext_case(&c);
	c.config.controller.macros = &macro;
	c.config.controller.macro_count = 1;
	c.show_spread = true;
	ck_assert_msg(klartext_run(&c, "CYCL DEF 225 ENGRAVING Q513=+10\nL X+11 Y+0 Z+0 FMAX M99\nL IX+1 FMAX\n"
				       "L X+20 Y+1 FMAX M99\nL X+0 Y+0 FMAX\nL Z+50 FMAX\nL X+1 FMAX\n"),
		      "%s", strbuf_text(&c.messages));
	ck_assert_str_eq(strbuf_text(&c.moves),
			 "rapid 11 0 0 0 0\nrapid 11 -20 0 0 0 spread 5 0 10\nrapid 11 20 0 0 0 spread 5 0 10\n"
			 "rapid 11 0 0 0 0 spread 5 0 10\nrapid 12 0 0 0 0 spread 5 20 10\n"
			 "rapid 20 1 0 0 0 spread 5 20 10\nrapid 20 -19 0 0 0 spread 5 0 20\n"
			 "rapid 20 21 0 0 0 spread 5 0 20\nrapid 20 1 0 0 0 spread 5 0 20\n"
			 "rapid 0 0 0 0 0 spread 5 20 10\nrapid 0 0 50 0 0 spread 0 0 10\nrapid 1 0 50 0 0\n");
	ck_assert(!klartext_run(&c, "TOOL CALL 1 Z\nCYCL DEF 225 ENGRAVING Q513=+10\nL X+1 Y+0 Z+0 FMAX M99\n"
				    "L X+9 Y+0 FMAX\nL X+20 RL F100\n"));
	ck_assert(strstr(strbuf_text(&c.messages), "at which height a cycle has left the tool"));
	case_release(&c);
	klartext_case(&c);
	c.config.controller.macros = &macro;
	c.config.controller.macro_count = 1;
	ck_assert(!klartext_run(&c, "TOOL CALL 1 Z\nCYCL DEF 225 ENGRAVING Q513=+10\nL X+1 Y+0 Z+0 FMAX M99\n" DRILL
				    "PATTERN DEF POS1 (X+1 Y+2 Z+0)\nCYCL CALL PAT\n"));
	ck_assert(strstr(strbuf_text(&c.messages), "CYCL CALL PAT while it is not known at which height a cycle has left"));
	case_release(&c);
}
END_TEST

/*
 * A cycle of the control whose moves are not modelled moves around the place of its call as far as the machine file
 * says.
 */
START_TEST(bounded_cycle)
{
	static const struct builder_macro macros[] = {{225, 0, MACRO_AROUND, {5, 20, 10}, NULL}, {18, 0, MACRO_NONE, {0}, NULL}};
	struct gcode_case c;

	klartext_case(&c);
	c.config.controller.macros = macros;
	c.config.controller.macro_count = 2;
	c.show_spread = true;
	ck_assert_msg(klartext_run(&c, "L X+10 FMAX\n9 CYCL DEF 225 ENGRAVING ~\n   QS500=\"A\" ;TEXT ~\n   Q513=+10 ;HEIGHT ~\n   Q514=+0 ;FACTOR\n10 L X+11 FMAX\nCYCL CALL\n"
				       "CYCL DEF 18.0 THREAD\nCYCL DEF 18.1 DEPTH -20\nCYCL DEF 18.2 PITCH +1\nL X+12 FMAX M99\n"),
		      "%s", strbuf_text(&c.messages));
	ck_assert_str_eq(strbuf_text(&c.moves), "rapid 10 0 0 0 0\nrapid 11 0 0 0 0\nrapid 11 -20 0 0 0 spread 5 0 10\n"
						"rapid 11 20 0 0 0 spread 5 0 10\nrapid 11 0 0 0 0 spread 5 0 10\n"
						"rapid 12 0 0 0 0 spread 5 20 10\n");
	case_release(&c);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("gcode_klartext_builder");

	tcase_add_test(tcase, probe_cycle);
	tcase_add_test(tcase, builder_program);
	tcase_add_test(tcase, left_by_cycle);
	tcase_add_test(tcase, bounded_cycle);
	return run_suite("gcode_klartext_builder", tcase);
}
