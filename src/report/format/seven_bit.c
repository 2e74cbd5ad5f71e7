#include "report/format/seven_bit.h"

#include <stdint.h>

/* The index among the characters that must not be in the text, from 1; 0 for all others. */
static const unsigned char reserved[128] = {
	[0] = 1, ['\r'] = 2, [14] = 3, [15] = 4, [26] = 5, [27] = 6, ['<'] = 7, [127] = 8,
};

/* Groups of seven bits of a run of bytes, the highest first; zeros fill the last one. */
struct groups {
	const unsigned char *next, *end;	/* bytes that were not read yet */
	size_t left;	/* groups */
	unsigned held;	/* its lowest `bits` bits were read, and are not in a group yet */
	int bits;
};

static struct groups groups_of(const void *bytes, size_t count)
{
	const unsigned char *first = bytes;

	return (struct groups){.next = first, .end = first + count, .left = (8 * count + 6) / 7};
}

static unsigned next_group(struct groups *groups)
{
	if (groups->bits < 7) {
		groups->held = groups->held << 8 | (groups->next < groups->end ? *groups->next++ : 0);
		groups->bits += 8;
	}
	groups->bits -= 7;
	groups->left--;
	return groups->held >> groups->bits & 127;
}

void seven_bit_add(struct strbuf *out, const void *bytes, size_t count)
{
	struct groups groups = groups_of(bytes, count);
	char piece[4096];
	size_t length = 0;

	while (groups.left) {
		const unsigned group = next_group(&groups);
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
		code = groups.left ? 0x100 + 128 * index + next_group(&groups) : 0x500 + index;
		piece[length++] = (char)(0xc0 | code >> 6);
		piece[length++] = (char)(0x80 | (code & 63));
	}
	strbuf_add(out, piece, length);
}
