#include "machine/library/offset_listing.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/axes.h"
#include "base/mem.h"
#include "base/strbuf.h"
#include "base/units.h"
#include "machine/library/text_lines.h"
#include "machine/tool_build.h"

/* A program that only writes offsets begins to write them within these lines. */
enum { FIRST_LINES = 50, WORK_OFFSETS = 6, EXTENDED_WORK_OFFSETS = 300 };

/* The values of the registers of a number, in mm. */
struct registers {
	long number;
	bool given[4];
	double value[4];	/* H geometry, H wear, D geometry, D wear: L10 to L13 */
	long line[4];
};

struct reading {
	struct tool_library *tools;
	struct diag *diag;
	double unit;
	bool unit_is_given;	/* by G20 or G21 */
	struct srcloc at;
	struct registers *rows;
	size_t count, capacity;
};

/* The words of a line; NAN: not given. */
struct line {
	double value[26];
	bool has_point[26];
	bool writes;	/* it has G10 */
};

static bool fault(const struct reading *r, const char *what)
{
	diag_error(r->diag, r->at, "%s", what);
	return false;
}

bool offset_listing_is(const char *text)
{
	struct text_lines lines = {.next = text};

	while (text_lines_next(&lines) && lines.number <= FIRST_LINES) {
		const char *at = lines.line, *end = lines.line + lines.length;
		struct letter_word word;

		while (letter_word_next(&at, end, &word) > 0)
			if (word.letter == 'G' && word.value > 9.5 && word.value < 10.5)
				return true;
	}
	return false;
}

static double given(const struct line *line, char letter)
{
	return line->value[letter - 'A'];
}

static bool is_given(const struct line *line, char letter)
{
	return !isnan(given(line, letter));
}

/* A whole number from low to high, or -1. */
static long whole(const struct line *line, char letter, long low, long high)
{
	double value = given(line, letter);

	return value >= (double)low && value <= (double)high && floor(value) >= value ? (long)value : -1;
}

static bool length_of(const struct reading *r, const struct line *line, char letter, double *value)
{
	if (fabs(given(line, letter)) > 0 && !line->has_point[letter - 'A']) {
		diag_error(r->diag, r->at,
			   "%c has no decimal point, and a parameter of the control decides what that means",
			   letter);
		return false;
	}
	*value = given(line, letter);
	return true;
}

static bool has_axis(const struct line *line)
{
	for (int slot = 0; slot < SLOT_COUNT; slot++)
		if (is_given(line, AXIS_LETTERS[slot]))
			return true;
	return false;
}

/* ------------------------------------------------------------- H and D */

static struct registers *row_of(struct reading *r, long number)
{
	for (size_t i = 0; i < r->count; i++)
		if (r->rows[i].number == number)
			return &r->rows[i];
	r->rows = mem_grow(r->rows, &r->capacity, r->count + 1, sizeof(*r->rows));
	r->rows[r->count] = (struct registers){.number = number};
	return &r->rows[r->count++];
}

static bool take_register(struct reading *r, const struct line *line, int which)
{
	long number = whole(line, 'P', 1, TOOL_NUMBER_MAX);
	struct registers *row;
	double value;

	if (number < 0 || !is_given(line, 'R'))
		return fault(r, "G10 for an offset needs P (number) and R (value)");
	if (has_axis(line))
		return fault(r, "G10 for an offset has its value in R; axis words are not supported");
	if (!length_of(r, line, 'R', &value))
		return false;
	row = row_of(r, number);
	if (row->given[which]) {
		diag_error(r->diag, r->at, "this offset is given twice (also in line %ld)", row->line[which]);
		return false;
	}
	row->given[which] = true;
	row->line[which] = r->at.line;
	row->value[which] = r->unit * value;
	return true;
}

static bool add_rows(struct reading *r)
{
	for (size_t i = 0; i < r->count; i++) {
		const struct registers *row = &r->rows[i];
		struct length_offset_description offset = {
			.number = row->number,
			.length = {row->given[0] || row->given[1], row->value[0] + row->value[1]},
			.radius = {row->given[2] || row->given[3], row->value[2] + row->value[3]},
			.d_of_control = true,
		};

		if (!tool_library_add_offset(r->tools, &offset, r->at, r->diag))
			return false;
	}
	return true;
}

/* -------------------------------------------------------- work offsets */

/* The name of the work offset, "" for the common one; false: reported. */
static bool name_offset(const struct reading *r, const struct line *line, bool extended, struct strbuf *name)
{
	long number = whole(line, 'P', extended ? 1 : 0, extended ? EXTENDED_WORK_OFFSETS : WORK_OFFSETS);

	if (number < 0)
		return fault(r, extended ? "G10 L20 needs P1 to P300" : "G10 L2 needs P0 to P6");
	if (extended)
		strbuf_addf(name, "G54.1 P%ld", number);
	else if (number)
		strbuf_addf(name, "G%ld", 53 + number);
	return true;
}

