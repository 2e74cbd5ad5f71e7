#include "gcode/dialect/sinumerik/block/sinumerik_block.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "base/ascii.h"
#include "gcode/dialect/sinumerik/block/sinumerik_coupling.h"
#include "gcode/dialect/sinumerik/block/sinumerik_spindle.h"
#include "gcode/dialect/sinumerik/block/sinumerik_traori.h"
#include "gcode/dialect/sinumerik/builder/sinumerik_builder.h"
#include "gcode/dialect/sinumerik/values/sinumerik_assign.h"
#include "gcode/dialect/sinumerik/values/sinumerik_expr.h"
#include "gcode/dialect/sinumerik/words/sinumerik_name.h"
#include "gcode/eval/expr.h"
#include "gcode/text/number.h"

/* The data that a read_... function works on. */
struct reading {
	struct interp *interp;
	struct lexer *lexer;
	struct sinumerik_block *block;
};

void sinumerik_block_clear(struct sinumerik_block *block)
{
	memset(block, 0, offsetof(struct sinumerik_block, value));
	for (int group = 0; group < SINUMERIK_GROUPS; group++)
		block->code[group] = CODE_NONE;
}

static bool set_code(struct reading *r, int group, int code, int column)
{
	struct sinumerik_block *block = r->block;

	if (block->code[group] != CODE_NONE)
		return fault(r->lexer->at, column,
			     "this and the word at column %d are of one group; a block can have only one of them",
			     block->code_column[group]);
	block->code[group] = code;
	block->code_column[group] = column;
	return true;
}

/* ---------------------------------------------------------------- numbers */

/* Is "=" next, and not "=="? */
static bool assigns(struct lexer *lexer)
{
	return lexer_peek(lexer) == '=' && lexer->at->text[lexer->position + 1] != '=';
}

/* ------------------------------------------------------------------ words */

static bool add_letter(struct reading *r, char letter, int column, double value, unsigned char way)
{
	struct sinumerik_block *block = r->block;
	const int index = letter - 'A', slot = slot_of_letter(letter);

	if (slot < 0 && way != SINUMERIK_WAY_MODAL && !sinumerik_way_fits_letter(r->lexer->at, column, letter, way))
		return false;
	if (slot >= 0 && !r->interp->config->has_axis[slot])
		return fault(r->lexer->at, column, "the machine has no %c axis", letter);
	if (sinumerik_block_has(block, letter))
		return fault(r->lexer->at, column, "the word %c stands twice in the block, at columns %d and %d",
			     letter, block->column[index], column);
	if (!block->axis_column && (letter_bit(letter) & (AXIS_BITS | SINUMERIK_CENTRE_BITS)))
		block->axis_column = column;
	block->letters |= letter_bit(letter);
	block->value[index] = value;
	block->way[index] = way;
	block->column[index] = column;
	return true;
}

/* Codes of the ISO mode. The language of Siemens does not have them. */
static bool is_iso(double value)
{
	static const double codes[] = {20, 21, 27, 28, 30, 43, 44, 49, 50, 51, 52, 65, 66, 67, 68, 69,
				       73, 76, 80, 81, 82, 83, 84, 85, 86, 87, 88, 89, 92, 98, 99};

	for (size_t i = 0; i < sizeof(codes) / sizeof(codes[0]); i++) {
		if (!(value < codes[i] || value > codes[i]))
			return true;
	}
	return false;
}

static bool read_g(struct reading *r, double value, int column)
{
	const double tenths = value * 10;
	const struct code *code;

	if (!(value >= 0 && value <= 999) || floor(value) < value)
		return fault(r->lexer->at, column, "G%g is no G-code", value);
	if (value >= 505 && value <= 599)
		return set_code(r, SINUMERIK_SYSTEM, (int)tenths, column);
	code = block_find_g(&r->interp->block, r->interp->config->dialect, (int)tenths);
	if (!code && is_iso(value))
		return fault(
		    r->lexer->at, column,
		    "G%g is not known; it is a code of ISO mode (G291), the language of Fanuc, which is not read here",
		    value);
	if (!code)
		return fault(r->lexer->at, column, "G%g is not known", value);
	if (code->state == CODE_REFUSED)
		return fault(r->lexer->at, column, "G%g: %s is not supported", value, code->what);
	return code->group == GROUP_NONE || set_code(r, code->group, code->number, column);
}

static bool read_m(struct reading *r, double value, int column)
{
	struct sinumerik_block *block = r->block;

	if (!(value >= 0 && value <= 99999999) || floor(value) < value)
		return fault(r->lexer->at, column, "M%g is no M-code", value);
	if (block->m_count == SINUMERIK_M_MAX)
		return fault(r->lexer->at, column, "a block can have at most %d M-codes", SINUMERIK_M_MAX);
	block->m[block->m_count] = (int)value;
	block->m_column[block->m_count++] = column;
	return true;
}

