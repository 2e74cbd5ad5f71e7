/* test_gcode_sinumerik_cycle.c - small programs of the sinumerik dialect: drilling cycles, CYCLE800, TRAORI. */
#include "sinumerik_case.h"

struct program {
	const char *text, *moves;
};

static const struct program programs[] = {
	{"G500 F6 G0 X0 Y0 Z50\nMCALL CYCLE81(10,0,2,-8)\nX10\nY5\nMCALL\nX0\n",
	 "rapid 0 0 50 0 0\nrapid 10 0 50 0 0\nrapid 10 0 2 0 0\nfeed 10 0 -8 0 0\n"
	 "rapid 10 0 10 0 0\nrapid 10 5 10 0 0\nrapid 10 5 2 0 0\nfeed 10 5 -8 0 0\n"
	 "rapid 10 5 10 0 0\nrapid 0 5 10 0 0\n"},
	{"G500 F6 CYCLE81(10,0,2,,8)\n",
	 "rapid 0 0 2 0 0\nfeed 0 0 -8 0 0\nrapid 0 0 10 0 0\n"},
	{"G500 F6 CYCLE82(10,1,1,-3,,1.5)\n",
	 "rapid 0 0 2 0 0\nfeed 0 0 -3 0 0\ndwell 1.5\nrapid 0 0 10 0 0\n"},
	{"G500 F6 CYCLE83(10,0,1,-10,,-5,,2,0,0,1,1)\n",
	 "rapid 0 0 1 0 0\nfeed 0 0 -5 0 0\nrapid 0 0 1 0 0\nrapid 0 0 -4.4 0 0\nfeed 0 0 -8 0 0\n"
	 "rapid 0 0 1 0 0\nrapid 0 0 -7.4 0 0\nfeed 0 0 -10 0 0\nrapid 0 0 10 0 0\n"},
	{"G500 F6 CYCLE83(10,0,1,-4,,,2,,,,,0)\n",
	 "rapid 0 0 1 0 0\nfeed 0 0 -2 0 0\nrapid 0 0 -1 0 0\nfeed 0 0 -4 0 0\nrapid 0 0 10 0 0\n"},
	/* _VRT is how far it lifts to break chips. */
	{"G500 F6 CYCLE83(10,0,1,-4,,,2,,,,,0,,,1.5)\n",
	 "rapid 0 0 1 0 0\nfeed 0 0 -2 0 0\nrapid 0 0 -0.5 0 0\nfeed 0 0 -4 0 0\nrapid 0 0 10 0 0\n"},
	/* If both depths are given, the relative one counts, unless it is 0; or _AMODE decides. */
	{"G500 F6 CYCLE81(10,1,1,-5,3)\n", "rapid 0 0 2 0 0\nfeed 0 0 -2 0 0\nrapid 0 0 10 0 0\n"},
	{"G500 F6 CYCLE81(10,1,1,-5,0)\n", "rapid 0 0 2 0 0\nfeed 0 0 -5 0 0\nrapid 0 0 10 0 0\n"},
	{"G500 F6 CYCLE82(10,1,1,-5,3,0,0,1,12)\n", "rapid 0 0 2 0 0\nfeed 0 0 -5 0 0\nrapid 0 0 10 0 0\n"},
	{"G500 F6 CYCLE82(10,1,1,-5,3,0,0,10001,11)\n", "rapid 0 0 2 0 0\nfeed 0 0 -2 0 0\nrapid 0 0 10 0 0\n"},
	{"G500 F6 CYCLE83(100,0,1,-80,,-60,,0,0,0,1,1)\n",
	 "rapid 0 0 1 0 0\nfeed 0 0 -60 0 0\nrapid 0 0 1 0 0\nrapid 0 0 -58.4 0 0\n"
	 "feed 0 0 -80 0 0\nrapid 0 0 100 0 0\n"},
	{"G500 S500 CYCLE84(10,0,2,-6,,0,3,,1.5,0,400,400)\n",
	 "rapid 0 0 2 0 0\nfeed 0 0 -6 0 0\nfeed 0 0 2 0 0\nrapid 0 0 10 0 0\n"},
	{"G500 S500 CYCLE84(10,0,2,-6,,0,3,8,,0,400,400)\n",
	 "rapid 0 0 2 0 0\nfeed 0 0 -6 0 0\nfeed 0 0 2 0 0\nrapid 0 0 10 0 0\n"},
	{"G500 S500 M3 CYCLE840(10,0,2,-6,,0,0,3,0,,1)\n",
	 "rapid 0 0 2 0 0\nfeed 0 0 -6 0 0\nfeed 0 0 2 0 0\nrapid 0 0 10 0 0\n"},
	{"G500 CYCLE85(10,0,1,-5,,0.5,60,120)\n",
	 "rapid 0 0 1 0 0\nfeed 0 0 -5 0 0\ndwell 0.5\nfeed 0 0 1 0 0\nrapid 0 0 10 0 0\n"},
	{"G500 F6 CYCLE86(10,0,1,-5,,0,3,-1,0.5,0.2,0)\n",
	 "rapid 0 0 1 0 0\nfeed 0 0 -5 0 0\nrapid -1 0.5 -4.8 0 0\nrapid -1 0.5 10 0 0\n"
	 "rapid 0 0 10 0 0\n"},
	{"G500 F6 CYCLE87(10,0,1,-5,,3)\n",
	 "rapid 0 0 1 0 0\nfeed 0 0 -5 0 0\nrapid 0 0 10 0 0\n"},
	{"G500 F6 CYCLE88(10,0,1,-5,,1,4)\n",
	 "rapid 0 0 1 0 0\nfeed 0 0 -5 0 0\ndwell 1\nrapid 0 0 10 0 0\n"},
	{"G500 F6 CYCLE89(10,0,1,-5,,1)\n",
	 "rapid 0 0 1 0 0\nfeed 0 0 -5 0 0\ndwell 1\nfeed 0 0 1 0 0\nrapid 0 0 10 0 0\n"},
	{"G500 F6 G0 X0 Y0 Z50\nGOTOF BEHIND\nFROM:\nX10\nUPTO:\nBEHIND:\nMCALL CYCLE81(10,0,2,-8)\n"
	 "REPEAT FROM UPTO P=2\nMCALL\nREPEAT FROM UPTO\n",
	 "rapid 0 0 50 0 0\nrapid 10 0 50 0 0\nrapid 10 0 2 0 0\nfeed 10 0 -8 0 0\nrapid 10 0 10 0 0\n"
	 "rapid 10 0 10 0 0\nrapid 10 0 2 0 0\nfeed 10 0 -8 0 0\nrapid 10 0 10 0 0\nrapid 10 0 10 0 0\n"},
	{"G500 F6 G0 Z10\nMCALL CYCLE81(10,0,2,-8)\nHOLES1(0,0,0,10,5,2)\nMCALL\n",
	 "rapid 0 0 10 0 0\nrapid 10 0 10 0 0\nrapid 10 0 2 0 0\nfeed 10 0 -8 0 0\n"
	 "rapid 10 0 10 0 0\nrapid 15 0 10 0 0\nrapid 15 0 2 0 0\nfeed 15 0 -8 0 0\n"
	 "rapid 15 0 10 0 0\n"},
	{"G500 F6 G0 X90 Z10\nMCALL CYCLE81(10,0,2,-8)\nHOLES1(0,0,90,10,5,2)\n"
	 "HOLES2(0,0,10,45,0,2)\nMCALL\n",
	 "rapid 90 0 10 0 0\nrapid 0 10 10 0 0\nrapid 0 10 2 0 0\nfeed 0 10 -8 0 0\n"
	 "rapid 0 10 10 0 0\nrapid 0 15 10 0 0\nrapid 0 15 2 0 0\nfeed 0 15 -8 0 0\n"
	 "rapid 0 15 10 0 0\nrapid 7.07106781 7.07106781 10 0 0\n"
	 "rapid 7.07106781 7.07106781 2 0 0\nfeed 7.07106781 7.07106781 -8 0 0\n"
	 "rapid 7.07106781 7.07106781 10 0 0\nrapid -7.07106781 -7.07106781 10 0 0\n"
	 "rapid -7.07106781 -7.07106781 2 0 0\nfeed -7.07106781 -7.07106781 -8 0 0\n"
	 "rapid -7.07106781 -7.07106781 10 0 0\n"},
	/* A grid goes to and fro along its smaller distance, from the corner in whose quarter the tool is. */
	{"G500 F6 G0 Z10\nCYCLE801(10,20,0,5,8,3,2)\n",
	 "rapid 0 0 10 0 0\nrapid 10 20 10 0 0\nrapid 15 20 10 0 0\nrapid 20 20 10 0 0\nrapid 20 28 10 0 0\n"
	 "rapid 15 28 10 0 0\nrapid 10 28 10 0 0\n"},
	{"G500 F6 G0 X90 Y90 Z10\nCYCLE801(10,20,0,8,5,2,3,0,0,,,,,1)\n",
	 "rapid 90 90 10 0 0\nrapid 18 30 10 0 0\nrapid 18 25 10 0 0\nrapid 18 20 10 0 0\nrapid 10 20 10 0 0\n"
	 "rapid 10 25 10 0 0\nrapid 10 30 10 0 0\n"},
	{"G500 F6 G0 Y90 Z10\nCYCLE801(10,0,90,5,8,2,2)\n",
	 "rapid 0 90 10 0 0\nrapid 2 5 10 0 0\nrapid 2 0 10 0 0\nrapid 10 0 10 0 0\nrapid 10 5 10 0 0\n"},
	{"G500 F6 G0 Z10\nHOLES2(0,0,10,0,30,2,1000)\n", "rapid 0 0 10 0 0\nrapid 10 0 10 0 0\nrapid -10 0 10 0 0\n"},
	{"G500 F6 G18 G0 Y20\nCYCLE81(10,0,2,-8)\n",
	 "rapid 0 20 0 0 0\nrapid 0 2 0 0 0\nfeed 0 -8 0 0 0\nrapid 0 10 0 0 0\n"},
	{"G500 F6 TRANS Z100\nAROT Z90\nCYCLE81(10,0,2,-8)\n",
	 "rapid 0 0 102 0 0\nfeed 0 0 92 0 0\nrapid 0 0 110 0 0\n"},
	{"G500 T1 D1 M6 G0 X1 Y2 Z3\nCYCLE800(0,\"TC1\",0,57,0,0,0,30,0,0,0,0,0,-1)\nG0 X1 Y2 Z3\n"
	 "CYCLE800()\nX0 Y0 Z0\n",
	 "tool 1\nrapid 1 2 103 0 0\norient 0 -0.5 0.866025404\nrapid 1 2 103 -30 0\n"
	 "tcp on length 100 zero A0 C0\nrapid 1 0.232050808 3.59807621 -30 0 tcp\n"
	 "tcp off length 100 zero A0 C0\nrapid 0 0 100 -30 0\n"},
	/* G18 is no plane of CYCLE800, unless DMODE names G17. */
	{"G500 G18\nCYCLE800()\nCYCLE800(0,\"\",0,57,0,0,0,30,0,0,0,0,0,-1,,1)\n",
	 "orient 0 -0.5 0.866025404\nrapid 0 0 0 -30 0\ntcp on length 0 zero A0 C0\n"},
	/* SUPA over a swivelled table: the tool of 100 mm stands along Z. */
	{"G54 T1 D1 M6\nCYCLE800(0,\"TC1\",0,57,0,0,0,30,0,0,0,0,0,-1)\nSUPA G0 Z50\nSUPA X3 Z9 D0\n",
	 "tool 1\norient 0 -0.5 0.866025404\nrapid 0 0 0 -30 0\ntcp on length 100 zero A0 C0\n"
	 "tcp off length 100 zero A0 C0\nrapid 0 0 150 -30 0\ntcp on length 100 zero A0 C0\n"
	 "tcp on length 0 zero A0 C0\ntcp off length 0 zero A0 C0\nrapid 3 0 9 -30 0\ntcp on length 0 zero A0 C0\n"},
	{"G500 CYCLE800(0,\"\",0,57,10,20,30,30,0,0,1,2,3,-1)\nG0 X0 Y0 Z0\n"
	 "CYCLE800(0,\"\",1,57,0,0,0,15,0,0,0,0,0,-1)\nG0 X0 Y0 Z0\nSUPA Z500\n",
	 "orient 0 -0.5 0.866025404\nrapid 0 0 0 -30 0\ntcp on length 0 zero A0 C0\n"
	 "rapid 11 20.2320508 33.5980762 -30 0 tcp\ntcp off length 0 zero A0 C0\n"
	 "orient 0 -0.707106781 0.707106781\nrapid 11 20.2320508 33.5980762 -45 0\n"
	 "tcp on length 0 zero A0 C0\nrapid 11 20.2320508 33.5980762 -45 0 tcp\n"
	 "tcp off length 0 zero A0 C0\nrapid 11 20.2320508 500 -45 0\ntcp on length 0 zero A0 C0\n"},
	/* A new plane deletes programmable frames, an added one takes them in; where limits leave one solution, DIR does
	 * not choose. */
	{"G500 TRANS X100\nAROT Z45\nCYCLE800(0,\"\",0,57,10,20,30,30,0,0,1,2,3,1)\nG0 X0 Y0 Z0\n"
	 "ATRANS X7\nAROT X15\nCYCLE800(0,\"\",1,57,0,0,0,0,0,0,0,0,0,-1)\nG0 X-7 Y0 Z0\nCYCLE800()\nTRANS\nX1\n",
	 "orient 0 -0.5 0.866025404\nrapid 0 0 0 -30 0\ntcp on length 0 zero A0 C0\n"
	 "rapid 11 20.2320508 33.5980762 -30 0 tcp\ntcp off length 0 zero A0 C0\n"
	 "orient 0 -0.707106781 0.707106781\nrapid 11 20.2320508 33.5980762 -45 0\n"
	 "tcp on length 0 zero A0 C0\nrapid 11 20.2320508 33.5980762 -45 0 tcp\n"
	 "tcp off length 0 zero A0 C0\nrapid 1 20.2320508 33.5980762 -45 0\n"},
	/* Positions of the machine's axes do not depend on what CYCLE800() did to a frame. */
	{"G500 TRANS X100\nCYCLE800()\nSUPA G0 Z5\nTRANS Y1\nX2 Y2\n", "rapid 0 0 5 0 0\nrapid 2 3 5 0 0\n"},
	{"G500 CYCLE800(1,\"\",0,27,0,0,0,90,0,0,0,0,0,1)\nG0 X1 Y0 Z0\n",
	 "orient 0 0 1\nrapid 0 0 400 0 0\nrapid 0 0 400 0 0\ntcp on length 0 zero A0 C0\n"
	 "rapid 0 1 0 0 0 tcp\n"},
	{"G500 CYCLE800(2,\"\",0,39,0,0,0,0,10,0,0,0,0,-1)\nCYCLE800(0,\"0\")\n",
	 "orient 0 -0.173648178 0.984807753\nrapid 0 0 400 0 0\nrapid -7 -8 400 0 0\n"
	 "rapid -7 -8 400 -10 0\ntcp on length 0 zero A0 C0\ntcp off length 0 zero A0 C0\n"},
	/* Solid angles: about Z, and then about the new Y; A90 B-30 tilts towards -Y. */
	{"G500 CYCLE800(4,\"\",200000,64,0,0,0,90,-30,0,0,0,0,-1)\nG500 G0 X1 Y0 Z0\n",
	 "orient 0 -0.5 0.866025404\nrapid 0 0 500 0 0\nrapid 0 0 500 -30 0\ntcp on length 0 zero A0 C0\n"
	 "rapid 0 0.866025404 0.5 -30 0 tcp\n"},
	{"G500 CYCLE800(5,\"\",110000,57,0,0,0,30,0,0,0,0,0,-1,25)\nG500 G0 X0 Y1 Z0\n",
	 "orient 0 -0.5 0.866025404\nrapid 0 0 25 0 0\nrapid 0 0 25 -30 0\ntcp on length 0 zero A0 C0\n"
	 "rapid 0 0.866025404 0.5 -30 0 tcp\n"},
	/* MODE=192 with zeros: the rotary axes go home. */
	{"G500 G0 A-30 C10\nCYCLE800(0,\"\",0,192,0,0,0,0,0,0,0,0,0,1)\nX1 Y2\nCYCLE800(0,\"\",0,192,5,0,0,0,0,0,0,0,0,0)\n"
	 "X1 Y2 Z3\n",
	 "rapid 0 0 0 -30 10\nrapid 0 0 0 0 0\nrapid 1 2 0 0 0\n"
	 "tcp on length 0 zero A0 C0\nrapid 6 2 3 0 0 tcp\n"},
	{"G500 G0 A-30\nCYCLE800(0,\"\",0,57,0,0,0,30,0,0,0,0,0,0)\nG0 X0 Y1 Z0\n",
	 "rapid 0 0 0 -30 0\norient 0 -0.5 0.866025404\ntcp on length 0 zero A0 C0\n"
	 "rapid 0 0.866025404 0.5 -30 0 tcp\n"},
	/* Another work offset while a plane is swivelled counts for the next plane; X10 Y20 Z30 is G54. */
	{"G500 CYCLE800(0,\"\",0,57,0,0,0,30,0,0,0,0,0,-1)\nG54 SUPA G0 Z50\n"
	 "CYCLE800(0,\"\",0,57,0,0,0,30,0,0,0,0,0,-1)\nX0 Y1 Z0\n",
	 "orient 0 -0.5 0.866025404\nrapid 0 0 0 -30 0\ntcp on length 0 zero A0 C0\n"
	 "tcp off length 0 zero A0 C0\nrapid 0 0 50 -30 0\ntcp on length 0 zero A0 C0\n"
	 "tcp off length 0 zero A0 C0\norient 0 -0.5 0.866025404\nrapid 0 0 50 -30 0\ntcp on length 0 zero A0 C0\n"
	 "rapid 10 20.8660254 30.5 -30 0 tcp\n"},
	/* Angles of zero turn the axes home, and nothing is swivelled; a shift is a plane, too. */
	{"G500 G0 A-30\nCYCLE800(0,\"\",0,57,0,0,0,0,0,0,0,0,0,-1)\nG500 G0 X1 C5\nTRAORI\nG500 X2\n",
	 "rapid 0 0 0 -30 0\norient 0 0 1\nrapid 0 0 0 0 0\nrapid 1 0 0 0 5\ntcp on length 0 zero A0 C0\n"
	 "rapid 2 -0.0871557427 0 0 5 tcp\n"},
	{"G500 G0 A-30\nCYCLE800(0,\"\",0,57,1,0,0,0,0,0,0,0,0,-1)\nG500 G0 X1\n",
	 "rapid 0 0 0 -30 0\norient 0 0 1\nrapid 0 0 0 0 0\ntcp on length 0 zero A0 C0\nrapid 2 0 0 0 0 tcp\n"},
	{"TRAORI\nG500 G0 X10 Y0 Z5\nC90\nX0\nTRAFOOF\nX1 Y1 Z1\n",
	 "tcp on length 0 zero A0 C0\nrapid 10 0 5 0 0 tcp\nrapid 10 0 5 0 90 tcp\n"
	 "rapid 0 0 5 0 90 tcp\ntcp off length 0 zero A0 C0\nrapid 1 1 1 0 90\n"},
	{"T1 D1 M6\nTRAORI\nG54\nG1 F6 X1 C10\nD0 X2\nTRAFOOF\nX0 Y0 Z0\n",
	 "tool 1\ntcp on length 100 zero A0 C0\nfeed 11 0 -100 0 10 tcp\n"
	 "tcp on length 0 zero A0 C0\nfeed 12 0 0 0 10 tcp\ntcp off length 0 zero A0 C0\n"
	 "feed 10 20 30 0 10\n"},
	{"G500 G0 X1 Y2 Z3\nTRAORI(1)\nG1 F6 X2 A3=0 B3=1 C3=1\nROT Z180\n"
	 "X1 Y1 Z1 A3=0 B3=1 C3=1\n",
	 "rapid 1 2 3 0 0\ntcp on length 0 zero A0 C0\norient 0 0.707106781 0.707106781\n"
	 "feed 2 2 3 45 0 tcp\norient 0 -0.707106781 0.707106781\nfeed -1 -1 1 -45 0 tcp\n"},
	/* On a great circle in pieces, each with its part of the way, and of the time under G93. */
	{"G500 TRAORI ORIWKS ORIVECT\nG1 F6 X8 A40\nA3=0 B3=0 C3=1\nX9 A3=0 B3=0 C3=2\n",
	 "tcp on length 0 zero A0 C0\nfeed 2 0 0 10 0 tcp\nfeed 4 0 0 20 0 tcp\nfeed 6 0 0 30 0 tcp\n"
	 "feed 8 0 0 40 0 tcp\nfeed 8 0 0 30 0 tcp\nfeed 8 0 0 20 0 tcp\nfeed 8 0 0 10 0 tcp\n"
	 "feed 8 0 0 0 0 tcp\nfeed 9 0 0 0 0 tcp\n"},
	{"G500 TRAORI ORIWKS ORIAXES\nG93 F2 X1 A10\nG94 F6 X2 A20\n",
	 "tcp on length 0 zero A0 C0\nfeed 1 0 0 10 0 tcp\nfeed 2 0 0 20 0 tcp\n"},
};