/* NULL as the offset: the common one. */
static bool take_values(struct reading *r, const struct line *line, struct work_offset_description *offset)
{
	double value;

	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		char letter = AXIS_LETTERS[slot];

		if (!is_given(line, letter))
			continue;
		if (!length_of(r, line, letter, &value))
			return false;
		if (!offset && fabs(value) > 0)
			return fault(r,
				     "the common offset of all work offsets (P0) is not 0, which a setup cannot have; "
				     "add it to each work offset");
		if (offset && offset->value[slot].given)
			return fault(r, "this work offset is given twice");
		/* Listings have a 0 for every axis that the control knows, even if the machine does not have it. */
		if (offset && fabs(value) > 0)
			offset->value[slot] = (struct optional_number){
				true, slot_is_rotary(slot) ? radians(value) : r->unit * value};
	}
	return true;
}

static bool take_work_offset(struct reading *r, const struct line *line, bool extended)
{
	struct strbuf name = {0};
	bool good;

	if (fabs(given(line, 'R')) > 0)
		return fault(r, "R rotates the work offset about Z, which a setup cannot have; program this rotation");
	good = name_offset(r, line, extended, &name) &&
	       take_values(r, line, name.length ? tool_library_work_offset(r->tools, strbuf_text(&name)) : NULL);

	strbuf_release(&name);
	return good;
}

/* --------------------------------------------------------------- lines */

static void set_unit(struct reading *r, double unit)
{
	r->unit = unit;
	r->unit_is_given = true;
}

static bool take_g(struct reading *r, struct line *line, double code)
{
	if (code > 9.5 && code < 10.5)
		line->writes = true;
	else if (code > 19.5 && code < 20.5)
		set_unit(r, MM_PER_INCH);
	else if (code > 20.5 && code < 21.5)
		set_unit(r, 1);
	else if (!(code > 89.5 && code < 90.5))
		return fault(r, "a listing of offsets can have only the codes G10, G20, G21 and G90");
	return true;
}

/*
 * Letters that are permitted besides those of an offset: the number of the line or program, and the end of the program.
 */
static bool is_frame(char letter)
{
	return letter == 'N' || letter == 'O' || letter == 'M';
}

static bool take_words(struct reading *r, const struct text_lines *lines, struct line *line)
{
	const char *at = lines->line, *end = lines->line + lines->length;
	struct letter_word word;
	int found;

	for (int i = 0; i < 26; i++)
		line->value[i] = NAN;
	while ((found = letter_word_next(&at, end, &word)) > 0) {
		int i = word.letter - 'A';

		if (word.letter == 'G' && !take_g(r, line, word.value))
			return false;
		if (word.letter == 'G')
			continue;
		if (!isnan(line->value[i]))
			return fault(r, "a letter occurs twice in the line");
		if (!is_frame(word.letter) && !strchr("LPRXYZABCUVW", word.letter))
			return fault(r, "a listing of offsets can have only the words L, P, R and axis words");
		line->value[i] = word.value;
		line->has_point[i] = word.has_point;
	}
	return found == 0 || *at == '%' || *at == ':' || fault(r, "this is not a line of a listing of offsets");
}

/* Does the line contain only its number, the program's number, or the end of the program? */
static bool is_empty(const struct line *line)
{
	double end = given(line, 'M');

	for (int i = 0; i < 26; i++)
		if (is_given(line, (char)('A' + i)) && !is_frame((char)('A' + i)))
			return false;
	return isnan(end) || whole(line, 'M', 2, 2) > 0 || whole(line, 'M', 30, 30) > 0 || whole(line, 'M', 99, 99) > 0;
}

static bool read_line(struct reading *r, const struct text_lines *lines)
{
	struct line line = {.writes = false};
	long mode;

	if (!take_words(r, lines, &line))
		return false;
	if (!line.writes)
		return is_empty(&line) || fault(r, "G10 is missing in this line");
	r->tools->unit_is_assumed |= !r->unit_is_given;
	mode = whole(&line, 'L', 1, 20);
	if (mode == 2 || mode == 20)
		return take_work_offset(r, &line, mode == 20);
	if (mode == 1)
		return take_register(r, &line, 1);
	if (mode >= 10 && mode <= 13)
		return take_register(r, &line, (int)mode - 10);
	return fault(r, "only G10 with L1, L2, L10, L11, L12, L13 and L20 writes offsets");
}

bool offset_listing_read(struct tool_library *tools, const char *text, const char *path, double unit,
			 struct diag *diag)
{
	struct reading r = {.tools = tools, .diag = diag, .unit = unit, .at = {.file = path}};
	struct text_lines lines = {.next = text};
	bool good = true;

	while (good && text_lines_next(&lines)) {
		r.at.line = lines.number;
		good = read_line(&r, &lines);
	}
	good = good && add_rows(&r);
	free(r.rows);
	return good;
}
