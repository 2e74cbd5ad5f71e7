/* test_gcode_klartext_bad.c - what is wrong with the words, the parameters, the flow and the head of a Klartext program: the exact messages. */
#include "klartext_case.h"

static const struct klartext_fault faults[] = {
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
	 "p.nc:2:5: error: Q5 has no value: the program has not assigned one; if the control holds one from "
	 "before, set <variable name=\"Q5\" value=\"\"/> in the machine file's <controller>"},
	{"L X+Q2000 FMAX\n",
	 "p.nc:2:5: error: Q parameters go from Q0 to Q1999"},
	{"L X+QL500 FMAX\n",
	 "p.nc:2:5: error: Q parameters go from QL0 to QL499"},
	{"L X+1 FMAX LA5\n",
	 "p.nc:2:12: error: LA belongs to M120"},
	{"L X+1 R+ F100\n",
	 "p.nc:2:7: error: R+: the radius compensation of a single axis is not supported"},
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
	{"L X+1 FMAX M1 M3 M8 M9 M7 M19 M36 M37 M57\n",
	 "p.nc:2:39: error: a block can have at most 8 M-functions"},
	{"L X+1 FMAX M58\n",
	 "p.nc:2:12: error: M58 is not known; if it moves no axis, set <mcode number=\"58\" action=\"ignore\"/> in "
	 "the machine file's <controller>"},
	{"L X+1 FMAX M92\n",
	 "p.nc:2:3: error: the machine's builder decides from where M92 counts X: set <reference number=\"1\" "
	 "X=\"\"/> in the machine file's <controller>, in machine coordinates"},
	{"1 ; LAST LINE ~\nL X+1 FMAX\n",
	 "p.nc:3:1: error: '~' has this line belong to the comment before it, but it reads like a block: take the '~' away, or "
	 "begin the line with ';'"},
	{"1 ; LAST LINE ~\n  Q1=5\n",
	 "p.nc:3:3: error: '~' has this line belong to the comment before it, but it reads like a block: take the '~' away, or "
	 "begin the line with ';'"},
	{"L X+1 FMAX M92 M91\n",
	 "p.nc:2:16: error: M91 and M92 in one block"},
	{"CC X+1 Y+1\nC X+1 Y+1 DR+ F100 M92\n",
	 "p.nc:3:20: error: M92 belongs to straight lines (L)"},
	{"L X+1 FMAX M101\n",
	 "p.nc:2:12: error: M101: tool change when the life of a tool ends is not supported; if it may be left "
	 "out, set <mcode number=\"101\" action=\"ignore\"/> in the machine file's <controller>"},
	{"L X+1 FU0.1\n",
	 "p.nc:2:7: error: a feed per revolution (FU, M136) without a spindle speed (S)"},
	{"L X+1 FT5\n",
	 "p.nc:2:7: error: FT: the time that a block takes is not supported; write F"},
	{"Q1 = - 2 ^ 2\n",
	 "p.nc:2:10: error: a minus before a power: whether it belongs to the base is not in the manuals; write brackets"},
	{"Q2 = 5\nQ1 = 3 * -Q2^2\n",
	 "p.nc:3:13: error: a minus before a power: whether it belongs to the base is not in the manuals; write brackets"},
	{"Q1 = - ( 2 ) ^ 2\n",
	 "p.nc:2:14: error: a minus before a power: whether it belongs to the base is not in the manuals; write brackets"},
	{"Q1 = 1 + ( -SIN ( 3 * ( 10 ) ) ^ 2 )\n",
	 "p.nc:2:32: error: a minus before a power: whether it belongs to the base is not in the manuals; write brackets"},
	{"Q1 = -SQRT 4 ^ 2\n",
	 "p.nc:2:14: error: a minus before a power: whether it belongs to the base is not in the manuals; write brackets"},
	{"Q1 = -PI ^ 2\n",
	 "p.nc:2:10: error: a minus before a power: whether it belongs to the base is not in the manuals; write brackets"},
	{"L X+1 F100 FZ0.1\n",
	 "p.nc:2:12: error: F stands twice in the block"},
	{"L X+1 FMAX M118 X1 Y1\n",
	 "p.nc:2:12: error: M118: handwheel moves during the program are not supported; if they may be left out, "
	 "set <mcode number=\"118\" action=\"ignore\"/> in the machine file's <controller>"},
	{"M124 T0.01\n",
	 "p.nc:2:1: error: M124: contour filter is not supported; if it may be left out, set <mcode "
	 "number=\"124\" action=\"ignore\"/> in the machine file's <controller>"},
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
	{"IF Q1 THEN\n",
	 "p.nc:2:1: error: IF is no block of this control"},
	{"OPEN CONTOUR\n",
	 "p.nc:2:1: error: OPEN is no block of this control"},
	{"L X+1 FMAX M104\n",
	 "p.nc:2:12: error: M104: the datum that was set last is not supported; select the datum by CYCL DEF 247, CYCL "
	 "DEF 7 or TRANS DATUM"},
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
	 "p.nc:4:10: error: LBL 1 is in line 2 of p.nc and in line 3 of p.nc: which one is meant is not certain"},
	{"CALL PGM nowhere.h\n",
	 "p.nc:2:10: error: there is no file of the program nowhere.h; if the machine's builder made it and it "
	 "moves no axis, set <macro program=\"NOWHERE\" action=\"none\"/> in the machine file's <controller>"},
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
	 "p.nc:3:10: error: 0.3 and 0.3 differ by 5.6e-17 only: the control may find them equal"},
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
	{"Q1 = SGN 0\n",
	 "p.nc:2:6: error: SGN of 0 is 0 on newer controls and 1 on older ones"},
	{"CALL SELECTED PGM\n",
	 "p.nc:2:15: error: CALL SELECTED PGM, but no SEL PGM has named a program"},
	{"FN 19: PLC=+10/+Q3\n",
	 "p.nc:2:4: error: FN 19: what the machine's PLC does is not known here"},
	{"SEL PGM \"nowhere.h\"\nCALL SELECTED PGM\n",
	 "p.nc:3:15: error: there is no file of the program nowhere.h; if the machine's builder made it and it "
	 "moves no axis, set <macro program=\"NOWHERE\" action=\"none\"/> in the machine file's <controller>"},
	{"CYCL DEF 12.0\nM99\n",
	 "p.nc:3:1: error: CYCL DEF 12 has not named a program"},
	{"CYCL DEF 12.0\nCYCL DEF 12.1 PGM S\nL X+1 FMAX M89\n",
	 "p.nc:4:12: error: M89 with CYCL DEF 12 (a program after every move) is not supported; write M99 into each "
	 "block that calls the program"},
	{"CYCL DEF 12.0\nCYCL DEF 12.1 PGM S\nL X+1 FMAX M99 M5\n",
	 "p.nc:4:16: error: M5 behind M99 that calls a program (CYCL DEF 12) is not supported: write it into a block of "
	 "its own"},
	{"CYCL DEF 12.0\nCYCL DEF 12.1 PGM S\nL X+1 FMAX M99 M129\n",
	 "p.nc:4:16: error: M129 behind M99 that calls a program (CYCL DEF 12) is not supported: write it into a block "
	 "of its own"},
	{"CYCL DEF 12.0\nCYCL DEF 12.1 nowhere.h\n",
	 "p.nc:3:15: error: CYCL DEF 12.1 needs PGM and a name"},
	{"Q1 = SQRT -1\n",
	 "p.nc:2:6: error: SQRT of -1: the value must not be negative"},
	{"Q1 = ASIN 2\n",
	 "p.nc:2:6: error: ASIN of 2: the value must be from -1 to 1"},
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
	{"Q1 = Q2\n",
	 "p.nc:2:6: error: Q2 has no value: the program has not assigned one; if the control holds one from "
	 "before, set <variable name=\"Q2\" value=\"\"/> in the machine file's <controller>"},
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
	{"FN 18: SYSREAD Q1 = ID270 NR1 IDX1\nL X+Q1 FMAX\n",
	 "p.nc:3:5: error: Q1 was read from the control (FN 18, ID270 NR1 IDX1), and that value is not known here: to "
	 "check the program, assign the value by FN 0 behind it, or write FN 20: WAIT FOR SYNC before it"},
	{"FN 20: WAIT FOR SYNC\nL X+3 FMAX\nFN 18: SYSREAD Q1 = ID240 NR1 IDX1\nL X+Q1 FMAX\n",
	 "p.nc:5:5: error: Q1 was read from the control (FN 18, ID240 NR1 IDX1), and that value is not known here: to "
	 "check the program, assign the value by FN 0 behind it, or write FN 20: WAIT FOR SYNC before it"},
	/* The axis moves away and back, so the control may read a position on the way. */
	{"FN 20: WAIT FOR SYNC\nL X+3 FMAX\nL X+0 FMAX\nFN 18: SYSREAD Q1 = ID270 NR1 IDX1\nL X+Q1 FMAX\n",
	 "p.nc:6:5: error: Q1 was read from the control (FN 18, ID270 NR1 IDX1), and that value is not known here: to "
	 "check the program, assign the value by FN 0 behind it, or write FN 20: WAIT FOR SYNC before it"},
	{"FN 28: TABREAD Q1 = +5/\"X,Y\"\nL X+Q2 FMAX\n",
	 "p.nc:3:5: error: Q2 was read from the control (FN 28), and that value is not known here: to check the "
	 "program, assign the value by FN 0 behind it"},
	{"FN 18: SYSREAD Q1 = ID50 NR2 IDX3\nL X+Q1 FMAX\n",
	 "p.nc:3:5: error: Q1 was read from a table of the control (FN 18), and what that holds is not known here: "
	 "set <variable name=\"ID50 NR2 IDX3\" value=\"\"/> in the machine file's <controller>"},
	{"FN 18: SYSREAD Q1 = ID20 NR1\nL X+Q1 FMAX\n",
	 "p.nc:3:5: error: Q1 was read from the control (FN 18, ID20 NR1), and that value is not known here: to check the "
	 "program, assign the value by FN 0 behind it, or name the tool by initial_tool of the <setup>"},
	{"TOOL CALL 1 Z DR+1\nFN 18: SYSREAD Q1 = ID200 NR1 IDX1\nL X+Q1 FMAX\n",
	 "p.nc:4:5: error: Q1 was read from the control (FN 18, ID200 NR1 IDX1), and that value is not known here: to "
	 "check the program, assign the value by FN 0 behind it"},
	{"FN 18: SYSREAD Q1 = ID530 NR1\nL X+Q1 FMAX\n",
	 "p.nc:3:5: error: Q1 was read from the control (FN 18, ID530 NR1), and that value is not known here: to "
	 "check the program, assign the value by FN 0 behind it, or select the preset by CYCL DEF 247 before it"},
	{"FN 18: SYSREAD Q1 ID20 NR1\n",
	 "p.nc:2:19: error: '=' is needed here"},
	{"FN 18: SYSREAD X = ID20 NR1\n",
	 "p.nc:2:16: error: a Q parameter is needed here"},
	{"FN 18: SYSREAD Q1 = NR1\n",
	 "p.nc:2:21: error: SYSREAD needs ID and its number"},
	{"FN 18: READ Q1 = ID20 NR1\n",
	 "p.nc:2:8: error: FN 18 needs SYSREAD here"},
	{"FN 28: READ Q1\n",
	 "p.nc:2:8: error: FN 28 needs TABREAD here"},
	{"FN 17: SYSWRITE ID210 NR4 IDX1 = 2\n",
	 "p.nc:2:4: error: FN 17 writes data of the control: what that changes is not known here; leave it out to check the "
	 "program"},
	{"FN 20: WAIT FOR I5==1\n",
	 "p.nc:2:4: error: FN 20: what the machine's PLC does is not known here"},
	{"Q1 = 5 * ~\n 1 / 0\n",
	 "p.nc:2:13: error: division by zero"},
	{"TOOL CALL DL+1\n",
	 "p.nc:2:11: error: DL and DR without a tool: no TOOL CALL has named one"},
	{"TOOL CALL 1 Z DL+1\nTOOL CALL DR+1\n",
	 "p.nc:3:11: error: DL was given before and is left out here: whether it still counts is not known here; write it, "
	 "too"},
	{"L X+Q108 FMAX\n",
	 "p.nc:2:5: error: Q108 is a value of the control that is not known here: write the value in its place"},
	{"TOOL CALL 3 Z\nL X+Q108 FMAX\n",
	 "p.nc:3:5: error: Q108 is a value of the control that is not known here: write the value in its place"},
	{"L M3\nL M5\nL X+Q110 FMAX\n",
	 "p.nc:4:5: error: Q110 is a value of the control that is not known here: write the value in its place"},
	{"FN 99: Q1 = 1\n",
	 "p.nc:2:4: error: FN 99 is not supported"},
	{"TOOL CALL 9 Z\n",
	 "p.nc:2:11: error: the setup defines no tool T9: add <tool number=\"9\" length=\"\"/> with "
	 "what it is made of"},
	{"TOOL CALL \"NONE\" Z\n",
	 "p.nc:2:11: error: the setup defines no tool named \"NONE\": add <tool number=\"\" "
	 "name=\"NONE\" length=\"\"/> with what it is made of"},
	{"TOOL CALL \"TWIN\" Z\n",
	 "p.nc:2:11: error: the setup has two tools named \"TWIN\", T3 and T4, and the control decides which it loads: "
	 "keep the one in the spindle, or give the other one another name"},
	{"TOOL CALL 1 Y\n",
	 "p.nc:2:13: error: another tool axis than Z is not supported"},
	{"TOOL CALL 1.25 Z\n",
	 "p.nc:2:11: error: a tool's number is a whole number from 0 to 32767"},
	{"TOOL CALL 1 Z FU0.2\n",
	 "p.nc:2:11: error: a feed per revolution (FU, FZ) without a spindle speed (S)"},
	{"SECTION START\n",
	 "p.nc:2:9: error: SECTION needs MONITORING"},
	{"TOOL CALL 1 Z Q\n",
	 "p.nc:2:15: error: TOOL CALL has a tool, its axis, S, F, FU, FZ, DL, DR and DR2"},
	{"TOOL DEF 1 L50\n",
	 "p.nc:2:12: error: TOOL DEF gives T1 a length of 50 mm, and the setup 100 mm: which of them the control "
	 "takes depends on whether its tool table is active; make them agree, or set tool_def=\"ignored\" in the "
	 "machine file's <controller> if the table counts"},
	{"TOOL DEF 1 X50\n",
	 "p.nc:2:12: error: TOOL DEF has a number, L and R"},
	{"TOOL FOO\n",
	 "p.nc:2:6: error: TOOL needs CALL or DEF"},
	{"M6\n",
	 "p.nc:2:1: error: M6, but no TOOL CALL has named a tool: if TOOL CALL alone changes it, set "
	 "m6=\"ignored\" in the machine file's <controller>"},
	{"L X+1 FMAX\nCALL LBL 1 REP 2\nL X+3 FMAX\nM30\nLBL 1\nL IX+1 FMAX\nLBL 0\n",
	 "p.nc:3:10: error: REP repeats the section from the label to this block, but the label stands behind it: a "
	 "subprogram is called without REP, once for each time that it runs"},
	{"TOOL CALL 1 Z\nL X+1 FMAX\nM6\n",
	 "p.nc:4:1: error: axes have moved between TOOL CALL and M6: if TOOL CALL alone changes the tool, set "
	 "m6=\"ignored\" in the machine file's <controller>; else write M6 right behind TOOL CALL"},
	{"F100\nC X+1 Y+1 DR+\n",
	 "p.nc:3:3: error: no CC has given the centre"},
	{"F100\nCR X+10 Y+0 R4 DR+\n",
	 "p.nc:3:13: error: a radius of 4 mm does not reach from the start of the circle to its end"},
	{"F100\nCR X+0 Y+0 R4 DR+\n",
	 "p.nc:3:4: error: a circle by its radius cannot end where it starts; use CC and C"},
	{"F100\nCR X+1 Y+0 DR+\n",
	 "p.nc:3:4: error: CR needs its radius in R"},
	{"STOP X\n",
	 "p.nc:2:7: error: a value is needed here"},
	{"END\n",
	 "p.nc:2:4: error: END needs PGM"},
	{"Q1=0\nLBL 2\nQ1=Q1+1\nLBL 1\nFN 9: IF +Q1 EQU +2 GOTO LBL 2\nFN 9: IF +Q1 EQU +1 GOTO LBL 4\n"
	 "LBL 4\nQ1=Q1+0.5\nCALL LBL 1 REP 2\nL X+1 FMAX\nLBL 3\nL X+1 FMAX\n",
	 "p.nc:10:10: error: a jump has left this program section before its repeats were done: whether "
	 "they are counted anew is not known here"},
	/* A coordinate after M118 would be read as a limit of the handwheel. */
	{"L X+10 F100 M118 X1 X+50\n",
	 "p.nc:2:21: error: behind M118 stand the limits of the handwheel, each once and without a sign, as in M118 X1 Y1: "
	 "coordinates of the block belong before M118"},
	{"L M118 X1 IY5\n",
	 "p.nc:2:11: error: behind M118 stand the limits of the handwheel, each once and without a sign, as in M118 X1 Y1: "
	 "coordinates of the block belong before M118"},
	{"L X+1 FMAX M118 X1 X2\n",
	 "p.nc:2:20: error: behind M118 stand the limits of the handwheel, each once and without a sign, as in M118 X1 Y1: "
	 "coordinates of the block belong before M118"},
	{"CALL LBL QS1\n",
	 "p.nc:2:10: error: QS1 has no value that is known here; if the control holds one from before, set "
	 "<variable name=\"QS1\" value=\"\"/> in the machine file's <controller>"},
	{"FN 9: IF Q1 IS UNDEFINED GOTO LBL 1\nLBL 1\n",
	 "p.nc:2:10: error: Q1 has no value: the program has not assigned one; if the control holds one from "
	 "before, set <variable name=\"Q1\" value=\"\"/> in the machine file's <controller>"},
	{"FN 9: IF +Q1 IS UNDEFINED GOTO LBL 1\nLBL 1\n",
	 "p.nc:2:11: error: Q1 has no value: the program has not assigned one; if the control holds one from "
	 "before, set <variable name=\"Q1\" value=\"\"/> in the machine file's <controller>"},
	{"Q1=5\nFN 9: IF Q1 IS GOTO LBL 1\nLBL 1\n",
	 "p.nc:3:16: error: IS needs DEFINED or UNDEFINED"},
	{"FN 0: Q1 SET 5\n",
	 "p.nc:2:14: error: SET needs UNDEFINED"},
};