START_TEST(moves)
{
	struct gcode_case c;

	sinumerik_case_init(&c);
	ck_assert_msg(case_run(&c, programs[_i].text), "%s%s", programs[_i].text, strbuf_text(&c.messages));
	ck_assert_str_eq(strbuf_text(&c.moves), programs[_i].moves);
	case_release(&c);
}
END_TEST

/* CYCLE800() leaves TRANS X100, or deletes it; ATRANS adds to what there is. */
START_TEST(frames_after_cycle800)
{
	static const char text[] = "G500 TRANS X100\nCYCLE800()\nG0 X1\nATRANS Y5\nX2 Y2\n";
	struct gcode_case c;

	sinumerik_case_init(&c);
	c.config.controller.frames_outlive_cycle800 = ANSWER_YES;
	ck_assert_msg(case_run(&c, text), "%s", strbuf_text(&c.messages));
	ck_assert_str_eq(strbuf_text(&c.moves), "rapid 101 0 0 0 0\nrapid 102 7 0 0 0\n");
	case_release(&c);
	sinumerik_case_init(&c);
	c.config.controller.frames_outlive_cycle800 = ANSWER_NO;
	ck_assert_msg(case_run(&c, text), "%s", strbuf_text(&c.messages));
	ck_assert_str_eq(strbuf_text(&c.moves), "rapid 1 0 0 0 0\nrapid 2 7 0 0 0\n");
	case_release(&c);
}
END_TEST

