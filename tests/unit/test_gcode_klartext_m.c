/* test_gcode_klartext_m.c - Klartext: M-functions whose meaning the machine file gives, M126, M94, M6 and M143. */
#include "klartext_case.h"

/* iTNC 530 user's manual, programming examples: M6 in the block that retracts, then TOOL CALL. */
START_TEST(m6_of_manual_changes)
{
	struct gcode_case c;

	klartext_case(&c);
	c.config.controller.m6 = M6_IGNORED;
	ck_assert_msg(klartext_run(&c, "M6\nTOOL CALL 1 Z S100\nL Z+0 R0 FMAX M3\nL Z+50 R0 FMAX M6\nTOOL CALL 2 Z S100\n"
				       "L Z+0 FMAX\n"),
		      "%s", strbuf_text(&c.messages));
	ck_assert_str_eq(strbuf_text(&c.moves), "tool 1\nrapid 0 0 100 0 0\nrapid 0 0 150 0 0\ntool 2\nrapid 0 0 40 0 0\n");
	case_release(&c);
}
END_TEST

/* The presets of a setup have no basic rotation, so there is nothing to erase; a caution says so. */
START_TEST(basic_rotation)
{
	struct gcode_case c;

	klartext_case(&c);
	ck_assert(klartext_run(&c, "L X+1 FMAX M143\nL X+2 FMAX\n"));
	ck_assert_str_eq(strbuf_text(&c.moves), "rapid 1 0 0 0 0\nrapid 2 0 0 0 0\n");
	ck_assert_ptr_nonnull(strstr(strbuf_text(&c.messages), "p.nc:2:12: warning: M143 erases the basic rotation"));
	case_release(&c);
}
END_TEST

START_TEST(rotary_ways)
{
	struct gcode_case c;

	/*
	 * M126 takes the shorter way if the display is reduced; without M126 the control moves by the plain difference.
	 */
	klartext_case(&c);
	c.config.wrap[SLOT_C] = WRAP_SHORTEST;
	ck_assert(klartext_run(&c, "M126\nL C+350 FMAX\nL C+10 FMAX\n"));
	ck_assert_str_eq(strbuf_text(&c.moves), "rapid 0 0 0 0 -10\nrapid 0 0 0 0 10\n");
	case_release(&c);
	klartext_case(&c);
	c.config.wrap[SLOT_C] = WRAP_SHORTEST;
	ck_assert(!klartext_run(&c, "L C+90 FMAX\nL C+350 FMAX\n"));
	ck_assert_ptr_nonnull(strstr(strbuf_text(&c.messages), "M126 is not in force: whether the control goes the plain way"));
	case_release(&c);
	/* The machine file says which way: the manual's examples, and half a turn, which then needs no answer. */
	for (int way = ROTARY_WAY_PLAIN; way <= ROTARY_WAY_SHORTER; way++) {
		static const char *const moves[] = {
			"", "rapid 0 0 0 0 350\nrapid 0 0 0 0 10\nrapid 0 0 0 0 340\nrapid 0 0 0 0 0\nrapid 0 0 0 0 -20\nrapid 0 0 0 0 -360\n",
			"rapid 0 0 0 0 -10\nrapid 0 0 0 0 10\nrapid 0 0 0 0 -20\nrapid 0 0 0 0 0\nrapid 0 0 0 0 -20\nrapid 0 0 0 0 0\n"};

		klartext_case(&c);
		c.config.wrap[SLOT_C] = WRAP_SHORTEST;
		c.config.controller.rotary_way = (enum rotary_way)way;
		c.config.controller.rotary_angle = ROTARY_ANGLE_AS_WRITTEN;
		ck_assert_msg(klartext_run(&c, "L C+350 FMAX\nL C+10 FMAX\nL C+340 FMAX\nL C+0 FMAX\nL C-20 FMAX\nL C+0 FMAX\n"),
			      "%s", strbuf_text(&c.messages));
		ck_assert_str_eq(strbuf_text(&c.moves), moves[way]);
		case_release(&c);
	}
	klartext_case(&c);
	c.config.wrap[SLOT_C] = WRAP_SHORTEST;
	c.config.controller.rotary_way = ROTARY_WAY_PLAIN;
	ck_assert(klartext_run(&c, "L C+180 FMAX\nL C+0 FMAX\n"));
	ck_assert_str_eq(strbuf_text(&c.moves), "rapid 0 0 0 0 180\nrapid 0 0 0 0 0\n");
	ck_assert(!klartext_run(&c, "L C+350 FMAX\nL C-20 FMAX\n"));
	ck_assert_ptr_nonnull(strstr(strbuf_text(&c.messages), "outside of 0 to 360 without M126"));
	case_release(&c);
	/* An angle outside of 0 to 360, also if the way to the angle as written is the shorter one. */
	for (int angle = ROTARY_ANGLE_UNKNOWN; angle <= ROTARY_ANGLE_REDUCED; angle++) {
		static const char *const moves[] = {
			"rapid 0 0 0 0 10\n", "rapid 0 0 0 0 10\nrapid 0 0 0 0 -5\nrapid 0 0 0 0 10\n",
			"rapid 0 0 0 0 10\nrapid 0 0 0 0 355\nrapid 0 0 0 0 10\n"};

		klartext_case(&c);
		c.config.wrap[SLOT_C] = WRAP_SHORTEST;
		c.config.controller.rotary_way = ROTARY_WAY_PLAIN;
		c.config.controller.rotary_angle = (enum rotary_angle)angle;
		ck_assert(klartext_run(&c, "L C+10 FMAX\nL C-5 FMAX\nL C+370 FMAX\n") == (angle != ROTARY_ANGLE_UNKNOWN));
		ck_assert_str_eq(strbuf_text(&c.moves), moves[angle]);
		case_release(&c);
	}
	klartext_case(&c);
	c.config.wrap[SLOT_C] = WRAP_SHORTEST;
	ck_assert(!klartext_run(&c, "L C+10 FMAX\nL C-5 FMAX\n"));
	ck_assert_ptr_nonnull(strstr(strbuf_text(&c.messages), "rotary_way=\"plain\" or \"shorter\""));
	case_release(&c);
	/* With a reduced display M94 has nothing to reduce. */
	klartext_case(&c);
	c.config.wrap[SLOT_C] = WRAP_SHORTEST;
	ck_assert(klartext_run(&c, "L IC+720 FMAX\nM126\nL C+10 FMAX M94\n"));
	ck_assert_str_eq(strbuf_text(&c.moves), "rapid 0 0 0 0 720\nrapid 0 0 0 0 730\n");
	case_release(&c);
	klartext_case(&c);
	ck_assert(klartext_run(&c, "M126\nL C+350 FMAX\n"));
	ck_assert_ptr_nonnull(
	    strstr(strbuf_text(&c.messages), "warning: M126 is in force, but C counts as a plain number"));
	case_release(&c);
	klartext_case(&c);
	c.config.wrap[SLOT_C] = WRAP_SIGN;
	ck_assert(!klartext_run(&c, "L C+350 FMAX\n"));
	case_release(&c);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("gcode_klartext_m");

	tcase_add_test(tcase, m6_of_manual_changes);
	tcase_add_test(tcase, basic_rotation);
	tcase_add_test(tcase, rotary_ways);
	return run_suite("gcode_klartext_m", tcase);
}
