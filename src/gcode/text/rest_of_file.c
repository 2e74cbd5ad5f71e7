#include "gcode/text/rest_of_file.h"

#include <string.h>

#include "gcode/text/line_shape.h"

/* Lines between two calls of `cancel`. */
#define ASK_LINES 4096

/* A section of the text between M30 and the end of the file. */
struct section {
	long number;	/* line of its O-number; 0: it has none */
	long motion;	/* line of its first block that moves axes; 0: none so far */
	bool nested;	/* inside of "o... sub" */
};

/* Has the block this M-code, with one or two digits? */
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

static bool ends_with(const char *block, const char *word)
{
	size_t length = strlen(block), tail = strlen(word);

	return length > tail && !strcmp(block + length - tail, word);
}

/* Adds a line to the section. True: a program that moves axes ends here. */
static bool add_line(struct section *section, const char *block, long line)
{
	if (*block == 'O' && ends_with(block, "ENDSUB"))
		section->nested = false;
	else if (*block == 'O' && ends_with(block, "SUB"))
		section->nested = true;
	if (!section->nested && !section->motion && line_shape_moves_axes(block))
		section->motion = line;
	/* A subprogram ends: the lines before belong to it, with or without an O-number (M97 of some controls). */
	if (has_code(block, "99", "99"))
		section->motion = 0;
	return section->motion && (has_code(block, "2", "02") || has_code(block, "30", "30"));
}

static struct rest_of_file found(const struct section *section)
{
	struct rest_of_file rest = {0};

	if (section->motion && section->number)
		rest.program = section->number;
	else
		rest.motion = section->motion;
	return rest;
}

struct rest_of_file rest_of_file_find(struct reader *reader, bool (*heads_main)(const char *text),
				      const struct cancel *cancel)
{
	struct section section = {0};
	bool complete = false;	/* the section is the one to be told */
	const char *text;
	char block[LINE_SHAPE_MAX];

	if (reader->base < 0)
		return (struct rest_of_file){0};
	while ((!complete || heads_main) && reader_next(reader, &text) == READER_LINE) {
		if (reader->line % ASK_LINES == 0 && cancel_asked(cancel))
			break;
		if (heads_main && heads_main(text))
			return (struct rest_of_file){.main = reader->line};
		line_shape_squeeze(text, block);
		if (complete)
			continue;
		if (line_shape_is_program_number(block)) {
			complete = section.motion > 0;
			if (!complete)
				section = (struct section){.number = reader->line};
		} else {
			complete = add_line(&section, block, reader->line);
		}
	}
	return found(&section);
}
