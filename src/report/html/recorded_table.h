/*
 * recorded_table.h - a table of any length in bounded memory: a coarse level in memory, and the rows themselves in a
 * temporary file.
 */
#ifndef FIVECHECK_REPORT_HTML_RECORDED_TABLE_H
#define FIVECHECK_REPORT_HTML_RECORDED_TABLE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "base/axes.h"
#include "base/strbuf.h"

enum { RECORDED_COLUMNS_MAX = 8 + SLOT_COUNT };

/* Joins a row of the coarse level with the next one. */
typedef void merge_rows_fn(int64_t *row, const int64_t *next, size_t columns);

/* CHUNK_ROWS rows, the last chunk perhaps fewer. */
struct recorded_chunk {
	long first;	/* row, from 0 */
	size_t rows;
	int64_t from, to;	/* column 0 of its first and last row */
	long offset;	/* of the packed chunk (pack_table.h) in the temporary file */
	size_t length;
};

/* Column 0 is the time and never decreases. Do not move the struct after recorded_table_init. */
struct recorded_table {
	size_t columns;
	long rows;
	merge_rows_fn *merge;
	int64_t *coarse;	/* each row stands for `stride` rows, the last one for `partial` */
	size_t coarse_rows;
	long stride, partial;
	int64_t *open;	/* rows of the chunk that is not complete */
	size_t open_rows;
	struct recorded_chunk *chunks;	/* complete ones */
	size_t chunk_count, chunk_capacity;
	int64_t first[RECORDED_COLUMNS_MAX];	/* the first row */
	int64_t last[RECORDED_COLUMNS_MAX];	/* the last row */
	FILE *spill;
	long spilled;	/* bytes */
	int error;	/* errno of the first write that failed; 0: none */
};

void recorded_table_init(struct recorded_table *table, size_t columns, merge_rows_fn *merge);
void recorded_table_release(struct recorded_table *table);

void recorded_table_add(struct recorded_table *table, const int64_t *row);

/*
 * Completes the last chunk. Nothing may be added afterwards. False: the temporary file failed; the reason is in
 * table->error.
 */
bool recorded_table_close(struct recorded_table *table);

/* Appends a complete chunk, packed. False: it could not be read; the reason is in table->error. */
bool recorded_table_chunk(struct recorded_table *table, size_t chunk, struct strbuf *out);

#endif