/* If the active edge is not certain, the machine's position is known and the program's is not. */
START_TEST(position_of_unknown_edge)
{
	struct gcode_case c;

	sinumerik_case_init(&c);
	c.config.controller.edge_after_tool_change = EDGE_AFTER_TOOL_CHANGE_UNKNOWN;
	ck_assert(!case_run(&c, "G500 T1 D1\nM6\nR1=$AA_IM[Z]\nR1=$AA_IW[Z]\n"));
	ck_assert_msg(strstr(strbuf_text(&c.messages), "p.nc:4:4: error: a parameter of the control (MD20270) decides"), "%s",
		      strbuf_text(&c.messages));
	case_release(&c);
}
END_TEST

/* The message for a block that needs the edge names the parameter and the answer. */
START_TEST(unknown_edge)
{
	static const char *const blocks[] = {"TRAORI", "CYCLE800(0,\"\",0,57,0,0,0,30,0,0,0,0,0,1)", "G41 G1 X5", "R1=$P_TOOL",
					     "R1=$P_TOOLL[1]", "R1=$P_TOOLR", "X1"};
	struct strbuf program = {0};
	struct gcode_case c;

	sinumerik_case_init(&c);
	c.config.controller.edge_after_tool_change = EDGE_AFTER_TOOL_CHANGE_UNKNOWN;
	strbuf_addf(&program, "F6 G500 T1 M6\n%s\n", blocks[_i]);
	ck_assert_msg(!case_run(&c, strbuf_text(&program)), "%s", blocks[_i]);
	ck_assert_msg(strstr(strbuf_text(&c.messages), "error: a parameter of the control (MD20270) decides which D holds after "
						       "M6: write D, or set edge_after_tool_change="),
		      "%s: %s", blocks[_i], strbuf_text(&c.messages));
	strbuf_release(&program);
	case_release(&c);
}
END_TEST

