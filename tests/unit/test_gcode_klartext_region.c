/* test_gcode_klartext_region.c - Klartext: milling cycles as regions, patterns of holes, and directions of the tool. */
#include "gcode_reach.h"
#include "klartext_case.h"

#define START "TOOL CALL 1 Z S100\nL X+10 Y+20 Z+100 FMAX\n"
#define DRILL "CYCL DEF 200 DRILLING Q200=2 Q201=-10 Q206=150 Q202=10 Q203=+0 Q204=20\n"
#define AT(x, y) "L X" x " Y" y " FMAX M99\n"
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
	/* It lies where its parameters say: a second call adds nothing for where the first one has left the tool. */
	{START "CYCL DEF 254 SLOT Q375=60 Q219=12 Q216=1 Q217=2" HEIGHTS "M99\n",
	 "tool 1\n"
	 "rapid X -30..32 Y -29..33 Z 102..200\n"
	 "feed X -30..32 Y -29..33 Z 80..102\n"
	 "rapid X -30..32 Y -29..33 Z 102..150\n"
	 "feed X -30..32 Y -29..33 Z 80..102\n"
	 "rapid X -30..32 Y -29..33 Z 102..150\n"},
	/* So does a contour, and the way there begins anywhere over the slot before. */
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
	/* Drilled before, 4 deeper than the thread; and in a helix alone. */
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
	/* A depth of 0 does nothing. */
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
	/* The same of pockets, which leave the tool anywhere over themselves. */
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

/* Every move by itself. */
static const struct klartext_program moves[] = {
	/* A circle that may lie in YZ or in ZX: anywhere about its centre; also where CC names Z no more. */
	{"L X+1 Y+2 Z+10 F100\nCC X+1 Y+2 Z+5\nC X+1 Y+2 Z+0 DR+\nC Z+0 DR-\nCC X+1 Y+2\nC X+1 Y+2 Z+10 DR-\n",
	 "feed 1 2 10 0 0\nfeed 1 2 0 0 0 spread 5.016 5.016 10.016\nfeed 1 2 0 0 0 spread 5.016 5.016 10.016\n"
	 "feed 1 2 10 0 0 spread 5.016 5.016 10.016\n"},
	/* LN with a direction: M128 turns the axes; without words of axes, too. */
	{"M128\nLN X+1 Y+2 NX+0 NY+0 NZ+1 TX+0 TY+0.5 TZ+0.866025404 F100\nLN TX+0 TY+0 TZ+1\n",
	 "tcp on length 0 zero A0 C0\norient 0 0.5 0.866025404\nfeed 1 2 0 30 0 tcp\norient 0 0 1\nfeed 1 2 0 0 0 tcp\n"},
	/* AXIS SPAT: the same by angles, each of which counts until it changes; M128 takes positions of the axes again. */
	{"FUNCTION TCPM F TCP AXIS SPAT PATHCTRL AXIS\nL X+1 Y+2 A-30 B+0 C+0 F100\nL A+0\nM128\nL A+5\n",
	 "tcp on length 0 zero A0 C0\norient 0 0.5 0.866025404\nfeed 1 2 0 30 0 tcp\norient 0 0 1\nfeed 1 2 0 0 0 tcp\n"
	 "feed 1 2 0 5 0 tcp\n"},
};

