#include "machine/library/toa_file.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/ascii.h"
#include "base/decimal.h"
#include "base/mem.h"
#include "base/units.h"
#include "machine/library/text_lines.h"

enum { WORD_MAX = 40, NAME_BYTES_MAX = 80, INDEX_MAX = 3 };

/* T is at most 32000, D too. */
#define INDEX_LARGEST 99999999.0

struct reading {
	struct toa_file *file;
	struct arena *arena;
	struct diag *diag;
	struct srcloc at;
	const char *next, *end;	/* of the line */
};

/* $NAME[index,index]=value */
struct assignment {
	char name[WORD_MAX];	/* without the $ */
	long index[INDEX_MAX];
	size_t count;
	double value;
	char text[NAME_BYTES_MAX];	/* of a string */
	bool is_text;
};

static bool fault(const struct reading *r, const char *what)
{
	diag_error(r->diag, r->at, "%s", what);
	return false;
}

/* ------------------------------------------------------------------- lexis */

static void skip_blanks(struct reading *r)
{
	while (r->next < r->end && ascii_is_space(*r->next))
		r->next++;
}

static bool take_byte(struct reading *r, char wanted)
{
	skip_blanks(r);
	if (r->next == r->end || *r->next != wanted)
		return false;
	r->next++;
	return true;
}

/* Letters, digits and underscores; the length is 0 if there are none, or too many. */
static size_t read_word(struct reading *r, char word[WORD_MAX])
{
	size_t length = 0;

	while (r->next < r->end && (ascii_is_alphanumeric(*r->next) || *r->next == '_')) {
		if (length == WORD_MAX - 1)
			return 0;
		word[length++] = ascii_upper(*r->next++);
	}
	word[length] = '\0';
	return length;
}

static bool read_number(struct reading *r, double *value)
{
	char text[WORD_MAX];
	size_t length = 0;

	skip_blanks(r);
	while (r->next < r->end && length < sizeof(text) - 1 &&
	       (ascii_is_digit(*r->next) || strchr("+-.", *r->next) ||
		(length && (*r->next == 'E' || *r->next == 'e'))))
		text[length++] = *r->next++;
	text[length] = '\0';
	/* The control writes 'H1F' for a number in another base: no length is written like this. */
	return length && decimal_read(text, length, value) && isfinite(*value);
}

static bool read_string(struct reading *r, char text[NAME_BYTES_MAX])
{
	size_t length = 0;

	for (; r->next < r->end && *r->next != '"'; r->next++) {
		if (length == NAME_BYTES_MAX - 1)
			return false;
		text[length++] = *r->next;
	}
	text[length] = '\0';
	return take_byte(r, '"');
}

static bool read_index(struct reading *r, struct assignment *out)
{
	double value;

	if (out->count == INDEX_MAX || !read_number(r, &value) || !(value >= 0 && value <= INDEX_LARGEST) ||
	    floor(value) < value)
		return false;
	out->index[out->count++] = (long)value;
	return true;
}

/* Does the name begin with this, and go on with a digit? */
static bool is_numbered(const char *name, const char *prefix)
{
	const size_t length = strlen(prefix);

	return !strncmp(name, prefix, length) && ascii_is_digit(name[length]);
}

/* The n of $TC_DPn; 0: another name. */
static long parameter_of(const char *name)
{
	return is_numbered(name, "TC_DP") ? strtol(name + strlen("TC_DP"), NULL, 10) : 0;
}

/* The type; the lengths 1 to 3, the radius, the corner radius, and the wear of each; and the adapter's lengths. */
static bool is_needed(long parameter)
{
	return parameter == 1 || (parameter >= 3 && parameter <= 7) || (parameter >= 12 && parameter <= 16) ||
	       (parameter >= 21 && parameter <= 23);
}

/* Corrections that must be 0. */
static bool is_correction(const char *name)
{
	return is_numbered(name, "TC_SCP") || is_numbered(name, "TC_ECP") || is_numbered(name, "TC_ADPT") ||
	       is_numbered(name, "TC_DPV") || !strcmp(name, "TC_DPV");
}

