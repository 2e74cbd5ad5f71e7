#include "gcode/text/rest_of_file.h"

#include <ctype.h>
#include <string.h>
#include <strings.h>

#include "base/axes.h"

/* Lines between two questions whether to go on. */
#define ASK_LINES 4096

/* Between M30 and the end of the file, some part of it. */
struct section {
	long number;	/* line of its O-number; 0: it has none */
	long motion;	/* line of its first block that moves axes; 0: none so far */
	bool nested;	/* inside of "o... sub" */
};

/* A line without comments and spaces, in upper case; what is longer than a block can sensibly be is cut off. */
static void squeeze(const char *line, char out[256])
{
	size_t length = 0;
	bool comment = false;

	for (; *line && *line != ';' && length < 255; line++) {
		comment = comment ? *line != ')' : *line == '(';
		if (!comment && *line != ')' && !isspace((unsigned char)*line))
			out[length++] = (char)toupper((unsigned char)*line);
	}
	out[length] = '\0';
}

static bool moves_axes(const char *block)
{
	for (const char *at = block; *at; at++)
		if (slot_of_letter(*at) >= 0 && (isdigit((unsigned char)at[1]) || strchr("+-.#[", at[1]) != NULL) && at[1] &&
		    (at == block || !isalpha((unsigned char)at[-1])))
			return true;
	return false;
}

/* Does the block have this code, an M with one or two digits? */
static bool has_code(const char *block, const char *plain, const char *padded)
{
	for (const char *at = strchr(block, 'M'); at; at = strchr(at + 1, 'M')) {
		size_t digits = strspn(at + 1, "0123456789");

		if ((digits == strlen(plain) && !strncmp(at + 1, plain, digits)) ||
		    (digits == strlen(padded) && !strncmp(at + 1, padded, digits)))
			return true;
	}
	return false;
}

/* "O1234" or ":1234" and no more: the number of a program. */
static bool is_program_number(const char *block)
{
	size_t digits = strspn(block + 1, "0123456789");

	return (*block == 'O' || *block == ':') && digits > 0 && block[1 + digits] == '\0';
}

static bool ends_with(const char *block, const char *word)
{
	size_t length = strlen(block), tail = strlen(word);

	return length > tail && !strcmp(block + length - tail, word);
}

/* Takes another line into account. True: a program ends here that moves axes. */
static bool take(struct section *section, const char *block, long line)
{
	if (*block == 'O' && ends_with(block, "ENDSUB"))
		section->nested = false;
	else if (*block == 'O' && ends_with(block, "SUB"))
		section->nested = true;
	if (!section->nested && !section->motion && moves_axes(block))
		section->motion = line;
	/* A subprogram ends: what stood before belongs to it, with or without an O-number (M97 of some controls). */
	if (has_code(block, "99", "99"))
		section->motion = 0;
	return section->motion && (has_code(block, "2", "02") || has_code(block, "30", "30"));
}

static struct rest_of_file found(const struct section *section)
{
	if (!section->motion)
		return (struct rest_of_file){0, 0};
	return section->number ? (struct rest_of_file){0, section->number} : (struct rest_of_file){section->motion, 0};
}

struct rest_of_file rest_of_file_find(struct reader *reader, const struct cancel *cancel)
{
	struct section section = {0};
	const char *text;
	char block[256];

	if (reader->base < 0)
		return (struct rest_of_file){0, 0};
	while (reader_next(reader, &text) == READER_LINE) {
		if (reader->line % ASK_LINES == 0 && cancel_asked(cancel))
			break;
		squeeze(text, block);
		if (is_program_number(block)) {
			if (section.motion)
				return found(&section);
			section = (struct section){.number = reader->line};
		} else if (take(&section, block, reader->line)) {
			return found(&section);
		}
	}
	return found(&section);
}
