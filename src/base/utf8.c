#include "base/utf8.h"

size_t utf8_length(const char *bytes)
{
	const unsigned char *text = (const unsigned char *)bytes;
	unsigned char c = text[0];
	size_t length = c < 0x80 ? 1 : c < 0xc2 ? 0 : c < 0xe0 ? 2 : c < 0xf0 ? 3 : c < 0xf5 ? 4 : 0;

	if (!c)
		return 0;
	for (size_t i = 1; i < length; i++) {
		if ((text[i] & 0xc0) != 0x80)
			return 0;
	}
	/* Refuse overlong forms, surrogates, and code points beyond U+10FFFF. */
	if ((c == 0xe0 && text[1] < 0xa0) || (c == 0xed && text[1] > 0x9f) || (c == 0xf0 && text[1] < 0x90) ||
	    (c == 0xf4 && text[1] > 0x8f))
		return 0;
	return length;
}

void utf8_add_clean(struct strbuf *out, const char *text)
{
	while (*text) {
		const char *from = text;
		size_t length;

		while ((length = utf8_length(text)) > 0)
			text += length;
		strbuf_add(out, from, (size_t)(text - from));
		if (!*text)
			break;
		strbuf_addf(out, "\xef\xbf\xbd");
		text++;
	}
}

size_t utf8_units(const char *text)
{
	size_t units = 0;

	while (*text) {
		size_t length = utf8_length(text);

		/* A code point beyond U+FFFF has four bytes and two UTF-16 units. */
		units += length == 4 ? 2 : 1;
		text += length ? length : 1;
	}
	return units;
}
