/* test_gcode_sinumerik_region.c - milling cycles of the sinumerik dialect that are regions, and their messages. */
#include "gcode_reach.h"
#include "sinumerik_refused.h"
#include "suite.h"

struct program {
	const char *text, *moves;
};

static const struct program programs[] = {
	{"G500 T1 D1 M6 G0 X0 Y0 Z0\nPOCKET1(10,0,2,-5,,40,30,5,50,60,0,100,200)\nX0 Z20\nY0\nX1\n",
	 "tool 1\nrapid X -32.5..65 Y -35..70 Z 95..110\nfeed X 35..65 Y 50..70 Z 95..102\n"
	 "rapid X -15..65 Y -10..70 Z 102..120\n"},
	{"G500 T1 D1 M6 F6 G0 X50 Y60 Z10\nPOCKET1(10,0,2,,5,40,30,5,50,60,90)\n",
	 "tool 1\nrapid X 40..60 Y 45..75 Z 102..110\nfeed X 40..60 Y 45..75 Z 95..102\n"
	 "rapid X 40..60 Y 45..75 Z 102..110\n"},
	{"G500 T1 D1 M6 F6 G0 X0 Y0 Z10\nPOCKET2(10,0,2,-5,,20,50,60)\n",
	 "tool 1\nrapid X -32.5..65 Y -37.5..75 Z 102..110\nfeed X 35..65 Y 45..75 Z 95..102\n"
	 "rapid X 35..65 Y 45..75 Z 102..110\n"},
	{"G500 T1 D1 M6 F6 G0 X0 Y0 Z10\nPOCKET3(10,0,2,-5,40,30,5,50,60,0)\n",
	 "tool 1\nrapid X -42.5..85 Y -42.5..85 Z 102..110\nfeed X 15..85 Y 35..85 Z 95..102\n"
	 "rapid X 15..85 Y 35..85 Z 102..110\n"},
	{"G500 T1 D1 M6 F6 G0 X0 Y0 Z10\nPOCKET3(10,0,2,5,40,30,5,50,60,0,,,,,,,,,,,,,,,,,1100,1,1)\n",
	 "tool 1\nrapid X -32.5..65 Y -35..70 Z 102..110\nfeed X 35..65 Y 50..70 Z 95..102\n"
	 "rapid X 35..65 Y 50..70 Z 102..110\n"},
	{"G500 T1 D1 M6 F6 G0 X0 Y0 Z10\nPOCKET4(10,0,2,-5,20,50,60)\n",
	 "tool 1\nrapid X -32.5..65 Y -37.5..75 Z 102..110\nfeed X 35..65 Y 45..75 Z 95..102\n"
	 "rapid X 35..65 Y 45..75 Z 102..110\n"},
	{"G500 T1 D1 M6 F6 G0 X0 Y0 Z10\nSLOT1(10,0,2,-5,,2,30,12,0,0,20,0,180)\n",
	 "tool 1\nrapid X -50..50 Y -1..1 Z 102..110\nfeed X 20..50 Y -1..1 Z 95..102\n"
	 "rapid X -50..50 Y -1..1 Z 102..102\nfeed X -50..-20 Y -1..1 Z 95..102\n"
	 "rapid X -85..50 Y -1..1 Z 102..110\n"},
	{"G500 T1 D1 M6 F6 G0 X0 Y0 Z10\nLONGHOLE(10,0,2,-5,,4,30,0,0,20,0,0)\n",
	 "tool 1\nrapid X -50..50 Y -50..50 Z 102..110\nfeed X 20..50 Y 0..0 Z 95..102\n"
	 "rapid X 0..35 Y -15..50 Z 102..102\nfeed X 0..0 Y 20..50 Z 95..102\n"
	 "rapid X -50..15 Y 0..35 Z 102..102\nfeed X -50..-20 Y 0..0 Z 95..102\n"
	 "rapid X -35..0 Y -50..15 Z 102..102\nfeed X 0..0 Y -50..-20 Z 95..102\n"
	 "rapid X -50..50 Y -85..50 Z 102..110\n"},
	{"G500 T1 D1 M6 F6 G0 X0 Y0 Z10\nSLOT2(10,0,2,-5,,3,70,15,60,60,42,0,120)\n",
	 "tool 1\nrapid X -52.25..104.5 Y -52.25..104.5 Z 102..110\n"
	 "feed X 15.5..104.5 Y 15.5..104.5 Z 95..102\nrapid X 15.5..104.5 Y 15.5..104.5 Z 102..110\n"},
	{"G500 T1 D1 M6 F6 G0 X0 Y0 Z10\nCYCLE71(10,0,2,-11,100,100,60,40,10,6,10,5,0,4000,31,2)\n",
	 "tool 1\nrapid X -89.3911..178.782 Y -84.7525..169.505 Z 102..110\n"
	 "feed X 73.3603..178.782 Y 80.3062..169.505 Z 89..102\n"
	 "rapid X 73.3603..178.782 Y 80.3062..169.505 Z 102..110\n"},
	{"G500 T1 D1 M6 F6 G0 X0 Y0 Z10\nCYCLE61(10,1,1,0,0,0,100,100,1,12,0,1000,31,0,1,10)\n",
	 "tool 1\nrapid X -61..111 Y -61..111 Z 102..110\nfeed X -11..111 Y -11..111 Z 100..102\n"
	 "rapid X -11..111 Y -11..111 Z 102..110\n"},
	{"G500 T1 D1 M6 F6 G0 X0 Y0 Z10\nCYCLE90(10,0,2,-40,,60,50,2,500,2,0,60,50)\n",
	 "tool 1\nrapid X -42.5..85 Y -37.5..75 Z 102..110\nfeed X 35..85 Y 25..75 Z 56..106\n"
	 "rapid X 35..85 Y 25..75 Z 102..110\n"},
	{"G500 T1 D1 M6 F6 G0 X0 Y0 Z10\nCYCLE70(10,0,2,-40,60,1,0,2,1,5,500,0,60,50)\n",
	 "tool 1\nrapid X -42.5..85 Y -37.5..75 Z 102..110\nfeed X 35..85 Y 25..75 Z 56..106\n"
	 "rapid X 35..85 Y 25..75 Z 102..110\n"},
	{"G500 F6 G18 G0 X0 Y10 Z0\nPOCKET2(10,0,2,-5,,20,50,60)\nZ1\nX1\n",
	 "rapid X -40..80 Y 2..10 Z -35..70\nfeed X 40..80 Y -5..2 Z 30..70\n"
	 "rapid X -19..80 Y 2..10 Z -19..70\n"},
	{"G500 T1 D1 M6 F6 AROT Z90\nG0 X0 Y0 Z10\nPOCKET1(10,0,2,-5,,40,30,5,50,60,0)\nG0 X0\nY0\nX0 Y0 Z10\nX1\n",
	 "tool 1\nrapid X -70..35 Y -32.5..65 Z 102..110\nfeed X -70..-50 Y 35..65 Z 95..102\n"
	 "rapid X -70..10 Y -15..65 Z 102..110\n"},
	/* MCALL mills at each position, and at those of a pattern. */
	{"G500 T1 D1 M6 F6 G0 X0 Y0 Z10\nMCALL POCKET4(10,0,2,-5,20)\nHOLES1(50,60,0,30,20,2)\nX90 Y-60\nMCALL\nG1 X0 Y0\n",
	 "tool 1\nrapid X 0..95 Y 0..75 Z 102..110\nfeed X 65..95 Y 45..75 Z 95..102\nrapid X 65..115 Y 45..75 Z 102..110\n"
	 "feed X 85..115 Y 45..75 Z 95..102\nrapid X 75..115 Y -75..75 Z 102..110\nfeed X 75..105 Y -75..-45 Z 95..102\n"
	 "rapid X 75..105 Y -75..-45 Z 102..110\nfeed X -15..105 Y -75..15 Z 110..110\n"},
	/* Y of the program, which was not open, takes nothing back of its X, which is the machine's Y. */
	{"G500 T1 D1 M6 F6 AROT Z90\nG0 X0 Y0 Z10\nLONGHOLE(10,0,2,-5,,1,30,0,0,20,0,0)\nG0 Y5\nF1 G1 Z11\n",
	 "tool 1\nrapid X 0..0 Y -25..50 Z 102..110\nfeed X 0..0 Y 20..50 Z 95..102\nrapid X -5..0 Y 20..50 Z 102..110\n"
	 "feed X -5..-5 Y 20..50 Z 110..111\n"},
	/* CYCLE800 while the position is uncertain: the position then may differ along any axis. */
	{"G500 T1 D1 M6 F6 G0 X0 Y0 Z10\nPOCKET2(10,0,2,-5,,20,50,60)\nCYCLE800(0,\"TC1\",0,57,0,0,0,30,0,0,0,0,0,-1)\n"
	 "G0 X1 Y2\nX1 Y2 Z3\nX2\n",
	 "tool 1\nrapid X -32.5..65 Y -37.5..75 Z 102..110\nfeed X 35..65 Y 45..75 Z 95..102\n"
	 "rapid X 35..65 Y 45..75 Z 102..110\norient X 0..0 Y -0.5..-0.5 Z 0.866025..0.866025\n"
	 "rapid X 28.7868..71.2132 Y 38.7868..81.2132 Z 88.7868..131.213\ntcp on length 100 zero A0 C0\n"
	 "rapid X -20.2132..71.2132 Y -14.2568..81.2132 Z -42.5763..31.2132\n"},
	/* Holes and pockets where the last cycle has left the tool. */
	{"G500 T1 D1 M6 F6 G0 X0 Y0 Z10\nPOCKET2(10,0,2,-5,,20,50,60)\nPOCKET2(10,0,2,-5,,20,50,60)\nCYCLE81(10,0,2,-9)\n",
	 "tool 1\nrapid X -32.5..65 Y -37.5..75 Z 102..110\nfeed X 35..65 Y 45..75 Z 95..102\n"
	 "rapid X 20..80 Y 30..90 Z 102..110\nfeed X 35..65 Y 45..75 Z 95..102\n"
	 "rapid X 35..65 Y 45..75 Z 102..110\nfeed X 35..65 Y 45..75 Z 91..91\n"
	 "rapid X 35..65 Y 45..75 Z 110..110\n"},
	{"G700 G500 T1 D1 M6 F6 G0 X0 Y0 Z1\nPOCKET2(1,0,.1,-.5,,2,5,6)\n",
	 "tool 1\nrapid X -86.4..172.8 Y -99.1..198.2 Z 102.54..125.4\n"
	 "feed X 81.2..172.8 Y 106.6..198.2 Z 87.3..102.54\n"
	 "rapid X 81.2..172.8 Y 106.6..198.2 Z 102.54..125.4\n"},
};

