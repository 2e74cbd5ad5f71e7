#include "machine/library/text_lines.h"

#include <math.h>
#include <string.h>

#include "base/ascii.h"
#include "base/decimal.h"

bool text_lines_next(struct text_lines *lines)
{
	if (!*lines->next)
		return false;
	/* A byte order mark is not part of the first line. */
	if (!lines->number && !strncmp(lines->next, "\xef\xbb\xbf", 3))
		lines->next += 3;
	lines->line = lines->next;
	lines->length = strcspn(lines->next, "\r\n");
	lines->next += lines->length;
	lines->next += *lines->next == '\r';
	lines->next += *lines->next == '\n';
	lines->number++;
	return true;
}

static const char *skip(const char *at, const char *end)
{
	while (at < end && (*at == ' ' || *at == '\t' || *at == '(')) {
		if (*at == '(') {
			const char *close = memchr(at, ')', (size_t)(end - at));

			if (!close)
				return at;
			at = close;
		}
		at++;
	}
	return at;
}

int letter_word_next(const char **at, const char *end, struct letter_word *word)
{
	const char *from = skip(*at, end), *to;
	char text[32];
	size_t length;

	*at = from;
	if (from == end || *from == ';')
		return 0;
	if (!ascii_is_letter(*from))
		return -1;
	to = skip(from + 1, end);
	for (length = 0; to + length < end && length < sizeof(text) - 1 && strchr("+-.0123456789", to[length]);
	     length++)
		text[length] = to[length];
	text[length] = '\0';
	if (!decimal_read(text, length, &word->value) || !isfinite(word->value))
		return -1;
	word->letter = ascii_upper(*from);
	word->has_point = strchr(text, '.') != NULL;
	*at = to + length;
	return 1;
}
