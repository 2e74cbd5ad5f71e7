/* test_gcode_sinumerik_comp.c - the sinumerik dialect: tool radius compensation, chamfers and roundings. */
#include "sinumerik_refused.h"

/* T1 D1 has a radius of 5. */
#define TOOL "F6 G500 T1 M6 D1 G17\nG0 X0 Y0 Z-100\n"

static const struct program {
	const char *text, *moves;
} programs[] = {
	/* "G40, G41, G42": NORM leads straight to the point beside the contour; G450 rounds outside corners. */
	{TOOL "G41 NORM G450 G1 X10 Y0\nY20\nX30\nG40 X30 Y0\n",
	 "tool 1\nrapid 0 0 0 0 0\nfeed 5 0 0 0 0\nfeed 5 20 0 0 0\n"
	 "arc 10 25 0 0 0 centre 10 20 0 normal 0 0 1 sweep -90\nfeed 30 25 0 0 0\nfeed 30 0 0 0 0\n"},
	/* An inside corner ends where the two paths cross. */
	{TOOL "G42 NORM G450 G1 X10 Y0\nY20\nX30\nG40 X30 Y0\n",
	 "tool 1\nrapid 0 0 0 0 0\nfeed 15 0 0 0 0\nfeed 15 15 0 0 0\nfeed 30 15 0 0 0\n"
	 "feed 30 0 0 0 0\n"},
	/* "G451": to the intersection of the paths; a block without a move in the plane may stand between. */
	{TOOL "G41 NORM G451 G1 X10 Y0\nY20\nM8\nX30\nG40 Y0\n",
	 "tool 1\nrapid 0 0 0 0 0\nfeed 5 0 0 0 0\nfeed 5 25 0 0 0\nfeed 30 25 0 0 0\n"
	 "feed 30 0 0 0 0\n"},
	/* A corner sharper than a right angle may also be rounded (MD20210): both paths are proved. */
	{TOOL "G41 NORM G451 G1 X10 Y0\nY20\nX20 Y10\nG40 Y0\n",
	 "tool 1\nrapid 0 0 0 0 0\nfeed 5 0 0 0 0\nfeed 5 20 0 0 0\n"
	 "feed 5 32.0710678 0 0 0 spread 8.06562965 8.06562965 0\n"
	 "feed 13.5355339 23.5355339 0 0 0 spread 8.06562965 8.06562965 0\n"
	 "feed 23.5355339 13.5355339 0 0 0\nfeed 20 0 0 0 0\n"},
	/* Neither NORM nor G450: every way to the contour and round its corners. */
	{TOOL "G41 G1 X10 Y0\nY20\nX30\nG40 Y0\n",
	 "tool 1\nrapid 0 0 0 0 0\nfeed 10 5 0 0 0 spread 7.07106781 7.07106781 0\n"
	 "feed 5 0 0 0 0 spread 7.07106781 7.07106781 0\nfeed 5 20 0 0 0\n"
	 "feed 5 25 0 0 0 spread 2.07106781 2.07106781 0\n"
	 "feed 10 25 0 0 0 spread 2.07106781 2.07106781 0\nfeed 30 25 0 0 0\n"
	 "feed 35 25 0 0 0 spread 5 5 0\nfeed 30 0 0 0 0 spread 5 5 0\n"},
	{TOOL "G41 KONT G450 DISC=50 G1 X10 Y0\nY20\nX30\nG40 Y0\n",
	 "tool 1\nrapid 0 0 0 0 0\nfeed 10 5 0 0 0 spread 7.07106781 7.07106781 0\n"
	 "feed 5 0 0 0 0 spread 7.07106781 7.07106781 0\nfeed 5 20 0 0 0\n"
	 "feed 5 25 0 0 0 spread 2.07106781 2.07106781 0\n"
	 "feed 10 25 0 0 0 spread 2.07106781 2.07106781 0\nfeed 30 25 0 0 0\n"
	 "feed 35 25 0 0 0 spread 5 5 0\nfeed 30 0 0 0 0 spread 5 5 0\n"},
	/* Arcs beside arcs, inside and outside. */
	{TOOL "G41 NORM G450 G1 X10 Y0\nY20\nG2 X30 Y40 I20 J0\nG3 X40 Y50 CR=10\nG40 G1 Y60\n",
	 "tool 1\nrapid 0 0 0 0 0\nfeed 5 0 0 0 0\nfeed 5 20 0 0 0\n"
	 "arc 30 45 0 0 0 centre 30 20 0 normal 0 0 1 sweep -90\n"
	 "arc 35 50 0 0 0 centre 30 50 0 normal 0 0 1 sweep 90\nfeed 40 60 0 0 0\n"},
	/* TRAORI holds the tool's tip beside the path, however the tool leans. */
	{"F6 G500 T1 M6 D1 G17\nTRAORI\nG0 X0 Y0 Z0 A30\nG41 NORM G450 G1 X10 Y0\nY20\nX30\nG40 X30 Y0\n", 
	 "tool 1\ntcp on length 100 zero A0 C0\nrapid 0 0 0 30 0 tcp\nfeed 5 0 0 30 0 tcp\nfeed 5 20 0 30 0 tcp\n"
	 "arc 10 25 0 30 0 centre 10 20 0 normal 0 0 1 sweep -90 tcp\nfeed 30 25 0 30 0 tcp\nfeed 30 0 0 30 0 tcp\n"},
	/* The edge's own radius: D2 has 4. */
	{"F6 G500 T1 M6 D2 G17\nG0 X0 Y0 Z-90\nG41 NORM G450\nG1 X10 Y0\nY20\nG40\nG0 X0 Y0\n",
	 "tool 1\nrapid 0 0 0 0 0\nfeed 6 0 0 0 0\nfeed 6 20 0 0 0\nfeed 10 20 0 0 0 spread 4 4 0\n"
	 "rapid 0 0 0 0 0 spread 4 4 0\n"},
	/* OFFN adds to the radius, until another one. */
	{"F6 G500 T1 M6 D2 G17 OFFN=1\nG0 X0 Y0 Z-90\nG41 NORM G450\nG1 X10 Y0\nY20\nG40 X0\nX0 Y0\n"
	 "G41 OFFN=0 X10 Y0\nY20\nG40 X0\n",
	 "tool 1\nrapid 0 0 0 0 0\nfeed 5 0 0 0 0\nfeed 5 20 0 0 0\nfeed 0 20 0 0 0\nfeed 0 0 0 0 0\n"
	 "feed 6 0 0 0 0\nfeed 6 20 0 0 0\nfeed 0 20 0 0 0\n"},
	/* A negative OFFN takes away from the radius of 5; with all of it the tool is on the path. */
	{TOOL "OFFN=-2\nG41 NORM G450 G1 X10 Y0\nY20\nX30\nG40 X30 Y0\n",
	 "tool 1\nrapid 0 0 0 0 0\nfeed 7 0 0 0 0\nfeed 7 20 0 0 0\n"
	 "arc 10 23 0 0 0 centre 10 20 0 normal 0 0 1 sweep -90\nfeed 30 23 0 0 0\nfeed 30 0 0 0 0\n"},
	{TOOL "OFFN=-5\nG41 NORM G450 G1 X10 Y0\nY20\nG2 X30 Y40 I20 J0\nG40 G1 X30 Y0\nG42 X10\nG40 X0\n",
	 "tool 1\nrapid 0 0 0 0 0\nfeed 10 0 0 0 0\nfeed 10 20 0 0 0\n"
	 "arc 30 40 0 0 0 centre 30 20 0 normal 0 0 1 sweep -90\nfeed 30 0 0 0 0\nfeed 10 0 0 0 0\nfeed 0 0 0 0 0\n"},
	/* Frames turn and mirror it; a mirror exchanges the sides. */
	{TOOL "ROT Z90\nG41 NORM G450 G1 X10 Y0\nY20\nX30\nG40 Y0\n",
	 "tool 1\nrapid 0 0 0 0 0\nfeed 0 5 0 0 0\nfeed -20 5 0 0 0\n"
	 "arc -25 10 0 0 0 centre -20 10 0 normal 0 0 1 sweep -90\nfeed -25 30 0 0 0\n"
	 "feed 0 30 0 0 0\n"},
	{TOOL "MIRROR X0\nG41 NORM G450 G1 X10 Y0\nY20\nX30\nG40 Y0\n",
	 "tool 1\nrapid 0 0 0 0 0\nfeed -5 0 0 0 0\nfeed -5 20 0 0 0\n"
	 "arc -10 25 0 0 0 centre -10 20 0 normal 0 0 -1 sweep -90\nfeed -30 25 0 0 0\n"
	 "feed -30 0 0 0 0\n"},
	/* After CYCLE800 in the swivelled plane. */
	{"F6 G500 T1 M6 D1 G17\nCYCLE800(0,\"\",0,57,0,0,0,30,0,0,0,0,0,-1)\nG0 X0 Y0 Z0\n"
	 "G41 NORM G450 G1 X10 Y0\nY20\nX30\nG40 Y0\n",
	 "tool 1\norient 0 -0.5 0.866025404\nrapid 0 0 0 -30 0\ntcp on length 100 zero A0 C0\n"
	 "rapid 0 0 0 -30 0 tcp\nfeed 5 0 0 -30 0 tcp\nfeed 5 17.3205081 10 -30 0 tcp\n"
	 "arc 10 21.6506351 12.5 -30 0 centre 10 17.3205081 10 normal 0 -0.5 0.866025 sweep -90 tcp\n"
	 "feed 30 21.6506351 12.5 -30 0 tcp\nfeed 30 0 0 -30 0 tcp\n"},
	/* "Chamfer, rounding": CHF is the length of the chamfer, CHR what it takes off both blocks. */
	{"F6 G500\nX10 CHF=2\nY10\nX0 CHR=2\nY0\n",
	 "feed 8.58578644 0 0 0 0\nfeed 10 1.41421356 0 0 0\nfeed 10 10 0 0 0\nfeed 2 10 0 0 0\n"
	 "feed 0 8 0 0 0\nfeed 0 0 0 0 0\n"},
	{"F6 G500\nX10 RND=2\nY10 RND=0\nX0\n",
	 "feed 8 0 0 0 0\narc 10 2 0 0 0 centre 8 2 0 normal 0 0 1 sweep 90\nfeed 10 10 0 0 0\n"
	 "feed 0 10 0 0 0\n"},
	{"F6 G500 TRANS X100\nAMIRROR X0\nX10 RND=2\n; a comment between\nG2 X20 Y10 I10 J0 RND=1\nG1 Y30\n",
	 "feed 87.7459667 0 0 0 0\n"
	 "arc 89.6824584 2.5 0 0 0 centre 87.7459667 2 0 normal 0 0 -1 sweep -104.477512\n"
	 "arc 80.9090909 9.95859195 0 0 0 centre 80 0 0 normal 0 0 -1 sweep -70.3065792\n"
	 "arc 80 10.9544512 0 0 0 centre 81 10.9544512 0 normal 0 0 -1 sweep 84.7840914\n"
	 "feed 80 30 0 0 0\n"},
	{TOOL "G41 NORM G450 G1 X10 Y0\nY20 RND=8\nX-10 CHR=8\nY0\nG40 X-30\n",
	 "tool 1\nrapid 0 0 0 0 0\nfeed 5 0 0 0 0\nfeed 5 12 0 0 0\n"
	 "arc 2 15 0 0 0 centre 2 12 0 normal 0 0 1 sweep 90\nfeed 0.0710678119 15 0 0 0\n"
	 "feed -5 9.92893219 0 0 0\nfeed -5 0 0 0 0\nfeed -30 0 0 0 0\n"},
};

