#include "report/format/seven_bit.h"

#include <stdint.h>
#include <string.h>

enum { NONE = -1 };

/* The index among the characters that must not stand in the text; NONE for all others. */
static int reserved_index(unsigned group)
{
	static const char reserved[8] = {0, '\r', 14, 15, 26, 27, '<', 127};
	const char *found = memchr(reserved, (int)group, sizeof(reserved));

	return found ? (int)(found - reserved) : NONE;
}

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
		const int index = reserved_index(group);
		unsigned code;

		if (length > sizeof(piece) - 2) {
			strbuf_add(out, piece, length);
			length = 0;
		}
		if (index == NONE) {
			piece[length++] = (char)group;
			continue;
		}
		code = i + 1 < groups ? 0x100 + 128 * (unsigned)index + group_at(bytes, count, i + 1)
				      : 0x500 + (unsigned)index;
		piece[length++] = (char)(0xc0 | code >> 6);
		piece[length++] = (char)(0x80 | (code & 63));
		i++;
	}
	strbuf_add(out, piece, length);
}