static bool matters(const char *name)
{
	return is_needed(parameter_of(name)) || !strcmp(name, "TC_TP2") || is_correction(name);
}

/* Nothing follows a value but another assignment: "120,25" and "10*2" are no values. */
static bool is_complete(struct reading *r)
{
	skip_blanks(r);
	return r->next == r->end || *r->next == '$';
}

/* Reads what follows the name of a variable that matters. */
static bool read_assignment(struct reading *r, struct assignment *out)
{
	bool good = take_byte(r, '[');

	do
		good = good && read_index(r, out);
	while (good && take_byte(r, ','));
	if (!good || !take_byte(r, ']') || !take_byte(r, '=')) {
		diag_error(r->diag, r->at,
			   "$%s must be followed by its numbers and its value, as in $TC_DP3[5,1]=120.25: take the "
			   "file as the control archives it",
			   out->name);
		return false;
	}
	out->is_text = take_byte(r, '"');
	if ((out->is_text ? read_string(r, out->text) : read_number(r, &out->value)) && is_complete(r))
		return true;
	diag_error(r->diag, r->at,
		   "the value of $%s must be a number with a decimal point, or a text of at most %d bytes", out->name,
		   NAME_BYTES_MAX - 1);
	return false;
}

/* -------------------------------------------------------------------- data */

/* Is there space for another one? False: reported. */
static bool has_space(const struct reading *r, size_t count)
{
	if (count < TOA_MOST)
		return true;
	diag_error(r->diag, r->at, "the file has more than %d tools or edges, more than any control archives",
		   TOA_MOST);
	return false;
}

/* NULL: reported. */
static struct toa_edge *edge_of(struct reading *r, long tool, long number)
{
	struct toa_file *file = r->file;

	/* Archives have all values of an edge together: the last one is the usual answer. */
	for (size_t i = file->edge_count; i > 0; i--)
		if (file->edges[i - 1].tool == tool && file->edges[i - 1].number == number)
			return &file->edges[i - 1];
	if (!has_space(r, file->edge_count))
		return NULL;
	file->edges = mem_grow(file->edges, &file->edge_capacity, file->edge_count + 1, sizeof(*file->edges));
	file->edges[file->edge_count] = (struct toa_edge){.tool = tool, .number = number, .line = r->at.line};
	return &file->edges[file->edge_count++];
}

/* NULL: reported. */
static struct toa_tool *tool_of(struct reading *r, long number)
{
	struct toa_file *file = r->file;

	for (size_t i = file->tool_count; i > 0; i--)
		if (file->tools[i - 1].number == number)
			return &file->tools[i - 1];
	if (!has_space(r, file->tool_count))
		return NULL;
	file->tools = mem_grow(file->tools, &file->tool_capacity, file->tool_count + 1, sizeof(*file->tools));
	file->tools[file->tool_count] = (struct toa_tool){.number = number, .line = r->at.line};
	return &file->tools[file->tool_count++];
}

const struct toa_tool *toa_file_tool(const struct toa_file *file, long number)
{
	for (size_t i = 0; i < file->tool_count; i++)
		if (file->tools[i].number == number)
			return &file->tools[i];
	return NULL;
}

/* $TC_DPn[t,d] */
static bool set_edge(struct reading *r, const struct assignment *a)
{
	const long parameter = parameter_of(a->name);
	struct toa_edge *edge;

	if (a->count != 2 || a->is_text)
		return fault(r, "$TC_DP needs a tool, an edge and a number, as in $TC_DP3[5,1]=120.25");
	edge = edge_of(r, a->index[0], a->index[1]);
	if (!edge)
		return false;
	if (edge->lines[parameter]) {
		diag_error(r->diag, r->at, "$TC_DP%ld[%ld,%ld] is given twice (also in line %ld)", parameter,
			   edge->tool, edge->number, edge->lines[parameter]);
		return false;
	}
	edge->value[parameter] = a->value;
	edge->lines[parameter] = r->at.line;
	return true;
}

