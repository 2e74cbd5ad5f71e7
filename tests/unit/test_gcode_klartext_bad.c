/* test_gcode_klartext_bad.c - what is wrong with a Klartext program, and where: the exact messages. */
#include "klartext_case.h"

static const struct {
	const char *blocks;
	const char *message;	/* the first line of what is said */
} faults[] = {
	{"X\n",
	 "p.nc:2:1: error: X is no block of this control"},
	{"L X+\n",
	 "p.nc:2:4: error: a value is needed here"},
	{"L X+10 X+20 FMAX\n",
	 "p.nc:2:8: error: X stands twice in the block"},
	{"L X+1\n",
	 "p.nc:2:3: error: a move without a feed rate: F or FMAX is needed"},
	{"L B+5 FMAX\n",
	 "p.nc:2:3: error: the machine has no B axis"},
	{"L X+1 F-5\n",
	 "p.nc:2:7: error: a feed rate cannot be negative"},
	{"L Q5 FMAX\n",
	 "p.nc:2:3: error: this is no word of a positioning block"},
	{"L X+Q5 FMAX\n",
	 "p.nc:2:5: error: Q5 has no value: the program has not assigned one, and what the control "
	 "still holds from before is not known"},
	{"L X+Q2000 FMAX\n",
	 "p.nc:2:5: error: Q parameters go from Q0 to Q1999"},
	{"L X+QL500 FMAX\n",
	 "p.nc:2:5: error: Q parameters go from QL0 to QL499"},
	{"L X+1 RL FMAX\n",
	 "p.nc:2:7: error: RL: radius compensation is not supported yet; post the path of the tool's "
	 "centre with R0"},
	{"L X+1 RR F100\n",
	 "p.nc:2:7: error: RR: radius compensation is not supported yet; post the path of the tool's "
	 "centre with R0"},
	{"L X+1 R+ F100\n",
	 "p.nc:2:7: error: R+: the radius compensation of a single axis is not supported yet"},
	{"L X+1 FMAX F100\n",
	 "p.nc:2:12: error: F stands twice in the block"},
	{"L X+1 R0 R0 FMAX\n",
	 "p.nc:2:10: error: the radius compensation stands twice in the block"},
	{"L X+1 S-5\n",
	 "p.nc:2:7: error: a spindle speed cannot be negative"},
	{"L X+1 FMAX M57.5\n",
	 "p.nc:2:13: error: an M-function is a whole number from 0 to 9999"},
	{"L X+1 FMAX M3 M3\n",
	 "p.nc:2:15: error: M3 stands twice in the block"},
	{"L X+1 FMAX M1 M3 M8 M9 M5 M13 M14 M4 M57\n",
	 "p.nc:2:38: error: a block can have at most 8 M-functions"},
	{"L X+1 FMAX M58\n",
	 "p.nc:2:12: error: M58 is not known; if it moves no axis, <mcode number=\"58\" "
	 "action=\"ignore\"/> in the machine's <controller> says so"},
	{"L X+1 FMAX M92\n",
	 "p.nc:2:12: error: M92: coordinates from a point that the builder of the machine has set is "
	 "not supported yet"},
	{"L X+1 FMAX M101\n",
	 "p.nc:2:12: error: M101: tool change when the life of a tool ends is not supported yet"},
	{"L X+1 FU0.1\n",
	 "p.nc:2:7: error: FU: a feed per revolution is not supported yet; give F in mm/min"},
	{"L X+1 FZ0.1\n",
	 "p.nc:2:7: error: FZ: a feed per tooth is not supported yet; give F in mm/min"},
	{"L X+1 F AUTO\n",
	 "p.nc:2:7: error: F AUTO, but TOOL CALL has given no F"},
	{"L X+1 PR+5 FMAX\n",
	 "p.nc:2:7: error: polar coordinates need LP or CP"},
	{"L X+1 DR+ F100\n",
	 "p.nc:2:3: error: DR, LEN and CCA belong to circles, APPR and DEP"},
	{"L X+1 R5 F100\n",
	 "p.nc:2:7: error: R with a radius belongs to CR, RND, APPR and DEP"},
	{"L I5 FMAX\n",
	 "p.nc:2:3: error: I needs an axis, PR or PA"},
	{"FOO X+1\n",
	 "p.nc:2:1: error: FOO is no block of this control"},
	{"L X+1 FMAX HELLO\n",
	 "p.nc:2:12: error: this is no word of a positioning block"},
	{"L X+1 FMAX NX+1\n",
	 "p.nc:2:3: error: NX and TX belong to LN"},
	{"L X+1 MB50\n",
	 "p.nc:2:7: error: MB belongs to M140"},
	{"L X+1..5 FMAX\n",
	 "p.nc:2:7: error: this is no word of a positioning block"},
	{"\"X\"\n",
	 "p.nc:2:1: error: this is no block of this control"},
	{"L X++1 FMAX\n",
	 "p.nc:2:4: error: a value is needed here"},
	{"L X+1 FMAX (comment)\n",
	 "p.nc:2:12: error: this is no word of a positioning block"},
	{"BEGIN PGM U MM\n",
	 "p.nc:2:7: error: a second BEGIN PGM before END PGM"},
	{"LBL\n",
	 "p.nc:2:4: error: a label is needed here"},
	{"CALL LBL 5\n",
	 "p.nc:2:10: error: the program has no LBL 5"},
	{"CALL LBL 0\n",
	 "p.nc:2:10: error: LBL 0 ends subprograms: nothing can call it or jump there"},
	{"CALL FOO\n",
	 "p.nc:2:6: error: CALL needs LBL or PGM"},
	{"LBL 1\nLBL 1\nCALL LBL 1\n",
	 "p.nc:4:10: error: LBL 1 stands more than once in the program"},
	{"CALL PGM nowhere.h\n",
	 "p.nc:2:10: error: there is no file of the program nowhere.h"},
	{"CALL LBL 1\nM30\nLBL 1\nL X+1 FMAX\n",
	 "p.nc:6:1: error: the program ends inside of the subprogram LBL 1: its LBL 0 is missing"},
	{"LBL 1\nCALL LBL 1\nLBL 0\n",
	 "p.nc:3:10: error: more than 19 calls inside each other"},
	{"LBL \"open\nL X+1 FMAX\n",
	 "p.nc:2:5: error: this name is not closed: the second quotation mark is missing"},
	{"FN 9: IF +1 EQU +1 GOTO LBL 99\n",
	 "p.nc:2:29: error: the program has no LBL 99"},
	{"FN 9: +1 EQU +1 GOTO LBL 99\n",
	 "p.nc:2:7: error: FN 9 needs IF here"},
	{"FN 9: IF +1 NE +1 GOTO LBL 9\n",
	 "p.nc:2:13: error: FN 9 compares by EQU"},
	{"FN 9: IF +1 EQU +1 LBL 9\n",
	 "p.nc:2:20: error: FN 9 needs GOTO LBL here"},
	{"Q1=0.1+0.2\nFN 9: IF +Q1 EQU +0.3 GOTO LBL 9\n",
	 "p.nc:3:32: error: 0.3 and 0.3 differ by 5.6e-17 only: the control may find them equal"},
	{"CALL LBL 1 REP\n",
	 "p.nc:2:15: error: a value is needed here"},
	{"CALL LBL 1.5\n",
	 "p.nc:2:10: error: a label is a whole number from 0 to 65535"},
	{"Q1\n",
	 "p.nc:2:3: error: '=' is needed here"},
	{"Q1 =\n",
	 "p.nc:2:5: error: a value is needed here"},
	{"Q1 = 1 +\n",
	 "p.nc:2:9: error: a value is needed here"},
	{"Q1 = 1 / 0\n",
	 "p.nc:2:8: error: division by zero"},
	{"Q1 = SQRT -1\n",
	 "p.nc:2:6: error: SQRT of -1: negative numbers have none"},
	{"Q1 = ASIN 2\n",
	 "p.nc:2:6: error: ASIN of 2: only numbers from -1 to 1 have one"},
	{"Q1 = LOG 0\n",
	 "p.nc:2:6: error: LOG of 0: only positive numbers have one"},
	{"Q1 = (1 + 2\n",
	 "p.nc:2:12: error: this expression is not closed: ')' is missing"},
	{"Q1 = 1 2\n",
	 "p.nc:2:8: error: the block should end here"},
	{"Q1 = FOO 3\n",
	 "p.nc:2:6: error: a value is needed here"},
	{"Q110 = 5\n",
	 "p.nc:2:1: error: Q110 belongs to the control: a program cannot assign it"},
	{"QS1 = \"A\"\n",
	 "p.nc:2:1: error: strings (QS) are not supported yet"},
	{"Q1 = Q2\n",
	 "p.nc:2:6: error: Q2 has no value: the program has not assigned one, and what the control "
	 "still holds from before is not known"},
	{"Q1 = -8 ^ 0.5\n",
	 "p.nc:2:9: error: a negative number to a power that is not whole"},
	{"Q1 = -5 % 3\n",
	 "p.nc:2:9: error: % of a negative number: which sign the control gives it is not known here"},
	{"Q1 = 10 ^ 400\n",
	 "p.nc:2:9: error: the result is infinite"},
	{"FN 4: Q1 = +1 DIV +0\n",
	 "p.nc:2:7: error: division by zero"},
	{"FN 5: Q1 = SQRT -4\n",
	 "p.nc:2:7: error: SQRT of -4: negative numbers have none"},
	{"FN 0: X = 5\n",
	 "p.nc:2:7: error: a Q parameter is needed here"},
	{"FN 0 Q1 = 5\n",
	 "p.nc:2:6: error: ':' is needed here"},
	{"FN 1: Q1 = +5 - +3\n",
	 "p.nc:2:15: error: FN 1 needs + between its values"},
	{"FN 14: ERROR = 1000\n",
	 "p.nc:2:4: error: FN 14 stops the program here with an error of its own"},
	{"FN 18: SYSREAD Q1 = ID50\n",
	 "p.nc:2:4: error: FN 18 reads data of the control, which is not known here; give the value by "
	 "FN 0"},
	{"FN 20: WAIT FOR I5==1\n",
	 "p.nc:2:4: error: FN 20: what the machine's PLC does is not known here"},
	{"FN 26: TABOPEN X\n",
	 "p.nc:2:4: error: FN 26: freely definable tables are not supported yet"},
	{"FN 99: Q1 = 1\n",
	 "p.nc:2:4: error: FN 99 is not supported yet"},
	{"TOOL CALL 9 Z\n",
	 "p.nc:2:11: error: the setup defines no tool T9: add <tool number=\"9\" length=\"\"/> with "
	 "what it is made of"},
	{"TOOL CALL \"NONE\" Z\n",
	 "p.nc:2:11: error: the setup defines no tool named \"NONE\": add <tool number=\"\" "
	 "name=\"NONE\" length=\"\"/> with what it is made of"},
	{"TOOL CALL \"TWIN\" Z\n",
	 "p.nc:2:11: error: the setup has two tools named \"TWIN\", T3 and T4"},
	{"TOOL CALL 1 Y\n",
	 "p.nc:2:13: error: another tool axis than Z is not supported yet"},
	{"TOOL CALL 1.2 Z\n",
	 "p.nc:2:11: error: a tool's number is a whole number from 0 to 32767"},
	{"TOOL CALL 1 Z Q\n",
	 "p.nc:2:15: error: TOOL CALL has a tool, its axis, S, F, DL, DR and DR2"},
	{"TOOL DEF 1 L50\n",
	 "p.nc:2:12: error: TOOL DEF gives T1 a length of 50 mm, and the setup 100 mm: which of them "
	 "the control takes depends on whether its tool table is active; make them agree, or leave L out"},
	{"TOOL DEF 1 X50\n",
	 "p.nc:2:12: error: TOOL DEF has a number, L and R"},
	{"TOOL FOO\n",
	 "p.nc:2:6: error: TOOL needs CALL or DEF"},
	{"M6\n",
	 "p.nc:2:1: error: M6, but no TOOL CALL has named a tool"},
	{"TOOL CALL 1 Z\nL X+1 FMAX\nM6\n",
	 "p.nc:4:1: error: axes have moved between TOOL CALL and M6: which of them changes the tool, "
	 "and which tool has moved, is not known; write M6 behind TOOL CALL"},
	{"L M128\nTOOL CALL 1 Z\n",
	 "p.nc:3:11: error: TOOL CALL while M128 is in force: the manual wants M129 first"},
	{"F100\nC X+1 Y+1 DR+\n",
	 "p.nc:3:3: error: no CC has given the centre"},
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
	{"CC X+0 Y+0 Z+0\n",
	 "p.nc:2:4: error: CC with X, Y and Z: two of them say in which plane the circle lies; leave "
	 "the third out"},
	{"CC X+0 F100\n",
	 "p.nc:2:4: error: CC has coordinates of X, Y and Z alone"},
	{"F100\nCR X+10 Y+0 R4 DR+\n",
	 "p.nc:3:13: error: a radius of 4 mm does not reach from the start of the circle to its end"},
	{"F100\nCR X+0 Y+0 R4 DR+\n",
	 "p.nc:3:4: error: a circle by its radius cannot end where it starts; use CC and C"},
	{"F100\nCR X+1 Y+0 DR+\n",
	 "p.nc:3:4: error: CR needs its radius in R"},
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
	 "p.nc:2:5: error: RND needs a straight line right before it"},
	{"F100\nL X+10\nRND R2\nL M8\n",
	 "p.nc:4:5: error: RND and CHF need a straight line in the plane behind them"},
	{"F100\nL X+10\nRND R2\nLBL 1\n",
	 "p.nc:4:5: error: RND and CHF need a straight line in the plane behind them"},
	{"F100\nL X+10\nRND R2\nL Y+5 M91\n",
	 "p.nc:4:5: error: RND and CHF need a straight line in the plane behind them"},
	{"F100\nL X+10\nRND R2\nRND R3\nL Y+5\n",
	 "p.nc:5:5: error: RND needs a straight line right before it"},
	{"F100\nL X+10\nRND R2\n",
	 "p.nc:4:5: error: RND and CHF need a straight line in the plane behind them"},
	{"F100\nL X+10\nRND\nL Y+10\n",
	 "p.nc:4:4: error: RND needs its radius in R"},
	{"F100\nL X+10\nRND R20\nL Y+10\n",
	 "p.nc:5:1: error: the rounding of 20 mm does not fit between these lines, which are 10 and 10 "
	 "mm long"},
	{"F100\nL X+10\nRND R2\nL X+0\n",
	 "p.nc:5:1: error: the path goes back the way it has come: there is no corner to cut off"},
	{"F100\nL X+10\nRND R2\nM30\n",
	 "p.nc:4:5: error: RND and CHF need a straight line in the plane behind them"},
	{"F100\nL X+10 FMAX\nRND R2\nL Y+10\n",
	 "p.nc:5:1: error: RND and CHF beside a move at FMAX are not supported"},
	{"F100\nL X+10\nRND R2\nCC X+10 Y+5\nC X+10 Y+10 DR+\n",
	 "p.nc:4:5: error: RND and CHF need a straight line in the plane behind them"},
	{"F100\nL X+10\nCHF 0\nL Y+5\n",
	 "p.nc:4:5: error: a chamfer must be more than 0"},
	{"F100\nL X+10\nRND R2\nTOOL CALL 1 Z\n",
	 "p.nc:4:5: error: RND and CHF need a straight line in the plane behind them"},
	{"CYCL DEF 7.1 X+5\n",
	 "p.nc:2:10: error: CYCL DEF 7.1, but no 7.0 has begun the cycle"},
	{"CYCL DEF 7.0\nCYCL DEF 7.1 X\n",
	 "p.nc:3:14: error: DATUM SHIFT needs an axis and a value here"},
	{"CYCL DEF 7.0\nCYCL DEF 7.1 #5\n",
	 "p.nc:3:14: error: a datum from a table is not supported yet: give its values in X, Y and Z"},
	{"CYCL DEF 7.0\nCYCL DEF 7.1 B+5\n",
	 "p.nc:3:14: error: the machine has no B axis"},
	{"CYCL DEF 10.0\nCYCL DEF 10.1 ROT+5\nCYCL DEF 7.0\nCYCL DEF 7.1 X+5\n",
	 "p.nc:5:14: error: a datum shift while a mirror image, a rotation or a scaling is in force: "
	 "whether it is turned with them is not known here; shift the datum first"},
	{"CYCL DEF 8.0\nCYCL DEF 8.1 X\nCYCL DEF 10.0\nCYCL DEF 10.1 ROT+5\n",
	 "p.nc:5:10: error: a mirror image and a rotation at a time: their order is not known here; "
	 "cancel one of them first"},
	{"CYCL DEF 8.0\nCYCL DEF 8.1 C\n",
	 "p.nc:3:14: error: a mirror image of C is not supported yet"},
	{"CYCL DEF 8.0\nCYCL DEF 8.1 X+5\n",
	 "p.nc:3:14: error: MIRROR IMAGE needs axes without values here"},
	{"CYCL DEF 10.0\nCYCL DEF 10.1 X+5\n",
	 "p.nc:3:15: error: ROTATION needs ROT and an angle here"},
	{"CYCL DEF 11.0\nCYCL DEF 11.1 SCL 0.5\n",
	 "p.nc:3:15: error: a machine parameter says whether SCALING changes Z, too; give the factors "
	 "of X, Y and Z by CYCL DEF 26"},
	{"CYCL DEF 11.0\nCYCL DEF 11.1 SCL 0\n",
	 "p.nc:3:15: error: a scaling factor must be more than 0 and less than 100"},
	{"CYCL DEF 26.0\nCYCL DEF 26.1 A2\n",
	 "p.nc:3:15: error: AXIS-SPECIFIC SCALING needs X, Y, Z or CCX, CCY, CCZ with a value here"},
	{"CYCL DEF 26.0\nCYCL DEF 26.1 X2\nF100\nL X+5\nCC X+0 Y+0\nC X+0 Y+5 DR+\n",
	 "p.nc:7:3: error: a circle while the factors of its plane's axes differ would be an ellipse"},
	{"CYCL DEF 26.0\nCYCL DEF 26.1 X2\nCYCL DEF 10.0\nCYCL DEF 10.1 ROT+5\n",
	 "p.nc:5:10: error: a rotation and factors that differ in X and Y at a time: their order is not "
	 "known here; cancel one of them first"},
	{"CYCL DEF 19.0\nCYCL DEF 19.1 A-45 F1000 ABST50\n",
	 "p.nc:3:20: error: F and a clearance of CYCL DEF 19 let the control turn the rotary axes "
	 "itself: that is not supported yet; turn them by Q120 to Q122"},
	{"CYCL DEF 19.0\nCYCL DEF 19.1 A-45\nL X+1 FMAX\n",
	 "p.nc:4:3: error: a move of linear axes between PLANE ... STAY and the rotary axes' way to the "
	 "plane (Q120 to Q122) is not supported"},
	{"CYCL DEF 247 Q339=5\n",
	 "p.nc:2:14: error: the setup defines no work offset G54.1 P5: add <work_offset name=\"G54.1 "
	 "P5\" X=\"\" Y=\"\" Z=\"\"/> with its values"},
	{"CYCL DEF 247 Q339=0\n",
	 "p.nc:2:14: error: presets from 1 to 99 are supported, as G54.1 P1 to P99 of the setup"},
	{"CYCL DEF 247 Q338=1\n",
	 "p.nc:2:10: error: DATUM SETTING needs Q339, the number of the preset"},
	{"CYCL DEF 247\nL X+1 FMAX\n",
	 "p.nc:2:10: error: DATUM SETTING needs Q339, the number of the preset"},
	{"CYCL DEF 10.0\nCYCL DEF 10.1 ROT+5\nCYCL DEF 247 Q339=1\n",
	 "p.nc:4:14: error: a preset while a datum shift, a mirror image, a rotation or a scaling is in "
	 "force: which of them it cancels is not known here; cancel them first"},
	{"CYCL DEF 32.0\nCYCL DEF 32.1 T-1\n",
	 "p.nc:3:10: error: a path tolerance cannot be negative"},
	{"CYCL DEF 9.0\nCYCL DEF 9.1 DWELL -1\n",
	 "p.nc:3:10: error: a dwell cannot be negative"},
	{"PLANE FOO\n",
	 "p.nc:2:7: error: PLANE needs SPATIAL, EULER, VECTOR, POINTS, RELATIVE or RESET"},
	{"PLANE SPATIAL SPA+5 TURN\n",
	 "p.nc:2:21: error: SPB is needed here"},
	{"PLANE SPATIAL SPA+5 SPB+0 SPC+0\n",
	 "p.nc:2:7: error: PLANE needs MOVE, TURN or STAY: what the rotary axes do"},
	{"PLANE SPATIAL SPA+5 SPB+0 SPC+0 TURN\n",
	 "p.nc:2:7: error: PLANE ... TURN and MOVE need F or FMAX"},
	{"PLANE SPATIAL SPA+5 SPB+0 SPC+0 TURN FMAX SYM+\n",
	 "p.nc:2:43: error: SYM is not supported yet: write SEQ+ or SEQ-"},
	{"PLANE SPATIAL SPA+5 SPB+0 SPC+0 TURN MB50 FMAX\n",
	 "p.nc:2:38: error: MB of PLANE is not supported yet: retract by M140 in a block before"},
	{"PLANE SPATIAL SPA+5 SPB+0 SPC+0 TURN FMAX HELLO\n",
	 "p.nc:2:43: error: this is no word of PLANE"},
	{"PLANE SPATIAL SPA-30 SPB+0 SPC+0 TURN FMAX SEQ-\n",
	 "p.nc:2:7: error: no position of the rotary axes within their limits has the tool stand on "
	 "this plane with this SEQ"},
	{"PLANE PROJECTED PROPR+5 PROMIN+5 ROT+0 TURN FMAX\n",
	 "p.nc:2:7: error: PLANE PROJECTED is not supported yet: write the plane as PLANE SPATIAL"},
	{"PLANE AXIAL A+5 STAY\n",
	 "p.nc:2:7: error: PLANE AXIAL is not supported yet: write the plane as PLANE SPATIAL"},
	{"PLANE VECTOR BX+0 BY+0 BZ+1 NX+0 NY+0 NZ+1 TURN FMAX\n",
	 "p.nc:2:14: error: the base vector must not be parallel to the normal"},
	{"PLANE VECTOR BX+0 BY+0 BZ+0 NX+0 NY+0 NZ+1 TURN FMAX\n",
	 "p.nc:2:14: error: a vector of length 0 has no direction"},
	{"PLANE SPATIAL SPA+0 SPB+0 SPC+30 TURN FMAX\n",
	 "p.nc:2:7: error: any angle of C suits this plane: write COORD ROT, which turns the "
	 "coordinates alone"},
	{"PLANE SPATIAL SPA+0 SPB+0 SPC+30 TURN FMAX TABLE ROT\n",
	 "p.nc:2:7: error: TABLE ROT where any angle of C suits the plane is not supported yet; write "
	 "COORD ROT"},
	{"L C+5 FMAX\nPLANE SPATIAL SPA+0 SPB+0 SPC+0 TURN FMAX\n",
	 "p.nc:3:7: error: any angle of C suits this plane, and it stands at 5: whether the control "
	 "leaves it there is not known here; turn C to 0 in a block before"},
	{"PLANE SPATIAL SPA-30 SPB+0 SPC+0 STAY\nL X+1 FMAX\n",
	 "p.nc:3:3: error: a move of linear axes between PLANE ... STAY and the rotary axes' way to the "
	 "plane (Q120 to Q122) is not supported"},
	{"PLANE SPATIAL SPA-30 SPB+0 SPC+0 STAY\nL A+30 X+1 FMAX\n",
	 "p.nc:3:3: error: a move of linear axes between PLANE ... STAY and the rotary axes' way to the "
	 "plane (Q120 to Q122) is not supported"},
	{"PLANE SPATIAL SPA-30 SPB+0 SPC+0 STAY\nL M128\n",
	 "p.nc:3:3: error: M128 before the rotary axes stand where PLANE ... STAY needs them"},
	{"PLANE SPATIAL SPA-30 SPB+0 SPC+0 TURN FMAX\nL A+5 FMAX\n",
	 "p.nc:3:3: error: a rotary axis leaves the tilted plane: write PLANE RESET first, or M128"},
	{"PLANE SPATIAL SPA-30 SPB+0 SPC+0 TURN FMAX\nL A+5 FMAX M91\n",
	 "p.nc:3:3: error: a rotary axis leaves the tilted plane: write PLANE RESET first"},
	{"L M128\nPLANE SPATIAL SPA-30 SPB+0 SPC+0 TURN FMAX\n",
	 "p.nc:3:7: error: PLANE while M128 is in force is not supported; M129 first"},
	{"PLANE SPATIAL SPA-30 SPB+0 SPC+0 TURN FMAX\nCYCL DEF 10.0\nCYCL DEF 10.1 ROT+5\n"
	 "PLANE RESET STAY\n",
	 "p.nc:5:7: error: PLANE while a mirror image, a rotation, a scaling or a shift of tilted "
	 "coordinates is in force: cancel it first, the last one first"},
	{"PLANE SPATIAL SPA-30 SPB+0 SPC+0 TURN FMAX\nCYCL DEF 247 Q339=1\nL X+1 FMAX\n",
	 "p.nc:4:3: error: CYCL DEF 247 has selected a preset in a tilted plane: whether the plane "
	 "stays tilted is not known here; write PLANE RESET first"},
	{"PLANE RELATIVE A+5 TURN FMAX\n",
	 "p.nc:2:16: error: PLANE RELATIVE needs SPA, SPB or SPC"},
	{"L C+270 FMAX\nPLANE RESET TURN FMAX\n",
	 "p.nc:3:7: error: whether PLANE RESET turns C to 0 or to a whole turn is not known here; turn "
	 "it in a block before"},
	{"M128\nL X+1 FMAX M91\n",
	 "p.nc:3:12: error: M91 while M128 is in force: the manual wants M129 first"},
	{"M140\n",
	 "p.nc:2:1: error: M140 needs MB and a way, or MB MAX"},
	{"M140 MB-5\n",
	 "p.nc:2:1: error: the way of M140 cannot be negative"},
	{"L X+1 M140 MB MAX FMAX\n",
	 "p.nc:2:7: error: M140 beside axis words: which comes first is not known here; write two blocks"},
	{"L C+720 FMAX\nM94\n",
	 "p.nc:3:1: error: M94 where C stands a turn or more away from 0 is not supported yet"},
	{"M138 A\nL X+1 FMAX\n",
	 "p.nc:2:1: error: M138 that leaves C out is not supported yet"},
	{"M94 B\n",
	 "p.nc:2:5: error: the machine has no B axis"},
	{"FUNCTION TCPM F TCP AXIS SPAT PATHCTRL AXIS\n",
	 "p.nc:2:21: error: AXIS SPAT: rotary words as spatial angles are not supported yet"},
	{"FUNCTION TCPM F TCP AXIS POS PATHCTRL VECTOR\n",
	 "p.nc:2:30: error: PATHCTRL VECTOR is not supported yet"},
	{"FUNCTION TCPM\n",
	 "p.nc:2:14: error: FUNCTION TCPM needs AXIS POS and PATHCTRL AXIS"},
	{"FUNCTION TCPM AXIS POS PATHCTRL AXIS REFPNT CNT-CNT\n",
	 "p.nc:2:38: error: REFPNT other than TIP-TIP is not supported yet"},
	{"FUNCTION MODE TURN\n",
	 "p.nc:2:10: error: this FUNCTION is not supported yet; TCPM, RESET TCPM and MODE MILL are"},
	{"FUNCTION TCPM FOO\n",
	 "p.nc:2:15: error: this is no word of FUNCTION TCPM"},
	{"FUNCTION TCPM F FOO\n",
	 "p.nc:2:15: error: F of TCPM is TCP or CONT"},
	{"LN X+1 NX+0 NY+0 NZ+1 TX+0 TY+0 TZ+1 F100\n",
	 "p.nc:2:4: error: TX, TY, TZ: a direction of the tool is not supported yet; post the positions "
	 "of the rotary axes"},
	{"TOOL CALL 1 Z DL+1\nLN X+1 NX+0 NY+0 NZ+1 F100\n",
	 "p.nc:3:4: error: LN with an oversize of the tool (DL, DR, DR2 of TOOL CALL): "
	 "three-dimensional compensation is not supported yet"},
	{"LN X+1 NQ+0 F100\n",
	 "p.nc:2:8: error: NX, NY or NZ is needed here"},
	{"M99\n",
	 "p.nc:2:1: error: no cycle has been defined that could be called"},
	{"L M128\nCYCL DEF 200 DRILLING Q200=2 Q201=-4 Q206=150 Q202=4 Q203=+0 Q204=9\nM99\n",
	 "p.nc:4:1: error: a cycle while M128 is in force is not supported yet"},
	{"CYCL DEF 200 DRILLING Q200=2 Q206=150 Q202=4 Q203=+0 Q204=9\nM99\n",
	 "p.nc:3:1: error: CYCL DEF 200 lacks Q201"},
	{"CYCL DEF 200 DRILLING Q200=2 Q201=4 Q206=150 Q202=4 Q203=+0 Q204=9\nM99\n",
	 "p.nc:3:1: error: Q201=4: what a depth above the surface does depends on a machine parameter"},
	{"CYCL DEF 200 DRILLING Q200=-2 Q201=-4 Q206=150 Q202=4 Q203=+0 Q204=9\nM99\n",
	 "p.nc:3:1: error: a set-up clearance (Q200, Q204) cannot be negative"},
	{"CYCL DEF 200 DRILLING Q200=2 Q201=-4 Q206=0 Q202=4 Q203=+0 Q204=9\nM99\n",
	 "p.nc:3:1: error: a cycle without a feed rate"},
	{"CYCL DEF 200 DRILLING Q200=2 Q201=-4 Q206=150 Q202=-4 Q203=+0 Q204=9\nM99\n",
	 "p.nc:3:1: error: Q202: a peck cannot be negative"},
	{"CYCL DEF 200 DRILLING Q200=2 Q201=-4 Q206=150 Q202=0.00001 Q203=+0 Q204=9\nM99\n",
	 "p.nc:3:1: error: Q202: more than 100000 pecks"},
	{"CYCL DEF 200 DRILLING Q200=2 Q201=-4 Q206=FZ Q202=4 Q203=+0 Q204=9\n",
	 "p.nc:2:38: error: Q206=FZ is not supported yet: give a number"},
	{"CYCL DEF 200 DRILLING Q200 2\n",
	 "p.nc:2:28: error: '=' is needed here"},
	{"CYCL DEF 200 DRILLING Q200=2 X+5\n",
	 "p.nc:2:33: error: '=' is needed here"},
	{"CYCL DEF 202 BORING Q200=2 Q201=-10 Q206=100 Q208=0 Q203=+0 Q204=20 Q214=7\nM99\n",
	 "p.nc:3:1: error: Q214 is a whole number from 0 to 4"},
	{"CYCL DEF 204 BACK BORING Q200=2 Q249=5\nM99\n",
	 "p.nc:3:1: error: CYCL DEF 204: back boring is not supported yet"},
	{"CYCL DEF 207 RIGID TAPPING Q200=2 Q201=-9 Q239=1 Q203=+0 Q204=20\nM99\n",
	 "p.nc:3:1: error: CYCL DEF 207 without a spindle speed (S)"},
	{"CYCL DEF 240 CENTERING Q200=2 Q343=1 Q201=-2 Q344=-10 Q206=100 Q211=0 Q203=+0 Q204=20\nM99\n",
	 "p.nc:3:1: error: Q343=1: a centring by its diameter needs the point angle of the tool; give "
	 "its depth in Q201"},
	{"CYCL DEF 208 BORE MILLING\n",
	 "p.nc:2:10: error: CYCL DEF 208: bore milling is not supported yet"},
	{"CYCL DEF 220 POLAR PATTERN\n",
	 "p.nc:2:10: error: CYCL DEF 220: a pattern of holes on a circle is not supported yet"},
	{"CYCL DEF 251 RECTANGULAR POCKET\n",
	 "p.nc:2:10: error: CYCL DEF 251 is not known: it may be a cycle of the machine's builder, "
	 "whose moves a checker cannot know"},
	{"CYCL DEF 413 DATUM\n",
	 "p.nc:2:10: error: touch probe cycle 413: where the probe stops is not known before the "
	 "program runs"},
	{"CYCL DEF 385 OEM\n",
	 "p.nc:2:10: error: CYCL DEF 385 is not known: it may be a cycle of the machine's builder, "
	 "whose moves a checker cannot know"},
	{"CYCL DEF X\n",
	 "p.nc:2:10: error: CYCL DEF needs the number of a cycle"},
	{"CYCL FOO\n",
	 "p.nc:2:6: error: CYCL needs DEF or CALL"},
	{"CYCL DEF 7 DATUM SHIFT\n",
	 "p.nc:2:10: error: CYCL DEF 7 is written in lines 7.0, 7.1 and on"},
	{"CYCL CALL PAT F100\n",
	 "p.nc:2:11: error: CYCL CALL PAT: patterns and point tables are not supported yet"},
	{"CYCL CALL X+5\n",
	 "p.nc:2:11: error: CYCL CALL with coordinates is written as CYCL CALL POS"},
	{"CYCL CALL POS X+5\n",
	 "p.nc:2:15: error: CYCL CALL POS needs absolute coordinates of X, Y and Z"},
	{"CYCL CALL POS X+5 Y+5 Z+5\n",
	 "p.nc:2:23: error: a Z other than 0 shifts the cycle: that is not supported yet; put it into Q203"},
	{"PATTERN DEF POS1\n",
	 "p.nc:2:1: error: PATTERN DEF is not supported yet"},
	{"SEL PATTERN \"X\"\n",
	 "p.nc:2:1: error: SEL: a selection of tables and contours is not supported yet"},
	{"APPR LT X+5 Y+5 LEN10\n",
	 "p.nc:2:1: error: APPR: an approach to a contour is not supported yet"},
	{"DEP LT LEN10\n",
	 "p.nc:2:1: error: DEP: a departure from a contour is not supported yet"},
	{"TCH PROBE 413\n",
	 "p.nc:2:1: error: TCH PROBE: where the probe stops is not known before the program runs"},
	{"FL X+5\n",
	 "p.nc:2:1: error: FK free contour programming is not supported yet"},
	{"TRANS DATUM AXIS X+5\n",
	 "p.nc:2:1: error: TRANS DATUM is not supported yet"},
	{"STOP X\n",
	 "p.nc:2:7: error: a value is needed here"},
	{"END\n",
	 "p.nc:2:4: error: END needs PGM"},
	{"CYCL DEF 1.0 PECKING\nCYCL DEF 1.1 SET UP -2\nM99\n",
	 "p.nc:4:1: error: the set-up clearance of CYCL DEF 1 cannot be negative"},
	{"CYCL DEF 1.0 PECKING\nCYCL DEF 1.2 DEPTH 2\nM99\n",
	 "p.nc:4:1: error: the depth of CYCL DEF 1 is above the surface"},
	{"Q1=0\nLBL 2\nQ1=Q1+1\nLBL 1\nFN 9: IF +Q1 EQU +2 GOTO LBL 2\nFN 9: IF +Q1 EQU +1 GOTO LBL 4\n"
	 "LBL 4\nQ1=Q1+0.5\nCALL LBL 1 REP 2\nL X+1 FMAX\nLBL 3\nL X+1 FMAX\n",
	 "p.nc:10:10: error: a jump has left this program section before its repeats were done: whether "
	 "they are counted anew is not known here"},
	{"PLANE SPATIAL SPA-30 SPB+0 SPC+0 TURN FMAX\nL C+360 FMAX\n",
	 "p.nc:3:3: error: a rotary axis leaves the tilted plane: write PLANE RESET first, or M128"},
	{"PLANE SPATIAL SPA-30 SPB+0 SPC+0 TURN FMAX\nL M128\nL A+10 FMAX\nM129\nL X+1 FMAX\n",
	 "p.nc:6:3: error: a move of linear axes between PLANE ... STAY and the rotary axes' way to the "
	 "plane (Q120 to Q122) is not supported"},
	{"CYCL DEF 7.0\nCYCL DEF 7.1 X+10\nL IX+1 FMAX\n",
	 "p.nc:4:3: error: an increment of X after a change of coordinates or a move that was not "
	 "programmed in them: from where the control counts is not known here; give X as an absolute "
	 "coordinate first"},
	{"M140 MB50\nL IZ-1 FMAX\n",
	 "p.nc:3:3: error: an increment of Z after a change of coordinates or a move that was not "
	 "programmed in them: from where the control counts is not known here; give Z as an absolute "
	 "coordinate first"},
	{"CYCL DEF 7.0\nCYCL DEF 7.1 X+10\nCC IX+5 IY+0\n",
	 "p.nc:4:4: error: an increment of X after a change of coordinates or a move that was not "
	 "programmed in them: from where the control counts is not known here; give X as an absolute "
	 "coordinate first"},
	{"CYCL DEF 7.0\nCYCL DEF 7.1 X+10\nCC\n",
	 "p.nc:4:3: error: an increment of X after a change of coordinates or a move that was not "
	 "programmed in them: from where the control counts is not known here; give X as an absolute "
	 "coordinate first"},
	{"CC X+0 Y+0\nCYCL DEF 7.0\nCYCL DEF 7.1 Y+10\nLP IPR+5 PA+0 FMAX\n",
	 "p.nc:5:4: error: an increment of Y after a change of coordinates or a move that was not "
	 "programmed in them: from where the control counts is not known here; give Y as an absolute "
	 "coordinate first"},
	{"CYCL DEF 7.0\nCYCL DEF 7.1 C+10\nL IC+5 FMAX\n",
	 "p.nc:4:3: error: an increment of C after its datum was shifted: from where the control counts "
	 "is not known here; give C as an absolute coordinate first"},
};

