/*
 * test_background.c - each piece of work is done once and in order while the caller goes on; after a result that
 * matters the next piece waits.
 */
#include "check/background.h"

#include <stdatomic.h>

#include "random.h"
#include "suite.h"

enum { PIECES_MOST = 300, ROUNDS = 5 };

struct pieces {
	struct background background;
	bool holds[PIECES_MOST];	/* the result of this one must be taken before the next is done */
	long given[PIECES_MOST];	/* written by the caller without a lock */
	long got[PIECES_MOST];	/* the result of the work, written without a lock */
	atomic_size_t taken, begun;
	atomic_int strange;	/* pieces out of order, or before they might be done */
	atomic_long rounds;
};

static void count_round(void *context, int number, size_t i)
{
	struct pieces *pieces = context;

	(void)number;
	(void)i;
	atomic_fetch_add(&pieces->rounds, 1);
}

static bool do_piece(void *context, size_t number)
{
	struct pieces *pieces = context;

	if (atomic_fetch_add(&pieces->begun, 1) != number ||
	    (number && pieces->holds[number - 1] && pieces->taken < number))
		atomic_fetch_add(&pieces->strange, 1);
	shared_loop_run(&pieces->background.loop, ROUNDS, 1, count_round, pieces);
	pieces->got[number] = 2 * pieces->given[number] + 1;
	return !pieces->holds[number];
}

/* Takes the results of the pieces that are done, or of as many as are wanted. */
static size_t take(struct pieces *pieces, size_t taken, size_t wanted)
{
	const size_t done = background_done(&pieces->background), until = done > wanted ? done : wanted;

	while (taken < until) {
		background_wait(&pieces->background, taken + 1);
		ck_assert_int_eq(pieces->got[taken], 2 * pieces->given[taken] + 1);
		pieces->taken = ++taken;
		background_take(&pieces->background, taken);
	}
	return taken;
}

START_TEST(work_is_done_in_order)
{
	for (long n = 0; n < random_cases(200); n++) {
		struct random random = random_case(1, n);
		const size_t count = 1 + (size_t)random_below(&random, PIECES_MOST);
		const int ahead = 1 + random_below(&random, 8), rarely = 1 + random_below(&random, 20);
		static struct pieces pieces;
		size_t taken = 0;

		pieces = (struct pieces){.taken = 0};
		for (size_t i = 0; i < count; i++)
			pieces.holds[i] = !random_below(&random, rarely);
		background_start(&pieces.background, do_piece, &pieces, 0);
		for (size_t i = 0; i < count; i++) {
			pieces.given[i] = random_below(&random, 1000);
			background_give(&pieces.background);
			taken = take(&pieces, taken, i + 1 < (size_t)ahead ? 0 : i + 1 - (size_t)ahead);
		}
		taken = take(&pieces, taken, count);
		background_end(&pieces.background);
		ck_assert_uint_eq(taken, count);
		ck_assert_uint_eq(pieces.begun, count);
		require(!pieces.strange, "case %ld: %d pieces out of order", n, pieces.strange);
		ck_assert_int_eq(pieces.rounds, ROUNDS * (long)count);
	}
}
END_TEST

START_TEST(what_is_held_is_never_done)
{
	static struct pieces pieces;

	pieces = (struct pieces){.holds = {false, true}};
	background_start(&pieces.background, do_piece, &pieces, 0);
	for (int i = 0; i < 4; i++)
		background_give(&pieces.background);
	background_wait(&pieces.background, 1);
	background_take(&pieces.background, 1);
	background_wait(&pieces.background, 2);
	background_end(&pieces.background);
	ck_assert_uint_eq(pieces.begun, 2);
}
END_TEST

/* A second thread may be started while pieces are being done. */
START_TEST(work_may_begin_late)
{
	static struct pieces pieces;

	pieces = (struct pieces){.begun = 7, .taken = 7};
	background_start(&pieces.background, do_piece, &pieces, 7);
	ck_assert_uint_eq(background_done(&pieces.background), 7);
	background_give(&pieces.background);
	background_give(&pieces.background);
	background_wait(&pieces.background, 9);
	background_end(&pieces.background);
	ck_assert_uint_eq(pieces.begun, 9);
	ck_assert_int_eq(pieces.strange, 0);
	ck_assert_int_eq(pieces.got[8], 1);
}
END_TEST

START_TEST(the_thread_may_have_nothing_to_do)
{
	static struct pieces pieces;

	background_start(&pieces.background, do_piece, &pieces, 0);
	background_end(&pieces.background);
	ck_assert_uint_eq(pieces.begun, 0);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("work");

	tcase_add_test(tcase, work_is_done_in_order);
	tcase_add_test(tcase, what_is_held_is_never_done);
	tcase_add_test(tcase, work_may_begin_late);
	tcase_add_test(tcase, the_thread_may_have_nothing_to_do);
	return run_suite("background", tcase);
}
