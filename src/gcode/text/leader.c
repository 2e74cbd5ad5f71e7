#include "gcode/text/leader.h"

#include <string.h>

#include "base/ascii.h"
#include "gcode/text/line_shape.h"

/* The most lines of a header. */
#define LEADER_LINES_MAX 1000

/* "G1 X=5" is a block of some control, though it has more than words of a letter and a number. */
static bool begins_with_g(const char *block)
{
	block += *block == 'N' ? 1 + strspn(block + 1, "0123456789") : 0;
	return *block == 'G' && ascii_is_digit(block[1]);
}

void leader_skip(struct reader *reader)
{
	char block[LINE_SHAPE_MAX];
	long long start = 0;
	const char *text;

	while (reader->line < LEADER_LINES_MAX && reader_next(reader, &text) == READER_LINE) {
		if (reader->line == 1)
			start = reader->start;
		line_shape_squeeze(text, block);
		if (*block == '%') {
			reader_seek(reader, reader->start, reader->line);
			return;
		}
		if (line_shape_is_program_number(block) || line_shape_is_block(block) ||
		    line_shape_moves_axes(block) || begins_with_g(block))
			break;
	}
	if (reader->line > 0)
		reader_seek(reader, start, 1);
	reader->furthest = 0;
}
