/* test_report_pack.c - how the data of a report are packed: tables, base64, the choice of pieces. */
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

#include "base/mem.h"
#include "report/format/base64.h"
#include "report/format/deflate.h"
#include "report/html/pack_table.h"
#include "report/html/recorded_table.h"
#include "report/html/report_data.h"
#include "report/html/selection.h"

#include "random.h"
#include "suite.h"

START_TEST(base64_is_that_of_the_rfc)
{
	static const char *const cases[][2] = {{"", ""}, {"f", "Zg=="}, {"fo", "Zm8="}, {"foo", "Zm9v"}, {"foobar", "Zm9vYmFy"}};

	for (size_t i = 0; i < COUNT(cases); i++) {
		struct strbuf out = {0};

		base64_add(&out, (const unsigned char *)cases[i][0], strlen(cases[i][0]));
		ck_assert_str_eq(strbuf_text(&out), cases[i][1]);
		strbuf_release(&out);
	}
}
END_TEST

START_TEST(zlib_reads_what_was_deflated)
{
	enum { COUNT = 100000 };
	char *bytes = mem_alloc(COUNT), *back = mem_alloc(COUNT);
	struct strbuf out = {0};
	uLongf length = COUNT;

	for (int i = 0; i < COUNT; i++)
		bytes[i] = (char)((long)i * i % 251);
	deflate_add(&out, bytes, COUNT, DEFLATE_FAST);
	ck_assert_int_eq(uncompress((Bytef *)back, &length, (const Bytef *)out.text, out.length), Z_OK);
	ck_assert_uint_eq(length, COUNT);
	ck_assert(!memcmp(bytes, back, COUNT));
	strbuf_release(&out);
	free(bytes);
	free(back);
}
END_TEST

START_TEST(a_table_comes_back)
{
	enum { ROWS = 300, COLUMNS = 3 };
	int64_t values[ROWS * COLUMNS], back[ROWS * COLUMNS];
	struct random random = random_case(1, 0);

	for (size_t rows = 1; rows <= ROWS; rows += 23) {
		struct strbuf out = {0};

		for (size_t i = 0; i < rows * COLUMNS; i++)
			values[i] = (int64_t)(random_bits(&random) >> (14 + 20 * (i % COLUMNS))) - 5;
		pack_table_add(&out, values, rows, COLUMNS);
		pack_table_read(back, rows, COLUMNS, strbuf_text(&out));
		ck_assert(!memcmp(values, back, rows * COLUMNS * sizeof(*values)));
		strbuf_release(&out);
	}
}
END_TEST

/*
 * A table, packed by hand according to report_data.h: 3 5 9 8 has the second differences 2 2 -5, whose codes are 4 4 9.
 */
START_TEST(a_table_is_packed_as_described)
{
	static const int64_t values[] = {3, 5, 9, 8};
	static const unsigned char wanted[] = {1, 0, 0, 0, 0, 0, 0, 0x08, 0x40, 4, 4, 9};
	struct strbuf out = {0};

	pack_table_add(&out, values, 4, 1);
	ck_assert_uint_eq(out.length, sizeof(wanted));
	ck_assert(!memcmp(out.text, wanted, sizeof(wanted)));
	strbuf_release(&out);
}
END_TEST

static void keep_least(int64_t *row, const int64_t *next, size_t columns)
{
	ck_assert_uint_eq(columns, 2);
	row[0] = next[0];
	row[1] = next[1] < row[1] ? next[1] : row[1];
}

START_TEST(a_long_table_has_all_rows_in_chunks_and_the_least_in_its_coarse_level)
{
	enum { ROWS = 3 * CHUNK_ROWS + 1234 };
	int64_t least = INT64_MAX, coarse_least = INT64_MAX, *back = mem_alloc(2 * CHUNK_ROWS * sizeof(*back));
	struct recorded_table table;
	long row = 0;

	recorded_table_init(&table, 2, keep_least);
	for (int64_t i = 0; i < ROWS; i++) {
		const int64_t values[2] = {2 * i, 1000000 - (i * 7919) % 99991};

		least = values[1] < least ? values[1] : least;
		recorded_table_add(&table, values);
	}
	ck_assert(recorded_table_close(&table));
	ck_assert_int_eq(table.rows, ROWS);
	ck_assert_uint_le(table.coarse_rows, COARSE_ROWS);
	ck_assert_uint_ge(table.coarse_rows, COARSE_ROWS / 2);
	ck_assert_int_eq(table.coarse[2 * (table.coarse_rows - 1)], 2 * (ROWS - 1));
	for (size_t i = 0; i < table.coarse_rows; i++) {
		ck_assert(!i || table.coarse[2 * i] > table.coarse[2 * i - 2]);
		coarse_least = table.coarse[2 * i + 1] < coarse_least ? table.coarse[2 * i + 1] : coarse_least;
	}
	ck_assert_int_eq(coarse_least, least);
	for (size_t i = 0; i < table.chunk_count; i++) {
		struct strbuf bytes = {0};

		ck_assert(recorded_table_chunk(&table, i, &bytes));
		ck_assert_int_eq(table.chunks[i].first, row);
		pack_table_read(back, table.chunks[i].rows, 2, strbuf_text(&bytes));
		for (size_t r = 0; r < table.chunks[i].rows; r++, row++) {
			ck_assert_int_eq(back[2 * r], 2 * row);
			ck_assert_int_eq(back[2 * r + 1], 1000000 - ((int64_t)row * 7919) % 99991);
		}
		strbuf_release(&bytes);
	}
	ck_assert_int_eq(row, ROWS);
	recorded_table_release(&table);
	free(back);
}
END_TEST

START_TEST(pieces_near_marks_come_first)
{
	static const size_t marks[] = {5}, wanted[] = {5, 4, 6, 3, 7, 2, 1, 0};
	size_t order[8];

	selection_order(order, 8, marks, 1);
	ck_assert(!memcmp(order, wanted, sizeof(wanted)));
	selection_order(order, 8, NULL, 0);
	for (size_t i = 0; i < 8; i++)
		ck_assert_uint_eq(order[i], i);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("report_pack");

	tcase_add_test(tcase, base64_is_that_of_the_rfc);
	tcase_add_test(tcase, zlib_reads_what_was_deflated);
	tcase_add_test(tcase, a_table_comes_back);
	tcase_add_test(tcase, a_table_is_packed_as_described);
	tcase_add_test(tcase, a_long_table_has_all_rows_in_chunks_and_the_least_in_its_coarse_level);
	tcase_add_test(tcase, pieces_near_marks_come_first);
	return run_suite("report_pack", tcase);
}