static bool set_call(struct reading *r, const char *name, int column)
{
	struct sinumerik_block *block = r->block;

	if (block->call[0])
		return fault(r->lexer->at, column, "a second call in the block");
	strcpy(block->call, name);
	block->call_column = column;
	block->call_has_arguments = lexer_peek(r->lexer) == '(';
	return true;
}

/* L100: the name of a subprogram. Leading zeros belong to it. */
static bool read_l(struct reading *r, size_t start, size_t end, int column)
{
	char name[SINUMERIK_NAME + 1] = "L";
	size_t length = end - start;

	while (length > 0 && !ascii_is_digit(r->lexer->at->text[start + length - 1]))
		length--;
	if (length == 0 || length > 8 || strspn(r->lexer->at->text + start, "0123456789") < length)
		return fault(r->lexer->at, column, "L needs the number of a subprogram");
	memcpy(name + 1, r->lexer->at->text + start, length);
	name[length + 1] = '\0';
	return set_call(r, name, column);
}

static bool take_word(struct reading *r, char letter, int column, double value, unsigned char way)
{
	switch (letter) {
	case 'G':
		return read_g(r, value, column);
	case 'M':
		return read_m(r, value, column);
	case 'N':
		return fault(r->lexer->at, column, "N is allowed only at the start of a block");
	case 'A': case 'B': case 'C': case 'D': case 'F': case 'I': case 'J': case 'K': case 'P': case 'S':
	case 'T': case 'U': case 'V': case 'W': case 'X': case 'Y': case 'Z':
		return add_letter(r, letter, column, value, way);
	case 'H':
		return sinumerik_builder_take_auxiliary(r->interp, value, column);
	default:
		return fault(r->lexer->at, column, "%c is neither an axis of the machine nor an address", letter);
	}
}

/* A number of an unusual form. If there is none, the position does not change. */
static bool read_spaced(struct reading *r, char letter, int column, size_t *position, double *value)
{
	const struct line_place *at = r->lexer->at;
	const size_t start = *position;
	bool point;

	if (number_read(at->text, position, value, &point) == NUMBER_TOO_LONG)
		return fault(at, column, "%c has a number of more than %d digits", letter, NUMBER_LENGTH_MAX);
	if (number_has_blank(at->text, start, *position))
		return fault(at, column, "a blank inside the number of %c; what a control makes of it differs", letter);
	return true;
}

/* X10.5, G1, M3: a letter and a plain number. A whole number followed by '=' is a part of a name: R1=, A3=. */
static bool read_plain(struct reading *r, char letter, int column, bool *done)
{
	struct lexer *lexer = r->lexer;
	const char *text = lexer->at->text;
	const size_t start = lexer->position + 1;
	size_t position = start;
	double value;
	bool point;
	const char *end = number_read_usual(text + start, &value, &point);

	*done = false;
	if (end)
		position = (size_t)(end - text);
	else if (!read_spaced(r, letter, column, &position, &value))
		return false;
	if (position == start || text[position] == '=' || (text[position] == '[' && letter == 'R') || letter == 'R')
		return true;
	*done = true;
	lexer->position = position;
	if (letter == 'L')
		return read_l(r, start, position, column);
	if (letter == 'E' ||
	    ((text[position] == 'E' || text[position] == 'e') && ascii_upper(text[position + 1]) == 'X'))
		return fault(lexer->at, column, letter == 'E' ? "E is neither an axis of the machine nor an address"
							       : "a number with an exponent (EX) needs '=' before it");
	return take_word(r, letter, column, value, SINUMERIK_WAY_MODAL);
}

/* T="NAME", T=TEXTVARIABLE */
static bool read_tool_name(struct reading *r, int column)
{
	r->block->names_tool = true;
	return sinumerik_expr_text(r->interp, r->lexer, &r->block->tool_name) && add_letter(r, 'T', column, 0, 0);
}

/* Addresses that are coordinates, like X, Y and Z: those of the intermediate point of CIP, and polar ones. */
static bool is_place(int address)
{
	return (address >= SINUMERIK_I1 && address <= SINUMERIK_K1) || address == SINUMERIK_AP ||
	       address == SINUMERIK_RP || address == SINUMERIK_DISCL || address == SINUMERIK_DISRP;
}