START_TEST(fault_table)
{
	const size_t length = strlen(faults[_i].message);
	struct gcode_case c;
	const char *said;

	klartext_case(&c);
	ck_assert_msg(!klartext_run(&c, faults[_i].blocks), "%s passes", faults[_i].blocks);
	said = strbuf_text(&c.messages);
	ck_assert_msg(!strncmp(said, faults[_i].message, length) && said[length] == '\n', "%s: %s", faults[_i].blocks,
		      said);
	ck_assert_uint_eq(c.diag.errors, 1);
	case_release(&c);
}
END_TEST

/* What is wrong with the whole program: its head, its end, its language. */
static const struct {
	const char *program;
	const char *message;
} heads[] = {
	{"L X+1 FMAX\n",
	 "p.nc:1:1: error: a Klartext program begins with BEGIN PGM, which says MM or INCH"},
	{"BEGIN PGM T\n", "p.nc:1:11: error: BEGIN PGM ends with the unit of the program, MM or INCH"},
	{"BEGIN T MM\n", "p.nc:1:7: error: BEGIN needs PGM"},
	{"BEGIN PGM T MM\nL X+1 FMAX\n", "p.nc:2: error: the file ends without END PGM: is it complete?"},
	{"%T G71 *\nN10 G00 X+1*\n",
	 "p.nc:1:1: error: this is a DIN/ISO program of the control (%NAME G71); only Klartext is supported"},
	{"BEGIN PGM T MM\nCYCL DEF 247 DATUM ~\nEND PGM T MM\n",
	 "p.nc:2:10: error: DATUM SETTING needs Q339, the number of the preset"},
};

