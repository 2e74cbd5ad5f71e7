/* test_gcode_sinumerik_soft.c - the sinumerik dialect: soft approach to a contour and retraction from it. */
#include "sinumerik_refused.h"

/* T1 D1 has a radius of 5. */
#define TOOL "F6 G500 T1 M6 D1 G17 G90\n"

/*
 * The figures were computed independently: the end of the contour is moved aside by the tool's radius first, and the
 * circle of DISR or the line is drawn there.
 */
static const struct program {
	const char *text, *moves;
} programs[] = {
	/* A quadrant on the left, down to the contour first; the corner behind it is an inside one. */
	{TOOL "G0 X0 Y0 Z-70\nG1 G41 NORM G450 G341 G247 DISR=13 DISCL=3 FAD=4 X40 Y-10 Z-100\nX60\nY10\nG40 X0 Y0\n",
	 "tool 1\nrapid 0 0 30 0 0\nrapid 27 8 30 0 0\nrapid 27 8 3 0 0\nfeed 27 8 0 0 0\n"
	 "arc 40 -5 0 0 0 centre 40 8 0 normal 0 0 1 sweep 90\nfeed 55 -5 0 0 0\nfeed 55 10 0 0 0\nfeed 0 0 0 0 0\n"},
	/* Without F and FAD the way down has the speed of the block before it. */
	{TOOL "G0 X0 Y0 Z-70\nG1 G41 NORM G450 G341 G247 DISR=13 DISCL=3 X40 Y-10 Z-100\nX60\nG40 X0 Y0\n",
	 "tool 1\nrapid 0 0 30 0 0\nrapid 27 8 30 0 0\nrapid 27 8 3 0 0\nrapid 27 8 0 0 0\n"
	 "arc 40 -5 0 0 0 centre 40 8 0 normal 0 0 1 sweep 90\nfeed 60 -5 0 0 0\nfeed 0 0 0 0 0\n"},
	/* G340: a helix on a semicircle, on the right with G42; OFFN adds to the radius of the tool. */
	{TOOL "OFFN=2\nG0 X0 Y0 Z-70\nG42 NORM G450 G340 G347 DISR=6 DISCL=AC(-96) X40 Y-10 Z-100 F6\nG1 X60\nY-30\n"
	 "G40 X0 Y0\n",
	 "tool 1\nrapid 0 0 30 0 0\nrapid 40 -29 30 0 0\nrapid 40 -29 4 0 0\n"
	 "arc 40 -17 0 0 0 centre 40 -23 4 normal 0 0 1 sweep -180\nfeed 53 -17 0 0 0\nfeed 53 -30 0 0 0\n"
	 "feed 0 0 0 0 0\n"},
	/* G147: a line that is longer by the radius of the tool; the next block gives the end of it. */
	{TOOL "G0 X0 Y0 Z-70\nG41 NORM G450 G341 G147 DISR=13 DISCL=3 FAD=4 Z=-100\nG1 X40 Y-10\nX60\nG40 X0 Y0\n",
	 "tool 1\nrapid 0 0 30 0 0\nrapid 22 -5 30 0 0\nrapid 22 -5 3 0 0\nfeed 22 -5 0 0 0\nfeed 40 -5 0 0 0\n"
	 "feed 60 -5 0 0 0\nfeed 0 0 0 0 0\n"},
	/* The next block gives the height, too. */
	{TOOL "G0 X0 Y0 Z-70\nG41 NORM G450 G340 G147 DISR=13 DISCL=3\nG1 X40 Y-10 Z-100\nX60\nG40 X0 Y0\n",
	 "tool 1\nrapid 0 0 30 0 0\nrapid 22 -5 30 0 0\nrapid 22 -5 3 0 0\nfeed 40 -5 0 0 0\nfeed 60 -5 0 0 0\n"
	 "feed 0 0 0 0 0\n"},
	/* G142: on the right of the contour, where the tool is not: its centre still goes on a circle of DISR. */
	{TOOL "G0 X0 Y0 Z-70\nG41 NORM G450 G142 G340 G247 DISR=12 X40 Y-10 Z-100 F6\nG1 X60\nG40 X0 Y0\n",
	 "tool 1\nrapid 0 0 30 0 0\nrapid 28 -17 30 0 0\nrapid 28 -17 0 0 0\n"
	 "arc 40 -5 0 0 0 centre 40 -17 0 normal 0 0 1 sweep -90\nfeed 60 -5 0 0 0\nfeed 0 0 0 0 0\n"},
	/* Without compensation: G140 is the side of the start; DISRP is the height of P1. */
	{TOOL "G0 X0 Y0 Z-70\nG340 G247 DISR=8 DISCL=3 DISRP=20 X40 Y-10 Z-100 F6\nG1 X60\n"
	 "G248 G142 DISR=8 DISCL=3 X50 Y0 Z-70\n",
	 "tool 1\nrapid 0 0 30 0 0\nrapid 32 -2 20 0 0\nrapid 32 -2 3 0 0\n"
	 "arc 40 -10 0 0 0 centre 40 -2 3 normal 0 0 1 sweep 90\nfeed 60 -10 0 0 0\n"
	 "arc 68 -18 3 0 0 centre 60 -18 0 normal 0 0 1 sweep -90\nfeed 68 -18 30 0 0\nfeed 50 0 30 0 0\n"},
	/* Behind the approach a circle; the retraction is a semicircle from the end of a circle. */
	{TOOL "G0 X0 Y0 Z-70\nG41 NORM G450 G341 G247 DISR=13 DISCL=2 X40 Y-10 Z-100 F6\nG2 X60 Y-30 I0 J-20\n"
	 "G40 G348 DISR=4 DISCL=2 X0 Y0 Z-70\n",
	 "tool 1\nrapid 0 0 30 0 0\nrapid 27 8 30 0 0\nrapid 27 8 2 0 0\nfeed 27 8 0 0 0\n"
	 "arc 40 -5 0 0 0 centre 40 8 0 normal 0 0 1 sweep 90\n"
	 "arc 65 -30 0 0 0 centre 40 -30 0 normal 0 0 1 sweep -90\n"
	 "arc 73 -30 0 0 0 centre 69 -30 0 normal 0 0 1 sweep 180\nfeed 73 -30 2 0 0\nfeed 73 -30 30 0 0\n"
	 "feed 0 0 30 0 0\n"},
	/* A retraction without coordinates ends above the contour; with Z alone it ends at Z. */
	{TOOL "G0 X0 Y0 Z-70\nG247 G141 G340 DISR=8 X40 Y-10 Z-100 F6\nG1 X60\nG248 DISR=8 DISCL=3\nG1 X0 Y0 Z-100\n"
	 "X60 Y0\nG348 DISR=8 DISCL=3 Z-80\nG0 X0\n",
	 "tool 1\nrapid 0 0 30 0 0\nrapid 32 -2 30 0 0\nrapid 32 -2 0 0 0\n"
	 "arc 40 -10 0 0 0 centre 40 -2 0 normal 0 0 1 sweep 90\nfeed 60 -10 0 0 0\n"
	 "arc 68 -2 3 0 0 centre 60 -2 0 normal 0 0 1 sweep 90\nfeed 0 0 0 0 0\nfeed 60 0 0 0 0\n"
	 "arc 60 16 3 0 0 centre 60 8 0 normal 0 0 1 sweep 180\nfeed 60 16 20 0 0\nrapid 0 16 20 0 0\n"},
	/* Compensation that goes on behind the retraction. */
	{TOOL "G0 X0 Y0 Z-70\nG41 NORM G450 G340 G247 DISR=10 X40 Y-10 Z-100 F6\nG1 X60\nG248 DISR=10 Z-80\n"
	 "G40 G1 X90 Y40\n",
	 "tool 1\nrapid 0 0 30 0 0\nrapid 30 5 30 0 0\nrapid 30 5 0 0 0\n"
	 "arc 40 -5 0 0 0 centre 40 5 0 normal 0 0 1 sweep 90\nfeed 60 -5 0 0 0\n"
	 "arc 70 5 0 0 0 centre 60 5 0 normal 0 0 1 sweep 90\nfeed 70 5 20 0 0\nfeed 90 40 20 0 0\n"},
	/* Frames turn it. */
	{TOOL "ROT Z90\nG0 X0 Y0 Z-70\nG41 NORM G450 G341 G247 DISR=13 DISCL=3 X40 Y-10 Z-100 F6\nG1 X60\n"
	 "G40 G248 DISR=13 DISCL=3 X0 Y0 Z-70\n",
	 "tool 1\nrapid 0 0 30 0 0\nrapid -8 27 30 0 0\nrapid -8 27 3 0 0\nfeed -8 27 0 0 0\n"
	 "arc 5 40 0 0 0 centre -8 40 0 normal 0 0 1 sweep 90\nfeed 5 60 0 0 0\n"
	 "arc -8 73 0 0 0 centre -8 60 0 normal 0 0 1 sweep 90\nfeed -8 73 3 0 0\nfeed -8 73 30 0 0\n"
	 "feed 0 0 30 0 0\n"},
	/* A mirror exchanges the sides. */
	{TOOL "MIRROR X0\nG0 X0 Y0 Z-70\nG41 NORM G450 G341 G247 DISR=13 DISCL=3 X40 Y-10 Z-100 F6\nG1 X60\n"
	 "G40 G348 DISR=13 DISCL=3 X0 Y0 Z-70\n",
	 "tool 1\nrapid 0 0 30 0 0\nrapid -27 8 30 0 0\nrapid -27 8 3 0 0\nfeed -27 8 0 0 0\n"
	 "arc -40 -5 0 0 0 centre -40 8 0 normal 0 0 -1 sweep 90\nfeed -60 -5 0 0 0\n"
	 "arc -60 21 0 0 0 centre -60 8 0 normal 0 0 -1 sweep 180\nfeed -60 21 3 0 0\nfeed -60 21 30 0 0\n"
	 "feed 0 0 30 0 0\n"},
	/* In inches, behind a shift that DISCL=AC() counts, too. */
	{"F6 G500 T1 M6 D1 G17 G90 G700\nTRANS X1 Z=-100/25.4\nG0 X0 Y0 Z1\n"
	 "G41 NORM G450 G341 G347 DISR=.5 DISCL=AC(.1) X2 Y-.5 Z0 F6\nG1 X3\nG40 X0 Y0\n",
	 "tool 1\nrapid 25.4 0 25.4 0 0\nrapid 76.2 17.7 25.4 0 0\nrapid 76.2 17.7 2.54 0 0\nfeed 76.2 17.7 0 0 0\n"
	 "arc 76.2 -7.7 0 0 0 centre 76.2 5 0 normal 0 0 1 sweep 180\nfeed 101.6 -7.7 0 0 0\nfeed 25.4 0 0 0 0\n"},
	/* Increments count from the programmed points. */
	{TOOL "G0 X0 Y0 Z-70\nG91 G41 NORM G450 G341 G247 DISR=13 DISCL=3 X40 Y-10 Z-30 F6\nG1 X20\n"
	 "G40 G248 DISR=13 DISCL=3 X-60 Y10 Z30\n",
	 "tool 1\nrapid 0 0 30 0 0\nrapid 27 8 30 0 0\nrapid 27 8 3 0 0\nfeed 27 8 0 0 0\n"
	 "arc 40 -5 0 0 0 centre 40 8 0 normal 0 0 1 sweep 90\nfeed 60 -5 0 0 0\n"
	 "arc 73 8 0 0 0 centre 60 8 0 normal 0 0 1 sweep 90\nfeed 73 8 3 0 0\nfeed 73 8 30 0 0\nfeed 0 0 30 0 0\n"},
	/* TRAORI guides the tool that leans. */
	{TOOL "TRAORI\nG0 X0 Y0 Z30 A30\nG41 NORM G450 G341 G247 DISR=13 DISCL=3 X40 Y-10 Z0 F6\nG1 X60\nG40 X0 Y0\n",
	 "tool 1\ntcp on length 100 zero A0 C0\nrapid 0 0 30 30 0 tcp\nrapid 27 8 30 30 0 tcp\n"
	 "rapid 27 8 3 30 0 tcp\nfeed 27 8 0 30 0 tcp\narc 40 -5 0 30 0 centre 40 8 0 normal 0 0 1 sweep 90 tcp\n"
	 "feed 60 -5 0 30 0 tcp\nfeed 0 0 0 30 0 tcp\n"},
	/* In G18 the third axis is Y. */
	{"F6 G500 G18 G90\nG0 X0 Y30 Z0\nG341 G141 G247 DISR=13 DISCL=3 Z40 X-10 Y0 F6\nG1 Z60\nG0 Y50\n",
	 "rapid 0 30 0 0 0\nrapid 3 30 27 0 0\nrapid 3 3 27 0 0\nfeed 3 0 27 0 0\n"
	 "arc -10 0 40 0 0 centre 3 0 40 normal 0 1 0 sweep 90\nfeed -10 0 60 0 0\nrapid -10 50 60 0 0\n"},
	/* In the plane of CYCLE800. */
	{TOOL "CYCLE800(0,\"\",0,57,0,0,0,30,0,0,0,0,0,-1)\nG0 X0 Y0 Z30\n"
	 "G41 NORM G450 G341 G247 DISR=13 DISCL=3 X40 Y-10 Z0 F6\nG1 X60\nG40 X0 Y0\n",
	 "tool 1\norient 0 -0.5 0.866025404\nrapid 0 0 0 -30 0\ntcp on length 100 zero A0 C0\n"
	 "rapid 0 -15 25.9807621 -30 0 tcp\nrapid 27 -8.07179677 29.9807621 -30 0 tcp\n"
	 "rapid 27 5.42820323 6.59807621 -30 0 tcp\nfeed 27 6.92820323 4 -30 0 tcp\n"
	 "arc 40 -4.33012702 -2.5 -30 0 centre 40 6.92820323 4 normal 0 -0.5 0.866025 sweep 90 tcp\n"
	 "feed 60 -4.33012702 -2.5 -30 0 tcp\nfeed 0 0 0 -30 0 tcp\n"},
};

