/* test_gcode_sinumerik_block.c - small programs of the sinumerik dialect: blocks, circles, frames, tools. */
#include "sinumerik_case.h"

struct program {
	const char *text, *moves;
};

static const struct program programs[] = {
	{"G54 G0 X1 Y2 Z3\n",
	 "rapid 11 22 33 0 0\n"},
	{"G505 G0 X1 Y2 Z3\n",
	 "rapid 2 4 6 0 0\n"},
	{"G500 G0 X1 Y2 Z3\n",
	 "rapid 1 2 3 0 0\n"},
	{"G500 G1 F6 X1\nX=IC(2) Y=AC(5)\n",
	 "feed 1 0 0 0 0\nfeed 3 5 0 0 0\n"},
	{"G500 G0 X4\nG91 X1 Y-1\nX=AC(0)\nG90 X3.5Y4Z-2\n",
	 "rapid 4 0 0 0 0\nrapid 5 -1 0 0 0\nrapid 0 -1 0 0 0\nrapid 3.5 4 -2 0 0\n"},
	{"G500 G1 X1F100\nx2 y3\n",
	 "feed 1 0 0 0 0\nfeed 2 3 0 0 0\n"},
	{"/ G500 G0 X1\nN10 G500 G0 X2\n:20 X3\nN30\nLABEL_1: X4\n",
	 "rapid 1 0 0 0 0\nrapid 2 0 0 0 0\nrapid 3 0 0 0 0\nrapid 4 0 0 0 0\n"},
	{"%_N_PART_MPF\n;$PATH=/_N_MPF_DIR\nG500 G0 X1\n",
	 "rapid 1 0 0 0 0\n"},
	{"\n ; a comment\n%\nG500 G0 X1\n%\nX2\n",
	 "rapid 1 0 0 0 0\n"},
	{"%_N_NOTHING_MPF\n%_N_OTHER_SPF\nX2\n", ""},
	{"%\nG500 G0 X1\n%\nX2\n",
	 "rapid 1 0 0 0 0\n"},
	{"F6 G500 X1 ; a comment (1) \"2\"\nMSG(\"a; b\"<<R1) MSG()\n"
	 "N20 G64 G601 SOFT FFWON COMPOF FNORM\nSTOPRE\n"
	 "FGROUP(X,Y) OVR=50 ACC[X]=80 LIMS=3000 FGREF[A]=10\nX2\n",
	 "feed 1 0 0 0 0\nfeed 2 0 0 0 0\n"},
	{"G500 G4 F2\nS600 M3\nG4 S100\nM5 M0 M1\nF6 X1\n",
	 "dwell 2\ndwell 10\nfeed 1 0 0 0 0\n"},
	{"G500 S1=600 M1=3 M8 M9 F6 X1\nSPOS=90 SPOS[1]=45\n",
	 "feed 1 0 0 0 0\n"},
	{"F6 G500 X1\nM2\n",
	 "feed 1 0 0 0 0\n"},
	{"F6 G500 X1\nM17\n",
	 "feed 1 0 0 0 0\n"},
	{"G500 G0 X10\nG2 X20 Y0 I5 J0 F6\n",
	 "rapid 10 0 0 0 0\narc 20 0 0 0 0 centre 15 0 0 normal 0 0 1 sweep -180\n"},
	{"G500 G0 X10\nG3 X20 Y0 CR=5 F6\n",
	 "rapid 10 0 0 0 0\narc 20 0 0 0 0 centre 15 0 0 normal 0 0 1 sweep 180\n"},
	{"G500 G0 X10\nG3 X20 Y0 CR=-13 F6\n",
	 "rapid 10 0 0 0 0\narc 20 0 0 0 0 centre 15 -12 0 normal 0 0 1 sweep 314.76027\n"},
	{"G500 G0 X10\nG2 I5 F6\n",
	 "rapid 10 0 0 0 0\narc 10 0 0 0 0 centre 15 0 0 normal 0 0 1 sweep -360\n"},
	{"G500 G0 X0 Y0\nG3 F6 X10 Y0 AR=180\n",
	 "rapid 0 0 0 0 0\narc 10 0 0 0 0 centre 5 0 0 normal 0 0 1 sweep 180\n"},
	{"G500 G0 X10 Y0\nG3 F6 I-10 AR=90\n",
	 "rapid 10 0 0 0 0\narc 0 10 0 0 0 centre 0 0 0 normal 0 0 1 sweep 90\n"},
	{"G500 G0 X0\nG2 X20 Y0 I=AC(10) J=AC(0) F6\n",
	 "rapid 0 0 0 0 0\narc 20 0 0 0 0 centre 10 0 0 normal 0 0 1 sweep -180\n"},
	{"G500 G91 G2 F6 X=IC(10) CR=5\n",
	 "arc 10 0 0 0 0 centre 5 0 0 normal 0 0 1 sweep -180\n"},
	{"G500 G0 X10\nG3 F6 X10 Y0 Z-6 I-10 TURN=2\n",
	 "rapid 10 0 0 0 0\narc 10 0 -6 0 0 centre 0 0 0 normal 0 0 1 sweep 1080\n"},
	{"G500 G0 X10\nG2 F6 X0 Y-10 Z-6 I-10 TURN=1\n",
	 "rapid 10 0 0 0 0\narc 0 -10 -6 0 0 centre 0 0 0 normal 0 0 1 sweep -450\n"},
	{"G500 CIP F6 X10 Y0 I1=5 J1=5\n",
	 "arc 10 0 0 0 0 centre 5 0 0 normal 0 0 -1 sweep 180\n"},
	{"G500 CIP F6 X20 Z0 I1=10 K1=10\n",
	 "arc 20 0 0 0 0 centre 10 0 0 normal 0 1 0 sweep 180\n"},
	{"G500 G91 CIP F6 X10 I1=5 J1=-5\n",
	 "arc 10 0 0 0 0 centre 5 0 0 normal 0 0 1 sweep 180\n"},
	{"G500 G18 G2 F6 X10 Z0 CR=5\n",
	 "arc 10 0 0 0 0 centre 5 0 0 normal 0 1 0 sweep -180\n"},
	{"G500 G19 G3 F6 Y10 Z0 J5 K0\n",
	 "arc 0 10 0 0 0 centre 0 5 0 normal 1 0 0 sweep 180\n"},
	{"G70 G500 G0 X1 F10\nG71 X1\n",
	 "rapid 25.4 0 0 0 0\nrapid 1 0 0 0 0\n"},
	{"G700 G500 F10 X3\nG710 X25.4\n",
	 "feed 76.2 0 0 0 0\nfeed 25.4 0 0 0 0\n"},
	{"G500 TRANS X10 Y5\nG0 X0 Y0\nATRANS X1\nX0\nTRANS Z3\nX0 Y0 Z0\nTRANS\nX0 Y0 Z0\n",
	 "rapid 10 5 0 0 0\nrapid 11 5 0 0 0\nrapid 0 0 3 0 0\nrapid 0 0 0 0 0\n"},
	{"G500 TRANS C30 A=10\nG0 C0 A0\n",
	 "rapid 0 0 0 10 30\n"},
	{"G500 ROT Z90\nG0 X10 Y0\nAROT Z-90\nX10 Y0\nROT\nX10 Y1\n",
	 "rapid 0 10 0 0 0\nrapid 10 0 0 0 0\nrapid 10 1 0 0 0\n"},
	{"G500 TRANS X100\nAROT Z90\nG0 X10 Y0\nG2 F6 X20 Y0 I5\n",
	 "rapid 100 10 0 0 0\narc 100 20 0 0 0 centre 100 15 0 normal 0 0 1 sweep -180\n"},
	{"G500 ROT Z90\nATRANS X5\nG0 X0 Y0\n",
	 "rapid 0 5 0 0 0\n"},
	{"G500 ROT RPL=30\nG0 X10\nY5\n",
	 "rapid 8.66025404 5 0 0 0\nrapid 6.16025404 9.33012702 0 0 0\n"},
	{"G500 G18 ROT RPL=90\nG0 X0 Z10\n",
	 "rapid 10 0 0 0 0\n"},
	{"G500 ROT X30 Y20 Z10\nG0 X10 Y20 Z30\n",
	 "rapid 20.9704012 6.05395318 30.3906552 0 0\n"},
	{"G54 G1 F6 X1 Z0\nPOS[Y]=5 FA[Y]=100\nG91\nPOS[Z]=IC(2)\nPOS[X]=AC(3)\nX1\n",
	 "feed 11 0 30 0 0\nrapid 11 25 30 0 0\nrapid 11 25 32 0 0\nrapid 13 25 32 0 0\nfeed 14 25 32 0 0\n"},
	/* "Traverse positioning axes (POS)": several at a time each move by themselves, and so beside G0. */
	{"G54 G1 F6 X1 Z0\nPOS[Y]=5 POS[A]=30\nG0 X2 POS[C]=90\nPOS[C]=0\nG1 X3\n",
	 "feed 11 0 30 0 0\nrapid 11 25 30 30 0 apart\nrapid 12 25 30 30 90 apart\nrapid 12 25 30 30 0\n"
	 "feed 13 25 30 30 0\n"},
	{"G500 ROTS X10 Y20\nG0 X10 Y0\nX0 Y10\nX0 Y0 Z10\n",
	 "rapid 9.39692621 0 -3.42020143 0 0\nrapid 0.559081383 9.86549223 1.53606348 0 0\n"
	 "rapid 3.37419707 -1.63464461 9.27053025 0 0\n"},
	{"G500 ROTS Z20 X10\nG0 X0 Y0 Z10\nX10 Z0\nROTS Y20\nAROTS X10\nX0 Y10 Z0\nROT Y20\nAROT X10\nX0 Y10 Z0\n",
	 "rapid 0 -1.73648178 9.84807753 0 0\nrapid 9.41354312 3.32293543 0.585923172 0 0\n"
	 "rapid 0.593911746 9.84807753 1.63175911 0 0\nrapid 0.593911746 9.84807753 1.63175911 0 0\n"},
	{"G500 SCALE X2 Y2 Z2\nG0 X10 Y5\nG3 F6 X10 Y15 CR=5\nATRANS X1\nG0 X0 Y0 Z0\n",
	 "rapid 20 10 0 0 0\narc 20 30 0 0 0 centre 20 20 0 normal 0 0 1 sweep 180\n"
	 "rapid 2 0 0 0 0\n"},
	/* In a plane whose axes are scaled alike a circle stays one; its height is scaled by itself, and X and Y alone. */
	{"G500 SCALE X2 Y2\nG0 X10 Y5\nG3 F6 X10 Y15 Z4 CR=5\n",
	 "rapid 20 10 0 0 0\narc 20 30 4 0 0 centre 20 20 0 normal 0 0 1 sweep 180\n"},
	{"G500 G18 ROT RPL=90\nASCALE X2 Z2\nG0 X10 Z5\nG3 F6 X10 Z15 I0 K5 Y1\n",
	 "rapid 10 0 -20 0 0\narc 30 1 -20 0 0 centre 20 0 -20 normal 0 1 0 sweep 180\n"},
	{"G500 SCALE X2\nG0 X10 Y5\n",
	 "rapid 20 5 0 0 0\n"},
	{"G500 MIRROR X0\nG0 X10 Y0\nG2 F6 X20 Y0 I5\nAMIRROR Y0\nG0 X1 Y1\n",
	 "rapid -10 0 0 0 0\narc -20 0 0 0 0 centre -15 0 0 normal 0 0 1 sweep 180\n"
	 "rapid -1 -1 0 0 0\n"},
	{"G500 MIRROR Z0\nAROT X90\nG0 X1 Y2 Z3\n",
	 "rapid 1 -3 -2 0 0\n"},
	{"T1 M6\nG500 G0 X0 Y0 Z10\nD0 Z10\nD2 Z10\n",
	 "tool 1\nrapid 0 0 110 0 0\nrapid 0 0 10 0 0\nrapid 0 0 100 0 0\n"},
	{"T=\"drill\" M6\nG500 G0 Z10\nT0 M6\nZ10\n",
	 "tool 2\nrapid 0 0 60 0 0\ntool 0\nrapid 0 0 10 0 0\n"},
	{"T1\nM6 T2\nG500 D1 G0 Z1\n",
	 "tool 2\nrapid 0 0 51 0 0\n"},
	{"G500 T1 M6 D1 G0 X1\nSUPA G0 Z5\nSUPA Z5 D0\n",
	 "tool 1\nrapid 1 0 0 0 0\nrapid 1 0 105 0 0\nrapid 1 0 5 0 0\n"},
	{"G54 T1 M6 D1\nG0 X0 Y0 Z0\nG53 X1 Y1 Z1\nG153 G1 F6 X2\nX0 Y0 Z0\n",
	 "tool 1\nrapid 10 20 130 0 0\nrapid 1 1 101 0 0\nfeed 2 1 101 0 0\nfeed 10 20 130 0 0\n"},
	{"G54 G0 X0 Y0\nG505 X0\nG500 X0 Y0\n",
	 "rapid 10 20 0 0 0\nrapid 1 20 0 0 0\nrapid 0 0 0 0 0\n"},
	{"G500 G0 X5 Y6 Z7\nG75 X1=0 Z1=0\nG75 FP=2 Y1=0\nG74 X1=0\nX=AC(9)\n",
	 "rapid 5 6 7 0 0\nrapid 200 6 202 0 0\nrapid 200 301 202 0 0\nrapid 100 301 202 0 0\n"
	 "rapid 9 301 202 0 0\n"},
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

int main(void)
{
	TCase *tcase = tcase_create("programs");

	tcase_add_loop_test(tcase, moves, 0, COUNT(programs));
	return run_suite("gcode_sinumerik_block", tcase);
}