/* X=..., M2=3, S1=500, A3=..., CR=... */
static bool read_assigned(struct reading *r, const char *name, int column, bool *done)
{
	const size_t digits = strspn(name + 1, "0123456789");
	struct sinumerik_word word;
	double value = 0;
	unsigned char way = 0;

	*done = true;
	if (name[1] == '\0' && name[0] != 'R') {
		lexer_take(r->lexer);
		if (name[0] == 'T' && sinumerik_expr_is_text(r->interp, r->lexer))
			return read_tool_name(r, column);
		return sinumerik_way_read(r->interp, r->lexer, &value, &way) &&
		       take_word(r, name[0], column, value, way);
	}
	if (sinumerik_codes_word(name, &word) && word.kind == SINUMERIK_WORD_ADDRESS) {
		lexer_take(r->lexer);
		if (r->block->addresses & 1U << word.code)
			return fault(r->lexer->at, column, "%s stands twice in the block", name);
		if (!sinumerik_way_read(r->interp, r->lexer, &value, &way) ||
		    !sinumerik_way_fits(r->lexer->at, column, name, way, is_place(word.code)))
			return false;
		r->block->addresses |= 1U << word.code;
		r->block->address_value[word.code] = value;
		r->block->address_way[word.code] = way;
		r->block->address_column[word.code] = column;
		return true;
	}
	if (digits > 0 && name[1 + digits] == '\0' && strchr("MSTH", name[0])) {
		lexer_take(r->lexer);
		if (name[0] != 'H' && !sinumerik_spindle_check(r->interp, name, column))
			return false;
		if (name[0] == 'T' && sinumerik_expr_is_text(r->interp, r->lexer))
			return read_tool_name(r, column);
		return sinumerik_way_read(r->interp, r->lexer, &value, &way) &&
		       take_word(r, name[0], column, value, way);
	}
	if (name[1] == '1' && name[2] == '\0' && slot_of_letter(name[0]) >= 0) {
		lexer_take(r->lexer);
		r->block->machine_axes = true;
		return sinumerik_way_read(r->interp, r->lexer, &value, &way) &&
		       add_letter(r, name[0], column, value, way);
	}
	*done = false;
	return true;
}

static bool step_over_value(struct reading *r, const char *name, double *value)
{
	unsigned char way;

	if (sinumerik_name_take_byte(r->lexer, '[')) {
		const char *close = strchr(r->lexer->at->text + r->lexer->position, ']');

		if (!close)
			return fault(r->lexer->at, lexer_next_column(r->lexer), "']' is needed here");
		r->lexer->position = (size_t)(close - r->lexer->at->text) + 1;
	}
	return sinumerik_name_need(r->lexer, '=', name) && sinumerik_way_read(r->interp, r->lexer, value, &way);
}

static bool read_zero(struct reading *r, const char *name, const struct sinumerik_word *word, int column)
{
	double value;

	if (!step_over_value(r, name, &value))
		return false;
	return !(fabs(value) > 0) || fault(r->lexer->at, column, "%s: %s is not supported, only %s=0", name,
					   word->what, name);
}

static bool read_position(struct reading *r, int column)
{
	int slot = 0;
	double value;
	unsigned char way;

	r->block->positions_column = column;
	if (!sinumerik_name_need(r->lexer, '[', "POS") || !sinumerik_expr_axis(r->interp, r->lexer, &slot) ||
	    !sinumerik_name_need(r->lexer, ']', "the axis") || !sinumerik_name_need(r->lexer, '=', "POS") ||
	    !sinumerik_way_read(r->interp, r->lexer, &value, &way))
		return false;
	r->block->positions |= letter_bit(AXIS_LETTERS[slot]);
	return add_letter(r, AXIS_LETTERS[slot], column, value, way);
}

static bool read_known(struct reading *r, const char *name, const struct sinumerik_word *word, int column)
{
	double value;

	switch (word->kind) {
	case SINUMERIK_WORD_CODE:
		if (word->code == SINUMERIK_TRAORI && !sinumerik_traori_read(r->interp, r->lexer))
			return false;
		return set_code(r, (int)word->group, word->code, column);
	case SINUMERIK_WORD_IGNORED:
		return true;
	case SINUMERIK_WORD_IGNORED_CALL:
		return sinumerik_name_step_over_call(r->lexer);
	case SINUMERIK_WORD_IGNORED_VALUE:
		return step_over_value(r, name, &value);
	case SINUMERIK_WORD_ZERO:
		return read_zero(r, name, word, column);
	case SINUMERIK_WORD_IGNORED_LINE:
		r->lexer->position += strlen(r->lexer->at->text + r->lexer->position);
		return true;
	case SINUMERIK_WORD_STOPS_READING:
		r->block->stops_reading = true;
		return true;
	case SINUMERIK_WORD_POSITION:
		return read_position(r, column);
	case SINUMERIK_WORD_SPINDLE_STANDS:
		r->block->spindle_stands = true;
		return step_over_value(r, name, &value);
	case SINUMERIK_WORD_COUPLING:
		return sinumerik_coupling_read(r->interp, r->lexer, column);
	case SINUMERIK_WORD_MASTER:
		return sinumerik_spindle_take_master(r->interp, r->lexer);
	case SINUMERIK_WORD_MODAL:
		r->block->modal = true;
		r->block->modal_column = column;
		return true;
	case SINUMERIK_WORD_ADDRESS:
		return fault(r->lexer->at, column, "%s needs '=' and a value", name);
	case SINUMERIK_WORD_STATEMENT:
		return fault(r->lexer->at, column, "%s stands at the start of its block", name);
	default:
		return fault(r->lexer->at, column, "%s: %s is not supported", name, word->what);
	}
}