START_TEST(goes_to_and_from_contours)
{
	struct gcode_case c;

	sinumerik_case_init(&c);
	case_expect(&c, programs[_i].text, programs[_i].moves);
	case_release(&c);
}
END_TEST

/* FAD is the speed of the way down, F that of the rest; on retraction the old speed holds up to P2. */
START_TEST(has_the_speeds)
{
	struct gcode_case c;

	sinumerik_case_init(&c);
	c.show_feed = true;
	case_expect(&c,
		    "G17 G90 G500 F600\nG1 X0 Y0 Z30\nG141 G341 G247 DISR=10 DISCL=3 FAD=60 X40 Y0 Z0 F300\nX60\n"
		    "G340 G248 DISR=10 DISCL=3 X0 Y0 Z30 F1200\n",
		    "feed 0 0 30 0 0 at 10 10\nfeed 30 10 30 0 0 at 10 10\nfeed 30 10 3 0 0 at 10 10\n"
		    "feed 30 10 0 0 0 at 1 1\narc 40 0 0 0 0 centre 40 10 0 normal 0 0 1 sweep 90 at 5 5\n"
		    "feed 60 0 0 0 0 at 5 5\narc 70 10 3 0 0 centre 60 10 0 normal 0 0 1 sweep 90 at 5 5\n"
		    "feed 70 10 30 0 0 at 20 20\nfeed 0 0 30 0 0 at 20 20\n");
	case_release(&c);
}
END_TEST

