/* test_interval_pool.c - intervals stay as long as they have users; then their storage is used again. */
#include "scene/interval_pool.h"

#include "suite.h"

/* Halves an interval as a sweep does, without filling in the halves. */
static void halve(struct interval_pool *pool, struct motion_interval *interval)
{
	for (int i = 0; i < 2; i++) {
		interval->halves[i] = interval_pool_take(pool);
		interval->halves[i]->halved = false;
	}
	interval->halved = true;
}

static size_t count_spare(const struct interval_pool *pool)
{
	size_t count = 0;

	for (const struct motion_interval *i = pool->spare; i; i = i->halves[0])
		count++;
	return count;
}

START_TEST(halves_live_as_long_as_they_are_used)
{
	struct interval_pool pool = {0};
	const struct motion_interval part = {.depth = 7, .halved = true, .users = 9};
	struct motion_interval *whole = interval_pool_copy(&pool, &part), *first;

	ck_assert_int_eq(whole->depth, 7);
	ck_assert(!whole->halved);
	halve(&pool, whole);
	first = whole->halves[0];
	halve(&pool, first);
	interval_pool_share(first);
	interval_pool_share(whole);
	interval_pool_leave(&pool, whole);
	ck_assert_uint_eq(count_spare(&pool), 0);
	/*
	 * The second half is released together with the whole; the first half has its own user, and keeps its halves.
	 */
	interval_pool_leave(&pool, whole);
	ck_assert_uint_eq(count_spare(&pool), 2);
	interval_pool_leave(&pool, first);
	ck_assert_uint_eq(count_spare(&pool), 5);
	interval_pool_release(&pool);
}
END_TEST

/* A walk that releases each interval as soon as it is halved needs three intervals, for any depth. */
START_TEST(storage_is_used_again)
{
	struct interval_pool pool = {0};
	const struct motion_interval part = {.depth = 0};

	for (int walk = 0; walk < 100; walk++) {
		struct motion_interval *interval = interval_pool_copy(&pool, &part), *halves[2];

		for (int depth = 0; depth < 10; depth++) {
			halve(&pool, interval);
			for (int i = 0; i < 2; i++)
				interval_pool_share(halves[i] = interval->halves[i]);
			interval_pool_leave(&pool, interval);
			interval_pool_leave(&pool, halves[1]);
			interval = halves[0];
		}
		interval_pool_leave(&pool, interval);
	}
	ck_assert_uint_le(pool.count, 3);
	ck_assert_uint_eq(count_spare(&pool), pool.count);
	interval_pool_release(&pool);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("core");

	tcase_add_test(tcase, halves_live_as_long_as_they_are_used);
	tcase_add_test(tcase, storage_is_used_again);
	return run_suite("interval_pool", tcase);
}