/* Patterns, and the same holes one by one. */
static const struct {
	const char *blocks, *same;
} equal[] = {
	/* An older cycle, which CYCL CALL may follow at once. */
	{START "L Z+2 FMAX\nCYCL DEF 1.0 PECKING\nCYCL DEF 1.1 SET UP 2\nCYCL DEF 1.2 DEPTH -10\nCYCL DEF 1.3 PECKG 5\n"
	 "CYCL DEF 1.4 DWELL 0\nCYCL DEF 1.5 F100\nCYCL CALL\nL X+30 FMAX\nCYCL CALL M8\n",
	 START "L Z+2 FMAX\nCYCL DEF 1.0 PECKING\nCYCL DEF 1.1 SET UP 2\nCYCL DEF 1.2 DEPTH -10\nCYCL DEF 1.3 PECKG 5\n"
	 "CYCL DEF 1.4 DWELL 0\nCYCL DEF 1.5 F100\nL M99\nL X+30 FMAX M99\n"},
	/* CONTOUR DEF names the contours, too. */
	{START "CONTOUR DEF P1 = LBL 1 I2 = LBL 2\nCYCL DEF 20 DATA Q1=-15 Q5=0 Q6=2 Q7=50\nCYCL DEF 22 ROUGH-OUT Q12=500\nM99\n"
	 "M30\nLBL 1\nL X+0 Y+0 RR\nL X+80\nL Y+60\nL X+0\nL Y+0\nLBL 0\nLBL 2\nL X+20 Y+20 RL\nL X+30 Y+30\nLBL 0\n",
	 START "CYCL DEF 14.0\nCYCL DEF 14.1 LABEL1 /2\nCYCL DEF 20 DATA Q1=-15 Q5=0 Q6=2 Q7=50\nCYCL DEF 22 ROUGH-OUT Q12=500\n"
	 "M99\nM30\nLBL 1\nL X+0 Y+0 RR\nL X+80\nL Y+60\nL X+0\nL Y+0\nLBL 0\nLBL 2\nL X+20 Y+20 RL\nL X+30 Y+30\nLBL 0\n"},
	{START DRILL "PATTERN DEF ~\n POS1 (X+1 Y+2 Z+0) ~\n POS2 (X+3 Y+4)\nCYCL CALL PAT FMAX M8\n",
	 START DRILL "L Z+100 FMAX\n" AT("+1", "+2") "L Z+100 FMAX\n" AT("+3", "+4")},
	{START "L Z+5 FMAX\n" DRILL "PATTERN DEF ROW1 (X+1 Y+2 D+8 NUM3 ROT+90)\nCYCL CALL PAT\n",
	 START "L Z+5 FMAX\n" DRILL "L Z+20 FMAX\n" AT("+1", "+2") "L Z+20 FMAX\n" AT("+1", "+10")
	 "L Z+20 FMAX\n" AT("+1", "+18")},
	{START DRILL "PATTERN DEF PAT1 (X+1 Y+2 DX+8 DY+9 NUMX2 NUMY2 ROT+0 Z+0)\nL Z+20 FMAX\nCYCL CALL PAT\n",
	 START DRILL "L Z+20 FMAX\nL Z+20 FMAX\n" AT("+1", "+2") "L Z+20 FMAX\n" AT("+9", "+2") "L Z+20 FMAX\n"
	 AT("+9", "+11") "L Z+20 FMAX\n" AT("+1", "+11")},
	/* ROTX turns the rows alone, ROTY the way from row to row, ROT both. */
	{START DRILL "PATTERN DEF PAT1 (X+1 Y+2 DX+8 DY+9 NUMX2 NUMY2 ROT-90 ROTX+90 ROTY+90)\nL Z+20 FMAX\nCYCL CALL PAT\n",
	 START DRILL "L Z+20 FMAX\nL Z+20 FMAX\n" AT("+1", "+2") "L Z+20 FMAX\n" AT("+9", "+2") "L Z+20 FMAX\n"
	 AT("+9", "+11") "L Z+20 FMAX\n" AT("+1", "+11")},
	/* F is the feed rate between the points. */
	{START DRILL "PATTERN DEF ROW1 (X+1 Y+2 D+8 NUM2)\nL Z+20 FMAX\nCYCL CALL PAT F500\n",
	 START DRILL "L Z+20 FMAX\nL Z+20 F500\nL X+1 Y+2 F500 M99\nL Z+20 F500\nL X+9 Y+2 F500 M99\n"},
	/* Without F the one that was programmed last counts, whatever a cycle's own is. */
	{START "L X+5 F700\nL Z+20 FMAX\n" DRILL "PATTERN DEF ROW1 (X+1 Y+2 D+8 NUM2)\nCYCL CALL PAT\n",
	 START "L X+5 F700\nL Z+20 FMAX\n" DRILL "PATTERN DEF ROW1 (X+1 Y+2 D+8 NUM2)\nCYCL CALL PAT F700\n"},
	/* Cycles of data are not called. */
	{START DRILL "CYCL DEF 271 OCM CONTOUR DATA Q203=+0 Q201=-20\nCYCL DEF 270 DATA Q390=1\nL X+1 Y+2 FMAX\n"
	 DRILL "M99\n",
	 START DRILL "L X+1 Y+2 FMAX M99\n"},
	{START DRILL "CYCL DEF 271 OCM CONTOUR DATA Q371=+0\nL X+1 Y+2 FMAX M99\n",
	 START DRILL "L X+1 Y+2 FMAX M99\n"},
	/* APPR goes to its helper point as the positioning block before went, also where a cycle stands between. */
	{START "L X+1 Y+2 FMAX\n" DRILL "M99\nAPPR LT X+20 Y+0 LEN10 RR F100\nL X+50 Y+0\nDEP LN LEN5\n",
	 START "L X+1 Y+2 FMAX\n" DRILL "M99\nL X+10 Y-5 FMAX\nL X+20 Y+0 RR F100\nL X+50\nDEP LN LEN5\n"},
	{START DRILL "PATTERN DEF CIRC1 (X+1 Y+2 D+20 START+0 NUM4)\nL Z+20 FMAX\nCYCL CALL PAT\n",
	 START DRILL "L Z+20 FMAX\nL Z+20 FMAX\n" AT("+11", "+2") "L Z+20 FMAX\n" AT("+1", "+12") "L Z+20 FMAX\n"
	 AT("-9", "+2") "L Z+20 FMAX\n" AT("+1", "-8")},
	{START DRILL "PATTERN DEF PITCHCIRC1 (X+1 Y+2 D+20 START+90 STEP+90 NUM2)\nL Z+20 FMAX\nCYCL CALL PAT\n",
	 START DRILL "L Z+20 FMAX\nL Z+20 FMAX\n" AT("+1", "+12") "L Z+20 FMAX\n" AT("-9", "+2")},
	/* Approaches and departures in polar coordinates. */
	{START "CC X+50 Y+0\nAPPR PLT PR+30 PA+180 LEN10 RR F100\nLP PA+90 PR+30\nDEP PLCT PR+100 PA+90 R+8\n",
	 START "APPR LT X+20 Y+0 LEN10 RR F100\nL X+50 Y+30\nDEP LCT X+50 Y+100 R+8\n"},
	{START "CC X+50 Y+0\nAPPR PLN PR+30 PA+180 LEN10 RL F100\nLP PA+90 PR+30\nDEP LN LEN5\n",
	 START "APPR LN X+20 Y+0 LEN10 RL F100\nL X+50 Y+30\nDEP LN LEN5\n"},
	{START "CC X+50 Y+0\nAPPR PCT PR+30 PA+180 CCA90 R+10 RL F100\nLP PA+90 PR+30\nDEP LN LEN5\n",
	 START "APPR CT X+20 Y+0 CCA90 R+10 RL F100\nL X+50 Y+30\nDEP LN LEN5\n"},
	/* Tapping with chip breaking goes up and down on the line of a tap without. */
	{START "CYCL DEF 209 TAPPING Q200=2 Q201=-10 Q239=+1 Q203=0 Q204=20 Q257=5 Q256=0.2 Q336=0 Q403=1\n" AT("+1", "+2"),
	 START "CYCL DEF 207 TAPPING Q200=2 Q201=-10 Q239=+1 Q203=0 Q204=20\n" AT("+1", "+2")},
	/* What moves no axis. */
	{START "FUNCTION FEED DWELL D-TIME0.5 F-TIME5\nFUNCTION S-PULSE P-TIME10 SCALE5\nFUNCTION FEED RESET\nL X+1 F100\n",
	 START "L X+1 F100\n"},
	{START DRILL "CYCL DEF 220 POLAR PATTERN Q216=1 Q217=2 Q244=20 Q245=0 Q246=360 Q247=0 Q241=4 Q200=2 Q203=0 Q204=30 "
	 "Q301=1\nL X+0 FMAX\n",
	 START "CYCL DEF 200 DRILLING Q200=2 Q201=-10 Q206=150 Q202=10 Q203=+0 Q204=30\nL Z+30 FMAX\n" AT("+11", "+2")
	 "L Z+30 FMAX\n" AT("+1", "+12") "L Z+30 FMAX\n" AT("-9", "+2") "L Z+30 FMAX\n" AT("+1", "-8") "L X+0 FMAX\n"},
	{START DRILL "CYCL DEF 221 PATTERN Q225=1 Q226=2 Q237=8 Q238=9 Q242=2 Q243=2 Q224=0 Q200=2 Q203=0 Q204=30 Q301=0\n"
	 "L X+0 FMAX\n",
	 START "CYCL DEF 200 DRILLING Q200=2 Q201=-10 Q206=150 Q202=10 Q203=+0 Q204=2\nL Z+30 FMAX\n" AT("+1", "+2")
	 "L Z+2 FMAX\n" AT("+9", "+2") "L Z+2 FMAX\n" AT("+9", "+11") "L Z+2 FMAX\n" AT("+1", "+11") "L X+0 FMAX\n"},
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

START_TEST(moves_table)
{
	klartext_expect(&moves[_i], true);
}
END_TEST

START_TEST(equal_table)
{
	struct gcode_case c[2];

	for (int i = 0; i < 2; i++) {
		const char *blocks = i ? equal[_i].same : equal[_i].blocks;

		klartext_case(&c[i]);
		ck_assert_msg(klartext_run(&c[i], blocks), "%s%s", blocks, strbuf_text(&c[i].messages));
	}
	ck_assert_str_eq(strbuf_text(&c[0].moves), strbuf_text(&c[1].moves));
	case_release(&c[0]);
	case_release(&c[1]);
}
END_TEST

/* What the machine file says of a probe's cycle: it moves around its place, and what it measures is not known. */
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
				       "7 L X+11 FMAX\nTCH PROBE 483 TOOL Q340=1\nL X+12 FMAX\n"),
		      "%s", strbuf_text(&c.messages));
	ck_assert_str_eq(strbuf_text(&c.moves), "rapid 10 0 0 0 0\nrapid 10 -20 0 0 0 spread 5 0 10\n"
						"rapid 10 20 0 0 0 spread 5 0 10\nrapid 10 0 0 0 0 spread 5 0 10\n"
						"rapid 11 0 0 0 0\nrapid 12 0 0 0 0\n");
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
			("there is no file of the program TNC:\\RESET.H; if the machine's builder made it and it moves no axis, "
			 "<macro program=\"RESET\" action=\"none\"/> in the machine's <controller> says so"),
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

/* Where a cycle of the control has left the tool is open until X and Y, and Z, are commanded. */
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

/* A cycle of the control that is not followed: where it is called it moves as far as the machine file says. */
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
	TCase *tcase = tcase_create("gcode_klartext_region");

	tcase_add_loop_test(tcase, regions_table, 0, COUNT(regions));
	tcase_add_loop_test(tcase, moves_table, 0, COUNT(moves));
	tcase_add_loop_test(tcase, equal_table, 0, COUNT(equal));
	tcase_add_test(tcase, probe_cycle);
	tcase_add_test(tcase, builder_program);
	tcase_add_test(tcase, left_by_cycle);
	tcase_add_test(tcase, bounded_cycle);
	return run_suite("gcode_klartext_region", tcase);
}