/* Each block ends behind its own moves; if the next block gives the end, the path to the contour belongs to it. */
START_TEST(keeps_the_order_of_blocks)
{
	struct gcode_case c;

	sinumerik_case_init(&c);
	ck_assert(case_run(&c, TOOL "G0 X0 Y0 Z-70\nG41 NORM G450 G341 G147 DISR=13 DISCL=3 FAD=4 Z=-100\n; note\n"
				    "G1 X40 Y-10\nX60\nG40 G148 DISR=5 X0 Y0\n"));
	ck_assert_str_eq(strbuf_text(&c.blocks),
			 "1:1:F6 G500 T1 M6 D1 G17 G90\n2:1:G0 X0 Y0 Z-70\n"
			 "3:3:G41 NORM G450 G341 G147 DISR=13 DISCL=3 FAD=4 Z=-100\n5:1:G1 X40 Y-10\n6:1:X60\n"
			 "7:2:G40 G148 DISR=5 X0 Y0\n");
	case_release(&c);
}
END_TEST

/* MD20150 may say G341 before the program gives either code, which matters if DISCL is above the contour. */
START_TEST(cautions_about_the_way_down)
{
	struct gcode_case c;

	sinumerik_case_init(&c);
	case_run(&c, TOOL "G0 X0 Y0 Z30\nG141 G247 DISR=10 DISCL=3 X40 Y0 Z0 F6\nG1 X60\nG248 DISR=4 DISCL=3\n");
	ck_assert_ptr_nonnull(strstr(strbuf_text(&c.messages), "p.nc:3:6: warning: before any G340 or G341, MD20150 says"));
	ck_assert_ptr_null(strstr(strbuf_text(&c.messages), "p.nc:5"));
	case_release(&c);
	sinumerik_case_init(&c);
	case_run(&c, TOOL "G0 X0 Y0 Z30\nG141 G247 DISR=10 X40 Y0 Z0 F6\nG1 X60\n");
	ck_assert_str_eq(strbuf_text(&c.messages), "");
	case_release(&c);
}
END_TEST

