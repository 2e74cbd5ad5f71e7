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
	 "p.nc:1:6: error: a macro statement stands in a block of its own\n    #1=1 G0 X1.\n         ^\n"},
	{BOTH, "G0 X1. #1=2\n",
	 "p.nc:1:8: error: an assignment stands in a block of its own\n    G0 X1. #1=2\n           ^\n"},
	{BOTH, "#1=1 #2=#1\n",
	 "p.nc:1:9: error: #1 is assigned in this block already; read it in the next one\n    #1=1 #2=#1\n    "
	 "        ^\n"},
	{BOTH, "#1=1/0\n", "p.nc:1:5: error: division by zero\n    #1=1/0\n        ^\n"},
	{BOTH, "#1=SQRT[-1]\n",
	 "p.nc:1:4: error: SQRT of -1: negative numbers have none\n    #1=SQRT[-1]\n       ^\n"},
	{BOTH, "#1=ACOS[2]\n",
	 "p.nc:1:4: error: ACOS of 2: only numbers from -1 to 1 have one\n    #1=ACOS[2]\n       ^\n"},
	{BOTH, "#1=TAB[1]\n", "p.nc:1:4: error: a value is needed here\n    #1=TAB[1]\n       ^\n"},
	{BOTH, "#1=SIN 30\n", "p.nc:1:8: error: SIN needs a value in brackets, [...]\n    #1=SIN 30\n           ^\n"},
	{BOTH, "##1=1\n", "p.nc:1:1: error: ## is not allowed; write #[#...]\n    ##1=1\n    ^\n"},
	{F, "#<a>=1\n",
	 "p.nc:1: warning: this looks like a program for LinuxCNC (#<name>), but it is read in the fanuc dialect\n"
	 "p.nc:1:1: error: variables with names are not supported yet\n    #<a>=1\n    ^\n"},
	{H, "#<a>=1\n",
	 "p.nc:1: warning: this looks like a program for LinuxCNC (#<name>), but it is read in the haas dialect\n"
	 "p.nc:1:1: error: variables with names are not supported yet\n    #<a>=1\n    ^\n"},
	{BOTH, "#1.5=1\n",
	 "p.nc:1:1: error: # needs the number of a variable, or an expression in brackets\n    #1.5=1\n    ^\n"},
	{BOTH, "#[1.5]=1\n", "p.nc:1:1: error: # needs a whole number that is not negative\n    #[1.5]=1\n    ^\n"},
	{BOTH, "G0 XSIN[30]\n",
	 "p.nc:1:5: error: a function behind an address needs brackets, X[...]\n    G0 XSIN[30]\n        ^\n"},
	{BOTH, "G0 X#1+1.\n", "p.nc:1:7: error: unexpected '+'\n    G0 X#1+1.\n          ^\n"},
	{BOTH, "G0 X[#1]\n",
	 "p.nc:1:5: error: a variable without a value alone in brackets; leave the brackets out\n    G0 "
	 "X[#1]\n        ^\n"},
	{F, "G65 P7 A[ROUND[1.5]]\nO7\nM99\n",
	 "p.nc:1:10: error: ROUND in an argument: to which digit differs; assign it to a variable before\n    "
	 "G65 P7 A[ROUND[1.5]]\n             ^\n"},
	{F, "#1=FIX[3*1.0000000001]\n",
	 "p.nc:1:4: error: FIX of a number that differs from 3 by 3e-10 only, less than a control computes "
	 "with\n    #1=FIX[3*1.0000000001]\n       ^\n"},
	{F, "#50=1\n",
	 "p.nc:1:1: error: #50 is no variable that is known in the fanuc dialect; programs have #1 to #33, "
	 "#100 to #199 and #500 to #999\n    #50=1\n    ^\n"},
	{H, "#50=1\n",
	 "p.nc:1:1: error: #50 is no variable that is known in the haas dialect; programs have #1 to #33, "
	 "#100 to #199 and #500 to #999\n    #50=1\n    ^\n"},
	{F, "G0 X#200\n",
	 "p.nc:1:5: error: #200 is no variable that is known in the fanuc dialect; programs have #1 to #33, "
	 "#100 to #199 and #500 to #999\n    G0 X#200\n        ^\n"},
	{H, "G0 X#200\n",
	 "p.nc:1:5: error: #200 is no variable that is known in the haas dialect; programs have #1 to #33, "
	 "#100 to #199 and #500 to #999\n    G0 X#200\n        ^\n"},
	{BOTH, "#1=#500\n",
	 "p.nc:1:4: error: #500 keeps its value from one program to the next, and this one has given it none "
	 "so far: <variable name=\"#500\" "
	 "value=\"\"/> in the machine's <controller> says what it holds\n    #1=#500\n       ^\n"},
	{H, "#1=#100\n",
	 "p.nc:1:4: error: #100 keeps its value from one program to the next, and this one has given it none "
	 "so far: <variable name=\"#100\" "
	 "value=\"\"/> in the machine's <controller> says what it holds\n    #1=#100\n       ^\n"},
	{F, "#1=#10100\n",
	 "p.nc:1:4: error: #10100 is a system variable that is not known here; if it stays the same while the "
	 "program runs: <variable name=\"#10100\" "
	 "value=\"\"/> in the machine's <controller> says what it holds\n    #1=#10100\n "
	 "      ^\n"},
	{F, "#1=LN[0]\n", "p.nc:1:4: error: LN of 0: only positive numbers have one\n    #1=LN[0]\n       ^\n"},
	{F, "G54 M98 P48\nO48\nM99\n",
	 "p.nc:1:9: error: P belongs to G54 and to M98: which of them has it is not known; write two blocks\n    G54 M98 P48\n"
	 "            ^\n"},
	{F, "#1=POW[2]\n", "p.nc:1:9: error: POW needs two values, POW[a,b]\n    #1=POW[2]\n            ^\n"},
	{F, "#1=POW[-1,.5]\n",
	 "p.nc:1:4: error: POW of -1 and 0.5: a number that is not positive may have no such power\n"
	 "    #1=POW[-1,.5]\n       ^\n"},
	{H, "#1=POW[2,3]\n", "p.nc:1:4: error: Haas has no function POW\n    #1=POW[2,3]\n       ^\n"},
	{H, "#1=LN[2]\n", "p.nc:1:4: error: Haas has no function LN\n    #1=LN[2]\n       ^\n"},
	{H, "#1=ATAN[1]/[2]\n",
	 "p.nc:1:11: error: ATAN[...]/[...]: Haas's manual knows ATAN of one value; to divide, write "
	 "[ATAN[...]]/\n    #1=ATAN[1]/[2]\n              ^\n"},
	{H, "#1=#2+1\n",
	 "p.nc:1:6: error: a variable without a value: what Haas's control computes with it is not in its "
	 "manual\n    #1=#2+1\n         ^\n"},
	{H, "IF [#1 EQ 0] GOTO 1\n",
	 "p.nc:1:8: error: a variable without a value: what Haas's control computes with it is not in its "
	 "manual\n    IF [#1 EQ 0] GOTO 1\n           ^\n"},
	{H, "#1=1 AND 2+1\n",
	 "p.nc:1:11: error: AND, OR and XOR among other operators: Haas gives no order; use brackets\n    "
	 "#1=1 AND 2+1\n              ^\n"},
	{F, "#1=[1 EQ 1]\n",
	 "p.nc:1:4: error: the result of a comparison is no number here\n    #1=[1 EQ 1]\n       ^\n"},
	{F, "IF [#1] GOTO 1\nN1\n",
	 "p.nc:1:4: error: IF needs a comparison: EQ, NE, GT, GE, LT or LE\n    IF [#1] GOTO 1\n       ^\n"},
	{F, "IF [[1 EQ 1] AND 1] GOTO 1\n",
	 "p.nc:1:14: error: one of the operands is a comparison, and the other is none\n    IF [[1 EQ 1] AND "
	 "1] GOTO 1\n                 ^\n"},
	{BOTH, "IF [1.0000000001 EQ 1] GOTO 1\n",
	 "p.nc:1:18: error: these numbers differ by 1e-10 only, less than a control computes with; compare "
	 "with a margin\n    IF [1.0000000001 EQ 1] GOTO 1\n                     ^\n"},
	{BOTH, "IF [1 EQ 1 EQ 1] GOTO 1\n",
	 "p.nc:1:12: error: the result of a comparison cannot be compared; use AND or OR\n    IF [1 EQ 1 EQ "
	 "1] GOTO 1\n               ^\n"},
	{F, "#1=1.5 AND 1\n",
	 "p.nc:1:8: error: AND, OR and XOR work on whole numbers that are not negative, not on 1.5\n    "
	 "#1=1.5 AND 1\n           ^\n"},
	{BOTH, "#1=-1 OR 1\n",
	 "p.nc:1:7: error: AND, OR and XOR work on whole numbers that are not negative, not on -1\n    #1=-1 "
	 "OR 1\n          ^\n"},
	{F, "#1=1.5 MOD 1\n",
	 "p.nc:1:8: error: MOD of 1.5 and 1: controls agree on whole numbers only\n    #1=1.5 MOD 1\n         "
	 "  ^\n"},
	{H, "#1=1.5 MOD 1\n",
	 "p.nc:1:8: error: MOD of 1.5 and 1: controls agree on whole numbers only that are not negative\n    "
	 "#1=1.5 MOD 1\n           ^\n"},
	{BOTH, "IF [1 EQ 1] G0 X1.\n",
	 "p.nc:1:13: error: IF [...] needs GOTO or THEN\n    IF [1 EQ 1] G0 X1.\n                ^\n"},
	{BOTH, "IF 1 EQ 1 GOTO 1\n",
	 "p.nc:1:4: error: IF needs a value in brackets, [...]\n    IF 1 EQ 1 GOTO 1\n       ^\n"},
	{BOTH, "IF [1 EQ 1] THEN G0 X1.\n",
	 "p.nc:1:18: error: THEN with anything but an assignment is not supported yet\n    IF [1 EQ 1] THEN "
	 "G0 X1.\n                     ^\n"},
	{BOTH, "IF [1 EQ 1] THEN GOTO 1\n",
	 "p.nc:1:18: error: THEN with anything but an assignment is not supported yet\n    IF [1 EQ 1] THEN "
	 "GOTO 1\n                     ^\n"},
	{BOTH, "IF [0 EQ 1] GOTO 1 G0 X1.\nN1\n",
	 "p.nc:1:20: error: a macro statement stands in a block of its own\n    IF [0 EQ 1] GOTO 1 G0 X1.\n"
	 "                       ^\n"},
	{BOTH, "IF [0 EQ 1] THEN #1=SIN[2] MOD 3 X[1.]\n",
	 "p.nc:1:34: error: a macro statement stands in a block of its own\n    IF [0 EQ 1] THEN #1=SIN[2] MOD 3 "
	 "X[1.]\n                                     ^\n"},
	{F, "G0 X-#1\n",
	 "p.nc:1:5: error: a sign before a variable without a value: whether that is 0 or nothing differs\n    "
	 "G0 X-#1\n        ^\n"},
	{BOTH, "GOTO 5\nN4\n", "p.nc:1:6: error: the program has no block N5\n    GOTO 5\n         ^\n"},
	{BOTH, "GOTO 0\n", "p.nc:1:6: error: block numbers start with 1\n    GOTO 0\n         ^\n"},
	{BOTH, "GOTO 1.5\n",
	 "p.nc:1:6: error: the block number of GOTO must be a whole number that is not negative\n    GOTO "
	 "1.5\n         ^\n"},
	{F, "GOTO #1\n",
	 "p.nc:1:6: error: the block number of GOTO must be a whole number that is not negative\n    GOTO "
	 "#1\n         ^\n"},
	{BOTH, "GOTO\n", "p.nc:1:5: error: a value is needed here\n    GOTO\n        ^\n"},
	{H, "N5 G0\nN5 X1.\nGOTO 5\n",
	 "p.nc:3:6: error: N5 stands in lines 1 and 2: which of them is meant is not clear\n    GOTO 5\n      "
	 "   ^\n"},
	{BOTH, "WHILE [1 EQ 1] DO4\nEND4\n",
	 "p.nc:1:18: error: the number of DO is from 1 to 3\n    WHILE [1 EQ 1] DO4\n                     ^\n"},
	{BOTH, "WHILE [1 EQ 1]\nEND1\n",
	 "p.nc:1:15: error: WHILE [...] needs DO\n    WHILE [1 EQ 1]\n                  ^\n"},
	{BOTH, "WHILE [1 EQ 1] DO1\nG0 X1.\n",
	 "p.nc:1:18: error: this loop is not closed: its END1 is missing\n    WHILE [1 EQ 1] DO1\n            "
	 "         ^\n"},
	{BOTH, "END1\n",
	 "p.nc:1:1: error: END1 without its DO1: a loop cannot be entered but by its DO\n    END1\n    ^\n"},
	{BOTH, "WHILE [1 EQ 1] DO1\nWHILE [1 EQ 1] DO1\nEND1\nEND1\n",
	 "p.nc:1:18: error: line 2 has a DO1 inside of this loop's DO1\n    WHILE [1 EQ 1] DO1\n              "
	 "       ^\n"},
	{BOTH, "WHILE [1 EQ 1] DO1\nWHILE [1 EQ 1] DO2\nEND1\nEND2\n",
	 "p.nc:1:18: error: the END1 of line 3 crosses this loop: DO2 is not closed before it\n    WHILE [1 "
	 "EQ 1] DO1\n                     ^\n"},
	{BOTH, "GOTO 5\nDO1\nN5 G0 X1.\nEND1\n",
	 "p.nc:4:1: error: END1 without its DO1: a loop cannot be entered but by its DO\n    END1\n    ^\n"},
	{BOTH, "#3000=1 (NO PART)\n",
	 "p.nc:1:1: error: #3000=1 stops the program with an alarm here\n    #3000=1 (NO PART)\n    ^\n"},
	{BOTH, "#3004=7\n",
	 "p.nc:1:1: error: #3004=7 switches exact stops off, which is not supported yet\n    #3004=7\n    ^\n"},
	{BOTH, "#1=#3001\n",
	 "p.nc:1:4: error: #3001 holds a clock: it is not known before the program runs\n    #1=#3001\n       "
	 "^\n"},
	{BOTH, "#1=#1000\n",
	 "p.nc:1:4: error: #1000 holds the state of an input or output, which may change while the program runs; "
	 "if it does not: <variable name=\"#1000\" "
	 "value=\"\"/> in the machine's <controller> says what it holds\n    #1=#1000\n       ^\n"},
	{BOTH, "#1=#5021\n",
	 "p.nc:1:4: error: #5021 holds where the machine is while the control reads ahead (the programmed "
	 "position is in #5001): it is not known before the program runs\n    #1=#5021\n       ^\n"},
	{BOTH, "#1=#5061\n",
	 "p.nc:1:4: error: #5061 holds what a probe has found: it is not known before the program runs\n    "
	 "#1=#5061\n       ^\n"},
	{BOTH, "#1=#2001\n",
	 "p.nc:1:4: error: #2001 holds tool offsets of the control's own table: it is not known before the "
	 "program runs\n    #1=#2001\n       ^\n"},
	{BOTH, "#1=#5201\n",
	 "p.nc:1:4: error: #5201 holds an offset of the control's own that lies on all work offsets: it is "
	 "not known before the program runs\n    #1=#5201\n       ^\n"},
	{F, "#1=#6000\n",
	 "p.nc:1:4: error: #6000 is a system variable that is not known here; if it stays the same while the "
	 "program runs: <variable name=\"#6000\" "
	 "value=\"\"/> in the machine's <controller> says what it holds\n    #1=#6000\n   "
	 "    ^\n"},
	{H, "#1=#6000\n",
	 "p.nc:1:4: error: #6000 is a system variable that is not known here; if it stays the same while the "
	 "program runs: <variable name=\"#6000\" "
	 "value=\"\"/> in the machine's <controller> says what it holds\n    #1=#6000\n    "
	 "   ^\n"},
	{F, "#5001=1\n", "p.nc:1:1: error: #5001 cannot be assigned here in the fanuc dialect\n    #5001=1\n    ^\n"},
	{H, "#5001=1\n", "p.nc:1:1: error: #5001 cannot be assigned here in the haas dialect\n    #5001=1\n    ^\n"},
	{BOTH, "#5221=1\nG0 X1.\n",
	 "p.nc:2:1: error: G54 was changed by assignment while it was in force; controls differ in when that "
	 "takes effect. Select G54 again before the next move\n    G0 X1.\n    ^\n"},
	{BOTH, "#5221=1\n#1=#5001\n",
	 "p.nc:2:4: error: #5001 cannot be read here: G54 was changed by assignment while it was in "
	 "force; select it again first\n    #1=#5001\n       ^\n"},
	{BOTH, "N1 GOTO 1\n",
	 "p.nc:1:1: error: 50 blocks of loops and subprograms have been carried out: is this loop endless? "
	 "--max-blocks sets another limit\n    N1 GOTO 1\n    ^\n"},
	{BOTH, "DO1\nEND1\n",
	 "p.nc:2:1: error: 50 blocks of loops and subprograms have been carried out: is this loop endless? "
	 "--max-blocks sets another limit\n    END1\n    ^\n"},
	{BOTH, "#[#1]=1\n", "p.nc:1:1: error: # needs a whole number that is not negative\n    #[#1]=1\n    ^\n"},
	{BOTH, "#1=2147483648 AND 1\n",
	 "p.nc:1:15: error: AND, OR and XOR work on whole numbers that are not negative, not on 2147483648\n  "
	 "  #1=2147483648 AND 1\n                  ^\n"},
	{BOTH, "#1=[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[\n",
	 "p.nc:1:36: error: brackets are nested more than 32 deep\n    "
	 "#1=[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[\n                                       ^\n"},
	{F, "G65 P7 I1. I1. I1. I1. I1. I1. I1. I1. I1. I1. I1.\n",
	 "p.nc:1:48: error: more than ten sets of I, J and K\n    G65 P7 I1. I1. I1. I1. I1. I1. I1. I1. I1. "
	 "I1. I1.\n                                                   ^\n"},
	{BOTH, "#7001=#0\n", "p.nc:1:1: error: #7001 cannot be vacant\n    #7001=#0\n    ^\n"},
	{BOTH, "#1=1e5\n",
	 "p.nc:1:5: error: a macro statement stands in a block of its own\n    #1=1e5\n        ^\n"},
	{BOTH, "#1=--1\n", "p.nc:1:5: error: two signs\n    #1=--1\n        ^\n"},
	{F, "G65 P7 A1 X7 F2\n",
	 "p.nc:1:1: error: the program O7 is neither in p.nc nor in a file of its own beside it or "
	 "in an --include folder\n    G65 P7 A1 X7 F2\n    ^\n"},
	{BOTH, "IF [1 EQ 1\n",
	 "p.nc:1:11: error: this expression is not closed: ']' is missing\n    IF [1 EQ 1\n              ^\n"},
	{BOTH, "DO0\n", "p.nc:1:3: error: the number of DO is from 1 to 3\n    DO0\n      ^\n"},
	{BOTH, "WHILE [1 EQ 1] DO1\n(\nEND2\n",
	 "p.nc:1:18: error: the END2 of line 3 crosses this loop: DO1 is not closed before it\n    WHILE [1 "
	 "EQ 1] DO1\n                     ^\n"},
	{BOTH, "/GOTO 3\n", "p.nc:1:7: error: the program has no block N3\n    /GOTO 3\n          ^\n"},
	{BOTH, "N10 N20\n", "p.nc:1:5: error: N is allowed only at the start of a block\n    N10 N20\n        ^\n"},
	{F, "G67 X1.\n", "p.nc:1:5: error: a macro statement stands in a block of its own\n    G67 X1.\n        ^\n"},
	{F, "G66 A1.\n", "p.nc:1:1: error: a macro call needs P, the number of the program\n    G66 A1.\n    ^\n"},
	{F, "G66 P7\nG0 X1. M30\nO7\nM99\n",
	 "p.nc:2:8: error: M30 in a block that moves, while G66 is in force; G67 first\n    G0 X1. M30\n      "
	 "     ^\n"},
	{F, "G66 P7\nG0 X1. M98 P7\nM30\nO7\nM99\n",
	 "p.nc:2:8: error: M98 in a block that moves, while G66 is in force; G67 first\n    G0 X1. M98 P7\n   "
	 "        ^\n"},
	{F, "G66 P7\nG81 X1. Z-1. R1. F9.\nM30\nO7\nM99\n",
	 "p.nc:2:1: error: axis words of a block that is no plain move, while G66 is in force; G67 first\n    "
	 "G81 X1. Z-1. R1. F9.\n    ^\n"},
	{F, "G66 P7\nM98 P8\nM30\nO7\nM99\nO8\nG0 X1.\nM99\n",
	 "p.nc:7:1: error: a move of a subprogram while G66 is in force is not supported yet\n    G0 X1.\n    "
	 "^\np.nc:2:1: note: O8 is called from here\n"},
	{BOTH, "DO1\nO2\nEND1\n",
	 "p.nc:1:3: error: this loop is not closed: its END1 is missing\n    DO1\n      ^\n"},
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
	 "p.nc:1:168: error: brackets are nested more than 32 deep\n    "
	 "#1=ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[AT"
	 "AN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[ATAN[AT"
	 "AN[\n                                                                                               "
	 "                                                                            ^\n"},
	{H, "G43.5 H1\n",
	 "p.nc:1:1: error: G43.5: tool centre point control with tool vectors is not supported yet\n    G43.5 "
	 "H1\n    ^\n"},
	{F, "G254 H1\n",
	 "p.nc:1: warning: this looks like a program for Haas (G254), but it is read in the fanuc dialect\n"
	 "p.nc:1:1: error: G254 is no G-code that is known in the fanuc dialect; <macro code=\"\"/> of the machine's <controller> declares one that the builder made\n    G254 H1\n    ^\n"},
	{H, "G254 H1\n",
	 "p.nc:1:6: error: H1 without G43: whether it changes the length depends on the control; write G43 H1\n    G254 H1\n         ^\n"},
	{F, "#1=#5004\n",
	 "p.nc:1:4: error: #5004: which axis is the control's number 4 is the machine builder's choice and "
	 "not known here\n    #1=#5004\n       ^\n"},
	{BOTH, "#1=#4001\n",
	 "p.nc:1:4: error: #4001, a modal code or word, is not followed here in this state of the program\n   "
	 " #1=#4001\n       ^\n"},
	{BOTH, "#1=#4111\n",
	 "p.nc:1:4: error: #4111, a modal code or word, is not followed here in this state of the program\n   "
	 " #1=#4111\n       ^\n"},
	{F, "G43.4 H0\n#1=#5001\n",
	 "p.nc:2:4: error: #5001 under tool centre point control is not supported yet\n    #1=#5001\n       "
	 "^\n"},
	{H, "G234 H0\n#1=#5001\n",
	 "p.nc:2:4: error: #5001 under tool centre point control is not supported yet\n    #1=#5001\n       "
	 "^\n"},
	{BOTH, "G65 A1.\n", "p.nc:1:1: error: a macro call needs P, the number of the program\n    G65 A1.\n    ^\n"},
	{BOTH, "G65 P7 G1.\n", "p.nc:1:8: error: G is no argument of a macro\n    G65 P7 G1.\n           ^\n"},
	{BOTH, "G65 P7 N1.\n", "p.nc:1:8: error: N is no argument of a macro\n    G65 P7 N1.\n           ^\n"},
	{BOTH, "G65 P0\n",
	 "p.nc:1:5: error: P: a whole number from 1 to 99999999 is needed\n    G65 P0\n        ^\n"},
	{F, "G65 P7 L0\n",
	 "p.nc:1:8: error: L: a whole number from 1 to 9999 is needed\n    G65 P7 L0\n           ^\n"},
	{F, "G65 P7 L2 A1.\nM30\nO7\nM99\n",
	 "p.nc:1:1: error: L with arguments: whether each repetition gets them anew is not supported yet; "
	 "call it L times in a loop\n    G65 P7 L2 A1.\n    ^\n"},
	{BOTH, "G0 G65 P7\n",
	 "p.nc:1:4: error: G65 stands before every other word of its block but N\n    G0 G65 P7\n       ^\n"},
	{BOTH, "G65 P7\n",
	 "p.nc:1:1: error: the program O7 is neither in p.nc nor in a file of its own beside it or in an "
	 "--include folder\n    G65 P7\n    ^\n"},
	{F, "G66 P7\nG66 P7\nM30\nO7\nM99\n",
	 "p.nc:2:1: error: G66 while another one is in force is not supported yet; G67 first\n    G66 P7\n    "
	 "^\n"},
	{F, "G66 P7\nG28 X0.\nM30\nO7\nM99\n",
	 "p.nc:2:5: error: axis words of a block that is no plain move, while G66 is in force; G67 first\n    "
	 "G28 X0.\n        ^\n"},
	{H, "G66 P7\n", "p.nc:1:1: error: G66 is no G-code that is known in the haas dialect; <macro code=\"\"/> of the machine's <controller> declares one that the builder made\n    G66 P7\n    ^\n"},
	{F, "G66.1 P7\n",
	 "p.nc:1:1: error: G66.1: modal macro call at every block is not supported yet\n    G66.1 P7\n    ^\n"},
	{BOTH, "M98\n", "p.nc:1:1: error: M98 needs P, the number of the program\n    M98\n    ^\n"},
	{BOTH, "M98 P7\n",
	 "p.nc:1:1: error: the program O7 is neither in p.nc nor in a file of its own beside it or in an "
	 "--include folder\n    M98 P7\n    ^\n"},
	{F, "M98 P10000\n",
	 "p.nc:1:5: error: the program's number, the last four digits of P, is 0\n    M98 P10000\n        ^\n"},
	{BOTH, "M98 P7 L0\n",
	 "p.nc:1:8: error: L0: a whole number from 1 to 9999 is needed\n    M98 P7 L0\n           ^\n"},
	{BOTH, "M98 P7 G4\n",
	 "p.nc:1:5: error: P belongs to G4 and to M98: which of them has it is not known; write two blocks\n    M98 P7 "
	 "G4\n        ^\n"},
	{H, "G0 X1. M98 P7 Q5\n",
	 "p.nc:1:15: error: no code in the block uses the word Q\n    G0 X1. M98 P7 Q5\n                  ^\n"},
	{F, "G0 X1. M98 P7 Q5\n",
	 "p.nc:1:15: error: M98 with both P and Q is not supported\n    G0 X1. M98 P7 Q5\n                  ^\n"},
	{F, "M198 P1\n",
	 "p.nc:1:1: error: M198: subprogram call from another memory is not supported yet\n    M198 P1\n    "
	 "^\n"},
	{F, "M97 P1\n",
	 "p.nc:1:1: error: M97 is not known; if it moves no axis, <mcode number=\"97\" action=\"ignore\"/> in "
	 "the machine's <controller> says so\n    M97 P1\n    ^\n"},
	{H, "M97 P5\n", "p.nc:1:5: error: the program has no block N5\n    M97 P5\n        ^\n"},
	{BOTH, "M99 L2\n", "p.nc:1:5: error: M99 with L is not supported yet\n    M99 L2\n        ^\n"},
	{BOTH, "M99 P5\n", "p.nc:1:5: error: the program has no block N5\n    M99 P5\n        ^\n"},
	{BOTH, "G0 X1.\nO2\nM30\n",
	 "p.nc:2:1: error: another program begins here, before M2, M30 or M99\n    O2\n    ^\n"},
	{BOTH, "M98 P7\nM30\nO7\nG0 X1.\nO8\nM99\n",
	 "p.nc:5:1: error: another program begins here, inside of O7: its M99 is missing\n    O8\n    "
	 "^\np.nc:1:1: note: O7 is called from here\n"},
	{BOTH, "M98 P7\nM30\nO7\nG0 X1.\n",
	 "p.nc:4: error: the file ends inside of the subprogram O7: its M99 is missing\np.nc:1:1: note: O7 is "
	 "called from here\n"},
	{F, "M98 P7\nM30\nO7\nG0 Q1.\nM99\n",
	 "p.nc:4:4: error: no code in the block uses the word Q\n    G0 Q1.\n       ^\np.nc:1:1: note: O7 is "
	 "called from here\n"},
	{F, "G65 P7\nM30\nO7\nG65 P7\nM99\n",
	 "p.nc:4:1: error: more than 5 macro calls inside each other\n    G65 P7\n    ^\np.nc:4:1: note: O7 "
	 "is called from here\np.nc:4:1: note: O7 is called from here\np.nc:4:1: note: O7 is called from "
	 "here\np.nc:4:1: note: O7 is called from here\np.nc:1:1: note: O7 is called from here\n"},
	{F, "G5.1\n", "p.nc:1:1: error: G5.1 needs Q\n    G5.1\n    ^\n"},
	{F, "G5.1 Q2 X1.\n",
	 "p.nc:1:9: error: X of G5.1 names an axis that is smoothed; its value must be 0\n    G5.1 Q2 X1.\n            ^\n"},
	{F, "G5 P3\n", "p.nc:1:1: error: G5: high-speed cycle machining is not supported yet\n    G5 P3\n    ^\n"},
	{F, "G8 P2\n", "p.nc:1:4: error: P2: a whole number from 0 to 1 is needed\n    G8 P2\n       ^\n"},
	{F, "G5.1 Q1\nG61\n",
	 "p.nc:2:1: error: G61 while G5.1, G8 or G5 P10000 is in force is not supported yet\n    G61\n    ^\n"},
	{H, "G187 P4\n", "p.nc:1:6: error: P4: a whole number from 1 to 3 is needed\n    G187 P4\n         ^\n"},
	{H, "G103 P20\n", "p.nc:1:6: error: P20: a whole number from 0 to 15 is needed\n    G103 P20\n         ^\n"},
	{H, "G253\n",
	 "p.nc:1:1: error: G253: spindle orientation to the feature coordinates (post with rotary words and G254) is not supported yet\n    G253\n"
	 "    ^\n"},
	{H, "G268 X0. Y0. Z0. I30.\n",
	 "p.nc:1:1: error: G268: feature coordinate system (post with rotary words and G254) is not supported yet\n"
	 "    G268 X0. Y0. Z0. I30.\n    ^\n"},
	{H, "G269\n", "p.nc:1:1: error: G269: cancelling of the feature coordinate system is not supported yet\n    G269\n    ^\n"},
	{H, "G72 I5. J30. L3\n",
	 "p.nc:1:1: error: G72: bolt holes along an angle (write the X and Y of each hole) is not supported yet\n"
	 "    G72 I5. J30. L3\n    ^\n"},
	{F, "G54.2 P1\n",
	 "p.nc:1:1: error: G54.2: rotary table dynamic fixture offset (post with a work offset for each angle) is not supported "
	 "yet, and P0, which ends it, is read\n    G54.2 P1\n    ^\n"},
	{F, "G71 U2. R1.\n",
	 "p.nc:1:1: error: G71: turning cycle of lathes (other controls mean millimetres: write G21) is not supported yet\n"
	 "    G71 U2. R1.\n    ^\n"},
	{F, "T01 T02 M06\n",
	 "p.nc:1:5: error: the word T stands twice in the block, at columns 1 and 5; if M6 loads the first and the second waits for the next "
	 "M6, m6_with_t=\"first\" in the machine's <controller> says so\n    T01 T02 M06\n        ^\n"},
	{H, "M34\n", "p.nc:1:1: error: M34: move of the coolant nozzle is not supported yet\n    M34\n    ^\n"},
	{H, "[1 EQ 1] G0 X1.\n",
	 "p.nc:1:10: error: a condition at the start of a block needs M99 P\n    [1 EQ 1] G0 X1.\n            "
	 " ^\n"},
	{BOTH, "O X5\n", "p.nc:1:1: error: O without a number\n    O X5\n    ^\n"},
	{F, "N#1 G0\n",
	 "p.nc:1:1: error: a line number must be a whole number that is not negative\n    N#1 G0\n    ^\n"},
	{F, "M98 P1 G10 L2\n",
	 "p.nc:1:12: error: L belongs to G10 and to M98: which of them has it is not known; write two blocks\n    M98 P1 "
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
