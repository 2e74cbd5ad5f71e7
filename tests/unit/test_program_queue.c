/*
 * test_program_queue.c - the order in which threads take programs: each program once, and the last thread ends soon
 * after the others.
 */
#include "cli/program_queue.h"

#include "random.h"
#include "suite.h"

enum { PROGRAMS_MOST = 40, THREADS_MOST = 5 };

static void expect_order(const double *sizes, const size_t *order, int count, int threads)
{
	struct program_queue queue;
	size_t program;

	program_queue_init(&queue, sizes, (size_t)count, threads);
	for (int i = 0; i < count; i++) {
		ck_assert(program_queue_take(&queue, &program));
		ck_assert_uint_eq(program, order[i]);
	}
	ck_assert(!program_queue_take(&queue, &program));
	program_queue_release(&queue);
}

START_TEST(large_ones_do_not_wait)
{
	static const double even[] = {3, 3, 3, 3}, unknown[] = {0, 0, 0}, late[] = {1, 1, 2, 9}, early[] = {9, 1, 2, 4};
	static const size_t in_order[] = {0, 1, 2, 3}, last_first[] = {3, 0, 2, 1}, largest_first[] = {0, 3, 2, 1};

	expect_order(even, in_order, COUNT(even), 2);
	expect_order(unknown, in_order, COUNT(unknown), 2);
	expect_order(late, in_order, COUNT(late), 1);
	expect_order(late, last_first, COUNT(late), 2);
	expect_order(early, largest_first, COUNT(early), 2);
}
END_TEST

static double largest_left(const double *sizes, const bool *taken, size_t count)
{
	double largest = 0;

	for (size_t i = 0; i < count; i++)
		largest = !taken[i] && sizes[i] > largest ? sizes[i] : largest;
	return largest;
}

/* The work of the threads, if a program takes as long as it is large, and each free thread takes the next program. */
struct run {
	double end;	/* of the last thread */
	bool last_was_largest;	/* its last program was the largest of those that were left */
};

static struct run run_of(const double *sizes, size_t count, int threads)
{
	double free_at[THREADS_MOST] = {0};
	bool taken[PROGRAMS_MOST] = {false};
	struct program_queue queue;
	struct run run = {0};

	program_queue_init(&queue, sizes, count, threads);
	for (size_t n = 0; n < count; n++) {
		const double largest = largest_left(sizes, taken, count);
		size_t program;
		int first = 0;

		ck_assert(program_queue_take(&queue, &program));
		ck_assert_uint_lt(program, count);
		ck_assert(!taken[program]);
		taken[program] = true;
		for (int i = 1; i < threads; i++)
			first = free_at[i] < free_at[first] ? i : first;
		free_at[first] += sizes[program];
		if (free_at[first] > run.end)
			run = (struct run){free_at[first], sizes[program] >= largest};
	}
	program_queue_release(&queue);
	return run;
}

/*
 * A program that is not taken as the largest has at most one thread's share of all that is left, so it ends no later
 * than if all programs were shared out evenly.
 */
START_TEST(only_a_large_one_ends_late)
{
	for (long n = 0; n < random_cases(2000); n++) {
		struct random random = random_case(1, n);
		const size_t count = 1 + (size_t)random_below(&random, PROGRAMS_MOST);
		const int threads = 1 + random_below(&random, THREADS_MOST);
		double sizes[PROGRAMS_MOST], sum = 0;
		struct run run;

		for (size_t i = 0; i < count; i++) {
			sizes[i] = random_below(&random, 4) ? random_below(&random, 10) : random_below(&random, 200);
			sum += sizes[i];
		}
		run = run_of(sizes, count, threads);
		require(run.last_was_largest || run.end <= sum / threads, "case %ld: %g, not %g", n, run.end,
			sum / threads);
	}
}
END_TEST

int main(void)
{
	const TTest *const tests[] = {large_ones_do_not_wait, only_a_large_one_ends_late};

	return RUN_TESTS("program_queue", tests);
}
