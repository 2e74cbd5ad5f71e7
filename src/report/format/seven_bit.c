#include "report/format/seven_bit.h"

#include <stdint.h>

/* The index among the characters that must not stand in the text, from 1; 0 for all others. */
static const unsigned char reserved[128] = {
	[0] = 1, ['\r'] = 2, [14] = 3, [15] = 4, [26] = 5, [27] = 6, ['<'] = 7, [127] = 8,
};

static unsigned group_at(const unsigned char *bytes, size_t count, size_t group)
{
	const size_t byte = 7 * group / 8, skip = 7 * group % 8;
	const unsigned two = (unsigned)bytes[byte] << 8 | (byte + 1 < count ? bytes[byte + 1] : 0);

	return two >> (9 - skip) & 127;
}

void seven_bit_add(struct strbuf *out, const void *bytes, size_t count)
{
	const size_t groups = (8 * count + 6) / 7;
	char piece[1024];
	size_t length = 0;

	for (size_t i = 0; i < groups; i++) {
		const unsigned group = group_at(bytes, count, i);
		unsigned index, code;

		if (length > sizeof(piece) - 2) {
			strbuf_add(out, piece, length);
			length = 0;
		}
		if (!reserved[group]) {
			piece[length++] = (char)group;
			continue;
		}
		index = reserved[group] - 1U;
		code = i + 1 < groups ? 0x100 + 128 * index + group_at(bytes, count, i + 1) : 0x500 + index;
		piece[length++] = (char)(0xc0 | code >> 6);
		piece[length++] = (char)(0x80 | (code & 63));
		i++;
	}
	strbuf_add(out, piece, length);
}