/*
 * G[8]=2: the second code of group 8. 840D sl, "Fundamentals", list of G functions: the groups whose numbers have no
 * gaps.
 */
static bool read_group(struct reading *r, int column)
{
	static const struct {
		int group, first, count, code;	/* the numbers from `first` on are the codes from `code` on */
	} rows[] = {{1, 1, 4, 0},   {6, 1, 3, 17},   {7, 1, 3, 40},   {8, 1, 1, 500},  {8, 2, 4, 54},
		    {8, 6, 95, 505}, {13, 1, 2, 70}, {13, 3, 1, 700}, {13, 4, 1, 710}, {14, 1, 2, 90}};
	int group, number;

	if (!sinumerik_name_need(r->lexer, '[', "G") ||
	    !sinumerik_expr_whole(r->interp, r->lexer, "the number of a group of G-codes", 1, 64, &group) ||
	    !sinumerik_name_need(r->lexer, ']', "the group") || !sinumerik_name_need(r->lexer, '=', "G[]") ||
	    !sinumerik_expr_whole(r->interp, r->lexer, "the number of a G-code in its group", 1, 100, &number))
		return false;
	for (size_t i = 0; i < sizeof(rows) / sizeof(rows[0]); i++) {
		if (rows[i].group == group && number >= rows[i].first && number < rows[i].first + rows[i].count)
			return read_g(r, rows[i].code + number - rows[i].first, column);
	}
	return fault(r->lexer->at, column, "G[%d]=%d is not supported: of the groups 1, 6, 7, 8, 13 and 14 only "
					   "the usual codes",
		     group, number);
}

static bool read_named(struct reading *r)
{
	const int column = lexer_column(r->lexer);
	char name[SINUMERIK_NAME + 1];
	struct sinumerik_word word;
	bool done = false;

	if (!sinumerik_name_read(r->lexer, name))
		return fault(r->lexer->at, column, "a name of more than %d bytes", SINUMERIK_NAME);
	if (name[0] == 'G' && name[1] == '\0' && lexer_peek(r->lexer) == '[')
		return read_group(r, column);
	if (assigns(r->lexer) && sinumerik_assign_is_own(r->interp, name))
		return sinumerik_assign(r->interp, r->lexer, name, column);
	if (assigns(r->lexer) && !read_assigned(r, name, column, &done))
		return false;
	if (done)
		return true;
	if (sinumerik_codes_word(name, &word))
		return read_known(r, name, &word, column);
	if (assigns(r->lexer) || lexer_peek(r->lexer) == '[')
		return sinumerik_assign(r->interp, r->lexer, name, column);
	if (name[1] == '\0' && name[0] == 'F' && lexer_peek(r->lexer) == '(')
		return fault(r->lexer->at, column, "F needs '=' before an expression");
	if (name[0] == 'R' && ascii_is_digit(name[1]))
		return fault(r->lexer->at, column, "%s needs '=' and a value; the radius of a circle is CR=", name);
	if (name[1] == '\0' || !sinumerik_starts_name(name[1]))
		return fault(r->lexer->at, column, "%c without a number", name[0]);
	return set_call(r, name, column);
}

bool sinumerik_block_read(struct interp *interp, struct lexer *lexer, struct sinumerik_block *block)
{
	struct reading reading = {interp, lexer, block};

	for (;;) {
		const char byte = ascii_upper(lexer_peek(lexer));
		const int column = lexer_column(lexer);
		bool done = false;

		if (byte == '\0' || byte == ';')
			return true;
		block->any = true;
		if (block->call[0] && block->call_has_arguments)
			return true;
		if (byte >= 'A' && byte <= 'Z' && !sinumerik_starts_name(lexer->at->text[lexer->position + 1])) {
			if (!read_plain(&reading, byte, column, &done))
				return false;
			if (done)
				continue;
		}
		if (sinumerik_starts_name(byte) || byte == '$') {
			if (!read_named(&reading))
				return false;
			continue;
		}
		if (byte == '/')
			return fault(lexer->at, column, "'/' is allowed only at the start of a block");
		if (byte > ' ' && byte <= '~')
			return fault(lexer->at, column, "unexpected '%c'", byte);
		return fault(lexer->at, column, "unexpected byte 0x%02X", (unsigned)(unsigned char)byte);
	}
}
