/* test_gcode_klartext_comp.c - Klartext: RL, RR, R0 and M97, RND and CHF beside circles; by hand and closed forms. */
#include "klartext_case.h"

struct program {
	const char *blocks;
	const char *moves;
};

#define START "TOOL CALL 1 Z\nL X-20 Y-20 R0 FMAX\n"
#define STARTED "tool 1\nrapid -20 -20 0 0 0\n"

/* T1 has a radius of 5 mm. */
static const struct program paths[] = {
	/* The first block ends beside the start of the second, outside corners are rounded, the last one leaves. */
	{START "L X+0 Y+0 RL F100\nL Y+50\nL X+50\nL X+50 Y-20 R0\n",
	 STARTED "feed -5 0 0 0 0\nfeed -5 50 0 0 0\narc 0 55 0 0 0 centre 0 50 0 normal 0 0 1 sweep -90\n"
	 "feed 50 55 0 0 0\nfeed 50 -20 0 0 0\n"},
	/* Inside corners are where the paths cross. */
	{START "L X+0 Y+0 RR F100\nL Y+50\nL X+50\nL X+50 Y-20 R0\n",
	 STARTED "feed 5 0 0 0 0\nfeed 5 45 0 0 0\nfeed 50 45 0 0 0\nfeed 50 -20 0 0 0\n"},
	/* RL again and blank leave it in force; an arc outside and inside. */
	{START "L X+0 Y+0 RL F100\nL Y+50 RL\nCC X+50 Y+50\nC X+50 Y+100 DR-\nL X+90 R\nL X+100 Y+150 R0\n",
	 STARTED "feed -5 0 0 0 0\nfeed -5 50 0 0 0\narc 50 105 0 0 0 centre 50 50 0 normal 0 0 1 sweep -90\n"
	 "feed 90 105 0 0 0\nfeed 100 150 0 0 0\n"},
	{START "L X+0 Y+0 RR F100\nL Y+50 RR\nCC X+50 Y+50\nC X+50 Y+100 DR-\nL X+90 R\nL X+100 Y+150 R0\n",
	 STARTED "feed 5 0 0 0 0\nfeed 5 50 0 0 0\narc 50 95 0 0 0 centre 50 50 0 normal 0 0 1 sweep -90\n"
	 "feed 90 95 0 0 0\nfeed 100 150 0 0 0\n"},
	/* A helix by CP, more than a turn. */
	{START "L X+0 Y+0 RR F100\nL Y+50\nCC X+50 Y+50\nCP IPA-450 IZ-9 DR-\nL X+90\nL X+100 Y+150 R0\n",
	 STARTED "feed 5 0 0 0 0\nfeed 5 50 0 0 0\narc 50 95 -9 0 0 centre 50 50 0 normal 0 0 1 sweep -450\n"
	 "feed 90 95 -9 0 0\nfeed 100 150 -9 0 0\n"},
	/* DR of TOOL CALL is added. */
	{"TOOL CALL 1 Z DR+1\nL X-20 Y-20 R0 FMAX\nL X+0 Y+0 RR F100\nL Y+50\nL X+50\nL X+50 Y-20 R0\n",
	 STARTED "feed 6 0 0 0 0\nfeed 6 44 0 0 0\nfeed 50 44 0 0 0\nfeed 50 -20 0 0 0\n"},
	/* RND and CHF are parts of the path that is compensated. */
	{START "L X+0 Y+0 RL F100\nL Y+50\nRND R8\nL X+50\nCHF 10\nL Y+0\nL X+60 Y-20 R0\n",
	 STARTED "feed -5 0 0 0 0\nfeed -5 42 0 0 0\narc 8 55 0 0 0 centre 8 42 0 normal 0 0 1 sweep -90\n"
	 "feed 40 55 0 0 0\narc 43.5355339 53.5355339 0 0 0 centre 40 50 0 normal 0 0 1 sweep -45\n"
	 "feed 53.5355339 43.5355339 0 0 0\narc 55 40 0 0 0 centre 50 40 0 normal 0 0 1 sweep -45\n"
	 "feed 55 0 0 0 0\nfeed 60 -20 0 0 0\n"},
	/* M97: the corner is drawn out. */
	{START "L X+0 Y+0 RL F100\nL Y+50 M97\nL X+50\nL Y+0\nL X+60 Y-20 R0\n",
	 STARTED "feed -5 0 0 0 0\nfeed -5 55 0 0 0\nfeed 50 55 0 0 0\n"
	 "arc 55 50 0 0 0 centre 50 50 0 normal 0 0 1 sweep -90\nfeed 55 0 0 0 0\nfeed 60 -20 0 0 0\n"},
	/* A shift and a rotation go with the path, a mirror image exchanges the sides. */
	{"CYCL DEF 7.0\nCYCL DEF 7.1 X+100\nCYCL DEF 10.0\nCYCL DEF 10.1 ROT+90\n"
	 START "L X+0 Y+0 RL F100\nL Y+50\nL X+50\nL X+50 Y-20 R0\n",
	 "tool 1\nrapid 120 -20 0 0 0\nfeed 100 -5 0 0 0\nfeed 50 -5 0 0 0\n"
	 "arc 45 0 0 0 0 centre 50 0 0 normal 0 0 1 sweep -90\nfeed 45 50 0 0 0\nfeed 120 50 0 0 0\n"},
	{"CYCL DEF 8.0\nCYCL DEF 8.1 X\n"
	 START "L X+0 Y+0 RL F100\nL Y+50\nL X+50\nL X+50 Y-20 R0\n",
	 "tool 1\nrapid 20 -20 0 0 0\nfeed 5 0 0 0 0\nfeed 5 50 0 0 0\n"
	 "arc 0 55 0 0 0 centre 0 50 0 normal 0 0 -1 sweep -90\nfeed -50 55 0 0 0\nfeed -50 -20 0 0 0\n"},
	/* Behind M30 and END PGM the tool stands where it is. */
	{START "L X+0 Y+0 RL F100\nL Y+50\nL X+50 M30\n",
	 STARTED "feed -5 0 0 0 0\nfeed -5 50 0 0 0\narc 0 55 0 0 0 centre 0 50 0 normal 0 0 1 sweep -90\n"
	 "feed 50 55 0 0 0\n"},
	/* R0 with Z alone: to the programmed point now or with the next move of X and Y. */
	{START "L X+0 Y+0 RL F100\nL Y+50\nL Z-10 R0 FMAX\nL X+70 FMAX\nL X+80 Y+90 FMAX\nL X+90 FMAX\n",
	 STARTED "feed -5 0 0 0 0\nfeed -5 50 0 0 0\nfeed 0 50 0 0 0 spread 5 5 0\nrapid 0 50 90 0 0 spread 5 5 0\n"
	 "rapid 70 50 90 0 0 spread 5 5 0\nrapid 80 90 90 0 0 spread 5 5 0\nrapid 90 90 90 0 0\n"},
	/* A subprogram under compensation; a block in Z between. */
	{START "L X+0 Y+0 RL F100\nCALL LBL 1\nL IZ-1\nL X+50\nL X+50 Y-20 R0\nL M30\nLBL 1\nL Y+50\nLBL 0\n",
	 STARTED "feed -5 0 0 0 0\nfeed -5 50 0 0 0\nfeed -5 50 -1 0 0 spread 7.07106781 7.07106781 0\n"
	 "arc 0 55 -1 0 0 centre 0 50 -1 normal 0 0 1 sweep -90 spread 0 0 1\n"
	 "feed 50 55 -1 0 0\nfeed 50 -20 -1 0 0\n"},
	/* A radius of 0 is none. */
	{"TOOL CALL 1 Z DR-5\nL X+0 Y+0 RL F100\nL Y+50 RL\nL X+50 R0\n",
	 "tool 1\nfeed 0 0 0 0 0\nfeed 0 50 0 0 0\nfeed 50 50 0 0 0\n"},
};