START_TEST(head_table)
{
	const size_t length = strlen(heads[_i].message);
	struct gcode_case c;

	klartext_case(&c);
	ck_assert_msg(!case_run(&c, heads[_i].program), "%s passes", heads[_i].program);
	ck_assert_msg(!strncmp(strbuf_text(&c.messages), heads[_i].message, length), "%s: %s", heads[_i].program,
		      strbuf_text(&c.messages));
	case_release(&c);
}
END_TEST

/* With all faults asked for, the program is read on behind each. */
START_TEST(all_faults)
{
	struct gcode_case c;

	klartext_case(&c);
	c.config.read.all_faults = true;
	ck_assert(!klartext_run(&c, "L X+1\nL Q5\nL X+2 FMAX\nFOO\nCYCL DEF 208\n"));
	ck_assert_uint_eq(c.diag.errors, 4);
	case_release(&c);
}
END_TEST

#define COUNT(array) ((int)(sizeof(array) / sizeof((array)[0])))

int main(void)
{
	Suite *suite = suite_create("gcode_klartext_bad");
	TCase *tcase = tcase_create("bad");
	SRunner *runner;
	int failed;

	tcase_add_loop_test(tcase, fault_table, 0, COUNT(faults));
	tcase_add_loop_test(tcase, head_table, 0, COUNT(heads));
	tcase_add_test(tcase, all_faults);
	suite_add_tcase(suite, tcase);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