static const struct refused_words bad[] = {
	{TOOL "G41 X10\nG42 X20\n", "the other side of the path while tool radius compensation is on; G40 first"},
	{TOOL "G41 X10\nTRANS X1\n", "a change of the frame while tool radius compensation is on; G40 first"},
	{TOOL "G41 X10\nG54\n", "a change of the work offset while tool radius compensation is on; G40 first"},
	{TOOL "G41 X10\nG18\n", "a change of the plane while tool radius compensation is on; G40 first"},
	{TOOL "G41 X10\nSUPA G0 Z0\n",
	 "a move in the machine's coordinates while tool radius compensation is on; G40 first"},
	{TOOL "G41 X10\nG75 X1=0\n",
	 "a move in the machine's coordinates while tool radius compensation is on; G40 first"},
	{TOOL "G41 X10\nTRAORI\n", "TRAORI or TRAFOOF while tool radius compensation is on; G40 first"},
	{TOOL "G41 X10\nD2\n", "another D while tool radius compensation is on; G40 first"},
	{TOOL "G41 X10\nT2 M6\n", "a tool change while tool radius compensation is on; G40 first"},
	{TOOL "G41 X10\nSTOPRE\n",
	 "STOPRE, which ends the control's look ahead, while tool radius compensation is on; G40 first"},
	{TOOL "G41 X10\nMCALL CYCLE81(10,0,1,-5)\n",
	 "a modal call while tool radius compensation is on; G40 first"},
	{TOOL "G41 X10\nCYCLE81(10,0,1,-5)\n", "CYCLE81 while tool radius compensation is on; G40 first"},
	{TOOL "G41 X10\nG451\n", "another way round corners while tool radius compensation is on; G40 first"},
	{TOOL "DISC=101\n", "DISC lies between 0 and 100"},
	{TOOL "G41 X10\nY10\nM0\n",
	 "the program stops under cutter compensation: controls differ in where the tool waits; write G40 first"},
	{TOOL "G41 G1 X10\nM30\n",
	 "the program stops under cutter compensation: controls differ in where the tool waits; write G40 first"},
	{TOOL "G41 G2 X10 CR=20\n", "cutter compensation must start and end with G0 or G1, not with an arc"},
	{TOOL "G41 G1 X10\nY10\nCIP X20 I1=15 J1=15 K1=-100\n",
	 "CIP under tool radius compensation is not supported"},
	{TOOL "G41 G1 X10\nY10\nG40 G2 X20 CR=20\n",
	 "tool radius compensation ends in a straight line (G0, G1), not in a circle"},
	{TOOL "G41 G451 NORM G1 X10\nY10\nX11 Y0\n",
	 "the path turns by 174.3 degrees at an outside corner, and a parameter of the control decides whether the "
	 "corner is extended or rounded: write G450 with DISC=0 to round it; if no G450 or G451 comes before, you can "
	 "also set cutter_comp_corner=\"circular\" in the machine file's <controller>"},
	{TOOL "OFFN=IC(3)\n", "OFFN takes a plain value, not IC()"},
	{"F6 G500 T1 M6 D0 OFFN=2\nG41 G1 X10\n",
	 "OFFN while no edge of a tool is in force (T0 or D0): whether the control keeps the tool away from the contour by "
	 "OFFN alone is not known; write D1, or OFFN=0"},
	{"F6 G500 D1 OFFN=2\nG42 G1 X10\n",
	 "OFFN while no edge of a tool is in force (T0 or D0): whether the control keeps the tool away from the contour by "
	 "OFFN alone is not known; write D1, or OFFN=0"},
	/* G41 is in force with a radius of 0, and each of these would change the radius. */
	{"F6 G500 T1 M6 D0 G17\nG0 X0 Y0 Z0\nG41 G1 X10 Y0\nY20\nD1\n",
	 "another D while tool radius compensation is on; G40 first"},
	{"F6 G500 T1 M6 D0 G17\nG0 X0 Y0 Z0\nG42 G1 X10 Y0\nD1 Y20\n",
	 "another D while tool radius compensation is on; G40 first"},
	{"F6 G500 T1 M6 D0 G17\nG0 X0 Y0 Z0\nG41 G1 X10 Y0\nT2 M6\n",
	 "a tool change while tool radius compensation is on; G40 first"},
	{"F6 G500 T1 M6 D0 G17\nG0 X0 Y0 Z0\nG41 G1 X10 Y0\nOFFN=2\n",
	 "another OFFN while tool radius compensation is on; G40 first"},
	{TOOL "OFFN=-5 G41 G1 X10 Y0\nOFFN=-4 Y20\n",
	 "another OFFN while tool radius compensation is on; G40 first"},
	{TOOL "OFFN=-5.01 G41 G1 X10 Y0\n", "OFFN is less than minus the tool's radius, which is not supported"},
	{TOOL "SCALE X2 Y2 Z2\nG41 G1 X10\n",
	 "tool radius compensation while SCALE is in force is not supported"},
	{TOOL "ROT X30\nG41 G1 X10\n",
	 "tool radius compensation in a plane that a frame tilts: CUT2D, which is in force, corrects in the plane of the "
	 "machine's axes; CUT2DF corrects in the tilted one"},
	{"G500 TRAORI\nT1 M6 D1\nNORM G41 G1 F6 X10\nX20 A10\n",
	 "TRAORI turns the tool while tool radius compensation is on, which is not supported: turn it before G41 or G42"},
	{"G500 TRAORI\nT1 M6 D1\nNORM G41 G1 F6 X10 A3=0 B3=1 C3=1\n",
	 "TRAORI turns the tool while tool radius compensation is on, which is not supported: turn it before G41 or G42"},
	{"G500 TRAORI\nT1 M6 D1\nAROT X10\nNORM G41 G1 F6 X10\n",
	 "tool radius compensation in a plane that a frame tilts: CUT2D, which is in force, corrects in the plane of the "
	 "machine's axes; CUT2DF corrects in the tilted one"},
	{"F6 G500\nX10 RND=2 CHF=1\n", "a block can have only one of CHF, CHR and RND"},
	{"F6 G500\nX10 RND=-2\n", "a chamfer or rounding cannot be negative"},
	{"F6 G500\nG0 X10 RND=2\n", "CHF, CHR and RND need a block with G1, G2 or G3"},
	{"F6 G500\nX10 RND=2\nM8\n",
	 "the block after a chamfer or rounding (CHF, CHR or RND) must be a move with G1, G2 or G3 in the plane"},
	{"F6 G500\nX10 RND=2\nY1\nX5\n",
	 "the chamfer or rounding (CHF, CHR or RND) of line 2 is longer than one of its blocks"},
	{"F6 G500\nX10 RND=2\nX20\n",
	 "the path has no corner at the chamfer or rounding (CHF, CHR or RND) of line 2"},
	{"F6 G500\nX10 Z5 RND=2\nY20\n",
	 "the blocks before and after a chamfer or rounding (CHF, CHR or RND) must be moves with G1, G2 or G3 in the "
	 "plane only"},
	{"F6 G500 SCALE X2\nX10 RND=2\nY20\n", "a rounding or chamfer where the frame scales its axes differently"},
	{"F6 G500\nX10 CHF=2\nG2 Y10 CR=20\n",
	 "a chamfer (CHF, CHR or RND) beside an arc is not supported"},
};

