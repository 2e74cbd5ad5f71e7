#include "gcode/dialect/family.h"

#include <string.h>

#include "control/dialects.h"
#include "gcode/dialect/family_signs.h"
#include "gcode/text/leader.h"
#include "gcode/text/line_shape.h"

/* The number of lines that are examined: these include the head of a program and its first moves. */
#define FAMILY_LINES 300

static bool reads(const struct family *family, const char *dialect)
{
	for (size_t i = 0; family->dialects[i]; i++) {
		if (!strcmp(family->dialects[i], dialect))
			return true;
	}
	return false;
}

/* Examines a line; true: a certain sign was found. */
static bool examine_line(const char *line, long number, const char *dialect, struct family_sign *found)
{
	char block[LINE_SHAPE_MAX];

	line_shape_squeeze(line, block);
	for (const struct sign *sign = family_signs; sign->family; sign++) {
		if ((found->line && !sign->certain) || reads(sign->family, dialect) ||
		    !family_signs_match(sign, line, block))
			continue;
		*found = (struct family_sign){number, sign->shown, sign->family->title, sign->certain};
		if (sign->certain)
			return true;
	}
	return false;
}

/* Goes to the first line to examine: text before a '%' is no sign. *start: the position of the first line. */
static enum reader_status begin(struct reader *reader, long long *start, const char **text)
{
	const enum reader_status status = reader_next(reader, text);

	*start = status == READER_LINE ? reader->start : 0;
	if (status == READER_LINE) {
		reader_seek(reader, *start, 1);
		leader_skip(reader);
	}
	return status;
}

static void go_back(struct reader *reader, long long start)
{
	if (reader->line > 0)
		reader_seek(reader, start, 1);
	reader->furthest = 0;
}

struct family_sign family_find(struct reader *reader, const char *dialect)
{
	struct family_sign found = {0};
	long long start;
	const char *text;
	bool more = begin(reader, &start, &text) == READER_LINE;
	const long last = reader->line + FAMILY_LINES;

	while (more && reader->line < last && reader_next(reader, &text) == READER_LINE)
		more = !examine_line(text, reader->line, dialect, &found);
	go_back(reader, start);
	return found;
}

/* A bit for each dialect of the family. */
static unsigned dialects_of(const struct family *family)
{
	unsigned bits = 0;

	for (size_t i = 0; family->dialects[i]; i++) {
		int row = dialect_row_find(family->dialects[i]);

		bits |= row < 0 ? 0 : 1U << row;
	}
	return bits;
}

/* Examines a line; false: the line contradicts the lines before. */
static bool narrow(const char *line, long number, unsigned *dialects, struct family_guess *guess)
{
	char block[LINE_SHAPE_MAX];

	line_shape_squeeze(line, block);
	for (const struct sign *sign = family_signs; sign->family; sign++) {
		const struct family_sign found = {number, sign->shown, sign->family->title, sign->certain};
		unsigned both;

		/* For a family that no dialect reads, one sign is enough. */
		if (*dialects == 0 || !family_signs_match(sign, line, block))
			continue;
		both = *dialects & dialects_of(sign->family);
		if (!both && guess->sign.line) {
			guess->against = found;
			return false;
		}
		if (both != *dialects)
			guess->sign = found;
		*dialects = both;
	}
	return true;
}

struct family_guess family_guess(struct reader *reader)
{
	struct family_guess guess = {.row = -1};
	unsigned dialects = ~0U;
	long long start;
	const char *text;
	enum reader_status status = begin(reader, &start, &text);
	const long last = reader->line + FAMILY_LINES;
	bool agreed = true;

	while (agreed && reader->line < last && status == READER_LINE) {
		status = reader_next(reader, &text);
		if (status == READER_LINE)
			agreed = narrow(text, reader->line, &dialects, &guess);
	}
	guess.end = reader_fault_of(reader, status, text);
	go_back(reader, start);
	guess.rows = dialects;
	for (int row = 0; agreed && dialect_names[row]; row++) {
		if (dialects == 1U << row)
			guess.row = row;
	}
	return guess;
}
