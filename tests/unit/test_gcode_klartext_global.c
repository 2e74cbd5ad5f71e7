/* test_gcode_klartext_global.c - Klartext: GLOBAL DEF, and PREDEF in cycles. */
#include "klartext_case.h"

/* Clearances of 2 and 50 mm, and how cycles drill. */
#define GENERAL "GLOBAL DEF 100 GENERAL ~\n Q200=+2 ;SET-UP CLEARANCE ~\n Q204=+50 ;2ND SET-UP CLEARANCE ~\n" \
		" Q253=750 ~\n Q208=MAX ;RETRACTION FEED RATE\n"
#define DRILLING "GLOBAL DEF 105 DRILLING Q256=+0.2 Q210=+0 Q211=+0.5\n"
#define DRILL "CYCL DEF 200 DRILLING ~\n Q200=PREDEF ;SET-UP ~\n Q201=-10 ~\n Q206=150 ~\n Q202=10 ~\n Q210=PREDEF ~\n" \
	      " Q203=+0 ~\n Q204=PREDEF ~\n Q211=PREDEF\n"
#define FAR "L Z+90 FMAX\n"

static const struct klartext_program programs[] = {
	/* The same moves as with the numbers in the cycle. */
	{GENERAL DRILLING FAR DRILL "L X+10 Y+20 R0 FMAX M99\n",
	 "rapid 0 0 90 0 0\nrapid 10 20 90 0 0\nrapid 10 20 2 0 0\nfeed 10 20 -10 0 0\ndwell 0.5\nrapid 10 20 2 0 0\n"
	 "rapid 10 20 50 0 0\n"},
	/* Without '~', with block numbers. */
	{"1 GLOBAL DEF 100 GENERAL\nQ200=2\nQ204=50\n2 GLOBAL DEF 105 DRILLING Q256=0.2 Q210=0 Q211=0\n3 L Z+90 FMAX\n"
	 "4 CYCL DEF 200 DRILLING\nQ200=PREDEF\nQ201=-10\nQ206=150\nQ202=10\nQ210=0\nQ203=+0\nQ204=PREDEF\nQ211=0\n"
	 "5 L X+10 Y+20 R0 FMAX M99\n",
	 "rapid 0 0 90 0 0\nrapid 10 20 90 0 0\nrapid 10 20 2 0 0\nfeed 10 20 -10 0 0\nrapid 10 20 2 0 0\n"
	 "rapid 10 20 50 0 0\n"},
	/* The amount of a chip break. */
	{"GLOBAL DEF 105 DRILLING Q256=0.5 Q210=0 Q211=0\n" FAR
	 "CYCL DEF 203 UNIVERSAL DRILLING Q200=2 Q201=-6 Q206=100 Q202=3 Q210=0 Q203=+0 Q204=20 Q212=0 Q213=2 Q205=0 Q211=0 "
	 "Q208=500 Q256=PREDEF\nL X+1 FMAX M99\n",
	 "rapid 0 0 90 0 0\nrapid 1 0 90 0 0\nrapid 1 0 2 0 0\nfeed 1 0 -3 0 0\nrapid 1 0 -2.5 0 0\nfeed 1 0 -6 0 0\n"
	 "rapid 1 0 2 0 0\nrapid 1 0 20 0 0\n"},
	/* A cycle that is defined behind another GLOBAL DEF has its values. */
	{GENERAL DRILLING FAR DRILL "L X+1 FMAX M99\nGLOBAL DEF 100 GENERAL Q200=5 Q204=20\n" DRILL "L X+2 FMAX M99\n",
	 "rapid 0 0 90 0 0\nrapid 1 0 90 0 0\nrapid 1 0 2 0 0\nfeed 1 0 -10 0 0\ndwell 0.5\nrapid 1 0 2 0 0\n"
	 "rapid 1 0 50 0 0\nrapid 2 0 50 0 0\nrapid 2 0 5 0 0\nfeed 2 0 -10 0 0\ndwell 0.5\nrapid 2 0 5 0 0\n"
	 "rapid 2 0 20 0 0\n"},
	/* The same values again change nothing, also for a cycle that is defined before. */
	{GENERAL DRILLING FAR DRILL GENERAL "L X+1 FMAX M99\n",
	 "rapid 0 0 90 0 0\nrapid 1 0 90 0 0\nrapid 1 0 2 0 0\nfeed 1 0 -10 0 0\ndwell 0.5\nrapid 1 0 2 0 0\n"
	 "rapid 1 0 50 0 0\n"},
	/* Behind a skipped block all its parameters are skipped, too. */
	{GENERAL "/" DRILLING "GLOBAL DEF 125 POSITIONING Q345=0\nGLOBAL DEF 120 PROBING ~\n Q320=1 ~\n Q260=50 ~\n Q301=1\n"
	 "GLOBAL DEF 110 POCKET MILLING ~\n Q370=1 ~\n Q351=1 ~\n Q366=1\nGLOBAL DEF 111 CONTOUR MILLING ~\n Q2=1 ~\n"
	 " Q6=2 ~\n Q7=50 ~\n Q9=1\nL X+1 FMAX\n",
	 "rapid 1 0 0 0 0\n"},
	/* A pattern retracts to the second set-up clearance. */
	{GENERAL DRILLING "GLOBAL DEF 125 POSITIONING Q345=0\nL Z+90 FMAX\nPATTERN DEF POS1 (X+10 Y+0 Z+0)\n" DRILL
	 "CYCL CALL PAT FMAX\n",
	 "rapid 0 0 90 0 0\nrapid 0 0 90 0 0\nrapid 10 0 90 0 0\nrapid 10 0 2 0 0\nfeed 10 0 -10 0 0\ndwell 0.5\n"
	 "rapid 10 0 2 0 0\nrapid 10 0 50 0 0\n"},
};

