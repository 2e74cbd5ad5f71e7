/* test_gcode_sinumerik_flow.c - small programs of the sinumerik dialect: variables, conditions, loops, jumps, repeated parts. */
#include "sinumerik_refused.h"

struct program {
	const char *text, *moves;
};

static const struct program programs[] = {
	{"DEF STRING[9] S_=\"B\"\nS_=\"A\"<<S_<<S_\nIF S_==\"ABB\"\nG500 G0 X1\nENDIF\n",
	 "rapid 1 0 0 0 0\n"},
	/* "Program section repetition": up to the first ENDLABEL behind the label, which is looked for backward first. */
	{"F6 G500\nAA: X=IC(1)\nENDLABEL:\nBB: Y=IC(1)\nENDLABEL:\nREPEAT AA P=2\nM30\n",
	 "feed 1 0 0 0 0\nfeed 1 1 0 0 0\nfeed 2 1 0 0 0\nfeed 3 1 0 0 0\n"},
	/* The repeated part may be the last of the file, behind M30, or of its program in the file. */
	{"F6 G500\nREPEAT FROM UPTO P=2\nY1\nM30\nFROM:\nX=IC(1)\nUPTO:", "feed 1 0 0 0 0\nfeed 2 0 0 0 0\nfeed 2 1 0 0 0\n"},
	{"F6 G500\nREPEAT FROM UPTO\nY1\nREPEATB UPTO\nM30\nFROM:\nUPTO: X=IC(1)\n",
	 "feed 1 0 0 0 0\nfeed 1 1 0 0 0\nfeed 2 1 0 0 0\n"},
	{"F6 G500\nREPEAT FROM UPTO P=2\nSUB\nM30\nFROM:\nX=IC(1)\nUPTO: SUB\n%_N_SUB_SPF\nZ=IC(1)\nM17\n",
	 "feed 1 0 0 0 0\nfeed 1 0 1 0 0\nfeed 2 0 1 0 0\nfeed 2 0 2 0 0\nfeed 2 0 3 0 0\n"},
	/* Posts end all of their parts with one label, behind M30. */
	{"F6 G500\nREPEAT PART2 PART0\nREPEAT PART1 PART0\nM30\nPART1:\nX=IC(1)\nPART0:\nPART2:\nY=IC(1)\nPART0:\n",
	 "feed 0 1 0 0 0\nfeed 1 1 0 0 0\n"},
	{"F6 G500\nCALL BLOCK PART2 TO PART0\nCALL BLOCK PART1 TO PART0\nCALL BLOCK PART2 TO PART0\nM30\nPART1: ; one\n"
	 "X=IC(1)\nPART0:\nPART2:\nY=IC(1)\nPART0:\n",
	 "feed 0 1 0 0 0\nfeed 1 1 0 0 0\nfeed 1 2 0 0 0\n"},
	/* Labels by texts, a part before the call, and MCALL in it. */
	{"DEF STRING[9] S_=\"to\"\nF6 G500 R1=0\nFROM:\nR1=R1+1\nX=R1\nTO1:\nCALL BLOCK \"FROM\" TO S_<<1\nY1\n",
	 "feed 1 0 0 0 0\nfeed 2 0 0 0 0\nfeed 2 1 0 0 0\n"},
	{"F6 G500 G0 Z10\nMCALL CYCLE81(10,0,2,-8)\nCALL BLOCK FROM TO UPTO\nMCALL\nM30\nFROM:\nX10\nUPTO:\n",
	 "rapid 0 0 10 0 0\nrapid 10 0 10 0 0\nrapid 10 0 2 0 0\nfeed 10 0 -8 0 0\nrapid 10 0 10 0 0\n"},
	/* A jump within the part, and REPEAT in it. */
	{"F6 G500\nCALL BLOCK FROM TO UPTO\nM30\nFROM:\nGOTOF THERE\nX9\nTHERE: X=IC(1)\nREPEATB THERE\nUPTO:\n",
	 "feed 1 0 0 0 0\nfeed 2 0 0 0 0\n"},
	{"F6 G500\nAA: X=IC(1)\nREPEATB AA\nAA: Y=IC(1)\nM30\n",
	 "feed 1 0 0 0 0\nfeed 2 0 0 0 0\nfeed 2 1 0 0 0\n"},
	/* Names of 32 bytes that differ in the last one only. */
	{"F6 G500 R1=0\nTOP: R1=R1+1\nIF R1==1 GOTOF A234567890123456789012345678901X IF R1==2 GOTOF A234567890123456789012345678901Y\n"
	 "M30\nA234567890123456789012345678901X: X1\nGOTOB TOP\nA234567890123456789012345678901Y: X2\nM30\n",
	 "feed 1 0 0 0 0\nfeed 2 0 0 0 0\n"},
	{"G500 F6 R1=5 R2=R1*2\nR[R1]=7\nX=R1 Y=R2 Z=R5\n",
	 "feed 5 10 7 0 0\n"},
	{"DEF REAL A_1=2.5, BB[3]=SET(1,2,3), CC[2,2]=REP(7)\nF6 G500 X=A_1 Y=BB[1] Z=CC[1,1]\n"
	 "BB[0]=SET(9,,8)\nX=BB[0] Y=BB[1] Z=BB[2]\n",
	 "feed 2.5 2 7 0 0\nfeed 9 2 8 0 0\n"},
	{"DEF REAL CC[2,3]\nCC[0,1]=4 cc[1,0]=5\nF6 G500 X=CC[0,1] Y=Cc[1,0] Z=CC[0,0]\n",
	 "feed 4 5 0 0 0\n"},
	{"DEF INT II=2.6, KK[2]=REP(3,1)\nDEF BOOL FLAG=5\nDEF CHAR CH=65\n"
	 "F6 G500 X=II Y=FLAG Z=CH\nX=KK[0] Y=KK[1]\n",
	 "feed 3 1 65 0 0\nfeed 3 0 65 0 0\n"},
	{"DEF STRING[20] S1=\"AB\", S2\nDEF AXIS AX=Z\nF6 G500\nS2=S1<<\"C\"<<2\nIF S2==\"ABC2\"\n"
	 "X1\nENDIF\nIF S1<>\"AB\" GOTOF NEVER\nX2\nIF \"a\"<\"b\" GOTOF NEVER\nX99\nNEVER: X3\n",
	 "feed 1 0 0 0 0\nfeed 2 0 0 0 0\nfeed 3 0 0 0 0\n"},
	{"F6 G500 R1=1\nIF R1==1\nX1\nIF R1==2\nX2\nELSE\nX3\nENDIF\nELSE\nX4\nENDIF\nX5\n",
	 "feed 1 0 0 0 0\nfeed 3 0 0 0 0\nfeed 5 0 0 0 0\n"},
	{"F6 G500 R1=2\nIF R1==1\nIF R1==2\nX1\nELSE\nX2\nENDIF\nELSE\nX3\nENDIF\n",
	 "feed 3 0 0 0 0\n"},
	{"F6 G500 R1=0\nWHILE R1<3\nR1=R1+1\nX=R1\nENDWHILE\n",
	 "feed 1 0 0 0 0\nfeed 2 0 0 0 0\nfeed 3 0 0 0 0\n"},
	{"F6 G500\nWHILE FALSE\nX1\nENDWHILE\nX2\n",
	 "feed 2 0 0 0 0\n"},
	{"F6 G500\nFOR R2=5 TO 7\nX=R2\nENDFOR\nX=R2\n",
	 "feed 5 0 0 0 0\nfeed 6 0 0 0 0\nfeed 7 0 0 0 0\nfeed 8 0 0 0 0\n"},
	{"F6 G500\nFOR R2=3 TO 1\nX99\nENDFOR\nX=R2\n",
	 "feed 3 0 0 0 0\n"},
	{"F6 G500\nDEF INT I1_, K1_\nFOR I1_=0 TO 1\nFOR K1_=0 TO 1\nX=10*I1_+K1_\nENDFOR\n"
	 "ENDFOR\n",
	 "feed 0 0 0 0 0\nfeed 1 0 0 0 0\nfeed 10 0 0 0 0\nfeed 11 0 0 0 0\n"},
	{"F6 G500 R1=2\nREPEAT\nR1=R1-1\nX=R1\nUNTIL R1<=0\n",
	 "feed 1 0 0 0 0\nfeed 0 0 0 0 0\n"},
	{"F6 G500 R1=0\nLOOP\nR1=R1+1\nIF R1>2 GOTOF OUT\nX=R1\nENDLOOP\nOUT: X0\n",
	 "feed 1 0 0 0 0\nfeed 2 0 0 0 0\nfeed 0 0 0 0 0\n"},
	{"F6 G500 R1=0\nWHILE R1<2\nR1=R1+1\nWHILE TRUE\nIF R1==1 GOTOF NEXT\nX=R1\nGOTOF NEXT\n"
	 "ENDWHILE\nNEXT: X=R1+10\nENDWHILE\n",
	 "feed 11 0 0 0 0\nfeed 2 0 0 0 0\nfeed 12 0 0 0 0\n"},
	{"F6 G500 R1=2\nAGAIN: X=R1\nR1=R1-1\nIF R1>0 GOTOB AGAIN\nX9\n",
	 "feed 2 0 0 0 0\nfeed 1 0 0 0 0\nfeed 9 0 0 0 0\n"},
	{"F6 G500\nGOTOF N50\nX99\nN50 X50\nGOTO FIN\nX98\nFIN:\nGOTOC NOWHERE\nX7\n"
	 "GOTOF \"LAST\"\nX97\nLAST: X8\n",
	 "feed 50 0 0 0 0\nfeed 7 0 0 0 0\nfeed 8 0 0 0 0\n"},
	{"F6 G500 R1=2\nIF R1==1 GOTOF A_1 IF R1==2 GOTOF A_2\nX9\nA_1: X1\nA_2: X2\n",
	 "feed 2 0 0 0 0\n"},
	{"F6 G500 R1=2\nCASE R1 OF 1 GOTOF A_1 2 GOTOF A_2 DEFAULT GOTOF A_3\nA_1: X1\nA_2: X2\n"
	 "A_3: X3\n",
	 "feed 2 0 0 0 0\nfeed 3 0 0 0 0\n"},
	{"F6 G500\nCASE(5) OF -1 GOTOB A_1 DEFAULT GOTOF A_3\nA_1: X1\nA_3: X3\n",
	 "feed 3 0 0 0 0\n"},
	{"F6 G500\nCASE 5 OF 1 GOTOF A_1 2 GOTOF A_1\nX2\nA_1: X1\n",
	 "feed 2 0 0 0 0\nfeed 1 0 0 0 0\n"},
	{"F6 G500 G91\nAA: X1\nX2\nREPEAT AA P=2\nX100\n",
	 "feed 1 0 0 0 0\nfeed 3 0 0 0 0\nfeed 4 0 0 0 0\nfeed 6 0 0 0 0\nfeed 7 0 0 0 0\n"
	 "feed 9 0 0 0 0\nfeed 109 0 0 0 0\n"},
	{"F6 G500 G91\nAA: X1\nX2\nREPEATB AA P=3\nX100\n",
	 "feed 1 0 0 0 0\nfeed 3 0 0 0 0\nfeed 4 0 0 0 0\nfeed 5 0 0 0 0\nfeed 6 0 0 0 0\n"
	 "feed 106 0 0 0 0\n"},
	{"F6 G500 G91\nAA: X1\nBB: X2\nX3\nREPEAT AA BB\nX100\n",
	 "feed 1 0 0 0 0\nfeed 3 0 0 0 0\nfeed 6 0 0 0 0\nfeed 7 0 0 0 0\nfeed 9 0 0 0 0\n"
	 "feed 109 0 0 0 0\n"},
	{"F6 G500 G91\nAA: X1\nENDLABEL: X10\nX100\nREPEAT AA P=2\nX1000\n",
	 "feed 1 0 0 0 0\nfeed 11 0 0 0 0\nfeed 111 0 0 0 0\nfeed 112 0 0 0 0\nfeed 122 0 0 0 0\n"
	 "feed 123 0 0 0 0\nfeed 133 0 0 0 0\nfeed 1133 0 0 0 0\n"},
};

/* The control would raise an alarm, or its reaction is not certain. */
static const struct refused_words bad[] = {
	{"CALL BLOCK AA TO BB\nM30\nAA:\nBB: G500 F6 X1\n",
	 "words behind the label that ends the part of CALL BLOCK: whether they are carried out is not certain; write the "
	 "label in a line of its own"},
	{"CALL BLOCK AA TO BB\nM30\nAA:\nM17\nBB:\n",
	 "the program ends in the part that CALL BLOCK of line 1 calls: whether it goes back from here is not certain"},
	{"CALL BLOCK AA TO BB\nM30\nAA:\nRET\nBB:\n",
	 "the program ends in the part that CALL BLOCK of line 1 calls: whether it goes back from here is not certain"},
	{"CALL BLOCK AA TO BB\nCC: M30\nAA:\nGOTOB CC\nBB:\n",
	 "this leaves the part that CALL BLOCK of line 1 calls: where it then goes back from is not certain"},
};

START_TEST(refused)
{
	sinumerik_refuses_words(&bad[_i]);
}
END_TEST

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
	tcase_add_loop_test(tcase, refused, 0, COUNT(bad));
	return run_suite("gcode_sinumerik_flow", tcase);
}
