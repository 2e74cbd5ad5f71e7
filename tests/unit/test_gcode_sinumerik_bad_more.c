/* test_gcode_sinumerik_bad_more.c - programs of the sinumerik dialect that are refused, each with message and place. */
#include "sinumerik_case.h"

struct bad {
	const char *program;
	int line, column;	/* column 0: the line as a whole */
	const char *message;
};

static const struct bad programs[] = {
	{"PROC\n", 1, 5,
	 "PROC needs the name of its subprogram"},
	{"CALL\n", 1, 5,
	 "a value is needed here"},
	{"CALL \"../.SPF\"\n", 1, 6,
	 ".SPF is neither a word that is known nor a subprogram: no file .SPF.SPF (or .spf, .MPF, .mpf, in "
	 "upper or lower case) lies beside the program or in a folder of --include"},
	{"EXTCALL \"NOSUCH\"\n", 1, 9,
	 "NOSUCH is neither a word that is known nor a subprogram: no file NOSUCH.SPF (or .spf, .MPF, .mpf, "
	 "in upper or lower case) lies beside the program or in a folder of --include"},
	{"NOSUCH\n", 1, 1,
	 "NOSUCH is neither a word that is known nor a subprogram: no file NOSUCH.SPF (or .spf, .MPF, .mpf, "
	 "in upper or lower case) lies beside the program or in a folder of --include"},
	{"NOSUCH(1,2)\n", 1, 1,
	 "NOSUCH is neither a word that is known nor a subprogram: no file NOSUCH.SPF (or .spf, .MPF, .mpf, "
	 "in upper or lower case) lies beside the program or in a folder of --include"},
	{"L100 P2\n", 1, 1,
	 "there is no file L100.SPF (or .spf, .MPF, .mpf, in upper or lower case) beside the program or in "
	 "a folder of --include; if L100 is the builder's and moves no axis, <macro program=\"100\" "
	 "action=\"none\"/> in the machine's <controller> says so"},
	{"L\n", 1, 1,
	 "L without a number"},
	{"X1 NOSUCH\n", 1, 4,
	 "a call stands in a block without axis words"},
	{"NOSUCH X1\n", 1, 1,
	 "a call stands in a block without axis words"},
	{"NOSUCH(1) Y5\n", 1, 11,
	 "nothing can follow a call in its block"},
	{"MCALL POCKET1(1)\n", 1, 7,
	 "POCKET1: milling of a pocket is not supported yet"},
	{"POCKET4(1)\n", 1, 1,
	 "POCKET4: milling of a pocket is not supported yet"},
	{"CYCLE61(1)\n", 1, 1,
	 "CYCLE61: milling of a contour is not supported yet"},
	{"CYCLE977(1)\n", 1, 1,
	 "CYCLE977: turning or measuring is not supported yet"},
	{"CYCLE899(1)\n", 1, 1,
	 "CYCLE899: milling of a slot is not supported yet"},
	{"CYCLE81(10,0,2)\n", 1, 1,
	 "the cycle needs RTP, RFP and one of DP and DPR"},
	{"CYCLE81(-1,0,2,-5)\n", 1, 1,
	 "the return plane RTP must not lie below the reference plane RFP, and the depth not above it (the "
	 "control's alarm 61101): RTP -1, RFP 0, depth -5 mm"},
	{"CYCLE81(10,0,2,5)\n", 1, 1,
	 "the return plane RTP must not lie below the reference plane RFP, and the depth not above it (the "
	 "control's alarm 61101): RTP 10, RFP 0, depth 5 mm"},
	{"CYCLE81(10,0,2,-5,4)\n", 1, 1,
	 "the depths DP and DPR differ: -5 and -4 mm; give one of them"},
	{"CYCLE85(10,0,2,-5)\n", 1, 1,
	 "CYCLE85 needs its feeds FFR and RFF"},
	{"CYCLE84(10,0,2,-5)\n", 1, 1,
	 "tapping needs a pitch (PIT), or a metric size (MPIT) from 3 to 48, and a speed"},
	{"CYCLE86(10,0,2,-5,,,7)\n", 1, 1,
	 "G1 without a feed rate (F)"},
	{"F6 CYCLE83(10,0,1,-10,,0)\n", 1, 4,
	 "the pecks of CYCLE83 never reach its depth"},
	{"MCALL X1\n", 1, 1,
	 "MCALL stands in a block without axis words"},
	{"CYCLE800(0,\"\",0,128,0,0,0,0,30,0,0,0,0,1)\n", 1, 1,
	 "MODE=128 of CYCLE800, a plane by projection angles, is not supported: in which direction X of the plane "
	 "then points is not certain; axis by axis (MODE=57 and the like) it is"},
	{"CYCLE800(0,\"\",0,192,0,0,0,0,30,0,0,0,0,1)\n", 1, 1,
	 "MODE=192 of CYCLE800, a plane by positions of the rotary axes, is not supported: in which direction X of "
	 "the plane then points is not certain; axis by axis (MODE=57 and the like) it is"},
	{"CYCLE800(0,\"\",0,64,0,0,0,0,0,5,0,0,0,1)\n", 1, 1,
	 "MODE=64 of CYCLE800 names no axis for angle 3"},
	{"CYCLE800(0,\"\",0,300,0,0,0,0,30,0,0,0,0,1)\n", 1, 1,
	 "MODE of CYCLE800 must lie between 0 and 255, not 300"},
	{"CYCLE800(0,\"\",0,57,0,0,0,0,0,0,0,0,0,2)\n", 1, 1,
	 "DIR of CYCLE800 must be -1, 0 or 1"},
	{"CYCLE800(0,\"\",0,57,0,0,0,30,0,0,0,0,0,0)\n", 1, 1,
	 "CYCLE800 with DIR=0 moves no axis, and the tool does not stand on this plane; turn the rotary axes first, or "
	 "give DIR 1 or -1"},
	{"CYCLE800(0,\"\",10,57,0,0,0,0,0,0,0,0,0,1)\n", 1, 1,
	 "CYCLE800 that guides the tool's tip while it swivels (tens of ST) is not supported yet"},
	{"CYCLE800(0,\"\",200100,57,0,0,0,0,0,0,0,0,0,1)\n", 1, 1,
	 "CYCLE800 that sets the tool up (hundreds of ST) is not supported yet"},
	{"CYCLE800(0,\"\",300000,57,0,0,0,0,0,0,0,0,0,1)\n", 1, 1,
	 "the hundred thousands of ST of CYCLE800 must be 0, 1 or 2"},
	{"G500 G0 C30\nCYCLE800(0,\"\",0,57,0,0,0,0,0,0,0,0,0,1)\n", 2, 1,
	 "the tool stands on the plane of CYCLE800 whatever the position of C: whether C then goes to 0 is set up by "
	 "the machine's maker: swivel_pole=\"zero\" or \"stays\" of the machine's <controller> says it"},
	{"CYCLE800(0,\"\",0,57,0,0,0,30,0,0,0,0,0,1)\n", 1, 1,
	 "CYCLE800 with DIR=1: no position within the limits stands the tool on the plane with A positive"},
	{"CYCLE800(3,\"\",0,57,0,0,0,0,0,0,0,0,0,1)\n", 1, 1,
	 "FR of CYCLE800 must be 0, 1, 2, 4 or 5, not 3"},
	{"CYCLE800(5,\"\",0,57,0,0,0,0,0,0,0,0,0,1,-1)\n", 1, 1,
	 "FR=5 of CYCLE800 needs a way FR_I that is not negative"},
	{"CYCLE832(-1)\n", 1, 1,
	 "the tolerance of CYCLE832 cannot be negative"},
	{"CYCLE800(0,\"\",0,8,0,0,0,10,0,0,0,0,0,1)\n", 1, 1,
	 "MODE=8 of CYCLE800 names no axis for angle 1"},
	{"CYCLE800(0.5)\n", 1, 1,
	 "FR of CYCLE800 must be a whole number, not 0.5"},
	{"G500 TRANS X1\nCYCLE800(0,\"\",0,57,0,0,0,0,0,0,0,0,0,1)\n", 2, 1,
	 "CYCLE800 while TRANS, ROT, SCALE or MIRROR is in force is not supported yet; give the shift in X0 "
	 "Y0 Z0 or behind it"},
	{"CYCLE800(0,\"\",0,57,0,0,0,0,0,0,0,0,0,1)\nG500 G0 C5\n", 2, 9,
	 "C while CYCLE800 has swivelled: the tool would leave the direction of its plane; CYCLE800() first"},
	{"CYCLE800(0,\"\",0,57,0,0,0,0,0,0,0,0,0,1)\nG505\n", 2, 1,
	 "another work offset while CYCLE800 has swivelled; CYCLE800() first"},
	{"CYCLE800(0,\"\",0,57,0,0,0,0,0,0,0,0,0,1)\nTRAORI\n", 2, 1,
	 "TRAORI while CYCLE800 has swivelled; CYCLE800() first"},
	{"TRAORI\nCYCLE800(0,\"\",0,57,0,0,0,0,0,0,0,0,0,1)\n", 2, 1,
	 "CYCLE800 while TRAORI is on; TRAFOOF first"},
	{"TRAORI\nSUPA G0 Z5\n", 2, 1,
	 "positions of the machine's axes (SUPA, G53, G153) while TRAORI is on; TRAFOOF first"},
	{"TRAORI\nG74 X1=0\n", 2, 1,
	 "G74 while TRAORI is on; TRAFOOF first"},
	{"TRAORI ORIVECT\nG500 G0 C5\n", 2, 9,
	 "the great circle (ORIVECT) ends with C at 0 degrees, and the block gives 5: the control changes over at the pole "
	 "or alarms; ORIAXES turns the axes evenly"},
	{"TRAORI ORIVECT ORIMKS\nG500 G0 A5\n", 2, 9,
	 "a great circle (ORIVECT) in the machine's coordinates (ORIMKS) is not supported; use ORIWKS"},
	{"TRAORI ORIVECT\nG500 G1 F6 X1 A3=0 B3=0 C3=-1\n", 2, 12,
	 "the tool turns round to the opposite direction: the plane of a great circle (ORIVECT) is not certain"},
	{"TRAORI ORIVECT\nG500 F6 G2 X1 CR=1 A5\n", 2, 9,
	 "a circle during which the tool turns on a great circle (ORIVECT) is not supported yet"},
	{"TRAORI ORIVECT\nG500 F6 X1 A5 RND=1\n", 2, 9,
	 "CHF, CHR or RND in a block that turns the tool is not supported"},
	{"TRAORI\nG500 G0 A3=0 B3=0 C3=0\n", 2, 1,
	 "the direction A3= B3= C3= has no length"},
	{"TRAORI\nG500 G0 C5 A3=0 C3=1\n", 2, 9,
	 "the block turns the tool by C and by a direction (A3= B3= C3=)"},
	{"TRAORI ORIMKS\nG500 G0 A3=0 C3=1\n", 2, 1,
	 "a direction A3= B3= C3= with ORIMKS is not supported yet; use ORIWKS"},
	{"TRAORI\nG500 G0 LEAD=5\n", 2, 9,
	 "LEAD: orientation by an angle of lead is not supported yet"},
	{"TRANSMIT\n", 1, 1,
	 "TRANSMIT: milling on the face of a turning part is not supported yet"},
	{"TRACYL(40)\n", 1, 1,
	 "TRACYL: milling on a cylinder is not supported yet"},
	{"ORIPATH\n", 1, 1,
	 "ORIPATH: orientation by the path is not supported yet"},
	{"ASPLINE X1\n", 1, 1,
	 "ASPLINE: spline interpolation is not supported yet"},
	{"BSPLINE\n", 1, 1,
	 "BSPLINE: spline interpolation is not supported yet"},
	{"POLY X1\n", 1, 1,
	 "POLY: polynomial interpolation is not supported yet"},
	{"RND=5\n", 1, 1,
	 "CHF, CHR and RND need a block with G1, G2 or G3"},
	{"CHF=2\n", 1, 1,
	 "CHF, CHR and RND need a block with G1, G2 or G3"},
	{"POS[X]=5\n", 1, 1,
	 "POS: positioning axis is not supported yet"},
	{"MEAS=1 X1\n", 1, 1,
	 "MEAS: measuring with a probe is not supported yet"},
	{"ID=1 WHEN $A_IN[1]==1 DO M5\n", 1, 1,
	 "ID: synchronous action is not supported yet"},
	{"WHENEVER 1==1 DO M5\n", 1, 1,
	 "WHENEVER: synchronous action is not supported yet"},
	{"G4\n", 1, 1,
	 "G4 needs its time: F in seconds, or S in turns of the spindle"},
	{"G4 S5\n", 1, 1,
	 "G4 S counts turns of the spindle, whose speed is not known"},
	{"G4 F-1\n", 1, 1,
	 "a dwell cannot be negative"},
	{"G4 F1 X5\n", 1, 7,
	 "G4 stands in a block without motion"},
	{"G75\n", 1, 1,
	 "G75 needs the axes that it moves: X1=0 and the like"},
	{"G75 FP=9 X1=0\n", 1, 1,
	 "G75 FP= must be a whole number from 1 to 3"},
	{"G0 X1=5\n", 1, 4,
	 "names of the machine's axes (X1=) are supported with G74 and G75 only"},
	{"FP=1\n", 1, 1,
	 "FP belongs to G75"},
	{"P5\n", 1, 1,
	 "P belongs to the call of a subprogram"},
	{"F-1\n", 1, 1,
	 "a feed rate cannot be negative"},
	{"S-1\n", 1, 1,
	 "a spindle speed cannot be negative"},
	{"S2=5\n", 1, 1,
	 "S2: other spindles than the first are not supported yet"},
	{"R1 5\n", 1, 1,
	 "a blank inside the number of R; what a control makes of it differs"},
	{"DEF REAL AB=1 2x\n", 1, 13,
	 "a blank inside a number"},
	{"M2=3\n", 1, 1,
	 "M2: other spindles than the first are not supported yet"},
	{"T-1\n", 1, 1,
	 "T must be a whole number that is not negative, not -1"},
	{"T1.5\n", 1, 1,
	 "T must be a whole number that is not negative, not 1.5"},
	{"T=\"NOSUCH\"\n", 1, 1,
	 "the setup defines no tool of the name \"NOSUCH\": add <tool number=\"\" name=\"NOSUCH\" length=\"\"/> "
	 "with what it is made of"},
	{"M6\n", 1, 1,
	 "M6, but no T has selected a tool"},
	{"T9 M6\n", 1, 4,
	 "the setup defines no tool T9: add <tool number=\"9\" length=\"\"/> with what it is made of"},
	{"T1 M6 D7\n", 1, 7,
	 "the setup defines no edge D7 of tool T1: add <edge number=\"7\" length=\"\"/> to it"},
	{"D1.5\n", 1, 1,
	 "D must be a whole number from 0 to 32000, not 1.5"},
	{"T1 M6 G18 D1\nG500 G0 Z1\n", 2, 9,
	 "in the plane of G18 a parameter of the control (SD42940) decides along which axis the tool's "
	 "length acts: tool_length_axis=\"z\" of the machine's <controller> says that it is Z in every plane; "
	 "the other way is not supported"},
	{"G56\n", 1, 1,
	 "the setup defines no work offset G56: add <work_offset name=\"G56\" X=\"\" Y=\"\" Z=\"\"/> with its values"},
	{"G500 G0 C=DC(10)\n", 1, 9,
	 "DC, ACP and ACN are for rotary axes that count modulo 360 degrees; wrap=\"shortest\" of this axis "
	 "in the machine file says that C is one"},
	{"G500 G0 X=DC(10)\n", 1, 9,
	 "DC, ACP and ACN are for rotary axes that count modulo 360 degrees; wrap=\"shortest\" of this axis "
	 "in the machine file says that X is one"},
	{"G500 G0 X=CAC(1)\n", 1, 11,
	 "positions of a table of the control (CAC)"},
	{"SUPA G0 X=IC(5)\n", 1, 9,
	 "positions of the machine's axes are absolute; an increment beside SUPA, G53 or G153 is not supported"},
	{"SUPA G91 G0 X5\n", 1, 13,
	 "positions of the machine's axes are absolute; an increment beside SUPA, G53 or G153 is not supported"},
	{"SUPA F6 G2 X5 I1\n", 1, 1,
	 "SUPA, G53 and G153 need G0 or G1, not a circle"},
	{"G500 G0 X1\nTRANS X5\nX=IC(1)\n", 3, 1,
	 "X by an increment after a change of frames, offsets or the tool: settings of the control "
	 "(SD42440, SD42442) decide whether the change is traversed, too: "
	 "increments_after_shift=\"traverse\" or \"stay\" of the machine's <controller> says it"},
	{"SETAL(65000\n", 1, 6,
	 "this '(' is not closed"},
	{"MSG(\"a\"\n", 1, 4,
	 "this '(' is not closed"},
	{"T=\"abc\n", 1, 3,
	 "this text is not closed: '\"' is missing"},
	{"ISOCALL \"X\"\n", 1, 1,
	 "ISOCALL: call of a program in ISO mode is not supported yet"},
	{"DIAMON\n", 1, 1,
	 "DIAMON: diameter programming is not supported yet"},
	{"KONTC\n", 1, 1,
	 "KONTC: start of cutter compensation on a curve is not supported yet"},
	{"G461\n", 1, 1,
	 "G461: end of cutter compensation, drawn out by a circle is not supported yet"},
	{"OFFN=1\n", 1, 1,
	 "OFFN: allowance of the contour is not supported yet"},
	{"RTLIOF\n", 1, 1,
	 "RTLIOF: rapids in which each axis goes at its own rate is not supported yet"},
	{"TCARR=1\n", 1, 1,
	 "TCARR: orientable tool carrier is not supported yet"},
	{"TOROT\n", 1, 1,
	 "TOROT: frame in the direction of the tool is not supported yet"},
	{"x(5)\n", 1, 1,
	 "X without a number"},
	{"G500 G43 X1\n", 1, 6,
	 "G43 is not known; it is a code of ISO mode (G291), the language of Fanuc, which is not read here"},
	{"5\n", 1, 1,
	 "unexpected '5'"},
	{"!\n", 1, 1,
	 "unexpected '!'"},
	{"X1 ) Y2\n", 1, 4,
	 "unexpected ')'"},
	{"G\n", 1, 1,
	 "G without a number"},
	{"M\n", 1, 1,
	 "M without a number"},
	{"G500 G2 X5 R5 F6\n", 1, 12,
	 "R5 needs '=' and a value; the radius of a circle is CR="},
};

/* The message is the only one, and the caret stands below the column of the line that it names. */
START_TEST(refused)
{
	const struct bad *bad = &programs[_i];
	struct strbuf expected = {0};
	const char *line = bad->program;
	struct gcode_case c;

	sinumerik_case_init(&c);
	ck_assert_msg(!case_run(&c, bad->program), "accepted: %s", bad->program);
	for (int i = 1; i < bad->line; i++)
		line = strchr(line, '\n') + 1;
	if (bad->column)
		strbuf_addf(&expected, "p.nc:%d:%d: error: %s\n    %.*s\n    %*s\n", bad->line, bad->column, bad->message,
			    (int)strcspn(line, "\n"), line, bad->column, "^");
	else
		strbuf_addf(&expected, "p.nc:%d: error: %s\n", bad->line, bad->message);
	ck_assert_str_eq(strbuf_text(&c.messages), strbuf_text(&expected));
	strbuf_release(&expected);
	case_release(&c);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("gcode_sinumerik_bad_more");
	TCase *tcase = tcase_create("programs");
	SRunner *runner;
	int failed;

	tcase_add_loop_test(tcase, refused, 0, sizeof(programs) / sizeof(programs[0]));
	suite_add_tcase(suite, tcase);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
