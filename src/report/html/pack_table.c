#include "report/html/pack_table.h"

#include <stdlib.h>
#include <string.h>

#include "base/mem.h"

static uint64_t zigzag(int64_t value)
{
	return value < 0 ? 2 * (uint64_t)(-(value + 1)) + 1 : 2 * (uint64_t)value;
}

/* The codes of rows 1 and later of one column. Returns the bits that any of them has. */
static uint64_t encode(uint64_t *codes, const int64_t *values, size_t rows, size_t columns)
{
	uint64_t bits = 0;
	int64_t delta = 0;

	for (size_t r = 1; r < rows; r++) {
		const int64_t step = values[r * columns] - values[(r - 1) * columns];

		codes[r - 1] = zigzag(step - delta);
		bits |= codes[r - 1];
		delta = step;
	}
	return bits;
}

static int planes_of(uint64_t bits)
{
	int planes = 0;

	for (; bits; bits >>= 8)
		planes++;
	return planes;
}

static void add_head(struct strbuf *out, int planes, int64_t first)
{
	const double number = (double)first;
	unsigned char head[9] = {(unsigned char)planes};
	uint64_t bits;

	memcpy(&bits, &number, sizeof(bits));
	for (int i = 0; i < 8; i++)
		head[1 + i] = (unsigned char)(bits >> 8 * i);
	strbuf_add(out, (const char *)head, sizeof(head));
}

static void add_planes(struct strbuf *out, const uint64_t *codes, size_t count, int planes, char *plane)
{
	for (int p = 0; p < planes; p++) {
		for (size_t i = 0; i < count; i++)
			plane[i] = (char)(codes[i] >> 8 * p & 255);
		strbuf_add(out, plane, count);
	}
}

void pack_table_add(struct strbuf *out, const int64_t *values, size_t rows, size_t columns)
{
	uint64_t *codes = mem_zalloc(rows, sizeof(*codes));
	char *plane = mem_alloc(rows);
	struct strbuf planes = {0};

	for (size_t c = 0; c < columns; c++) {
		const int count = planes_of(encode(codes, values + c, rows, columns));

		add_head(out, count, values[c]);
		add_planes(&planes, codes, rows - 1, count, plane);
	}
	strbuf_add(out, strbuf_text(&planes), planes.length);
	strbuf_release(&planes);
	free(plane);
	free(codes);
}

static int64_t unzigzag(uint64_t code)
{
	return code & 1 ? -(int64_t)(code >> 1) - 1 : (int64_t)(code >> 1);
}

static int64_t read_first(const char *head)
{
	uint64_t bits = 0;
	double number;

	for (int i = 0; i < 8; i++)
		bits |= (uint64_t)(unsigned char)head[1 + i] << 8 * i;
	memcpy(&number, &bits, sizeof(number));
	return (int64_t)number;
}

void pack_table_read(int64_t *values, size_t rows, size_t columns, const char *bytes)
{
	const char *plane = bytes + 9 * columns;

	for (size_t c = 0; c < columns; c++) {
		const int planes = (unsigned char)bytes[9 * c];
		int64_t delta = 0;

		values[c] = read_first(bytes + 9 * c);
		for (size_t r = 1; r < rows; r++) {
			uint64_t code = 0;

			for (int p = 0; p < planes; p++)
				code |= (uint64_t)(unsigned char)plane[(size_t)p * (rows - 1) + r - 1] << 8 * p;
			delta += unzigzag(code);
			values[r * columns + c] = values[(r - 1) * columns + c] + delta;
		}
		plane += (size_t)planes * (rows - 1);
	}
}