START_TEST(moves)
{
	struct gcode_case c;

	sinumerik_case_init(&c);
	c.show_spread = true;
	ck_assert_msg(case_run(&c, programs[_i].text), "%s%s", programs[_i].text, strbuf_text(&c.messages));
	ck_assert_str_eq(strbuf_text(&c.moves), programs[_i].moves);
	case_release(&c);
}
END_TEST

/* Before any G450 or G451 the machine file says how outside corners are led round; the program's word comes first. */
START_TEST(corners_of_the_machine)
{
	static const struct {
		enum comp_corner_form form;
		const char *words, *corner;
	} cases[] = {
		{COMP_CORNER_CIRCULAR, "", "arc 10 25 0 0 0 centre 10 20 0 normal 0 0 1 sweep -90\n"},
		{COMP_CORNER_LINEAR, "", "feed 5 25 0 0 0\n"},
		{COMP_CORNER_CIRCULAR, "G451 ", "feed 5 25 0 0 0\n"},
		{COMP_CORNER_LINEAR, "G450 ", "arc 10 25 0 0 0 centre 10 20 0 normal 0 0 1 sweep -90\n"},
		{COMP_CORNER_CIRCULAR, "DISC=50 ",
		 "feed 5 25 0 0 0 spread 2.07106781 2.07106781 0\nfeed 10 25 0 0 0 spread 2.07106781 2.07106781 0\n"},
	};

	for (size_t i = 0; i < COUNT(cases); i++) {
		struct strbuf program = {0};
		struct gcode_case c;

		sinumerik_case_init(&c);
		c.show_spread = true;
		c.config.controller.comp_corner = cases[i].form;
		strbuf_addf(&program, TOOL "G41 NORM %sG1 X10 Y0\nY20\nX30\nG40 X30 Y0\n", cases[i].words);
		ck_assert_msg(case_run(&c, strbuf_text(&program)), "%s", strbuf_text(&c.messages));
		ck_assert_msg(strstr(strbuf_text(&c.moves), cases[i].corner), "%zu: %s", i, strbuf_text(&c.moves));
		strbuf_release(&program);
		case_release(&c);
	}
}
END_TEST

