#include "machine/library/tool_table_file.h"

#include <math.h>
#include <string.h>

#include "machine/library/text_lines.h"
#include "machine/tool_build.h"

struct reading {
	struct tool_library *tools;
	struct diag *diag;
	double unit;
	struct srcloc at;
};

bool tool_table_file_is(const char *text)
{
	struct text_lines lines = {.next = text};

	while (text_lines_next(&lines)) {
		const char *at = lines.line, *end = lines.line + lines.length;
		struct letter_word word;
		bool number = false, pocket = false;
		int found;

		while ((found = letter_word_next(&at, end, &word)) > 0) {
			number = number || word.letter == 'T';
			pocket = pocket || strchr("PZD", word.letter);
		}
		if (found < 0 || number || pocket)
			return found == 0 && number && pocket;
	}
	return false;
}

static bool fault(const struct reading *r, const char *what)
{
	diag_error(r->diag, r->at, "%s", what);
	return false;
}

/* Reads one word of a line. */
static bool take(const struct reading *r, const struct letter_word *word, struct length_offset_description *offset)
{
	switch (word->letter) {
	case 'T':
		if (!(word->value >= 1 && word->value <= TOOL_NUMBER_MAX) || floor(word->value) < word->value)
			return fault(r, "T must be a tool number, 1 or more");
		offset->number = (long)word->value;
		return true;
	case 'Z':
		offset->length = (struct optional_number){true, r->unit * word->value};
		return true;
	case 'D':
		offset->radius = (struct optional_number){true, r->unit * word->value / 2};
		return true;
	case 'P':
	case 'I':
	case 'J':
	case 'Q':
		return true;
	default:
		break;
	}
	if (!strchr("XYABCUVW", word->letter))
		return fault(r, "a line of a tool table can have only T, P, D, I, J, Q and axis letters");
	if (fabs(word->value) > 0) {
		diag_error(r->diag, r->at,
			   "the tool has an offset in %c, but a setup can have only offsets along the tool (Z)",
			   word->letter);
		return false;
	}
	return true;
}

static bool read_line(const struct reading *r, const struct text_lines *lines)
{
	const char *at = lines->line, *end = lines->line + lines->length;
	struct length_offset_description offset = {.of_tool = true, .length = {true, 0}};
	struct letter_word word;
	char letters[32] = "";
	size_t count = 0;
	int found;

	while ((found = letter_word_next(&at, end, &word)) > 0) {
		if (strchr(letters, word.letter))
			return fault(r, "a letter occurs twice in this line");
		if (!take(r, &word, &offset))
			return false;
		/* There are fewer letters than places. */
		letters[count++] = word.letter;
	}
	if (found < 0)
		return fault(r,
			     "a line of a tool table must have letters, each with a number, and may end with a comment "
			     "after a semicolon");
	if (!count)
		return true;
	if (!offset.number)
		return fault(r, "T is missing in this line");
	return tool_library_add_offset(r->tools, &offset, r->at, r->diag);
}

bool tool_table_file_read(struct tool_library *tools, const char *text, const char *path, double unit,
			  struct diag *diag)
{
	struct reading r = {.tools = tools, .diag = diag, .unit = unit, .at = {.file = path}};
	struct text_lines lines = {.next = text};

	while (text_lines_next(&lines)) {
		r.at.line = lines.number;
		if (!read_line(&r, &lines))
			return false;
	}
	return true;
}