struct t_case {
	enum answer changes;
	const char *program, *moves;	/* NULL: it is asked */
};

/* MD22550: does T by itself change the tool? */
static const struct t_case t_cases[] = {
	{ANSWER_UNKNOWN, "G500 T1 D1\nG0 X1\n", NULL},
	{ANSWER_UNKNOWN, "G500 T1\nG0 C1\nSUPA X3 Z5\nM6\nX1 Z1\nT2\nX2\n",
	 "rapid 0 0 0 0 1\nrapid 3 0 5 0 1\ntool 1\nrapid 1 0 101 0 1\nrapid 2 0 101 0 1\n"},
	/* The M6 behind the move says what T does. */
	{ANSWER_UNKNOWN, "G500 T1\nG0 X3 Z5\nM6\nZ1\n",
	 "rapid 3 0 5 0 0\ntool 1\nrapid 3 0 101 0 0\n"},
	{ANSWER_UNKNOWN, "G500 T1\nG0 X3\nG0X2T2M06\n", "rapid 3 0 0 0 0\ntool 2\nrapid 2 0 0 0 0\n"},
	{ANSWER_UNKNOWN, "G500 T1\nG0 X1\n;M6\nMSG(\"M6\")\nM60\nM6.6\nM_M6=1\nT1M6=3\n%_N_L6_SPF\nM6\n", NULL},
	/* Lines after the end may never run, and an M6 before the end counts. */
	{ANSWER_UNKNOWN, "G500 T1 D1\nG0 X1\nM30\nM6\n", NULL},
	{ANSWER_UNKNOWN, "G500 T1 D1\nG0 X1\nG0 M02\nT2 M6\n", NULL},
	{ANSWER_UNKNOWN, "G500 T1 D1\nG0 X1\nM17\nM6\n", NULL},
	{ANSWER_UNKNOWN, "G500 T1\nG0 X1\nM6 M30\n", "rapid 1 0 0 0 0\ntool 1\n"},
	{ANSWER_UNKNOWN, "G500 T0\nG0 X1\n", "rapid 1 0 0 0 0\n"},
	{ANSWER_NO, "G500 T1 D0\nG0 X1 Z5\n", "rapid 1 0 5 0 0\n"},
	{ANSWER_YES, "G500 T1 D0\nG0 X1 Z5\nT2\nZ6\nM6\nT=\"MILL10\" D1 Z7\nT0\nZ8\n",
	 "tool 1\nrapid 1 0 5 0 0\ntool 2\nrapid 1 0 56 0 0\ntool 1\nrapid 1 0 107 0 0\ntool 0\nrapid 1 0 8 0 0\n"},
};

START_TEST(t_without_m6)
{
	const struct t_case *row = &t_cases[_i];
	struct gcode_case c;

	sinumerik_case_init(&c);
	c.config.controller.t_changes_tool = row->changes;
	ck_assert_msg(case_run(&c, row->program) == (row->moves != NULL), "%s%s", row->program, strbuf_text(&c.messages));
	if (row->moves)
		ck_assert_str_eq(strbuf_text(&c.moves), row->moves);
	else
		ck_assert_msg(strstr(strbuf_text(&c.messages), "T without any M6: a parameter of the control (MD22550)"),
			      "%s", strbuf_text(&c.messages));
	case_release(&c);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("programs");

	tcase_add_loop_test(tcase, moves, 0, COUNT(programs));
	tcase_add_test(tcase, frames_after_cycle800);
	tcase_add_test(tcase, position_of_unknown_edge);
	tcase_add_loop_test(tcase, unknown_edge, 0, 7);
	tcase_add_loop_test(tcase, t_without_m6, 0, COUNT(t_cases));
	return run_suite("gcode_sinumerik_cycle", tcase);
}
