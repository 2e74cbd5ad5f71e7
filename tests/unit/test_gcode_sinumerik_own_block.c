/* test_gcode_sinumerik_own_block.c - the sinumerik dialect: codes that stand in a block of their own. */
#include "sinumerik_refused.h"
#include "suite.h"

#define LEAVES(column) \
	"the code at column " column " takes the words of its block, and leaves none for this one: write two blocks"

/*
 * If two codes of a block take words, or a code stands beside words of another, it is not known which code the words
 * belong to.
 */
static const struct refused_program programs[] = {
	{"G500 G17\nTRANS X10 G110\n", 2, 11, LEAVES("1")},
	{"G500 G17\nG111 X5 ROT Z10\n", 2, 1, LEAVES("9")},
	{"G500\nTRANS X10 G74\n", 2, 11, LEAVES("1")},
	{"G500\nG75 X1=0 TRANS Y5\n", 2, 1, LEAVES("10")},
	{"G500\nG26 X100 TRANS Y5\n", 2, 1, LEAVES("10")},
	{"G500\nG25 X0 G0 Y5\n", 2, 8, LEAVES("1")},
	{"G500 G17\nG4 F2 S500\n", 2, 7, LEAVES("1")},
	{"G500 G17\nTRANS X5 CR=5\n", 2, 10, LEAVES("1")},
	{"G500 G17\nTRANS X5 J5\n", 2, 10, LEAVES("1")},
	{"G500 G17\nTRANS X5 POS[C]=5\n", 2, 10, LEAVES("1")},
	{"G500 G17 S100\nG33 Z10 TRANS\n", 2, 1, LEAVES("9")},
	{"G500 G17\nTRANS X5 AP=5 RP=10\n", 2, 10, LEAVES("1")},
	{"G500 G17\nG110 X5 ANG=5\n", 2, 9, LEAVES("1")},
};

START_TEST(refused)
{
	sinumerik_refuses(&programs[_i]);
}
END_TEST

static const struct program {
	const char *text, *moves;
} beside[] = {
	/* A motion beside them holds from the next move on. */
	{"G500 F6 G0 X1\nTRANS Y2 G1\nX2\n", "rapid 1 0 0 0 0\nfeed 2 0 0 0 0\n"},
	{"G500 F6 G1 X1\nG0 ROT\nX2\n", "feed 1 0 0 0 0\nrapid 2 0 0 0 0\n"},
	{"G500 F6 G1 X1\nG0 G4 F1\nX2\n", "feed 1 0 0 0 0\ndwell 1\nrapid 2 0 0 0 0\n"},
	{"G500 F6 G17 G1 X1\nG110 X5 G0\nX2\n", "feed 1 0 0 0 0\nrapid 2 0 0 0 0\n"},
	{"G500 F6 G1 X1\nG0 G75 Z1=0\nX2\n", "feed 1 0 0 0 0\nrapid 1 0 202 0 0\nrapid 2 0 202 0 0\n"},
	{"G500 F6 G1 X1\nG26 S500 G0\nX2\n", "feed 1 0 0 0 0\nrapid 2 0 0 0 0\n"},
	/* And so do the other words. */
	{"G500 F6 G0 X1\nTRANS X2 F60 G1 M8\nX2\n", "rapid 1 0 0 0 0\nfeed 4 0 0 0 0\n"},
};

START_TEST(taken)
{
	struct gcode_case c;

	sinumerik_case_init(&c);
	ck_assert_msg(case_run(&c, beside[_i].text), "%s%s", beside[_i].text, strbuf_text(&c.messages));
	ck_assert_str_eq(strbuf_text(&c.moves), beside[_i].moves);
	case_release(&c);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("programs");

	tcase_add_loop_test(tcase, refused, 0, COUNT(programs));
	tcase_add_loop_test(tcase, taken, 0, COUNT(beside));
	return run_suite("gcode_sinumerik_own_block", tcase);
}
