/* test_gcode_klartext_bad_path.c - what is wrong with circles, corners, radius compensation, APPR and DEP: the exact messages. */
#include "klartext_case.h"

static const struct klartext_fault faults[] = {
	{"L X+1 RL FMAX\n",
	 "p.nc:2:7: error: radius compensation without a tool: TOOL CALL comes first"},
	{"TOOL CALL 3 Z\nL X+1 RR F100\n",
	 "p.nc:3:7: error: the radius of T3 is not known: give the tool of the setup a <cutter>, or diameter=\"\""},
	{"TOOL DEF 1 R4\nTOOL CALL 1 Z\nL X+1 RR F100\n",
	 "p.nc:4:7: error: TOOL DEF gives T1 a radius of 4 mm, and the setup 5 mm: which of them the control takes "
	 "depends on whether its tool table is active; make them agree, or say tool_def=\"ignored\" in the machine's "
	 "<controller> if the table counts"},
	{"TOOL CALL 1 Z DR-6\nL X+1 RR F100\n",
	 "p.nc:3:7: error: the radius of T1 with DR is -1 mm: compensation by a negative radius is not supported"},
	{"TOOL CALL 1 Z\nL Z+1 RR F100\n",
	 "p.nc:3:7: error: radius compensation starts in a straight line that moves in the plane of X and Y"},
	{"TOOL CALL 1 Z\nL RL\n",
	 "p.nc:3:3: error: radius compensation starts in a straight line that moves in the plane of X and Y"},
	{"TOOL CALL 1 Z\nL M128\nL X+1 RR F100\n",
	 "p.nc:4:7: error: radius compensation while M128 is in force is not supported; post the path of the tool's "
	 "centre with R0"},
	{"TOOL CALL 1 Z\nL X+1 RR F100\nL X+20 RL\n",
	 "p.nc:4:8: error: RL while the tool is on the other side of the path: the manual wants a block with R0 between"},
	{"TOOL CALL 1 Z\nL X+1 RR F100\nL X+20 R0\n",
	 "p.nc:4:8: error: R0 right behind the first block of radius compensation is not supported"},
	{"TOOL CALL 1 Z\nL X+1 RR F100 M120 LA5\n",
	 "p.nc:3:7: error: radius compensation with M120: it leaves out what the tool cannot reach, which is not supported "
	 "yet; post the path of the tool's centre with R0"},
	{"TOOL CALL 1 Z\nL X+1 RR F100\nL X+20 M120 LA5\n",
	 "p.nc:4:8: error: M120 under radius compensation is not supported; R0 comes first"},
	{"TOOL CALL 1 Z\nL X+1 RR F100\nL X+20 M98\n",
	 "p.nc:4:8: error: M98 under radius compensation is not supported; R0 comes first"},
	{"TOOL CALL 1 Z\nL X+1 RR F100\nL X+20 M128\n",
	 "p.nc:4:8: error: M128 under radius compensation is not supported; R0 comes first"},
	{"TOOL CALL 1 Z\nL X+1 RR F100\nL X+20 A+5\n",
	 "p.nc:4:3: error: axes other than X, Y and Z under radius compensation are not supported"},
	{"TOOL CALL 1 Z\nL X+1 RR F100\nL X+20 M91\n",
	 "p.nc:4:8: error: M91 under radius compensation is not supported: R0 comes first"},
	{"TOOL CALL 1 Z\nL X+1 RR F100\nPLANE RESET STAY\n",
	 "p.nc:4:6: error: PLANE under radius compensation is not supported; a block with R0 comes first"},
	{"TOOL CALL 1 Z\nL X+1 RR F100\nCALL PGM X\n",
	 "p.nc:4:10: error: CALL PGM under radius compensation is not supported; R0 comes first"},
	{"TOOL CALL 1 Z\nL X+10 RR F100\nL X+20\nL X+10\n",
	 "p.nc:5:3: error: the path turns back on itself under cutter compensation: which side of the corner is the "
	 "inside depends on the control"},
	{"TOOL CALL 1 Z\nL X+10 RL F100\nL X+20\nL Y+3\nL X+30\nL Y+0\n",
	 "p.nc:6:3: error: the straight feed of line 5 ends in an inside corner that the tool (radius 5 mm) cannot reach "
	 "without gouging"},
	{"TOOL CALL 1 Z\nL X+10 RL F100\nL X+20\nCR X+26 R3 DR+\n",
	 "p.nc:5:4: error: the arc's radius, 3 mm, is not greater than the radius of the compensation, 5 mm"},
	{"TOOL CALL 1 Z\nL X+10 RL F100\nL X+20\nL Z+5 R0\nCR X+26 R3 DR+\n",
	 "p.nc:6:4: error: a circle while it is not known where the tool stands in X and Y: behind R0 without a move in the "
	 "plane, DEP, or a cycle that mills a pocket; move X and Y first"},
	{"TOOL CALL 1 Z\nL X+10 RL F100\nL X+20\nL Z+5 R0\nL M128\n",
	 "p.nc:6:3: error: M128 while it is not known where the tool stands in X and Y: behind R0 without a move in the "
	 "plane, DEP, or a cycle that mills a pocket; move X and Y first"},
	{"TOOL CALL 1 Z\nAPPR LT X+20 LEN5 F100\n",
	 "p.nc:3:9: error: APPR needs RL or RR"},
	{"TOOL CALL 1 Z\nAPPR XT X+20 LEN5 F100\n",
	 "p.nc:3:6: error: APPR and DEP need LT, LN, CT or LCT, or PLT, PLN, PCT or PLCT"},
	{"TOOL CALL 1 Z\nAPPR LN X+20 RL F100\n",
	 "p.nc:3:9: error: LN needs LEN, more than 0"},
	{"TOOL CALL 1 Z\nAPPR CT X+20 R+10 RL F100\n",
	 "p.nc:3:9: error: CT needs CCA, between 0 and 360 degrees"},
	{"TOOL CALL 1 Z\nAPPR LCT X+20 R-10 RL F100\n",
	 "p.nc:3:15: error: R of LCT must be more than 0"},
	{"TOOL CALL 1 Z\nAPPR LCT X+20 R+10 RL FMAX\n",
	 "p.nc:3:23: error: APPR cannot be moved at FMAX; it needs F"},
	{"TOOL CALL 1 Z\nAPPR LT X+20 IZ LEN5 RL F100\nL Y+20\n",
	 "p.nc:3:17: error: a value is needed here"},
	{"TOOL CALL 1 Z\nAPPR CT X+20 CCA90 R-4 RL F100\nL Y+20\n",
	 "p.nc:3:20: error: a circle from the side of the workpiece whose radius, 4 mm, is not greater than the tool's, "
	 "5 mm, is not supported"},
	{"TOOL CALL 1 Z\nAPPR LCT X+9 R+10 RL F100\nL Y+20\n",
	 "p.nc:3:14: error: the other end of this straight line lies within the circle"},
	{"TOOL CALL 1 Z\nAPPR LT X+20 LEN5 RL F100\nL Z+20\n",
	 "p.nc:3:1: error: APPR needs a straight line or a circle in the plane of X and Y right behind it"},
	{"TOOL CALL 1 Z\nAPPR LT X+20 LEN5 RL F100\nM8\n",
	 "p.nc:3:1: error: APPR needs a straight line or a circle in the plane of X and Y right behind it"},
	{"TOOL CALL 1 Z\nAPPR LT X+20 LEN5 RL F100\nL Y+20\nAPPR LT X+20 LEN5 RL F100\n",
	 "p.nc:5:9: error: APPR under radius compensation: DEP or R0 comes first"},
	{"F100\nL X+5\nDEP LT LEN5\n",
	 "p.nc:4:8: error: DEP without radius compensation (RL, RR) is not supported"},
	{"TOOL CALL 1 Z\nAPPR LT X+20 LEN5 RL F100\nL Y+20\nDEP LT X+5 LEN5\n",
	 "p.nc:5:8: error: only DEP LCT names its end in X and Y"},
	{"TOOL CALL 1 Z\nL X+10 RL F100\n",
	 "p.nc:4:1: error: the program ends right behind the first block of radius compensation: where the tool is then "
	 "is not known"},
	{"F100\nCC X+0 Y+0\nC X+1 Y+1\n",
	 "p.nc:4:3: error: C needs its direction of rotation, DR+ or DR-"},
	{"F100\nCC X+0 Y+0\nC X+1 Y+1 DR+\n",
	 "p.nc:4:3: error: a circle of radius 0: 0 mm at its start, 1.41421 mm at its end"},
	{"L X+5 F100\nCC X+0 Y+0\nC X+0 Y+6 DR+\n",
	 "p.nc:4:3: error: the radius of the circle is 5 mm at its start and 6 mm at its end"},
	{"L X+5 F100\nCC X+0 Y+0\nC X+0 Y+5 Z+1 DR+\n",
	 "p.nc:4:11: error: Z does not belong to the plane of this circle; a helix is written as CP"},
	{"L X+5 F100\nCC X+0 Y+0\nC X+0 Y+5 DR+ FMAX\n",
	 "p.nc:4:15: error: a circle cannot be moved at FMAX; it needs F"},
	{"L X+10 F100\nCC X+0 Y+0 Z+0\nC X+3 Y+3 DR+\n",
	 "p.nc:4:3: error: the circle about this CC lies in none of the planes XY, YZ and ZX: its radii differ, or it leaves "
	 "the plane; a helix is written as CP"},
	{"L X+10 F100\nCC X+0 Y+0 Z+0\nC X+0 Y+10 Z+5 DR+\n",
	 "p.nc:4:3: error: the circle about this CC lies in none of the planes XY, YZ and ZX: its radii differ, or it leaves "
	 "the plane; a helix is written as CP"},
	{"L Z+10 F100\nCC X+0 Y+0 Z+5\nC Z+0 DR+\nRND R1\nL X+5\n",
	 "p.nc:4:3: error: CC with X, Y and Z leaves open in which plane this circle lies: under radius compensation and "
	 "beside RND and CHF it has to be known; leave one of them out"},
	{"L Z+10 F100\nCC X+0 Y+0 Z+5\nC Z+0 DR+\nCT X+5\n",
	 "p.nc:5:4: error: CT needs a path block before it that moves in the plane, to start in its direction"},
	{"CC X+0 F100\n",
	 "p.nc:2:4: error: CC has coordinates of X, Y and Z alone"},
	{"F100\nCT X+5\n",
	 "p.nc:3:4: error: CT needs a path block before it that moves in the plane, to start in its "
	 "direction"},
	{"L X+5 F100\nCT X-5 Y+0\n",
	 "p.nc:3:4: error: the end of CT lies behind its start: no circle leads there"},
	{"LP PR+5 PA+0 FMAX\n",
	 "p.nc:2:4: error: no CC has given the centre"},
	{"CC\nLP X+5 PA+0 FMAX\n",
	 "p.nc:3:4: error: polar coordinates and X in one block"},
	{"L X+5 F100\nCC X+0 Y+0\nCP DR+\n",
	 "p.nc:4:4: error: CP needs PA or IPA"},
	{"L X+5 F100\nCC X+0 Y+0\nCP PR+5 PA+9 DR+\n",
	 "p.nc:4:4: error: CP keeps the distance from the pole; PR does not belong to it"},
	{"L X+5 F100\nCC X+0 Y+0\nCP IPA+90 DR-\n",
	 "p.nc:4:4: error: the signs of IPA and DR differ"},
	{"L X+5 F100\nCC X+0 Y+0\nCP IPA+0 DR+\n",
	 "p.nc:4:4: error: a circle of 0 degrees"},
	{"L X+5 F100\nCC X+0 Y+0\nC X+0 Y+5 C+5 DR+\n",
	 "p.nc:4:11: error: C in a circle or in polar coordinates is not supported yet"},
	{"L X+5 F100\nCC X+0 Y+0\nC X+0 Y+5 DR+ M91\n",
	 "p.nc:4:15: error: M91 belongs to straight lines (L)"},
	{"RND R5\n",
	 "p.nc:2:5: error: RND needs a line or a circle right before it"},
	{"F100\nL X+10\nRND R2\nL M8\n",
	 "p.nc:4:5: error: RND and CHF need a line or a circle in the plane behind them"},
	{"F100\nL X+10\nRND R2\nLBL 1\n",
	 "p.nc:4:5: error: RND and CHF need a line or a circle in the plane behind them"},
	{"F100\nL X+10\nRND R2\nL Y+5 M91\n",
	 "p.nc:4:5: error: RND and CHF need a line or a circle in the plane behind them"},
	{"F100\nL X+10\nRND R2\nRND R3\nL Y+5\n",
	 "p.nc:5:5: error: RND needs a line or a circle right before it"},
	{"F100\nL X+10\nRND R2\n",
	 "p.nc:4:5: error: RND and CHF need a line or a circle in the plane behind them"},
	{"TOOL CALL 1 Z\nL X+10 RL F100\nRND R8\nL Y+10\n",
	 "p.nc:3:8: error: RND and CHF right behind the block that starts radius compensation are not supported"},
	{"F100\nL X+10\nRND\nL Y+10\n",
	 "p.nc:4:4: error: RND needs its radius in R"},
	{"F100\nL X+10\nRND R20\nL Y+10\n",
	 "p.nc:5:3: error: the rounding of 20 mm is longer than one of the paths beside it"},
	{"F100\nL X+10\nRND R2\nL X+0\n",
	 "p.nc:5:3: error: the path goes back the way it has come: there is no corner to cut off"},
	{"F100\nL X+10\nRND R2\nM30\n",
	 "p.nc:4:5: error: RND and CHF need a line or a circle in the plane behind them"},
	{"F100\nL X+10 FMAX\nRND R2\nL Y+10\n",
	 "p.nc:5:3: error: RND and CHF beside a move at FMAX are not supported"},
	{"F100\nL X+10\nCHF 2\nCC X+10 Y+5\nC X+10 Y+10 DR+\n",
	 "p.nc:6:3: error: CHF needs straight lines on both sides"},
	{"F100\nL X+10\nRND R20\nCC X+20 Y+0\nC X+20 Y+10 DR-\n",
	 "p.nc:6:3: error: the rounding of 20 mm is longer than one of the paths beside it"},
	{"F100\nL X+10 M99\nRND R2\nL Y+10\n",
	 "p.nc:3:8: error: M99 in the block before RND or CHF is not supported: write it into a block of its own"},
	{"F100\nL X+10\nRND R2\nL Y+10 M128\n",
	 "p.nc:5:8: error: M128 in the block behind RND or CHF is not supported: write it into a block of its own"},
	{"F100\nL X+10 A+5\nRND R2\nL Y+10\n",
	 "p.nc:3:3: error: RND and CHF behind a move of other axes than X, Y and Z are not supported"},
	{"F100\nL X+10\nCHF 0\nL Y+5\n",
	 "p.nc:4:5: error: a chamfer must be more than 0"},
	{"F100\nL X+10\nRND R2\nTOOL CALL 1 Z\n",
	 "p.nc:4:5: error: RND and CHF need a line or a circle in the plane behind them"},
	{"F100\nFL X+10\n",
	 "p.nc:3:4: error: FK: the block does not say where its line ends, or leaves several solutions: that is "
	 "not supported yet; write the end of the element"},
	{"F100\nFL LEN10 X+5\n",
	 "p.nc:3:10: error: FK: the block does not say where its line ends, or leaves several solutions: that is "
	 "not supported yet; write the end of the element"},
	{"F100\nFL AN+0 X-5\n",
	 "p.nc:3:9: error: FK: the data of this element contradict each other"},
	{"F100\nFL AN+0 LEN5 X+6\n",
	 "p.nc:3:14: error: FK: the data of this element contradict each other"},
	{"F100\nFL RX 10 Y+5\n",
	 "p.nc:3:4: error: RX: points and relations of FK are not supported yet"},
	{"F100\nFL PR+5 PA+0\n",
	 "p.nc:3:13: error: polar coordinates of FK need FPOL before them"},
	{"F100\nFL IX+5 Y+1\n",
	 "p.nc:3:4: error: FK reads absolute coordinates of X and Y; increments and Z are not supported yet"},
	/* Along which direction a tangential element goes on behind a change of coordinates is not known. */
	{"L X+5 F100\nCYCL DEF 10.0\nCYCL DEF 10.1 ROT+90\nFLT LEN5\n",
	 "p.nc:5:9: error: a tangential element needs a path block before it that moves in the plane"},
	{"L X+5 F100\nCYCL DEF 8.0\nCYCL DEF 8.1 X\nCT X+5 Y+5\n",
	 "p.nc:5:4: error: CT needs a path block before it that moves in the plane, to start in its direction"},
	{"F100\nFLT LEN5\n",
	 "p.nc:3:9: error: a tangential element needs a path block before it that moves in the plane"},
	{"F100\nFC R+5 DR+ X+10 Y+0\n",
	 "p.nc:3:4: error: FK: the block does not say where the centre of its circle is, or leaves several "
	 "solutions: that is not supported yet; write the end of the element"},
	{"F100\nFC CCX+5 CCY+0 DR+\n",
	 "p.nc:3:16: error: FK: the block does not say where its circle ends, or leaves several solutions: that is "
	 "not supported yet; write the end of the element"},
	{"F100\nFC CCX+5 CCY+0 X+10 Y+0\n",
	 "p.nc:3:16: error: FC and FCT need their direction of rotation, DR+ or DR-"},
	{"F100\nL X+10\nFCT DR- X+15 Y+5\n",
	 "p.nc:4:5: error: FK: the data of this element contradict each other"},
	{"F100\nFC CCX+5 CCY+0 R7 DR+ CCA90\n",
	 "p.nc:3:16: error: FK: the data of this element contradict each other"},
	{"FPOL X+1\n",
	 "p.nc:2:6: error: FPOL needs absolute coordinates of X and Y, alone"},
	{"FSELECT1\n",
	 "p.nc:2:1: error: FSELECT chooses one of several solutions, which are not worked out here: write the end "
	 "of the element before it"},
};

START_TEST(fault_table)
{
	klartext_expect_fault(&faults[_i]);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("gcode_klartext_bad_path");
	TCase *tcase = tcase_create("bad");
	SRunner *runner;
	int failed;

	tcase_add_loop_test(tcase, fault_table, 0, COUNT(faults));
	suite_add_tcase(suite, tcase);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
