#include "report/html/recorded_table.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "report/html/pack_table.h"
#include "report/html/report_data.h"

void recorded_table_init(struct recorded_table *table, size_t columns, merge_rows_fn *merge)
{
	*table = (struct recorded_table){
		.columns = columns,
		.merge = merge,
		.stride = 1,
		.coarse = mem_alloc(COARSE_ROWS * columns * sizeof(int64_t)),
		.open = mem_alloc(CHUNK_ROWS * columns * sizeof(int64_t)),
	};
}

void recorded_table_release(struct recorded_table *table)
{
	free(table->coarse);
	free(table->open);
	free(table->chunks);
	if (table->spill)
		fclose(table->spill);
	*table = (struct recorded_table){0};
}

static size_t row_size(const struct recorded_table *table)
{
	return table->columns * sizeof(int64_t);
}

/* Joins the rows of the coarse level in pairs. Each of them stands for `stride` rows. */
static void halve(struct recorded_table *table)
{
	const size_t n = table->columns;

	for (size_t i = 0; i < table->coarse_rows / 2; i++) {
		table->merge(table->coarse + 2 * i * n, table->coarse + (2 * i + 1) * n, n);
		memmove(table->coarse + i * n, table->coarse + 2 * i * n, row_size(table));
	}
	table->coarse_rows /= 2;
	table->stride *= 2;
	table->partial = table->stride;
}

static void add_coarse(struct recorded_table *table, const int64_t *row)
{
	if (table->coarse_rows && table->partial < table->stride) {
		table->merge(table->coarse + (table->coarse_rows - 1) * table->columns, row, table->columns);
		table->partial++;
		return;
	}
	if (table->coarse_rows == COARSE_ROWS)
		halve(table);
	memcpy(table->coarse + table->coarse_rows * table->columns, row, row_size(table));
	table->coarse_rows++;
	table->partial = 1;
}

static bool write_chunk(struct recorded_table *table, const struct strbuf *packed)
{
	errno = 0;
	if (!table->spill)
		table->spill = tmpfile();
	if (table->spill && fwrite(packed->text, 1, packed->length, table->spill) == packed->length)
		return true;
	table->error = errno ? errno : EIO;
	return false;
}

static void close_chunk(struct recorded_table *table)
{
	const size_t n = table->columns;
	struct strbuf packed = {0};

	pack_table_add(&packed, table->open, table->open_rows, n);
	if (!table->error && write_chunk(table, &packed)) {
		table->chunks =
		    mem_grow(table->chunks, &table->chunk_capacity, table->chunk_count + 1, sizeof(*table->chunks));
		table->chunks[table->chunk_count++] = (struct recorded_chunk){
			.first = table->rows - (long)table->open_rows,
			.rows = table->open_rows,
			.from = table->open[0],
			.to = table->open[(table->open_rows - 1) * n],
			.offset = table->spilled,
			.length = packed.length,
		};
		table->spilled += (long)packed.length;
	}
	strbuf_release(&packed);
	table->open_rows = 0;
}

void recorded_table_add(struct recorded_table *table, const int64_t *row)
{
	if (!table->rows)
		memcpy(table->first, row, row_size(table));
	memcpy(table->last, row, row_size(table));
	add_coarse(table, row);
	memcpy(table->open + table->open_rows * table->columns, row, row_size(table));
	table->open_rows++;
	table->rows++;
	if (table->open_rows == CHUNK_ROWS)
		close_chunk(table);
}

bool recorded_table_close(struct recorded_table *table)
{
	if (table->open_rows)
		close_chunk(table);
	errno = 0;
	if (table->spill && !table->error && fflush(table->spill))
		table->error = errno ? errno : EIO;
	return !table->error;
}

bool recorded_table_chunk(struct recorded_table *table, size_t chunk, struct strbuf *out)
{
	const struct recorded_chunk *it = &table->chunks[chunk];
	char *bytes = mem_alloc(it->length);

	errno = 0;
	if (fseek(table->spill, it->offset, SEEK_SET) || fread(bytes, 1, it->length, table->spill) != it->length)
		table->error = errno ? errno : EIO;
	else
		strbuf_add(out, bytes, it->length);
	free(bytes);
	return !table->error;
}