static const struct refused_program bad[] = {
	{"MCALL CYCLE71(1)\n", 1, 7,
	 "MCALL CYCLE71: a face is milled where the cycle itself says"},
	{"G500 POCKET1(10,0,2)\n", 1, 6,
	 "POCKET1 needs RTP, RFP and one of DP and DPR"},
	{"G500 POCKET3(10,0,2)\n", 1, 6,
	 "POCKET3 needs RTP, RFP and DP"},
	{"G500 T1 D1 M6 F6 POCKET3(10,0,2,-5,40,30,5,50,60,0,,,,,,,5)\n", 1, 18,
	 "POCKET3 that makes a chamfer (units of _VARI 5) is not supported: how near to the edge the tool goes is not known"},
	{"G500 POCKET2(10,0,2,-5,,20,50,60)\n", 1, 6,
	 "POCKET2 without a feed rate"},
	{"G500 F6 SLOT1(10,0,2,-5,,0,30,12,0,0,20,0,180)\n", 1, 9,
	 "SLOT1 needs a number of slots, NUM, from 1 to 1000"},
	{"G500 F6 LONGHOLE(10,0,2,-5,,1.5,30,0,0,20,0,0)\n", 1, 9,
	 "LONGHOLE needs a number of slots, NUM, from 1 to 1000"},
	{"G500 F6 CYCLE90(10,0,2,-40,,60,50,2,500,2,1,60,50)\n", 1, 9,
	 "CYCLE90 on an outside thread: how far aside the tool goes is not known"},
	{"G500 F6 CYCLE90(10,0,2,-40,,60,50,,500,2,0,60,50)\n", 1, 9,
	 "CYCLE90 needs the pitch of its thread in mm or inches, PIT"},
	{"G500 F6 CYCLE70(10,0,2,-40,60,1,0,2,1,5,500,0,60,50,,,2)\n", 1, 9,
	 "CYCLE70 with a pitch in threads an inch or in modules (_PITA) is not supported"},
	{"G500 G19 F6 POCKET4(10,0,2,-5,20,50,60,,,,,,,,,,,,,,,,,1)\n", 1, 13,
	 "_DMODE of POCKET4 works in the plane of G17, and G19 is in force; select G17 before it"},
	{"G500 F6 POCKET4(10,0,2,-5,20,50,60,,,,,,,,,,,,,,,,,1,3)\n", 1, 9,
	 "the units of _AMODE of POCKET4 must be 0, 1 or 2, not 3"},
	{"G500 F6 POCKET3(-10,0,2,-5,20,50)\n", 1, 9,
	 "the return plane RTP must not lie below the reference plane RFP, and the depth not above it (the "
	 "control's alarm 61101): RTP -10, RFP 0, depth -5 mm"},
	{"T1 D1 M6 G500 F6 G41 X10 Y10\nPOCKET2(10,0,2,-5,,20,50,60)\n", 2, 1,
	 "POCKET2 while tool radius compensation is on; G40 first"},
	{"CYCLE76(50,0,1,,10,60,40)\n", 1, 1,
	 "CYCLE76: milling round a spigot, from how far outside is not published, is not supported; lines and circles (G1, G2, G3) can say "
	 "its moves"},
	{"T1 D1 M6 G500 F6 G0 X0 Y0 Z10\nPOCKET2(10,0,2,-5,,20,50,60)\nG91 X5\n", 3, 5,
	 "an increment from where a milling cycle has left the tool: where it stands over its region is not "
	 "known; go to an absolute position in the plane first"},
	{"T1 D1 M6 G500 F6 G0 X0 Y0 Z10\nPOCKET2(10,0,2,-5,,20,50,60)\nX0\nY=IC(5)\n", 4, 1,
	 "an increment from where a milling cycle has left the tool: where it stands over its region is not "
	 "known; go to an absolute position in the plane first"},
	{"T1 D1 M6 G500 F6 G0 X0 Y0 Z10\nPOCKET2(10,0,2,-5,,20,50,60)\nG2 X0 Y0 CR=50\n", 3, 1,
	 "a circle from where a milling cycle has left the tool: where it stands over its region is not known; go "
	 "to an absolute position in the plane first"},
	{"T1 D1 M6 G500 F6 G0 X0 Y0 Z10\nPOCKET2(10,0,2,-5,,20,50,60)\nG1 G41 X0 Y0\n", 3, 4,
	 "tool radius compensation from where a milling cycle has left the tool: where it stands over its region "
	 "is not known; go to an absolute position in the plane first"},
	{"T1 D1 M6 G500 F6 G0 X0 Y0 Z10\nPOCKET2(10,0,2,-5,,20,50,60)\nG110 X0 Y0\n", 3, 1,
	 "a pole (G110) from where a milling cycle has left the tool: where it stands over its region is not "
	 "known; go to an absolute position in the plane first"},
	{"T1 D1 M6 G500 F6 G0 X0 Y0 Z10\nPOCKET2(10,0,2,-5,,20,50,60)\nR1=$AA_IW[X]\n", 3, 4,
	 "a position from where a milling cycle has left the tool: where it stands over its region is not known; "
	 "go to an absolute position in the plane first"},
	{"T1 D1 M6 G500 F6 G0 X0 Y0 Z10\nPOCKET2(10,0,2,-5,,20,50,60)\nHOLES1(0,0,0,10,5,2)\n", 3, 1,
	 "HOLES1 from where a milling cycle has left the tool: where it stands over its region is not known; go "
	 "to an absolute position in the plane first"},
};

START_TEST(moves)
{
	struct strbuf reached = {0};
	struct gcode_case c;
	char *lines;

	sinumerik_case_init(&c);
	c.show_spread = true;
	ck_assert_msg(case_run(&c, programs[_i].text), "%s%s", programs[_i].text, strbuf_text(&c.messages));
	lines = strdup(strbuf_text(&c.moves));
	summarise(&reached, lines);
	ck_assert_str_eq(strbuf_text(&reached), programs[_i].moves);
	free(lines);
	strbuf_release(&reached);
	case_release(&c);
}
END_TEST

START_TEST(refused)
{
	sinumerik_refuses(&bad[_i]);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("programs");

	tcase_add_loop_test(tcase, moves, 0, COUNT(programs));
	tcase_add_loop_test(tcase, refused, 0, COUNT(bad));
	return run_suite("gcode_sinumerik_region", tcase);
}
