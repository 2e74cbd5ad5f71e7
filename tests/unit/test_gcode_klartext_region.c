/* test_gcode_klartext_region.c - Klartext: milling cycles whose path only the control knows, proved as regions. */
#include "gcode_reach.h"
#include "klartext_case.h"

#define START "TOOL CALL 1 Z S100\nL X+10 Y+20 Z+100 FMAX\n"
#define DRILL "CYCL DEF 200 DRILLING Q200=2 Q201=-10 Q206=150 Q202=10 Q203=+0 Q204=20\n"
#define HEIGHTS " Q200=2 Q203=0 Q201=-20 Q204=50 Q206=100 Q207=500\nM99\n"

#define CONTOURS \
	"CYCL DEF 14.0 CONTOUR\nCYCL DEF 14.1 CONTOUR LABEL1 /2\n" \
	"CYCL DEF 20 CONTOUR DATA Q1=-15 Q2=1 Q3=0 Q4=0 Q5=0 Q6=2 Q7=50 Q8=0.1 Q9=1\n"

/* The centre of the tool, of radius 5 mm, may be anywhere in the region, until X and Y are commanded. */
static const struct klartext_program regions[] = {
	{START "CYCL DEF 251 POCKET Q218=60 Q219=30" HEIGHTS "L X+0 FMAX\nL X+0 Y+0 FMAX\nL X+1 FMAX\n",
	 "tool 1\n"
	 "rapid X -15..35 Y 10..30 Z 102..200\n"
	 "feed X -15..35 Y 10..30 Z 80..102\n"
	 "rapid X -25..35 Y -10..30 Z 102..150\n"},
	/* Its lower left corner, turned by 90 degrees. */
	{START "CYCL DEF 251 POCKET Q218=60 Q219=30 Q224=90 Q367=1" HEIGHTS,
	 "tool 1\n"
	 "rapid X -15..10 Y 20..75 Z 102..200\n"
	 "feed X -15..5 Y 25..75 Z 80..102\n"
	 "rapid X -15..5 Y 25..75 Z 102..150\n"},
	{START "CYCL DEF 252 POCKET Q223=40" HEIGHTS,
	 "tool 1\n"
	 "rapid X -5..25 Y 5..35 Z 102..200\n"
	 "feed X -5..25 Y 5..35 Z 80..102\n"
	 "rapid X -5..25 Y 5..35 Z 102..150\n"},
	{START "CYCL DEF 208 BORE MILLING Q335=40" HEIGHTS,
	 "tool 1\n"
	 "rapid X -5..25 Y 5..35 Z 102..200\n"
	 "feed X -5..25 Y 5..35 Z 80..102\n"
	 "rapid X -5..25 Y 5..35 Z 102..150\n"},
	{START "CYCL DEF 253 SLOT Q218=60 Q219=12 Q374=0 Q367=1" HEIGHTS,
	 "tool 1\n"
	 "rapid X 10..65 Y 19..21 Z 102..200\n"
	 "feed X 15..65 Y 19..21 Z 80..102\n"
	 "rapid X 15..65 Y 19..21 Z 102..150\n"},
	{START "CYCL DEF 254 SLOT Q375=60 Q219=12 Q216=1 Q217=2" HEIGHTS,
	 "tool 1\n"
	 "rapid X -30..32 Y -29..33 Z 102..200\n"
	 "feed X -30..32 Y -29..33 Z 80..102\n"
	 "rapid X -30..32 Y -29..33 Z 102..150\n"},
	/*
	 * The region lies where its parameters say: a second call does not widen it by the place where the first call
	 * has left the tool.
	 */
	{START "CYCL DEF 254 SLOT Q375=60 Q219=12 Q216=1 Q217=2" HEIGHTS "M99\n",
	 "tool 1\n"
	 "rapid X -30..32 Y -29..33 Z 102..200\n"
	 "feed X -30..32 Y -29..33 Z 80..102\n"
	 "rapid X -30..32 Y -29..33 Z 102..150\n"
	 "feed X -30..32 Y -29..33 Z 80..102\n"
	 "rapid X -30..32 Y -29..33 Z 102..150\n"},
	/* The same holds for a contour; the way to it begins anywhere over the slot before. */
	{START "CYCL DEF 254 SLOT Q375=60 Q219=12 Q216=1 Q217=2" HEIGHTS CONTOURS
	 "CYCL DEF 22 ROUGH-OUT Q10=5 Q11=100 Q12=350\nM99\nM30\n"
	 "LBL 1\nL X+100 Y+100 RR\nL X+140\nL Y+130\nL X+100\nL Y+100\nLBL 0\nLBL 2\nL X+110 Y+110 RR\nL X+120\nLBL 0\n",
	 "tool 1\n"
	 "rapid X -30..32 Y -29..33 Z 102..200\n"
	 "feed X -30..32 Y -29..33 Z 80..102\n"
	 "rapid X -30..135 Y -29..125 Z 102..150\n"
	 "feed X 105..135 Y 105..125 Z 85..102\n"
	 "rapid X 105..135 Y 105..125 Z 102..150\n"},
	{START "CYCL DEF 262 THREAD Q335=20 Q239=1.5" HEIGHTS,
	 "tool 1\n"
	 "rapid X 5..15 Y 15..25 Z 100.5..201.5\n"
	 "feed X 5..15 Y 15..25 Z 78.5..103.5\n"
	 "rapid X 5..15 Y 15..25 Z 100.5..151.5\n"},
	/* A countersink at the front reaches farther than the thread, and the bore is deeper. */
	{START "CYCL DEF 263 THREAD Q335=20 Q239=1.5 Q356=-25 Q358=-2 Q359=8" HEIGHTS,
	 "tool 1\n"
	 "rapid X 2..18 Y 12..28 Z 100.5..201.5\n"
	 "feed X 2..18 Y 12..28 Z 73.5..103.5\n"
	 "rapid X 2..18 Y 12..28 Z 100.5..151.5\n"},
	/* Through a bore of 20, 3 beside its centre, to 2 below its end and 15 more of the tool. */
	{START "CYCL DEF 204 BACK BORING Q249=5 Q250=20 Q251=3 Q252=15 Q253=700 Q254=200 Q214=1" HEIGHTS,
	 "tool 1\n"
	 "rapid X 7..13 Y 17..23 Z 102..200\n"
	 "feed X 7..13 Y 17..23 Z 63..102\n"
	 "rapid X 7..13 Y 17..23 Z 102..150\n"},
	/* About a blank of 64 by 44, on all sides 3 radii and 2 mm. */
	{START "CYCL DEF 256 STUD Q218=60 Q219=40 Q424=64 Q425=44" HEIGHTS,
	 "tool 1\n"
	 "rapid X -39..59 Y -29..69 Z 102..200\n"
	 "feed X -39..59 Y -29..69 Z 80..102\n"
	 "rapid X -39..59 Y -29..69 Z 102..150\n"},
	{START "CYCL DEF 257 STUD Q223=60 Q222=64" HEIGHTS,
	 "tool 1\n"
	 "rapid X -39..59 Y -29..69 Z 102..200\n"
	 "feed X -39..59 Y -29..69 Z 80..102\n"
	 "rapid X -39..59 Y -29..69 Z 102..150\n"},
	/* A hexagon about a circle of 60: its corners lie on one of 69.28; on a circle of 60 they lie inside the blank. */
	{START "CYCL DEF 258 STUD Q571=60 Q222=64 Q572=6 Q573=0" HEIGHTS,
	 "tool 1\n"
	 "rapid X -41.641..61.641 Y -31.641..71.641 Z 102..200\n"
	 "feed X -41.641..61.641 Y -31.641..71.641 Z 80..102\n"
	 "rapid X -41.641..61.641 Y -31.641..71.641 Z 102..150\n"},
	{START "CYCL DEF 258 STUD Q571=60 Q222=64 Q572=6 Q573=1" HEIGHTS,
	 "tool 1\n"
	 "rapid X -39..59 Y -29..69 Z 102..200\n"
	 "feed X -39..59 Y -29..69 Z 80..102\n"
	 "rapid X -39..59 Y -29..69 Z 102..150\n"},
	/* First drilled 4 mm deeper than the thread; then in a helix only. */
	{START "CYCL DEF 264 THREAD Q335=20 Q239=1.5 Q356=-24 Q358=0 Q359=0" HEIGHTS,
	 "tool 1\n"
	 "rapid X 5..15 Y 15..25 Z 100.5..201.5\n"
	 "feed X 5..15 Y 15..25 Z 74.5..103.5\n"
	 "rapid X 5..15 Y 15..25 Z 100.5..151.5\n"},
	{START "CYCL DEF 265 THREAD Q335=20 Q239=1.5 Q358=0 Q359=0" HEIGHTS,
	 "tool 1\n"
	 "rapid X 5..15 Y 15..25 Z 100.5..201.5\n"
	 "feed X 5..15 Y 15..25 Z 78.5..103.5\n"
	 "rapid X 5..15 Y 15..25 Z 100.5..151.5\n"},
	/* Line by line over a face of 40 by 30 from (0, 10, 3) on: beside it a diameter and the set-up clearance. */
	{START "CYCL DEF 230 MULTIPASS Q225=0 Q226=10 Q227=3 Q218=40 Q219=30 Q240=5 Q206=100 Q207=500 Q209=100 Q200=2\nM99\n",
	 "tool 1\n"
	 "rapid X -12..52 Y -2..52 Z 105..200\n"
	 "feed X -12..52 Y -2..52 Z 103..105\n"
	 "rapid X -12..52 Y -2..52 Z 105..105\n"},
	/* About an outside thread of 20, 3 radii, 2 mm, the pitch and the countersink aside. */
	{START "CYCL DEF 267 THREAD Q335=20 Q239=1.5 Q358=-25 Q359=3" HEIGHTS,
	 "tool 1\n"
	 "rapid X -21.5..41.5 Y -11.5..51.5 Z 100.5..201.5\n"
	 "feed X -21.5..41.5 Y -11.5..51.5 Z 73.5..103.5\n"
	 "rapid X -21.5..41.5 Y -11.5..51.5 Z 100.5..151.5\n"},
	/* A face of 40 by -20 from (0, 10) on, from 3 down to 1: beside it a diameter and 4 mm. */
	{START "CYCL DEF 232 FACE MILLING Q225=0 Q226=10 Q227=3 Q386=1 Q218=40 Q219=-20 Q357=4" HEIGHTS,
	 "tool 1\n"
	 "rapid X -14..54 Y -24..24 Z 105..200\n"
	 "feed X -14..54 Y -24..24 Z 101..105\n"
	 "rapid X -14..54 Y -24..24 Z 105..153\n"},
	/* The same where the tool stands: it is the corner at which the sides begin, or the centre, or the upper right one. */
	{START "CYCL DEF 233 FACE MILLING Q227=3 Q386=1 Q218=40 Q219=-20 Q357=4" HEIGHTS,
	 "tool 1\n"
	 "rapid X -4..64 Y -14..34 Z 105..200\n"
	 "feed X -4..64 Y -14..34 Z 101..105\n"
	 "rapid X -4..64 Y -14..34 Z 105..153\n"},
	{START "CYCL DEF 233 FACE MILLING Q227=3 Q386=1 Q218=40 Q219=20 Q357=4 Q367=0" HEIGHTS,
	 "tool 1\n"
	 "rapid X -24..44 Y -4..44 Z 105..200\n"
	 "feed X -24..44 Y -4..44 Z 101..105\n"
	 "rapid X -24..44 Y -4..44 Z 105..153\n"},
	{START "CYCL DEF 233 FACE MILLING Q227=3 Q386=1 Q218=40 Q219=20 Q357=4 Q367=3" HEIGHTS,
	 "tool 1\n"
	 "rapid X -44..24 Y -14..34 Z 105..200\n"
	 "feed X -44..24 Y -14..34 Z 101..105\n"
	 "rapid X -44..24 Y -14..34 Z 105..153\n"},
	/* Slots and finishing of TNC 426, about (40, 30): 60 by 20 turned by 90 degrees, and on a pitch circle of 50. */
	{START "CYCL DEF 210 SLOT Q216=40 Q217=30 Q218=60 Q219=20 Q224=90" HEIGHTS,
	 "tool 1\n"
	 "rapid X 10..45 Y 5..55 Z 102..200\n"
	 "feed X 35..45 Y 5..55 Z 80..102\n"
	 "rapid X 35..45 Y 5..55 Z 102..150\n"},
	{START "CYCL DEF 211 CIRCULAR SLOT Q216=40 Q217=30 Q244=50 Q219=20 Q245=10 Q248=90" HEIGHTS,
	 "tool 1\n"
	 "rapid X 10..70 Y 0..60 Z 102..200\n"
	 "feed X 10..70 Y 0..60 Z 80..102\n"
	 "rapid X 10..70 Y 0..60 Z 102..150\n"},
	{START "CYCL DEF 212 POCKET FINISHING Q216=40 Q217=30 Q218=60 Q219=20 Q220=5 Q221=1" HEIGHTS,
	 "tool 1\n"
	 "rapid X 10..65 Y 20..35 Z 102..200\n"
	 "feed X 15..65 Y 25..35 Z 80..102\n"
	 "rapid X 15..65 Y 25..35 Z 102..150\n"},
	{START "CYCL DEF 214 C. POCKET FINISHING Q216=40 Q217=30 Q222=30 Q223=40" HEIGHTS,
	 "tool 1\n"
	 "rapid X 10..55 Y 15..45 Z 102..200\n"
	 "feed X 25..55 Y 15..45 Z 80..102\n"
	 "rapid X 25..55 Y 15..45 Z 102..150\n"},
	/* Studs: 22 mm aside, and the allowance. */
	{START "CYCL DEF 213 STUD FINISHING Q216=40 Q217=30 Q218=60 Q219=20 Q220=5 Q221=1" HEIGHTS,
	 "tool 1\n"
	 "rapid X -13..93 Y -3..63 Z 102..200\n"
	 "feed X -13..93 Y -3..63 Z 80..102\n"
	 "rapid X -13..93 Y -3..63 Z 102..150\n"},
	{START "CYCL DEF 215 C. STUD FINISHING Q216=40 Q217=30 Q222=50 Q223=40" HEIGHTS,
	 "tool 1\n"
	 "rapid X -7..87 Y -17..77 Z 102..200\n"
	 "feed X -7..87 Y -17..77 Z 80..102\n"
	 "rapid X -7..87 Y -17..77 Z 102..150\n"},
	/* The older cycles start at the set-up clearance, 2 mm over the surface. */
	{START "L Z+2 FMAX\nCYCL DEF 5.0 KREISTASCHE\nCYCL DEF 5.1 ABST+2\nCYCL DEF 5.2 TIEFE-20\n"
	 "CYCL DEF 5.3 ZUSTLG+3 F100\nCYCL DEF 5.4 RADIUS20\nCYCL DEF 5.5 F450 DR+\nL M99\n",
	 "tool 1\n"
	 "rapid X -5..25 Y 5..35 Z 102..200\n"
	 "feed X -5..25 Y 5..35 Z 80..102\n"
	 "rapid X -5..25 Y 5..35 Z 102..102\n"},
	{START "L Z+2 FMAX\nCYCL DEF 4.0\nCYCL DEF 4.1 SET UP -2\nCYCL DEF 4.2 DEPTH -20\nCYCL DEF 4.3 PECKG -3 F100\n"
	 "CYCL DEF 4.4 X60\nCYCL DEF 4.5 Y30\nCYCL DEF 4.6 F450 DR- RADIUS 5\nL M99\n",
	 "tool 1\n"
	 "rapid X -15..35 Y 10..30 Z 102..200\n"
	 "feed X -15..35 Y 10..30 Z 80..102\n"
	 "rapid X -15..35 Y 10..30 Z 102..102\n"},
	{START "L Z+2 FMAX\nCYCL DEF 3.0\nCYCL DEF 3.1 SET UP 2\nCYCL DEF 3.2 DEPTH -20\nCYCL DEF 3.3 PECKG 3 F100\n"
	 "CYCL DEF 3.4 Y60\nCYCL DEF 3.5 X12\nCYCL DEF 3.6 F450\nL M99\n",
	 "tool 1\n"
	 "rapid X -2..22 Y -40..80 Z 102..200\n"
	 "feed X -2..22 Y -40..80 Z 80..102\n"
	 "rapid X -2..22 Y -40..80 Z 102..102\n"},
	/* Contours of subprograms: the box about them, circles whole, less the radius of the tool. */
	{START CONTOURS "CYCL DEF 22 ROUGH-OUT Q10=-5 Q11=150 Q12=500\nL M99\nM30\n"
	 "LBL 1\nL X+0 Y+50 RR\nL Y+100\nRND R5\nL X+80\nL IY-100\nL X+0\nL Y+50\nLBL 0\n"
	 "LBL 2\nCC X+90 Y+50\nL X+90 Y+40 RL\nC X+90 Y+40 DR+\nLBL 0\n",
	 "tool 1\n"
	 "rapid X 5..95 Y 5..95 Z 102..200\n"
	 "feed X 5..95 Y 5..95 Z 85..102\n"
	 "rapid X 5..95 Y 5..95 Z 102..150\n"},
	/* Pilot holes lie where the mill of Q13 plunges, whatever the drill: up to the contour itself. */
	{START CONTOURS "CYCL DEF 21 PILOT DRILLING Q10=-5 Q11=150 Q13=2\nL M99\nM30\n"
	 "LBL 1\nL X+0 Y+0 RR\nL X+80\nL Y+60\nL X+0\nL Y+0\nLBL 0\nLBL 2\nL X+90 Y+70\nLBL 0\n",
	 "tool 1\n"
	 "rapid X 0..90 Y 0..70 Z 102..200\n"
	 "feed X 0..90 Y 0..70 Z 85..102\n"
	 "rapid X 0..90 Y 0..70 Z 102..150\n"},
	{START CONTOURS "CYCL DEF 23 FLOOR FINISHING Q11=150 Q12=500\nL M99\nM30\n"
	 "LBL 1\nL X+0 Y+0 RR\nL X+80\nL Y+60\nL X+0\nL Y+0\nLBL 0\nLBL 2\nL X+90 Y+70\nLBL 0\n",
	 "tool 1\n"
	 "rapid X 5..85 Y 5..65 Z 102..200\n"
	 "feed X 5..85 Y 5..65 Z 85..102\n"
	 "rapid X 5..85 Y 5..65 Z 102..150\n"},
	{START CONTOURS "CYCL DEF 24 SIDE Q9=1 Q10=-5 Q11=150 Q12=500 Q14=-1\nCYCL CALL M8\nM30\n"
	 "LBL 1\nCC X+0 Y+0\nLP PR+20 PA+180 RR\nCP PA+0 DR+\nCP IPA+180 DR+\nLBL 0\n"
	 "LBL 2\nL X+0 Y+0\nCR X+10 R+5 DR+\nLBL 0\n",
	 "tool 1\n"
	 "rapid X -16..16 Y -16..20 Z 102..200\n"
	 "feed X -16..16 Y -16..16 Z 85..102\n"
	 "rapid X -16..16 Y -16..16 Z 102..150\n"},
	/* With a depth of 0 the cycle does nothing. */
	{START "CYCL DEF 252 POCKET Q223=40 Q200=2 Q203=0 Q201=0 Q204=50 Q207=500\nM99\n",
	 "tool 1\n"
	 "rapid X 10..10 Y 20..20 Z 200..200\n"},
	/* The points of a frame, in any order: between them and behind them the tool may be anywhere over the rectangle. */
	{START DRILL "PATTERN DEF FRAME1 (X+10 Y+20 DX+30 DY+40 NUMX2 NUMY2 ROT+0 Z+0)\nCYCL CALL PAT\nL Z+150 FMAX\n",
	 "tool 1\n"
	 "rapid X 10..40 Y 20..60 Z 102..200\n"
	 "feed X 10..10 Y 20..20 Z 90..90\n"
	 "rapid X 10..40 Y 20..20 Z 102..200\n"
	 "feed X 40..40 Y 20..20 Z 90..90\n"
	 "rapid X 10..40 Y 20..60 Z 102..200\n"
	 "feed X 10..10 Y 60..60 Z 90..90\n"
	 "rapid X 10..40 Y 60..60 Z 102..200\n"
	 "feed X 40..40 Y 60..60 Z 90..90\n"
	 "rapid X 10..40 Y 20..60 Z 102..250\n"},
	/* The same with pockets, which leave the tool anywhere above themselves. */
	{START "CYCL DEF 251 POCKET Q218=60 Q219=30 Q200=2 Q203=100 Q201=-20 Q204=50 Q207=500\n"
	       "PATTERN DEF FRAME1 (X+100 Y+20 DX+300 DY+400 NUMX2 NUMY2 ROT+0 Z+0)\nCYCL CALL PAT\nL Y-90 F500\n",
	 "tool 1\n"
	 "rapid X 10..400 Y 10..420 Z 200..250\n"
	 "feed X 75..125 Y 10..30 Z 180..202\n"
	 "rapid X 75..425 Y 10..30 Z 202..250\n"
	 "feed X 375..425 Y 10..30 Z 180..202\n"
	 "rapid X 75..425 Y 10..430 Z 202..250\n"
	 "feed X 75..125 Y 410..430 Z 180..202\n"
	 "rapid X 75..425 Y 410..430 Z 202..250\n"
	 "feed X 375..425 Y 410..430 Z 180..202\n"
	 "rapid X 75..425 Y 10..430 Z 202..250\n"
	 "feed X 75..425 Y -300..430 Z 250..250\n"},
	/* In turned coordinates the region lies across the axes. */
	{"CYCL DEF 10.0\nCYCL DEF 10.1 ROT+90\n" START "CYCL DEF 251 POCKET Q218=60 Q219=30" HEIGHTS,
	 "tool 1\n"
	 "rapid X -30..-10 Y -15..35 Z 102..200\n"
	 "feed X -30..-10 Y -15..35 Z 80..102\n"
	 "rapid X -30..-10 Y -15..35 Z 102..150\n"},
};

static void expect(const struct klartext_program *program)
{
	struct strbuf reached = {0};
	struct gcode_case c;
	char *lines;
	bool good;

	klartext_case(&c);
	c.show_spread = true;
	good = klartext_run(&c, program->blocks);
	ck_assert_msg(good, "%s%s", program->blocks, strbuf_text(&c.messages));
	ck_assert_str_eq(strbuf_text(&c.messages), "");
	lines = strdup(strbuf_text(&c.moves));
	summarise(&reached, lines);
	ck_assert_msg(!strcmp(strbuf_text(&reached), program->moves), "%s makes\n%s and not\n%s", program->blocks,
		      strbuf_text(&reached), program->moves);
	free(lines);
	strbuf_release(&reached);
	case_release(&c);
}

START_TEST(regions_table)
{
	expect(&regions[_i]);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("gcode_klartext_region");

	tcase_add_loop_test(tcase, regions_table, 0, COUNT(regions));
	return run_suite("gcode_klartext_region", tcase);
}