/* And whether NORM holds before any NORM or KONT. */
START_TEST(start_of_the_machine)
{
	static const struct {
		enum comp_start type;
		const char *words, *start;
	} cases[] = {
		{COMP_START_A, "", "feed 5 0 0 0 0\nfeed 5 20 0 0 0\n"},
		{COMP_START_A, "KONT ", "feed 10 5 0 0 0 spread 7.07106781 7.07106781 0\n"},
		{COMP_START_B, "", "feed 10 5 0 0 0 spread 7.07106781 7.07106781 0\n"},
		{COMP_START_B, "NORM ", "feed 5 0 0 0 0\nfeed 5 20 0 0 0\n"},
	};

	for (size_t i = 0; i < COUNT(cases); i++) {
		struct strbuf program = {0};
		struct gcode_case c;

		sinumerik_case_init(&c);
		c.show_spread = true;
		c.config.controller.comp_start = cases[i].type;
		strbuf_addf(&program, TOOL "G41 %sG450 G1 X10 Y0\nY20\nX30\nG40 X30 Y0\n", cases[i].words);
		ck_assert_msg(case_run(&c, strbuf_text(&program)), "%s", strbuf_text(&c.messages));
		ck_assert_msg(strstr(strbuf_text(&c.moves), cases[i].start), "%zu: %s", i, strbuf_text(&c.moves));
		strbuf_release(&program);
		case_release(&c);
	}
}
END_TEST

