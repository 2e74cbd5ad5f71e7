/* test_gcode_sinumerik_path.c - the sinumerik dialect: how far the control may leave the path, move by move. */
#include "sinumerik_case.h"

static const struct program {
	const char *text, *moves;
} programs[] = {
	/* "Continuous-path mode": ADIS is for feeds, ADISPOS for rapids; the corner between them is rounded by either. */
	{"G500 F6 G641 ADIS=0.5 ADISPOS=2\nX1\nG60 X2\nG64 X3\n",
	 "feed 1 0 0 0 0 blend 2\nfeed 2 0 0 0 0 exact\nfeed 3 0 0 0 0 blend 0\n"},
	{"G500 F6 G642 CTOL=0.02 OTOL=0.5\nX1\nSTOLF=3\nX2\nCTOL=-1 OTOL=-1 X3\n",
	 "feed 1 0 0 0 0 blend 0.02 turn 0.5\nfeed 2 0 0 0 0 blend 0.06 turn 0.5\n"
	 "feed 3 0 0 0 0 blend 0\n"},
	/* "High speed settings (CYCLE832)" */
	{"G500 F6 CYCLE832(0.01,_ORI_FINISH,0.8)\nX1\nCYCLE832(0.02,_ROUGH,1)\nX2\nCYCLE832(0.03)\nX3\n",
	 "feed 1 0 0 0 0 blend 0.01 turn 0.8\nfeed 2 0 0 0 0 blend 0.02\nfeed 3 0 0 0 0 blend 0.03\n"},
	/* Top Surface, a matter of the hundreds, smooths within the same tolerance. */
	{"G500 F6 CYCLE832(0.01,_TOP_SURFACE_SMOOTH_ON+_ORI_FINISH,0.8)\nX1\nCYCLE832(0.02,_TOP_SURFACE_SMOOTH_OFF+_ROUGH,1)\nX2\n"
	 "CYCLE832(0.03)\nX3\n",
	 "feed 1 0 0 0 0 blend 0.01 turn 0.8\nfeed 2 0 0 0 0 blend 0.02\nfeed 3 0 0 0 0 blend 0.03\n"},
	{"G500 F6 CYCLE832(0.05,112101)\nX1\nCYCLE832(0.05,_OFF,1)\nX2\nCYCLE832(0.05)\nX3\nCYCLE832()\nX4\n",
	 "feed 1 0 0 0 0 blend 0.05\nfeed 2 0 0 0 0 blend 0\nfeed 3 0 0 0 0 blend 0.05\n"
	 "feed 4 0 0 0 0 blend 0\n"},
};

START_TEST(moves)
{
	struct gcode_case c;

	sinumerik_case_init(&c);
	c.show_blend = true;
	ck_assert_msg(case_run(&c, programs[_i].text), "%s%s", programs[_i].text, strbuf_text(&c.messages));
	ck_assert_str_eq(strbuf_text(&c.moves), programs[_i].moves);
	case_release(&c);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("programs");

	tcase_add_loop_test(tcase, moves, 0, COUNT(programs));
	return run_suite("gcode_sinumerik_path", tcase);
}