/* $TC_TP2[t] */
static bool set_tool(struct reading *r, const struct assignment *a)
{
	struct toa_tool *tool;

	if (a->count != 1 || !a->is_text)
		return fault(r, "$TC_TP2 needs a tool and a name, as in $TC_TP2[5]=\"MILL\"");
	tool = tool_of(r, a->index[0]);
	if (!tool)
		return false;
	if (tool->name) {
		diag_error(r->diag, r->at, "$TC_TP2[%ld] is given twice (also in line %ld)", tool->number, tool->line);
		return false;
	}
	tool->name = arena_strdup(r->arena, a->text);
	return true;
}

static bool set_parameter(struct reading *r, const struct assignment *a)
{
	if (is_needed(parameter_of(a->name)))
		return set_edge(r, a);
	if (!is_correction(a->name))
		return set_tool(r, a);
	if (a->is_text || !(fabs(a->value) > 0))
		return true;
	diag_error(r->diag, r->at,
		   "$%s is not 0: sum offsets, setup offsets, adapters and orientations of tools change the length in "
		   "a way that a setup cannot have; remove the tool from the file",
		   a->name);
	return false;
}

/* ------------------------------------------------------------------- lines */

/* Moves to the next $ outside of strings, or to the end of the line. */
static void skip_to_variable(struct reading *r)
{
	bool quoted = false;

	for (; r->next < r->end && (quoted || *r->next != '$'); r->next++)
		quoted ^= *r->next == '"';
}

/* The end of a line without its comment. */
static const char *end_of(const struct text_lines *lines)
{
	const char *end = lines->line + lines->length;
	bool quoted = false;

	for (const char *at = lines->line; at < end; at++) {
		if (*at == ';' && !quoted)
			return at;
		quoted ^= *at == '"';
	}
	return end;
}

/* METRIC or INCH by itself. */
static bool read_unit(struct reading *r)
{
	const char *from = r->next;
	char word[WORD_MAX];
	double unit = 0;

	skip_blanks(r);
	if (read_word(r, word))
		unit = !strcmp(word, "METRIC") ? 1 : !strcmp(word, "INCH") ? MM_PER_INCH : 0;
	r->next = from;
	if (unit > 0 && r->file->unit > 0 && fabs(unit - r->file->unit) > 0)
		return fault(r, "the file has both METRIC and INCH");
	if (unit > 0)
		r->file->unit = unit;
	return true;
}

static bool read_line(struct reading *r)
{
	if (!read_unit(r))
		return false;
	for (skip_to_variable(r); r->next < r->end; skip_to_variable(r)) {
		struct assignment assignment = {.count = 0};

		r->next++;
		if (!read_word(r, assignment.name) || !matters(assignment.name))
			continue;
		if (!read_assignment(r, &assignment) || !set_parameter(r, &assignment))
			return false;
		/* 120.25 may have become 120, or 12. */
		if (!*r->end)
			return fault(r, "the file is cut off: the line of this value does not end");
	}
	return true;
}

bool toa_file_is(const char *text)
{
	static const char *const names[] = {"$TC_DP", "$TC_TP"};
	struct text_lines lines = {.next = text};

	while (text_lines_next(&lines)) {
		const char *at = lines.line, *end = end_of(&lines);

		/* The number of a block. */
		at += strspn(at, " \t");
		if (at < end && (*at == 'N' || *at == 'n')) {
			at++;
			at += strspn(at, "0123456789");
			at += strspn(at, " \t");
		}
		for (size_t i = 0; i < sizeof(names) / sizeof(*names); i++)
			if ((size_t)(end - at) > strlen(names[i]) && ascii_same_start(at, names[i], strlen(names[i])) &&
			    ascii_is_digit(at[strlen(names[i])]))
				return true;
	}
	return false;
}

bool toa_file_read(struct toa_file *file, struct arena *arena, const char *text, const char *path, struct diag *diag)
{
	struct reading r = {.file = file, .arena = arena, .diag = diag, .at = {.file = path}};
	struct text_lines lines = {.next = text};

	while (text_lines_next(&lines)) {
		r.at.line = lines.number;
		r.next = lines.line;
		r.end = end_of(&lines);
		if (!read_line(&r))
			return false;
	}
	return true;
}

void toa_file_release(struct toa_file *file)
{
	free(file->edges);
	free(file->tools);
	*file = (struct toa_file){0};
}
