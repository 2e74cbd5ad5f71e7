#include "report/picture/png.h"

#include <stdint.h>
#include <string.h>
#include <zlib.h>

#include "report/format/deflate.h"

static void add_u32(struct strbuf *out, uint32_t value)
{
	const char bytes[4] = {(char)(value >> 24), (char)(value >> 16 & 255), (char)(value >> 8 & 255),
			       (char)(value & 255)};

	strbuf_add(out, bytes, sizeof(bytes));
}

static void add_chunk(struct strbuf *out, const char *kind, const struct strbuf *data)
{
	const size_t start = out->length + 4;

	add_u32(out, (uint32_t)data->length);
	strbuf_add(out, kind, 4);
	strbuf_add(out, strbuf_text(data), data->length);
	add_u32(out, (uint32_t)crc32(0, (const Bytef *)out->text + start, (uInt)(out->length - start)));
}

/* Each row begins with its filter: 2, the difference from the row above. */
static void add_rows(struct strbuf *out, const unsigned char *pixels, size_t width, size_t height)
{
	const size_t row = 3 * width;

	for (size_t y = 0; y < height; y++) {
		strbuf_add(out, "\2", 1);
		for (size_t i = 0; i < row; i++) {
			const unsigned char above = y ? pixels[(y - 1) * row + i] : 0;
			const char byte = (char)(unsigned char)(pixels[y * row + i] - above);

			strbuf_add(out, &byte, 1);
		}
	}
}

void png_add(struct strbuf *out, const unsigned char *pixels, int width, int height)
{
	struct strbuf head = {0}, rows = {0}, packed = {0}, none = {0};

	strbuf_add(out, "\x89PNG\r\n\x1a\n", 8);
	add_u32(&head, (uint32_t)width);
	add_u32(&head, (uint32_t)height);
	/* 8 bits, colours without alpha, deflate, filters by row, not interlaced. */
	strbuf_add(&head, "\10\2\0\0\0", 5);
	add_chunk(out, "IHDR", &head);
	add_rows(&rows, pixels, (size_t)width, (size_t)height);
	deflate_add(&packed, strbuf_text(&rows), rows.length, DEFLATE_SMALL);
	add_chunk(out, "IDAT", &packed);
	add_chunk(out, "IEND", &none);
	strbuf_release(&head);
	strbuf_release(&rows);
	strbuf_release(&packed);
}
