/*
 * test_shared_loop.c - each round of a shared loop is carried out once, by the owner's threads or by the helper, before
 * the loop returns.
 */
#include "check/shared_loop.h"

#include <stdatomic.h>

#include "random.h"
#include "suite.h"

enum { ROUNDS_MOST = 200, THREADS_MOST = 3 };

struct rounds {
	atomic_int done[ROUNDS_MOST], inside[THREADS_MOST + 1];
	/* rounds with a thread number that is too large, or that another thread uses at the same time */
	atomic_int strange;
	int threads;
};

static void carry_out(void *context, int number, size_t i)
{
	struct rounds *rounds = context;

	if (number < 0 || number > rounds->threads || atomic_fetch_add(&rounds->inside[number], 1) != 0)
		atomic_fetch_add(&rounds->strange, 1);
	else
		atomic_fetch_sub(&rounds->inside[number], 1);
	atomic_fetch_add(&rounds->done[i], 1);
}

struct helper {
	struct shared_loop *loop;
	bool ended;	/* guarded by the lock */
	long helped;
};

static void *help(void *context)
{
	struct helper *helper = context;
	struct shared_loop *loop = helper->loop;

	pthread_mutex_lock(&loop->lock);
	while (!helper->ended) {
		if (shared_loop_help(loop))
			helper->helped++;
		else
			pthread_cond_wait(&loop->changed, &loop->lock);
	}
	pthread_mutex_unlock(&loop->lock);
	return NULL;
}

static void end(struct helper *helper)
{
	pthread_mutex_lock(&helper->loop->lock);
	helper->ended = true;
	pthread_cond_signal(&helper->loop->changed);
	pthread_mutex_unlock(&helper->loop->lock);
}

static void run_loops(struct shared_loop *loop)
{
	for (long n = 0; n < random_cases(2000); n++) {
		struct random random = random_case(1, n);
		const int count = random_below(&random, ROUNDS_MOST + 1);
		struct rounds rounds = {.threads = 1 + random_below(&random, THREADS_MOST)};

		shared_loop_run(loop, (size_t)count, rounds.threads, carry_out, &rounds);
		for (int i = 0; i < ROUNDS_MOST; i++)
			require(rounds.done[i] == (i < count), "case %ld: round %d of %d was carried out %d times", n,
				i, count, rounds.done[i]);
		require(!rounds.strange, "case %ld: %d strange numbers", n, rounds.strange);
	}
}

START_TEST(rounds_are_carried_out_once)
{
	struct shared_loop loop;
	struct helper helper = {.loop = &loop};
	pthread_t thread;

	shared_loop_init(&loop);
	ck_assert_int_eq(pthread_create(&thread, NULL, help, &helper), 0);
	run_loops(&loop);
	end(&helper);
	ck_assert_int_eq(pthread_join(thread, NULL), 0);
	shared_loop_release(&loop);
}
END_TEST

START_TEST(without_a_helper_the_owner_does_all)
{
	struct shared_loop loop;

	shared_loop_init(&loop);
	run_loops(&loop);
	shared_loop_release(&loop);
}
END_TEST

static void take_the_rest(void *context, int number, size_t i)
{
	struct helper *helper = context;

	/* In the owner's first round the helper does all other rounds. */
	if (number == 0 && i == 0) {
		pthread_mutex_lock(&helper->loop->lock);
		while (shared_loop_help(helper->loop))
			helper->helped++;
		pthread_mutex_unlock(&helper->loop->lock);
	}
}

START_TEST(a_helper_takes_rounds)
{
	struct shared_loop loop;
	struct helper helper = {.loop = &loop};

	shared_loop_init(&loop);
	shared_loop_run(&loop, 10, 1, take_the_rest, &helper);
	ck_assert_int_eq(helper.helped, 9);
	shared_loop_release(&loop);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("rounds");

	tcase_add_test(tcase, rounds_are_carried_out_once);
	tcase_add_test(tcase, without_a_helper_the_owner_does_all);
	tcase_add_test(tcase, a_helper_takes_rounds);
	return run_suite("shared_loop", tcase);
}
