#include "base/strbuf.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"

/* Bytes: the room for a text before its length is known. */
#define SHORT_TEXT 64

char *strbuf_extend(struct strbuf *buf, size_t count)
{
	const size_t before = buf->length, after = before + count;

	if (after >= buf->capacity)
		buf->text = mem_grow(buf->text, &buf->capacity, after + 1, 1);
	buf->length = after;
	buf->text[after] = '\0';
	return buf->text + before;
}

void strbuf_add(struct strbuf *buf, const char *bytes, size_t count)
{
	memcpy(strbuf_extend(buf, count), bytes, count);
}

void strbuf_addf(struct strbuf *buf, const char *format, ...)
{
	va_list args;

	va_start(args, format);
	strbuf_addv(buf, format, args);
	va_end(args);
}

void strbuf_addv(struct strbuf *buf, const char *format, va_list args)
{
	va_list again;
	size_t room;
	int length;

	/* Most of the added texts are short, and are then printed once. */
	buf->text = mem_grow(buf->text, &buf->capacity, buf->length + SHORT_TEXT, 1);
	room = buf->capacity - buf->length;
	va_copy(again, args);
	length = vsnprintf(buf->text + buf->length, room, format, args);
	assert(length >= 0);
	if ((size_t)length >= room) {
		buf->text = mem_grow(buf->text, &buf->capacity, buf->length + (size_t)length + 1, 1);
		vsnprintf(buf->text + buf->length, (size_t)length + 1, format, again);
	}
	va_end(again);
	buf->length += (size_t)length;
}

size_t strbuf_control_bytes(const char *text)
{
	const unsigned char first = (unsigned char)text[0], second = first ? (unsigned char)text[1] : 0;

	if (first < 0x20 || first == 0x7f)
		return 1;
	/* U+0080 to U+009F in UTF-8 */
	return first == 0xc2 && second >= 0x80 && second < 0xa0 ? 2 : 0;
}

void strbuf_add_visible(struct strbuf *buf, const char *text)
{
	while (*text) {
		const size_t controls = strbuf_control_bytes(text);

		strbuf_add(buf, controls ? "?" : text, 1);
		text += controls ? controls : 1;
	}
}

void strbuf_clear(struct strbuf *buf)
{
	buf->length = 0;
	if (buf->text)
		buf->text[0] = '\0';
}

void strbuf_release(struct strbuf *buf)
{
	free(buf->text);
	*buf = (struct strbuf){0};
}

const char *strbuf_text(const struct strbuf *buf)
{
	return buf->text ? buf->text : "";
}
