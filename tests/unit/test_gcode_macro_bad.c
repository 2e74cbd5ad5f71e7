/* test_gcode_macro_bad.c - macros of Fanuc and Haas that must be refused, each with all that is said of it. */
#include "gcode_case.h"

enum { F = 1, H = 2, BOTH = F | H };

static const struct {
	int dialects;
	const char *program, *messages;
} faults[] = {
	{BOTH, "#1\nM30\n", "p.nc:1:3: error: '=' is missing after the variable\n    #1\n      ^\n"},
	{BOTH, "#1=\nM30\n", "p.nc:1:4: error: a value is needed here\n    #1=\n       ^\n"},
	{BOTH, "#0=1\n", "p.nc:1:1: error: #0 is always vacant; it cannot be assigned\n    #0=1\n    ^\n"},
	{BOTH, "#1=[1+2\n", "p.nc:1:8: error: this expression is not closed: ']' is missing\n    #1=[1+2\n           ^\n"},
	{BOTH, "#1=1+\n", "p.nc:1:6: error: a value is needed here\n    #1=1+\n         ^\n"},
	{BOTH, "#1=1 G0 X1.\n",
	 "p.nc:1:6: error: a macro statement needs a block of its own\n    #1=1 G0 X1.\n         ^\n"},
	{BOTH, "G0 X1. #1=2\n",
	 "p.nc:1:8: error: an assignment needs a block of its own\n    G0 X1. #1=2\n           ^\n"},
	{BOTH, "#1=1 #2=#1\n",
	 "p.nc:1:9: error: #1 is assigned in this block; read it in the next block\n    #1=1 #2=#1\n            ^\n"},
	{BOTH, "#1=1/0\n", "p.nc:1:5: error: division by zero\n    #1=1/0\n        ^\n"},
	{BOTH, "#1=SQRT[-1]\n",
	 "p.nc:1:4: error: SQRT of -1: the value must not be negative\n    #1=SQRT[-1]\n       ^\n"},
	{BOTH, "#1=ACOS[2]\n",
	 "p.nc:1:4: error: ACOS of 2: the value must be from -1 to 1\n    #1=ACOS[2]\n       ^\n"},
	{BOTH, "#1=TAB[1]\n", "p.nc:1:4: error: a value is needed here\n    #1=TAB[1]\n       ^\n"},
	{BOTH, "#1=SIN 30\n", "p.nc:1:8: error: SIN needs a value in brackets, [...]\n    #1=SIN 30\n           ^\n"},
	{BOTH, "##1=1\n", "p.nc:1:1: error: ## is not allowed; write #[#...]\n    ##1=1\n    ^\n"},
	{F, "#<a>=1\n",
	 "p.nc:1: warning: this looks like a program for LinuxCNC (#<name>), but the dialect is fanuc\n"
	 "p.nc:1:1: error: named variables are not supported\n    #<a>=1\n    ^\n"},
	{H, "#<a>=1\n",
	 "p.nc:1: warning: this looks like a program for LinuxCNC (#<name>), but the dialect is haas\n"
	 "p.nc:1:1: error: named variables are not supported\n    #<a>=1\n    ^\n"},
	{BOTH, "#1.5=1\n",
	 "p.nc:1:1: error: # needs a variable number or an expression in brackets\n    #1.5=1\n    ^\n"},
	{BOTH, "#[1.5]=1\n",
	 "p.nc:1:1: error: the number of a variable must be a whole number that is not negative\n    #[1.5]=1\n    ^\n"},
	{BOTH, "G0 XSIN[30]\n",
	 "p.nc:1:5: error: a function after an address needs brackets: X[...]\n    G0 XSIN[30]\n        ^\n"},
	{BOTH, "G0 X#1+1.\n", "p.nc:1:7: error: unexpected '+'\n    G0 X#1+1.\n          ^\n"},
	{BOTH, "G0 X[#1]\n",
	 "p.nc:1:5: error: brackets around a variable without a value; remove the brackets\n    G0 X[#1]\n        ^\n"},
	{F, "G65 P7 A[ROUND[1.5]]\nO7\nM99\n",
	 "p.nc:1:10: error: ROUND in an argument: controls round to different digits; assign the value to a variable "
	 "first\n    G65 P7 A[ROUND[1.5]]\n             ^\n"},
	{F, "#1=FIX[3*1.0000000001]\n",
	 "p.nc:1:4: error: FIX of a number that differs from 3 by only 3e-10, which is less than the precision of a "
	 "control\n    #1=FIX[3*1.0000000001]\n       ^\n"},
	{F, "#50=1\n",
	 "p.nc:1:1: error: #50 is not a variable of the fanuc dialect; programs have #1 to #33, #100 to #199 and #500 "
	 "to #999\n    #50=1\n    ^\n"},
	{H, "#50=1\n",
	 "p.nc:1:1: error: #50 is not a variable of the haas dialect; programs have #1 to #33, #100 to #199 and #500 "
	 "to #999\n    #50=1\n    ^\n"},
	{F, "G0 X#200\n",
	 "p.nc:1:5: error: #200 is not a variable of the fanuc dialect; programs have #1 to #33, #100 to #199 and #500 "
	 "to #999\n    G0 X#200\n        ^\n"},
	{H, "G0 X#200\n",
	 "p.nc:1:5: error: #200 is not a variable of the haas dialect; programs have #1 to #33, #100 to #199 and #500 "
	 "to #999\n    G0 X#200\n        ^\n"},
	{BOTH, "#1=#500\n",
	 "p.nc:1:4: error: #500 keeps its value from earlier programs, and this program has not set it: set <variable "
	 "name=\"#500\" value=\"\"/> in the machine file's <controller>\n    #1=#500\n       ^\n"},
	{H, "#1=#100\n",
	 "p.nc:1:4: error: #100 keeps its value from earlier programs, and this program has not set it: set <variable "
	 "name=\"#100\" value=\"\"/> in the machine file's <controller>\n    #1=#100\n       ^\n"},
	{F, "#1=#10100\n",
	 "p.nc:1:4: error: #10100 is a tool offset of the control's table: set <variable name=\"#10100\" value=\"\"/> in "
	 "the machine file's <controller>\n    #1=#10100\n       ^\n"},
	{F, "#1=LN[0]\n", "p.nc:1:4: error: LN of 0: the value must be greater than 0\n    #1=LN[0]\n       ^\n"},
	{F, "G54 M98 P48\nO48\nM99\n",
	 "p.nc:1:9: error: P can belong to G54 or to M98, and it is not known to which; write two blocks\n    G54 M98 "
	 "P48\n"
	 "            ^\n"},
	{F, "#1=POW[2]\n", "p.nc:1:9: error: POW needs two values, POW[a,b]\n    #1=POW[2]\n            ^\n"},
	{F, "#1=POW[-1,.5]\n",
	 "p.nc:1:4: error: POW of -1 and 0.5 may be undefined: the base must be greater than 0\n"
	 "    #1=POW[-1,.5]\n       ^\n"},
	{H, "#1=POW[2,3]\n", "p.nc:1:4: error: Haas has no function POW\n    #1=POW[2,3]\n       ^\n"},
	{H, "#1=LN[2]\n", "p.nc:1:4: error: Haas has no function LN\n    #1=LN[2]\n       ^\n"},
	{H, "#1=ATAN[1]/[2]\n",
	 "p.nc:1:11: error: ATAN[...]/[...]: in Haas's manual ATAN has one value; for a division write [ATAN[...]]/\n  "
	 "  #1=ATAN[1]/[2]\n              ^\n"},
	{H, "#1=#2+1\n",
	 "p.nc:1:6: error: a variable without a value: Haas's manual does not say what the control computes\n    "
	 "#1=#2+1\n         ^\n"},
	{H, "IF [#1 EQ 0] GOTO 1\n",
	 "p.nc:1:8: error: a variable without a value: Haas's manual does not say what the control computes\n    IF "
	 "[#1 EQ 0] GOTO 1\n           ^\n"},
	{H, "#1=1 AND 2+1\n",
	 "p.nc:1:11: error: AND, OR and XOR beside other operators: Haas defines no order; use brackets\n    #1=1 AND "
	 "2+1\n              ^\n"},
	{F, "#1=[1 EQ 1]\n",
	 "p.nc:1:4: error: a comparison cannot be used as a number here\n    #1=[1 EQ 1]\n       ^\n"},
	{F, "IF [#1] GOTO 1\nN1\n",
	 "p.nc:1:4: error: IF needs a comparison (EQ, NE, GT, GE, LT or LE)\n    IF [#1] GOTO 1\n       ^\n"},
	{F, "IF [[1 EQ 1] AND 1] GOTO 1\n",
	 "p.nc:1:14: error: AND, OR and XOR need two comparisons or two numbers, not one of each\n    IF [[1 EQ 1] AND "
	 "1] GOTO 1\n                 ^\n"},
	{BOTH, "IF [1.0000000001 EQ 1] GOTO 1\n",
	 "p.nc:1:18: error: these numbers differ by only 1e-10, which is less than the precision of a control; compare "
	 "with a margin\n    IF [1.0000000001 EQ 1] GOTO 1\n                     ^\n"},
	{BOTH, "IF [1 EQ 1 EQ 1] GOTO 1\n",
	 "p.nc:1:12: error: the result of a comparison cannot be compared again; use AND or OR\n    IF [1 EQ 1 EQ 1] "
	 "GOTO 1\n               ^\n"},
	{F, "#1=1.5 AND 1\n",
	 "p.nc:1:8: error: AND, OR and XOR need whole numbers that are not negative, not 1.5\n    #1=1.5 AND 1\n       "
	 "    ^\n"},
	{BOTH, "#1=-1 OR 1\n",
	 "p.nc:1:7: error: AND, OR and XOR need whole numbers that are not negative, not -1\n    #1=-1 OR 1\n          "
	 "^\n"},
	{F, "#1=1.5 MOD 1\n",
	 "p.nc:1:8: error: MOD of 1.5 and 1: controls agree only for whole numbers\n    #1=1.5 MOD 1\n           ^\n"},
	{H, "#1=1.5 MOD 1\n",
	 "p.nc:1:8: error: MOD of 1.5 and 1: controls agree only for whole numbers that are not negative\n    #1=1.5 "
	 "MOD 1\n           ^\n"},
	{BOTH, "IF [1 EQ 1] G0 X1.\n",
	 "p.nc:1:13: error: IF [...] needs GOTO or THEN\n    IF [1 EQ 1] G0 X1.\n                ^\n"},
	{BOTH, "IF 1 EQ 1 GOTO 1\n",
	 "p.nc:1:4: error: IF needs a value in brackets, [...]\n    IF 1 EQ 1 GOTO 1\n       ^\n"},
	{BOTH, "IF [1 EQ 1] THEN G0 X1.\n",
	 "p.nc:1:18: error: THEN is supported only with an assignment\n    IF [1 EQ 1] THEN G0 X1.\n                   "
	 "  ^\n"},
	{BOTH, "IF [1 EQ 1] THEN GOTO 1\n",
	 "p.nc:1:18: error: THEN is supported only with an assignment\n    IF [1 EQ 1] THEN GOTO 1\n                   "
	 "  ^\n"},
	{BOTH, "IF [0 EQ 1] GOTO 1 G0 X1.\nN1\n",
	 "p.nc:1:20: error: a macro statement needs a block of its own\n    IF [0 EQ 1] GOTO 1 G0 X1.\n"
	 "                       ^\n"},
	{BOTH, "IF [0 EQ 1] THEN #1=SIN[2] MOD 3 X[1.]\n",
	 "p.nc:1:34: error: a macro statement needs a block of its own\n    IF [0 EQ 1] THEN #1=SIN[2] MOD 3 X[1.]\n   "
	 "                                  ^\n"},
	{F, "G0 X-#1\n",
	 "p.nc:1:5: error: a sign before a variable without a value: controls differ in whether the result is 0 or has "
	 "no value\n    G0 X-#1\n        ^\n"},
	{BOTH, "GOTO 5\nN4\n", "p.nc:1:6: error: the program has no block N5\n    GOTO 5\n         ^\n"},
	{BOTH, "GOTO 0\n", "p.nc:1:6: error: block numbers start at 1\n    GOTO 0\n         ^\n"},
	{BOTH, "GOTO 1.5\n",
	 "p.nc:1:6: error: the block number of GOTO must be a whole number that is not negative\n    GOTO 1.5\n         "
	 "^\n"},
	{F, "GOTO #1\n",
	 "p.nc:1:6: error: the block number of GOTO must be a whole number that is not negative\n    GOTO #1\n         "
	 "^\n"},
	{BOTH, "GOTO\n", "p.nc:1:5: error: a value is needed here\n    GOTO\n        ^\n"},
	{H, "N5 G0\nN5 X1.\nGOTO 5\n",
	 "p.nc:3:6: error: N5 occurs in lines 1 and 2, so the jump is ambiguous\n    GOTO 5\n         ^\n"},
	{BOTH, "O1\nM98 P2\nM30\nO2\nM99\nO2\nG0 X1.\nM99\n",
	 "p.nc:2:1: error: O2 occurs in lines 4 and 6 of p.nc, so the call is ambiguous\n    M98 P2\n    ^\n"},
	{BOTH, "WHILE [1 EQ 1] DO4\nEND4\n",
	 "p.nc:1:18: error: the number of DO must be from 1 to 3\n    WHILE [1 EQ 1] DO4\n                     ^\n"},
	{BOTH, "WHILE [1 EQ 1]\nEND1\n",
	 "p.nc:1:15: error: WHILE [...] needs DO\n    WHILE [1 EQ 1]\n                  ^\n"},
	{BOTH, "WHILE [1 EQ 1] DO1\nG0 X1.\n",
	 "p.nc:1:18: error: this loop is not closed: END1 is missing\n    WHILE [1 EQ 1] DO1\n                     "
	 "^\n"},
	{BOTH, "END1\n",
	 "p.nc:1:1: error: END1 without DO1; a jump into a loop is not allowed\n    END1\n    ^\n"},
	{BOTH, "WHILE [1 EQ 1] DO1\nWHILE [1 EQ 1] DO1\nEND1\nEND1\n",
	 "p.nc:1:18: error: line 2 has DO1 inside this loop, which is also DO1\n    WHILE [1 EQ 1] DO1\n               "
	 "      ^\n"},
	{BOTH, "WHILE [1 EQ 1] DO1\nWHILE [1 EQ 1] DO2\nEND1\nEND2\n",
	 "p.nc:1:18: error: END1 in line 3 crosses this loop: DO2 is still open there\n    WHILE [1 EQ 1] DO1\n        "
	 "             ^\n"},
	{BOTH, "GOTO 5\nDO1\nN5 G0 X1.\nEND1\n",
	 "p.nc:4:1: error: END1 without DO1; a jump into a loop is not allowed\n    END1\n    ^\n"},
	{BOTH, "#3000=1 (NO PART)\n",
	 "p.nc:1:1: error: #3000=1 stops the program with an alarm here\n    #3000=1 (NO PART)\n    ^\n"},
	{BOTH, "#3004=7\n",
	 "p.nc:1:1: error: #3004=7 switches exact stops off, which is not supported\n    #3004=7\n    ^\n"},
	{BOTH, "#1=#3001\n",
	 "p.nc:1:4: error: #3001 (a clock) is not known before the program runs\n    #1=#3001\n       ^\n"},
	{BOTH, "#1=#1000\n",
	 "p.nc:1:4: error: #1000 is the state of an input or output, which may change while the program runs; if it "
	 "stays the same: set <variable name=\"#1000\" value=\"\"/> in the machine file's <controller>\n    #1=#1000\n "
	 "      ^\n"},
	{BOTH, "#1=#5021\n",
	 "p.nc:1:4: error: #5021 (the position of the machine during read-ahead (#5001 has the programmed position)) "
	 "is not known before the program runs\n    #1=#5021\n       ^\n"},
	{BOTH, "#1=#5061\n",
	 "p.nc:1:4: error: #5061 (a probed position) is not known before the program runs\n    #1=#5061\n       ^\n"},
	{BOTH, "#1=#2001\n",
	 "p.nc:1:4: error: #2001 is a tool offset of the control's table: set <variable name=\"#2001\" value=\"\"/> in "
	 "the machine file's <controller>\n    #1=#2001\n       ^\n"},
	{BOTH, "#1=#5201\n",
	 "p.nc:1:4: error: #5201 (an external work offset of the control, which is added to all work offsets) is not "
	 "known before the program runs\n    #1=#5201\n       ^\n"},
	{F, "#1=#6000\n",
	 "p.nc:1:4: error: #6000 is an unknown system variable; if it stays the same while the program runs: set "
	 "<variable name=\"#6000\" value=\"\"/> in the machine file's <controller>\n    #1=#6000\n       ^\n"},
	{H, "#1=#6000\n",
	 "p.nc:1:4: error: #6000 is an unknown system variable; if it stays the same while the program runs: set "
	 "<variable name=\"#6000\" value=\"\"/> in the machine file's <controller>\n    #1=#6000\n       ^\n"},
	{F, "#5001=1\n", "p.nc:1:1: error: #5001 cannot be assigned here in the fanuc dialect\n    #5001=1\n    ^\n"},
	{H, "#5001=1\n", "p.nc:1:1: error: #5001 cannot be assigned here in the haas dialect\n    #5001=1\n    ^\n"},
	{BOTH, "#5221=1\nG0 X1.\n",
	 "p.nc:2:1: error: G54 was changed by assignment while it was active, and controls differ in when that takes "
	 "effect; select G54 again before the next move\n    G0 X1.\n    ^\n"},
	{BOTH, "#5221=1\n#1=#5001\n",
	 "p.nc:2:4: error: #5001 cannot be read here: G54 was changed by assignment while it was active; select it "
	 "again first\n    #1=#5001\n       ^\n"},
	{BOTH, "N1 GOTO 1\n",
	 "p.nc:1:1: error: 50 blocks of loops and subprograms were executed: is this loop endless? --max-blocks sets "
	 "another limit\n    N1 GOTO 1\n    ^\n"},
	{BOTH, "DO1\nEND1\n",
	 "p.nc:2:1: error: 50 blocks of loops and subprograms were executed: is this loop endless? --max-blocks sets "
	 "another limit\n    END1\n    ^\n"},
	{BOTH, "#[#1]=1\n",
	 "p.nc:1:1: error: the number of a variable must be a whole number that is not negative\n    #[#1]=1\n    ^\n"},
	{BOTH, "#1=2147483648 AND 1\n",
	 "p.nc:1:15: error: AND, OR and XOR need whole numbers that are not negative, not 2147483648\n    "
	 "#1=2147483648 AND 1\n                  ^\n"},
	{BOTH, "#1=[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[\n",
	 "p.nc:1:36: error: brackets are nested deeper than 32 levels\n    "
	 "#1=[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[\n                                       ^\n"},
	{F, "G65 P7 I1. I1. I1. I1. I1. I1. I1. I1. I1. I1. I1.\n",
	 "p.nc:1:48: error: more than ten sets of I, J and K\n    G65 P7 I1. I1. I1. I1. I1. I1. I1. I1. I1. "
	 "I1. I1.\n                                                   ^\n"},
	{BOTH, "#7001=#0\n", "p.nc:1:1: error: #7001 cannot be vacant\n    #7001=#0\n    ^\n"},
	{BOTH, "#1=1e5\n",
	 "p.nc:1:5: error: a macro statement needs a block of its own\n    #1=1e5\n        ^\n"},
	{BOTH, "#1=--1\n", "p.nc:1:5: error: two signs in a row\n    #1=--1\n        ^\n"},
	{F, "G65 P7 A1 X7 F2\n",
	 "p.nc:1:1: error: program O7 is neither in p.nc nor in a file of its own beside it or in an --include "
	 "folder\n    G65 P7 A1 X7 F2\n    ^\n"},
	{BOTH, "IF [1 EQ 1\n",
	 "p.nc:1:11: error: this expression is not closed: ']' is missing\n    IF [1 EQ 1\n              ^\n"},
	{BOTH, "DO0\n", "p.nc:1:3: error: the number of DO must be from 1 to 3\n    DO0\n      ^\n"},
	{BOTH, "WHILE [1 EQ 1] DO1\n(\nEND2\n",
	 "p.nc:1:18: error: END2 in line 3 crosses this loop: DO1 is still open there\n    WHILE [1 EQ 1] DO1\n        "
	 "             ^\n"},
	{BOTH, "/GOTO 3\n", "p.nc:1:7: error: the program has no block N3\n    /GOTO 3\n          ^\n"},
	{BOTH, "N10 N20\n", "p.nc:1:5: error: N is allowed only at the start of a block\n    N10 N20\n        ^\n"},
	{F, "G67 X1.\n", "p.nc:1:5: error: a macro statement needs a block of its own\n    G67 X1.\n        ^\n"},
	{F, "G66 A1.\n", "p.nc:1:1: error: a macro call needs P (program number)\n    G66 A1.\n    ^\n"},
	{F, "G66 P7\nG0 X1. M30\nO7\nM99\n",
	 "p.nc:2:8: error: M30 in a block with motion while G66 is active; write G67 first\n    G0 X1. M30\n           "
	 "^\n"},
	{F, "G66 P7\nG0 X1. M98 P7\nM30\nO7\nM99\n",
	 "p.nc:2:8: error: M98 in a block with motion while G66 is active; write G67 first\n    G0 X1. M98 P7\n        "
	 "   ^\n"},
	{F, "G66 P7\nG81 X1. Z-1. R1. F9.\nM30\nO7\nM99\n",
	 "p.nc:2:1: error: axis words in a block without a plain move while G66 is active; write G67 first\n    G81 "
	 "X1. Z-1. R1. F9.\n    ^\n"},
	{F, "G66 P7\nM98 P8\nM30\nO7\nM99\nO8\nG0 X1.\nM99\n",
	 "p.nc:7:1: error: a move in a subprogram while G66 is active is not supported\n    G0 X1.\n    ^\np.nc:2:1: "
	 "note: O8 is called from here\n"},
	{BOTH, "DO1\nO2\nEND1\n",
	 "p.nc:1:3: error: this loop is not closed: END1 is missing\n    DO1\n      ^\n"},
	{BOTH, "M98 P7\nM30\nO7\nGOTO 5\nM99\nO8\nN5 M99\n",
	 "p.nc:4:6: error: the program has no block N5\n    GOTO 5\n         ^\np.nc:1:1: note: O7 is called "
	 "from here\n"},
	{BOTH, "M98 P7\nM30\nN5\nO7\nGOTO 5\nM99\n",
	 "p.nc:5:6: error: the program has no block N5\n    GOTO 5\n         ^\np.nc:1:1: note: O7 is called "
	 "from here\n"},
	{BOTH, "O[1]\n",
	 "p.nc:1:1: error: a program number must be a whole number that is not negative\n    O[1]\n    ^\n"},
	{BOTH, "#1=ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN["
	 "ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[\n",
	 "p.nc:1:168: error: brackets are nested deeper than 32 levels\n    "
	 "#1=ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[\n                                                                                                                                                                           ^\n"},
	{H, "G43.5 H1\n",
	 "p.nc:1:1: error: G43.5: tool centre point control with tool vectors is not supported; "
	 "post the program without it\n    G43.5 "
	 "H1\n    ^\n"},
	{F, "G254 H1\n",
	 "p.nc:1: warning: this looks like a program for Haas (G254), but the dialect is fanuc\n"
	 "p.nc:1:1: error: G254 is not a G-code of the fanuc dialect; if the machine builder made it, set <macro "
	 "code=\"\"/> in the machine file's <controller>\n    G254 H1\n    ^\n"},
	{H, "G254 H1\n",
	 "p.nc:1:6: error: H1 without G43: controls differ in whether it changes the length; write G43 H1\n    G254 "
	 "H1\n         ^\n"},
	{F, "#1=#5004\n",
	 "p.nc:1:4: error: #5004: the machine builder decides which axis has number 4 in the control\n    #1=#5004\n   "
	 "    ^\n"},
	{BOTH, "#1=#4001\n",
	 "p.nc:1:4: error: #4001 is a modal code or word whose value is not known here\n    #1=#4001\n    "
	 "   ^\n"},
	{BOTH, "#1=#4111\n",
	 "p.nc:1:4: error: #4111 is a modal code or word whose value is not known here\n    #1=#4111\n    "
	 "   ^\n"},
	{F, "G43.4 H0\n#1=#5001\n",
	 "p.nc:2:4: error: reading #5001 under tool centre point control is not supported\n    #1=#5001\n       ^\n"},
	{H, "G234 H0\n#1=#5001\n",
	 "p.nc:2:4: error: reading #5001 under tool centre point control is not supported\n    #1=#5001\n       ^\n"},
	{BOTH, "G65 A1.\n", "p.nc:1:1: error: a macro call needs P (program number)\n    G65 A1.\n    ^\n"},
	{BOTH, "G65 P7 G1.\n", "p.nc:1:8: error: a macro has no argument G\n    G65 P7 G1.\n           ^\n"},
	{BOTH, "G65 P7 N1.\n", "p.nc:1:8: error: a macro has no argument N\n    G65 P7 N1.\n           ^\n"},
	{BOTH, "G65 P0\n",
	 "p.nc:1:5: error: P must be a whole number from 1 to 99999999\n    G65 P0\n        ^\n"},
	{F, "G65 P7 L0\n",
	 "p.nc:1:8: error: L must be a whole number from 1 to 9999\n    G65 P7 L0\n           ^\n"},
	{F, "G65 P7 L2 A1.\nM30\nO7\nM99\n",
	 "p.nc:1:1: error: L with arguments is not supported, because it is not known whether each repetition starts "
	 "with the same arguments; call the macro in a loop\n    G65 P7 L2 A1.\n    ^\n"},
	{BOTH, "G0 G65 P7\n",
	 "p.nc:1:4: error: G65 must be the first word of its block after N\n    G0 G65 P7\n       ^\n"},
	{BOTH, "G65 P7\n",
	 "p.nc:1:1: error: program O7 is neither in p.nc nor in a file of its own beside it or in an --include "
	 "folder\n    G65 P7\n    ^\n"},
	{F, "G66 P7\nG66 P7\nM30\nO7\nM99\n",
	 "p.nc:2:1: error: G66 inside another G66 is not supported; cancel the first by G67\n    G66 P7\n    ^\n"},
	{F, "G66 P7\nG28 X0.\nM30\nO7\nM99\n",
	 "p.nc:2:5: error: axis words in a block without a plain move while G66 is active; write G67 first\n    G28 "
	 "X0.\n        ^\n"},
	{H, "G66 P7\n",
	 "p.nc:1:1: error: G66 is not a G-code of the haas dialect; if the machine builder made it, set <macro "
	 "code=\"\"/> in the machine file's <controller>\n    G66 P7\n    ^\n"},
	{F, "G66.1 P7\n",
	 "p.nc:1:1: error: G66.1: modal macro call at every block is not supported; "
	 "post the program without it\n    G66.1 P7\n    ^\n"},
	{BOTH, "M98\n", "p.nc:1:1: error: M98 needs P, the number of the program\n    M98\n    ^\n"},
	{BOTH, "M98 P7\n",
	 "p.nc:1:1: error: program O7 is neither in p.nc nor in a file of its own beside it or in an --include "
	 "folder\n    M98 P7\n    ^\n"},
	{F, "M98 P10000\n",
	 "p.nc:1:5: error: the program number (the last four digits of P) is 0\n    M98 P10000\n        ^\n"},
	{BOTH, "M98 P7 L0\n",
	 "p.nc:1:8: error: L0 must be a whole number from 1 to 9999\n    M98 P7 L0\n           ^\n"},
	{BOTH, "M98 P7 G4\n",
	 "p.nc:1:5: error: P can belong to G4 or to M98, and it is not known to which; write two blocks\n    M98 P7 "
	 "G4\n        ^\n"},
	{H, "G0 X1. M98 P7 Q5\n",
	 "p.nc:1:15: error: no code in the block uses the word Q\n    G0 X1. M98 P7 Q5\n                  ^\n"},
	{F, "G0 X1. M98 P7 Q5\n",
	 "p.nc:1:15: error: M98 with both P and Q is not supported\n    G0 X1. M98 P7 Q5\n                  ^\n"},
	{F, "M198 P1\n",
	 "p.nc:1:1: error: M198: subprogram call from another memory is not supported; "
	 "post the program without it or, if it moves no axis, set <mcode number=\"198\" "
	 "action=\"ignore\"/> in the machine file's <controller>\n    M198 P1\n    "
	 "^\n"},
	{F, "M97 P1\n",
	 "p.nc:1:1: error: M97 is not known; if it moves no axis, set <mcode number=\"97\" action=\"ignore\"/> in the "
	 "machine file's <controller>\n    M97 P1\n    ^\n"},
	{H, "M97 P5\n", "p.nc:1:5: error: the program has no block N5\n    M97 P5\n        ^\n"},
	{BOTH, "M99 L2\n", "p.nc:1:5: error: M99 with L is not supported\n    M99 L2\n        ^\n"},
	{BOTH, "M99 P5\n", "p.nc:1:5: error: the program has no block N5\n    M99 P5\n        ^\n"},
	{BOTH, "G0 X1.\nO2\nM30\n",
	 "p.nc:2:1: error: another program begins here before M2, M30 or M99\n    O2\n    ^\n"},
	{BOTH, "M98 P7\nM30\nO7\nG0 X1.\nO8\nM99\n",
	 "p.nc:5:1: error: another program begins here, but O7 has not ended: its M99 is missing\n    O8\n    "
	 "^\np.nc:1:1: note: O7 is called from here\n"},
	{BOTH, "M98 P7\nM30\nO7\nG0 X1.\n",
	 "p.nc:4: error: the subprogram O7 is not closed at the end of the file: M99 is missing\np.nc:1:1: note: O7 is "
	 "called from here\n"},
	{F, "M98 P7\nM30\nO7\nG0 Q1.\nM99\n",
	 "p.nc:4:4: error: no code in the block uses the word Q\n    G0 Q1.\n       ^\np.nc:1:1: note: O7 is "
	 "called from here\n"},
	{F, "G65 P7\nM30\nO7\nG65 P7\nM99\n",
	 "p.nc:4:1: error: more than 5 nested macro calls\n    G65 P7\n    ^\np.nc:4:1: note: O7 is called from "
	 "here\np.nc:4:1: note: O7 is called from here\np.nc:4:1: note: O7 is called from here\np.nc:4:1: note: O7 is "
	 "called from here\np.nc:1:1: note: O7 is called from here\n"},
	{F, "G5.1\n", "p.nc:1:1: error: G5.1 needs Q\n    G5.1\n    ^\n"},
	{F, "G5.1 Q2 X1.\n",
	 "p.nc:1:9: error: X in G5.1 selects an axis to smooth; its value must be 0\n    G5.1 Q2 X1.\n            ^\n"},
	{F, "G5 P3\n", "p.nc:1:1: error: G5 P3 (high-speed cycle machining) is not supported; "
	 "write its moves as G1\n    G5 P3\n    ^\n"},
	{F, "G8 P2\n", "p.nc:1:4: error: P2 must be a whole number from 0 to 1\n    G8 P2\n       ^\n"},
	{F, "G5.1 Q1\nG61\n",
	 "p.nc:2:1: error: G61 while G5.1, G8 or G5 P10000 is active is not supported\n    G61\n    ^\n"},
	{H, "G187 P4\n", "p.nc:1:6: error: P4 must be a whole number from 1 to 3\n    G187 P4\n         ^\n"},
	{H, "G103 P20\n", "p.nc:1:6: error: P20 must be a whole number from 0 to 15\n    G103 P20\n         ^\n"},
	{H, "G253\n",
	 "p.nc:1:1: error: G253: spindle orientation to the feature coordinates (post with rotary words and G254) is not supported; "
	 "post the program without it\n    G253\n"
	 "    ^\n"},
	{H, "G268 X0. Y0. Z0. I30.\n",
	 "p.nc:1:1: error: G268: feature coordinate system (post with rotary words and G254) is not supported; "
	 "post the program without it\n"
	 "    G268 X0. Y0. Z0. I30.\n    ^\n"},
	{H, "G269\n", "p.nc:1:1: error: G269: cancelling of the feature coordinate system is not supported; "
	 "post the program without it\n    G269\n    ^\n"},
	{H, "G72 I5. J30. L3\n",
	 "p.nc:1:1: error: G72: bolt holes along an angle (write X and Y of each hole) is not supported; "
	 "post the program without it\n"
	 "    G72 I5. J30. L3\n    ^\n"},
	{F, "G54.2 P1\n",
	 "p.nc:1:1: error: G54.2: rotary table dynamic fixture offset (post with a work offset for each angle) is not "
	 "supported, only P0, which cancels it\n    G54.2 P1\n    ^\n"},
	{F, "G71 U2. R1.\n",
	 "p.nc:1:1: error: G71: lathe turning cycle (for millimetres write G21) is not supported; "
	 "post the program without it\n"
	 "    G71 U2. R1.\n    ^\n"},
	{F, "T01 T02 M06\n",
	 "p.nc:1:5: error: the word T occurs twice in the block, at columns 1 and 5; if M6 loads the first tool and "
	 "the second one is preselected, set m6_with_t=\"first\" in the machine file's <controller>\n    T01 T02 M06\n "
	 "       ^\n"},
	{H, "M34\n", "p.nc:1:1: error: M34: move of the coolant nozzle is not supported; "
	 "post the program without it or, if it moves no axis, set <mcode number=\"34\" "
	 "action=\"ignore\"/> in the machine file's <controller>\n    M34\n    ^\n"},
	{H, "[1 EQ 1] G0 X1.\n",
	 "p.nc:1:10: error: a condition at the start of a block must be followed by M99 P\n    [1 EQ 1] G0 X1.\n       "
	 "      ^\n"},
	{BOTH, "O X5\n", "p.nc:1:1: error: O without a number\n    O X5\n    ^\n"},
	{F, "N#1 G0\n",
	 "p.nc:1:1: error: a line number must be a whole number that is not negative\n    N#1 G0\n    ^\n"},
	{F, "M98 P1 G10 L2\n",
	 "p.nc:1:12: error: L can belong to G10 or to M98, and it is not known to which; write two blocks\n    M98 P1 "
	 "G10 L2\n               ^\n"},
};

START_TEST(refused)
{
	for (int dialect = F; dialect <= H; dialect++) {
		struct gcode_case c;

		if (!(faults[_i].dialects & dialect))
			continue;
		case_init(&c);
		c.config.dialect = dialect == F ? &dialect_fanuc : &dialect_haas;
		c.config.read.max_blocks = 50;
		ck_assert_msg(!case_run(&c, faults[_i].program), "accepted: %s", faults[_i].program);
		ck_assert_str_eq(strbuf_text(&c.messages), faults[_i].messages);
		case_release(&c);
	}
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("gcode_macro_bad");

	tcase_add_loop_test(tcase, refused, 0, COUNT(faults));
	return run_suite("gcode_macro_bad", tcase);
}