START_TEST(fault_table)
{
	klartext_expect_fault(&faults[_i]);
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
	{"BEGIN PGM T MM\nQ1 = 5 ~\n",
	 "p.nc:2:1: error: the next line, in which this formula goes on, cannot be read"},
	{"BEGIN PGM T MM\nL X+1 FMAX ~\n",
	 "p.nc:2:1: error: the next line, in which this block goes on, cannot be read"},
	{"BEGIN PGM T MM\nL X+1 FMAX ~\n7 L Y+2\nEND PGM T MM\n",
	 "p.nc:2:1: error: '~' continues this block, but the next line begins with a number"},
	{"BEGIN PGM T MM\nBLK FORM 0.2 X+1 Y+1 Z+0 ~\nL Y+2 FMAX\nEND PGM T MM\n",
	 "p.nc:2:1: error: '~' continues this block, but the next line begins another one"},
	{"BEGIN PGM T MM\nFN 16: F-PRINT A / B ~\n Q1 = 5\nEND PGM T MM\n",
	 "p.nc:2:1: error: '~' continues this block, but the next line begins another one"},
	{"BEGIN PGM T MM\nBLK FORM 0.2 X+1 Y+1 Z+0 ~\nFSELECT 1\nEND PGM T MM\n",
	 "p.nc:2:1: error: '~' continues this block, but the next line begins another one"},
	{"BEGIN PGM T MM\nL X+1 ~ Y+2 ~\n Z+3 FMAX\nEND PGM T MM\n",
	 "p.nc:2:7: error: this is no word of a positioning block"},
	{"BEGIN PGM T MM\nL X+1 ~\n Y+2 ~ Z+3 ~\n A+4 FMAX\nEND PGM T MM\n",
	 "p.nc:2:13: error: this is no word of a positioning block"},
	{"BEGIN PGM T MM\nL X+1 ~\n Y+2 FMAX ~ ; more\n Z+3\nEND PGM T MM\n",
	 "p.nc:2:18: error: this is no word of a positioning block"},
	{"BEGIN PGM T MM\nQ1 = 1 ~ + 2 ~\n + 3\nEND PGM T MM\n",
	 "p.nc:2:8: error: the block should end here"},
	{"BEGIN PGM T MM\nL X+1 FMAX ; more ~\n Y+2\nEND PGM T MM\n",
	 "p.nc:3:2: error: '~' behind the comment of the block before leaves open whether this line belongs to it: "
	 "take the '~' away, or write it before the comment's ';' and without the comment"},
	{"BEGIN PGM T MM\nL X+1 FMAX\n7 END PGM T MM\n\n; the next\n0 BEGIN PGM U MM\nL X+2 FMAX\nEND PGM U MM\n",
	 "p.nc:6:1: error: another program begins behind END PGM, and the control reads none of it: give each program as "
	 "a file of its own"},
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

/* If all faults are wanted, reading continues after each fault. */
START_TEST(all_faults)
{
	struct gcode_case c;

	klartext_case(&c);
	c.config.read.all_faults = true;
	ck_assert(!klartext_run(&c, "L X+1\nL Q5\nL X+2 FMAX\nFOO\nCYCL DEF 18.0\n"));
	ck_assert_uint_eq(c.diag.errors, 4);
	case_release(&c);
	/* A tool that the setup lacks causes no further faults: the label ends, and the speed is that of TOOL CALL. */
	klartext_case(&c);
	c.config.read.all_faults = true;
	ck_assert(!klartext_run(&c, "TOOL CALL 9 Z S500\nCALL LBL 1\nM3\nL Z+5 FMAX\nCYCL DEF 207 X Q200=2 Q201=-5 Q239=1 Q203=+0 "
				    "Q204=+5\nCYCL CALL\nM30\nLBL 1\n5 CYCL DEF 247 X ~\n Q339=7 ;N\nLBL 0\n"));
	ck_assert_uint_eq(c.diag.errors, 2);
	ck_assert_ptr_nonnull(strstr(strbuf_text(&c.messages), "p.nc:11:2: error: the setup defines no work offset G54.1 P7"));
	case_release(&c);
}
END_TEST

/* A joined block may be as long as a few lines, but not as long as a whole file. */
START_TEST(endless_block)
{
	for (int length = 32000; length <= 33000; length += 1000) {
		struct strbuf program = {0};
		struct gcode_case c;

		klartext_case(&c);
		strbuf_addf(&program, "BEGIN PGM T MM\nL X+1 ~\nY+2%*s~\nZ+3%*s~\nR0 FMAX\nEND PGM T MM\n", length, " ",
			    length, " ");
		ck_assert_int_eq(case_run(&c, strbuf_text(&program)), length == 32000);
		if (length > 32000)
			ck_assert_str_eq(strbuf_text(&c.messages), "p.nc:2: error: '~' continues this block over more than "
								   "65536 bytes; is this an NC program?\n");
		strbuf_release(&program);
		case_release(&c);
	}
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("bad");

	tcase_add_loop_test(tcase, fault_table, 0, COUNT(faults));
	tcase_add_loop_test(tcase, head_table, 0, COUNT(heads));
	tcase_add_test(tcase, all_faults);
	tcase_add_test(tcase, endless_block);
	return run_suite("gcode_klartext_bad", tcase);
}