START_TEST(gives_values_to_cycles)
{
	klartext_expect(&programs[_i], false);
}
END_TEST

static const struct klartext_fault faults[] = {
	{"CYCL DEF 200 DRILLING Q200=PREDEF\n",
	 "p.nc:2:23: error: Q200=PREDEF, but no GLOBAL DEF before it has given Q200"},
	{GENERAL "CYCL DEF 200 DRILLING Q201=PREDEF\n",
	 "p.nc:7:23: error: Q201=PREDEF, but no GLOBAL DEF before it has given Q201"},
	{"GLOBAL DEF 100 GENERAL Q200=PREDEF\n",
	 "p.nc:2:24: error: Q200=PREDEF in GLOBAL DEF, which itself gives the value"},
	{"GLOBAL DEF 100 GENERAL Q200=2 Q256=1\n",
	 "p.nc:2:31: error: Q256 does not belong to GLOBAL DEF 100"},
	{"GLOBAL DEF 100 GENERAL Q200=\n",
	 "p.nc:2:24: error: Q200 of GLOBAL DEF 100 needs a value"},
	{"GLOBAL DEF 101\n",
	 "p.nc:2:8: error: GLOBAL DEF 101 is not supported: 100, 105, 110, 111, 120 and 125 are"},
	{"GLOBAL 100\n",
	 "p.nc:2:8: error: GLOBAL needs DEF"},
	{"GLOBAL DEF 125 POSITIONING Q345=2\n",
	 "p.nc:2:28: error: Q345 is 0 or 1"},
	{GENERAL DRILLING DRILL "GLOBAL DEF 100 GENERAL Q200=5 Q204=50\nL X+1 FMAX M99\n",
	 "p.nc:18:12: error: Q200 has been changed since CYCL DEF 200: whether the call takes its new value is not known here; "
	 "define the cycle anew"},
	{GENERAL DRILLING "GLOBAL DEF 125 POSITIONING Q345=1\nL Z+50 FMAX\nPATTERN DEF POS1 (X+10 Y+0 Z+0)\n" DRILL
	 "CYCL CALL PAT FMAX\n",
	 "p.nc:20:11: error: a pattern after GLOBAL DEF 125 with Q345=1: to which position the tool retracts is not certain; "
	 "Q345=0 is the second set-up clearance"},
	{GENERAL "L X+Q200 FMAX\n", 
	 "p.nc:7:5: error: whether GLOBAL DEF also changes Q200 itself is not known: assign the value to another parameter"},
};

START_TEST(refuses)
{
	klartext_expect_fault(&faults[_i]);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("global");

	tcase_add_loop_test(tcase, gives_values_to_cycles, 0, COUNT(programs));
	tcase_add_loop_test(tcase, refuses, 0, COUNT(faults));
	return run_suite("gcode_klartext_global", tcase);
}
