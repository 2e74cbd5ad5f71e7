/* test_gcode_sinumerik_bad_parts.c - what is refused of calls, parts that are repeated, and synchronous actions. */
#include "sinumerik_refused.h"
#include "suite.h"

static const struct refused_program programs[] = {
	{"CALL BLOCK AA TO BB\n", 1, 12,
	 "there is no label AA in this program"},
	{"CALL BLOCK AA BB\n", 1, 15,
	 "TO is needed here"},
	{"CALL \"SUB\" BLOCK AA TO BB\n", 1, 6,
	 "CALL BLOCK of a part of another program is not supported; CALL BLOCK of a part of this one is, and so is a "
	 "call of the whole other one"},
	{"BB:\nCALL BLOCK AA TO BB\nM30\nAA:\n", 2, 12,
	 "there is no label BB behind the start of this part"},
	{"AA:\nBB:\nR1=1\nBB:\nREPEAT AA BB\n", 5, 8,
	 "BB is in line 2 of p.nc and in line 4 of p.nc: which one is meant is not certain"},
	{"GOTOF AA\nR1=1\nAA:\nR1=2\nAA:\n", 1, 7,
	 "AA is in line 3 of p.nc and in line 5 of p.nc: which one is meant is not certain"},
	{"AA:\nR1=1\nAA:\nR1=2\nIF R1==2 GOTOB AA\n", 5, 16,
	 "AA is in line 1 of p.nc and in line 3 of p.nc: which one is meant is not certain"},
	{"aa:\nAA:\nR1=2\nGOTO AA\n", 4, 6,
	 "AA is in line 1 of p.nc and in line 2 of p.nc: which one is meant is not certain"},
	{"N10 R1=1\nN20 R1=2\nN10 R1=3\nGOTOB N10\n", 4, 7,
	 "N10 is in line 1 of p.nc and in line 3 of p.nc: which one is meant is not certain"},
	{"AA:\nAA:\nBB:\nREPEAT AA BB\n", 4, 8,
	 "AA is in line 1 of p.nc and in line 2 of p.nc: which one is meant is not certain"},
	{"CALL BLOCK AA TO BB\nM30\nAA:\nAA:\nBB:\n", 1, 12,
	 "AA is in line 3 of p.nc and in line 4 of p.nc: which one is meant is not certain"},
	{"RET(\"AA\")\n", 1, 4,
	 "what follows here is not supported"},
	{"RET X10\n", 1, 5,
	 "what follows here is not supported"},
	/* Whether a control takes N0100 for N100 is not known: neither is taken for the other one. */
	{"GOTOF N100\nR1=1\nN0100 R1=2\n", 1, 7,
	 "N100 has other leading zeros in line 3: write both alike"},
	{"N7 R1=1\nN007 R1=2\nGOTOB N7\n", 3, 7,
	 "N7 is in line 1 of p.nc and in line 2 of p.nc: which one is meant is not certain"},
	/* Numbers that do not rise: the second one is found, too. */
	{"N10 GOTOF N30\nN20 R1=1\nN30 R1=2\nN25 R1=3\nN30 R1=4\n", 1, 11,
	 "N30 is in line 3 of p.nc and in line 5 of p.nc: which one is meant is not certain"},
	/* The program calls itself, or the other one of its name. */
	{"%_N_OWN_MPF\nOWN\nM30\n%_N_OWN_SPF\nM17\n", 2, 1,
	 "OWN is in line 1 of p.nc and in line 4 of p.nc: which one is meant is not certain"},
	{"ID=1 WHEN $A_IN[1]==1 DO M5\n", 1, 26,
	 "a synchronous action that may move an axis or change the program is not supported; behind DO stand outputs "
	 "($A_OUT[1]=1), overrides ($AC_OVR), timers, SETAL, STOPREOF, RDISABLE, and M-codes that move no axis"},
	{"WHENEVER 1==1 DO $A_OUT[1]=1POS[X]=5\n", 1, 35,
	 "a synchronous action that may move an axis or change the program is not supported; behind DO stand outputs "
	 "($A_OUT[1]=1), overrides ($AC_OVR), timers, SETAL, STOPREOF, RDISABLE, and M-codes that move no axis"},
	{"WHENEVER 1==1 DO M8 POS[X]=5\n", 1, 21,
	 "a synchronous action that may move an axis or change the program is not supported; behind DO stand outputs "
	 "($A_OUT[1]=1), overrides ($AC_OVR), timers, SETAL, STOPREOF, RDISABLE, and M-codes that move no axis"},
	{"WHENEVER $AA_IW[X]>5 DO DELDTG\n", 1, 25,
	 "a synchronous action that may move an axis or change the program is not supported; behind DO stand outputs "
	 "($A_OUT[1]=1), overrides ($AC_OVR), timers, SETAL, STOPREOF, RDISABLE, and M-codes that move no axis"},
	{"DO $AA_OFF[Z]=5\n", 1, 4,
	 "a synchronous action that may move an axis or change the program is not supported; behind DO stand outputs "
	 "($A_OUT[1]=1), overrides ($AC_OVR), timers, SETAL, STOPREOF, RDISABLE, and M-codes that move no axis"},
	{"EVERY $AA_IM[X]>5 DO $A_OUT[1]=1 $R5=1\n", 1, 34,
	 "a synchronous action that may move an axis or change the program is not supported; behind DO stand outputs "
	 "($A_OUT[1]=1), overrides ($AC_OVR), timers, SETAL, STOPREOF, RDISABLE, and M-codes that move no axis"},
	{"IDS=1 EVERY $AA_IM[X]>5 DO OWN\n", 1, 28,
	 "a synchronous action that may move an axis or change the program is not supported; behind DO stand outputs "
	 "($A_OUT[1]=1), overrides ($AC_OVR), timers, SETAL, STOPREOF, RDISABLE, and M-codes that move no axis"},
	{"ID=3 WHEN $A_IN[1]==1 ; DO M8\n", 1, 3,
	 "a synchronous action needs DO and what it does"},
	{"WHEN TRUE DO $A_OUT[1\n", 1, 22,
	 "'=' is needed behind $A_OUT"},
	{"WHEN TRUE DO\n", 1, 13,
	 "a synchronous action that may move an axis or change the program is not supported; behind DO stand outputs "
	 "($A_OUT[1]=1), overrides ($AC_OVR), timers, SETAL, STOPREOF, RDISABLE, and M-codes that move no axis"},
	{"EXTCALL \"NOSUCH\"\n", 1, 9,
	 "NOSUCH is neither a word that is known nor a subprogram: no file NOSUCH.SPF (or .spf, .MPF, .mpf, in "
	 "upper or lower case) lies beside the program or in a folder of --include; if NOSUCH is the builder's and "
	 "moves no axis, set <macro program=\"NOSUCH\" action=\"none\"/> in the machine file's <controller>"},
	{"PCALL \"A\"\n", 1, 7,
	 "the path of PCALL stands without quotes"},
	{"PCALL/A X1\n", 1, 9,
	 "what follows here is not supported"},
	{"EXTCALL(\"A\") X1\n", 1, 14,
	 "what follows here is not supported"},
	{"P2 QOUT(\"A\")\n", 1, 4,
	 "QOUT with P and a text among its arguments is not supported"},
	{"QOUT(1) P0\n", 1, 10,
	 "P must be a whole number from 1 to 9999, not 0"},
	{"QOUT(1) PX\n", 1, 9,
	 "nothing can follow a call in its block"},
	{"G500 F6 P2 CYCLE81(10,0,2,-5)\n", 1, 9,
	 "P belongs to the call of a subprogram"},
	{"ISOCALL \"X\"\n", 1, 1,
	 "ISOCALL: call of a program in ISO mode is not supported"},
};

START_TEST(refused)
{
	sinumerik_refuses(&programs[_i]);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("programs");

	tcase_add_loop_test(tcase, refused, 0, COUNT(programs));
	return run_suite("gcode_sinumerik_bad_parts", tcase);
}
