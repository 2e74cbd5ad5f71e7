/* test_cut_store.c - chunks come back as they were written, from memory and from the file; a full disk is noticed. */
#include <errno.h>
#include <signal.h>
#include <sys/resource.h>

#include "random.h"
#include "stock/cut_store.h"
#include "suite.h"

enum { LIMIT = 5, CHUNKS = 3000 };

static void fill(struct cut_store *store, int count)
{
	for (int i = 0; i < count; i++) {
		struct cut_chunk *chunk = cut_store_add(store);

		ck_assert_ptr_eq(chunk, cut_store_last(store));
		ck_assert_int_eq(chunk->count, 0);
		chunk->cutter = i;
		chunk->count = 1 + i % CUT_CHUNK;
		chunk->ends[chunk->count].time = 3 * i;
	}
}

START_TEST(chunks_come_back)
{
	struct random random = random_case(1, 0);
	struct cut_store store;

	cut_store_init(&store, LIMIT);
	ck_assert_ptr_null(cut_store_last(&store));
	fill(&store, CHUNKS);
	ck_assert_uint_eq(store.count, CHUNKS);
	for (int n = 0; n < 20000; n++) {
		const int i = n < CHUNKS ? n : (int)random_in(&random, 0, CHUNKS);
		const struct cut_chunk *chunk = cut_store_get(&store, (size_t)i);

		ck_assert_int_eq(chunk->cutter, i);
		ck_assert_int_eq(chunk->count, 1 + i % CUT_CHUNK);
		ck_assert_double_eq(chunk->ends[chunk->count].time, 3 * i);
	}
	ck_assert_int_eq(store.fault, 0);
	cut_store_release(&store);
}
END_TEST

START_TEST(few_chunks_need_no_file)
{
	struct cut_store store;

	cut_store_init(&store, LIMIT);
	fill(&store, LIMIT + 1);
	for (int i = 0; i <= LIMIT; i++)
		ck_assert_int_eq(cut_store_get(&store, (size_t)i)->cutter, i);
	ck_assert_ptr_null(store.file);
	cut_store_release(&store);
}
END_TEST

/* As on a full disk: files may not grow beyond some chunks. */
START_TEST(a_failed_write_is_a_fault)
{
	const struct rlimit small = {20 * sizeof(struct cut_chunk), RLIM_INFINITY};
	struct cut_store store;

	signal(SIGXFSZ, SIG_IGN);
	ck_assert_int_eq(setrlimit(RLIMIT_FSIZE, &small), 0);
	cut_store_init(&store, LIMIT);
	fill(&store, LIMIT + 20);
	ck_assert_int_eq(store.fault, 0);
	fill(&store, 20);
	ck_assert_int_eq(store.fault, EFBIG);
	/* The stored chunks can no longer be read, but nothing worse happens. */
	ck_assert_int_eq(cut_store_get(&store, LIMIT + 30)->count, 0);
	cut_store_release(&store);
}
END_TEST

int main(void)
{
	TCase *cases = tcase_create("all");

	tcase_add_test(cases, chunks_come_back);
	tcase_add_test(cases, few_chunks_need_no_file);
	tcase_add_test(cases, a_failed_write_is_a_fault);
	return run_suite("cut_store", cases);
}