/* Where an arc goes on in a line, rounding may make a corner of it by 1e-16: that is no whole turn about the corner. */
START_TEST(tangents_in_frames)
{
	for (int degrees = 1; degrees <= 40; degrees++) {
		struct strbuf program = {0};
		struct gcode_case c;

		sinumerik_case_init(&c);
		strbuf_addf(&program,
			    TOOL "TRANS X5 Y6 Z7\nAROT X%d\nAROT Y5\nG0 X-20 Y-15 Z20\nCUT2DF NORM G450\n"
				 "G1 G41 X0 Y0\nX60\nG3 X80 Y20 CR=20\nG1 Y50\nG40 X0\n", degrees);
		ck_assert_msg(case_run(&c, strbuf_text(&program)), "%s", strbuf_text(&c.messages));
		ck_assert_msg(!strstr(strbuf_text(&c.moves), "sweep -360"), "%d: %s", degrees, strbuf_text(&c.moves));
		strbuf_release(&program);
		case_release(&c);
	}
}
END_TEST

/* MD20250: a contour of straight lines and an inside corner continues after blocks without a move in the plane. */
START_TEST(idle_blocks)
{
	static const char program[] = TOOL "G450 NORM G41 G1 X0 Y20\nF5\nZ-101\nM8\nY40\nZ-102\nF6\nZ-103\nX-20\nG40 X-40\n";
	static const char wanted[] = "tool 1\nrapid 0 0 0 0 0\nfeed -5 20 0 0 0\n"
				     "feed -5 20 -1 0 0\nfeed -5 35 -1 0 0\nfeed -5 35 -2 0 0\n"
				     "feed -5 35 -3 0 0\nfeed -20 35 -3 0 0\nfeed -40 40 -3 0 0\n";
	struct gcode_case c;

	sinumerik_case_init(&c);
	case_refuses(&c,
		     "p.nc:7:1: error: 3 blocks without a move in the plane of cutter compensation before this block, "
		     "and a parameter of the control (MD20250) decides how many it looks past: set "
		     "cutter_comp_idle_blocks=\"\" in the machine file's <controller>\n", "%s", program);
	sinumerik_case_init(&c);
	c.config.controller.comp_idle_blocks = 2;
	case_refuses(&c, "write at most 2 such blocks in a row", "%s", program);
	sinumerik_case_init(&c);
	c.config.controller.comp_idle_blocks = 3;
	ck_assert_msg(case_run(&c, program), "%s", strbuf_text(&c.messages));
	ck_assert_str_eq(strbuf_text(&c.moves), wanted);
	case_release(&c);
}
END_TEST

START_TEST(refused)
{
	sinumerik_refuses_words(&bad[_i]);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("programs");

	tcase_add_loop_test(tcase, moves, 0, COUNT(programs));
	tcase_add_test(tcase, corners_of_the_machine);
	tcase_add_test(tcase, start_of_the_machine);
	tcase_add_test(tcase, tangents_in_frames);
	tcase_add_test(tcase, idle_blocks);
	tcase_add_loop_test(tcase, refused, 0, COUNT(bad));
	return run_suite("gcode_sinumerik_comp", tcase);
}
