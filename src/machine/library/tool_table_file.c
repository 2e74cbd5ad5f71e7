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

/* A line of the table. */
struct line {
	struct length_offset_description offset;
	char beside;	/* an axis with an offset other than Z; 0: none */
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
static bool take_word(const struct reading *r, const struct letter_word *word, struct line *line)
{
	switch (word->letter) {
	case 'T':
		if (!(word->value >= 0 && word->value <= TOOL_NUMBER_MAX) || floor(word->value) < word->value)
			return fault(r, "T must be a tool number, or 0 for no tool");
		line->offset.number = (long)word->value;
		return true;
	case 'Z':
		line->offset.length = (struct optional_number){true, r->unit * word->value};
		return true;
	case 'D':
		line->offset.radius = (struct optional_number){true, r->unit * word->value / 2};
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
	if (fabs(word->value) > 0)
		line->beside = word->letter;
	return true;
}

static bool add_line(const struct reading *r, const struct line *line)
{
	const struct length_offset_description *offset = &line->offset;

	/* T0 is the empty spindle. */
	if (!offset->number)
		return (!line->beside && !(fabs(offset->length.value) > 0) && !(fabs(offset->radius.value) > 0)) ||
		       fault(r, "T0 is no tool, so a setup cannot have its length or diameter: remove the line");
	if (!line->beside || !tool_library_wants(r->tools, offset->number))
		return tool_library_add_offset(r->tools, offset, r->at, r->diag);
	diag_error(r->diag, r->at,
		   "tool %ld has an offset in %c, but a setup can have only offsets along the tool (Z): remove the "
		   "line, or leave the tool out with numbers=\"\" of <tools>",
		   offset->number, line->beside);
	return false;
}

static bool read_line(const struct reading *r, const struct text_lines *lines)
{
	const char *at = lines->line, *end = lines->line + lines->length;
	struct line line = {.offset = {.of_tool = true, .length = {true, 0}}};
	struct letter_word word;
	char letters[32] = "";
	size_t count = 0;
	int found;

	while ((found = letter_word_next(&at, end, &word)) > 0) {
		if (strchr(letters, word.letter))
			return fault(r, "a letter occurs twice in this line");
		if (!take_word(r, &word, &line))
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
	return strchr(letters, 'T') ? add_line(r, &line) : fault(r, "T is missing in this line");
}

bool tool_table_file_read(struct tool_library *tools, const char *text, const char *path, double unit,
			  struct diag *diag)
{
	struct reading r = {.tools = tools, .diag = diag, .unit = unit, .at = {.file = path}};
	struct text_lines lines = {.next = text};

	tools->unit_is_assumed = true;
	while (text_lines_next(&lines)) {
		r.at.line = lines.number;
		if (!read_line(&r, &lines))
			return false;
	}
	return true;
}