#define AWAY TOOL "G0 X0 Y0 Z30\n"
#define ON AWAY "G41 NORM G450 G340 G247 DISR=10 X40 Y-10 Z0 F6\nG1 X60\n"

static const struct refused_program bads[] = {
	{"X10 DISR=5\n", 1, 5, "this word belongs to a soft approach or retraction"},
	{AWAY "G41 G247 X40 Y0 Z0 F6\n", 3, 5, "G247 needs DISR, the length of its line or the radius of its circle"},
	{AWAY "G41 G247 DISR=0 X40 Y0 Z0 F6\nG1 X60\n", 3, 5, "G247 needs DISR that is more than 0"},
	{AWAY "G41 G142 G247 DISR=4 X40 Y0 Z0 F6\nG1 X60\n", 3, 10,
	 "DISR of G247, on the side of the contour where the tool is not, must be more than the tool's radius, 5 mm"},
	{AWAY "G41 G147 DISR=-6 X40 Y0 Z0 F6\nG1 X60\n", 3, 5, "G147 needs DISR that is more than 0, or with tool radius"},
	{AWAY "OFFN=1 G41 G147 DISR=6 X40 Y0 Z0 F6\nG1 X60\n", 3, 12, "G147 with OFFN is not supported"},
	{AWAY "G247 DISR=6 X40 Y0 Z0 F6\nG1 X60\n", 3, 1, "G247 with G143, or with G140 and G40, from a point on the tangent"},
	{AWAY "G41 G247 DISR=6 X40 Y0 Z0\nG1 X60\n", 3, 5, "G247 without F while G0 is in force"},
	{AWAY "G41 G247 DISR=6 X40 Z0 F6\nG1 X60\n", 3, 5, "G247 with one coordinate of the plane"},
	{AWAY "G41 G247 DISR=6 DISCL=31 X40 Y0 Z0 F6\nG1 X60\n", 3, 5,
	 "the heights of G247 are not in order: the contour at 100 mm, P2 (DISCL) at 131 mm and P1 (DISRP, or the other end) "
	 "at 130 mm"},
	{AWAY "G41 G247 DISR=6 DISCL=-1 X40 Y0 Z0 F6\nG1 X60\n", 3, 5, "the heights of G247 are not in order"},
	{AWAY "G41 G247 DISR=6 DISCL=IC(1) X40 Y0 Z0 F6\nG1 X60\n", 3, 17, "only a distance or AC() may stand here"},
	{AWAY "G41 G247 DISR=6 X40 Y0 Z0 F6 FAD=0\nG1 X60\n", 3, 30, "FAD must be more than 0"},
	{AWAY "G41 G247 DISR=6 X40 Y0 Z0 A5 F6\nG1 X60\n", 3, 5, "G247 has coordinates of X, Y and Z alone"},
	{AWAY "SUPA G247 DISR=6 X40 Y0 Z0 F6\n", 3, 6, "G247 has coordinates of X, Y and Z alone"},
	{AWAY "SCALE X2 Y2 Z2\nG141 G247 DISR=6 X40 Y0 Z0 F6\n", 4, 6, "G247 while SCALE is in force is not supported"},
	{AWAY "G93\nG141 G247 DISR=6 X40 Y0 Z0 F6\n", 4, 6, "G247 in inverse time mode (G93) is not supported"},
	{AWAY "S100 M3\nG95 G141 G247 DISR=6 X40 Y0 Z0 F6\n", 4, 10, "another kind of feed (G94, G95) beside G247"},
	{AWAY "G41 G247 DISR=6 X40 Y0 Z0 F6\nM8\n", 4, 1,
	 "G247 of line 3 waits for the path that it touches: the block behind it must be a move in the plane"},
	{AWAY "G41 G247 DISR=6 X40 Y0 Z0 F6\nR1=5\n", 4, 1, "G247 of line 3 waits for the path that it touches"},
	{AWAY "G41 G247 DISR=6 X40 Y0 Z0 F6\nM30\n", 4, 1, "G247 of line 3 waits for the path that it touches"},
	{AWAY "G41 G247 DISR=6 X40 Y0 Z0 F6\nG1 Z-5\n", 4, 1, "the path behind the approach of line 3 must be a line or a circle"},
	{AWAY "G41 G147 DISR=6 Z0\nX40 Y0\nX60\n", 4, 1, "this block gives the end of the approach of line 3, so it needs G1"},
	{AWAY "G41 G147 DISR=6 Z0\nG2 X40 Y0 CR=50\nX60\n", 4, 1, "this block gives the end of the approach of line 3"},
	{ON "G247 DISR=6 X80 Y0 Z0\nX90\n", 5, 1, "G247 while tool radius compensation has begun is not supported"},
	{ON "G40 G248 DISR=6 Z30\n", 5, 1, "G40 beside a soft retraction without a coordinate of the plane"},
	{ON "G40 G148 DISR=6 X71 Y-10\n", 5, 5, "G40 beside G148 needs a way in the plane from beside the contour to its end"},
	{ON "G40 G248 DISR=6 DISCL=2 X0 Y0\n", 5, 5, "the heights of G248 are not in order"},
	{ON "G248 DISR=6 DISRP=5\n", 5, 1, "DISRP of G248 needs coordinates of the plane"},
	{ON "Z5\nG248 DISR=6\n", 6, 1, "G248 goes on in the direction of the motion before it, which is not known here"},
	{AWAY "G141 G248 DISR=6\n", 3, 6, "G248 behind a contour that moves with G0 is not supported"},
	{AWAY "G1 X10\nG248 DISR=6\n", 4, 1, "G248 with G143, or with G140 and G40, needs its end in the plane"},
	{AWAY "MCALL CYCLE81(50,0,1,-5)\nG141 G247 DISR=6 X40 Y0 Z0 F6\n", 4, 6, "G247 in the contour of a cycle or under MCALL"},
};