/* RND beside circles, without compensation: its centre is as far from both as its radius. */
static const struct program corners[] = {
	{"F100\nL X+10\nRND R2\nCC X+10 Y+10\nC X+20 Y+10 DR+\n",
	 "feed 10 0 0 0 0\narc 20 10 0 0 0 centre 10 10 0 normal 0 0 1 sweep 90\n"},
	{"F100\nL X+20\nRND R2\nCC X+10 Y+0\nC X+10 Y+10 DR+\n",
	 "feed 17.7459667 0 0 0 0\narc 19.6824584 2.5 0 0 0 centre 17.7459667 2 0 normal 0 0 1 sweep 104.477512\n"
	 "arc 10 10 0 0 0 centre 10 0 0 normal 0 0 1 sweep 75.5224878\n"},
	{"L X+20 F100\nCC X+10 Y+0\nC X+0 Y+0 DR+\nRND R2\nL X+20\n",
	 "feed 20 0 0 0 0\narc 0.317541634 2.5 0 0 0 centre 10 0 0 normal 0 0 1 sweep 165.522488\n"
	 "arc 2.25403331 0 0 0 0 centre 2.25403331 2 0 normal 0 0 1 sweep 104.477512\nfeed 20 0 0 0 0\n"},
};

static void expect(const struct program *program)
{
	struct gcode_case c;
	bool good;

	klartext_case(&c);
	c.show_spread = true;
	good = klartext_run(&c, program->blocks);
	ck_assert_msg(good, "%s%s", program->blocks, strbuf_text(&c.messages));
	ck_assert_str_eq(strbuf_text(&c.messages), "");
	ck_assert_msg(!strcmp(strbuf_text(&c.moves), program->moves), "%s makes\n%s and not\n%s", program->blocks,
		      strbuf_text(&c.moves), program->moves);
	case_release(&c);
}

START_TEST(paths_table)
{
	expect(&paths[_i]);
}
END_TEST

START_TEST(corners_table)
{
	expect(&corners[_i]);
}
END_TEST

/* Every block is told once, in order, with its own moves. */
START_TEST(blocks_in_order)
{
	struct gcode_case c;

	klartext_case(&c);
	ck_assert(klartext_run(&c, "F100\nL X+10\nRND R2\nL Y+10\nL X+0\n"));
	ck_assert_str_eq(strbuf_text(&c.blocks), "2:0:F100\n3:1:L X+10\n4:0:RND R2\n5:2:L Y+10\n6:1:L X+0\n");
	case_release(&c);
}
END_TEST

#define COUNT(array) ((int)(sizeof(array) / sizeof((array)[0])))

int main(void)
{
	Suite *suite = suite_create("gcode_klartext_comp");
	TCase *tcase = tcase_create("gcode_klartext_comp");
	SRunner *runner;
	int failed;

	tcase_add_loop_test(tcase, paths_table, 0, COUNT(paths));
	tcase_add_loop_test(tcase, corners_table, 0, COUNT(corners));
	tcase_add_test(tcase, blocks_in_order);
	suite_add_tcase(suite, tcase);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