/* The messages begin like this. */
START_TEST(refuses)
{
	const struct refused_program *bad = &bads[_i];
	char expected[300];
	struct gcode_case c;

	sinumerik_case_init(&c);
	ck_assert_msg(!case_run(&c, bad->program), "accepted: %s", bad->program);
	snprintf(expected, sizeof(expected), "p.nc:%d:%d: error: %s", bad->line, bad->column, bad->message);
	ck_assert_msg(strstr(strbuf_text(&c.messages), expected), "%s\nnot: %s", strbuf_text(&c.messages), expected);
	case_release(&c);
}
END_TEST

/* The waiting block is named also where the file ends. */
START_TEST(waits_at_the_end_of_the_file)
{
	struct gcode_case c;

	sinumerik_case_init(&c);
	case_run(&c, AWAY "G41 G247 DISR=6 X40 Y0 Z0 F6\n");
	ck_assert_ptr_nonnull(strstr(strbuf_text(&c.messages),
				     "G247 of line 3 waits for the path that it touches, but the file ends here"));
	case_release(&c);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("programs");

	tcase_add_loop_test(tcase, goes_to_and_from_contours, 0, COUNT(programs));
	tcase_add_test(tcase, has_the_speeds);
	tcase_add_test(tcase, keeps_the_order_of_blocks);
	tcase_add_test(tcase, cautions_about_the_way_down);
	tcase_add_loop_test(tcase, refuses, 0, COUNT(bads));
	tcase_add_test(tcase, waits_at_the_end_of_the_file);
	return run_suite("gcode_sinumerik_soft", tcase);
}
