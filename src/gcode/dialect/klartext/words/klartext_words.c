#include "gcode/dialect/klartext/words/klartext_words.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

#include "base/ascii.h"
#include "base/same_double.h"
#include "gcode/dialect/klartext/text/klartext_lexis.h"
#include "gcode/dialect/klartext/values/klartext_value.h"

const struct klartext_m *klartext_words_m(const struct klartext_words *words, int number)
{
	for (int i = 0; i < words->m_count; i++) {
		if (words->m[i].number == number)
			return &words->m[i];
	}
	return NULL;
}

static bool refuse_twice(struct lexer *lexer, int column, const char *what)
{
	return fault(lexer->at, column, "%s stands twice in the block", what);
}

static char next_byte(struct lexer *lexer)
{
	char byte = lexer_peek(lexer);

	return ascii_upper(byte);
}

static char byte_after(const struct lexer *lexer, size_t distance)
{
	const char *text = lexer->at->text + lexer->position;
	char byte = '\0';

	for (size_t i = 0; i <= distance; i++) {
		byte = text[i];
		if (byte == '\0')
			return byte;
	}
	return ascii_upper(byte);
}

/* With TCPM and AXIS SPAT, a spatial angle is modal. */
static bool read_spatial(struct lexer *lexer, struct klartext_words *words, int slot, bool increment, int column)
{
	struct klartext_tcpm *tcpm = &klartext_of(lexer->context)->tcpm;

	if (increment)
		return fault(lexer->at, column, "an increment of a spatial angle (AXIS SPAT) is not supported");
	if (words->spatial & 1U << slot)
		return fault(lexer->at, column, "%c stands twice in the block", AXIS_LETTERS[slot]);
	lexer_take(lexer);
	words->spatial |= 1U << slot;
	tcpm->given[slot - SLOT_A] = true;
	return klartext_value(lexer, &tcpm->angle[slot - SLOT_A]);
}

/* Reads X, IX and so on. The lexer is at the letter of the axis. */
static bool read_axis(struct lexer *lexer, struct klartext_words *words, int slot, bool increment, int column)
{
	struct interp *interp = lexer->context;
	double value;

	if (slot_is_rotary(slot) && klartext_of(interp)->tcpm.spatial)
		return read_spatial(lexer, words, slot, increment, column);
	if (!interp->config->has_axis[slot])
		return fault(lexer->at, column, "the machine has no %c axis", AXIS_LETTERS[slot]);
	if (words->axes & 1U << slot)
		return fault(lexer->at, column, "%c stands twice in the block", AXIS_LETTERS[slot]);
	lexer_take(lexer);
	if (!klartext_value(lexer, &value))
		return false;
	words->axes |= 1U << slot;
	words->increments |= increment ? 1U << slot : 0;
	words->value[slot] = slot_is_rotary(slot) ? value : value * interp->state.scale;
	words->column[slot] = column;
	return true;
}

/* Reads PR, PA, IPR or IPA. The lexer is at the P. */
static bool read_polar(struct lexer *lexer, struct klartext_words *words, bool increment, int column)
{
	struct interp *interp = lexer->context;
	bool radius = byte_after(lexer, 1) == 'R';
	double value;

	if (radius ? words->has_radius : words->has_angle)
		return refuse_twice(lexer, column, radius ? "PR" : "PA");
	lexer->position += 2;
	if (!klartext_value(lexer, &value))
		return false;
	if (radius) {
		words->has_radius = true;
		words->radius = value * interp->state.scale;
		words->radius_increment = increment;
		words->radius_column = column;
	} else {
		words->has_angle = true;
		words->angle = value;
		words->angle_increment = increment;
		words->angle_column = column;
	}
	return true;
}

void klartext_words_caution_teeth(struct lexer *lexer, int column)
{
	struct klartext_lines *lines = &klartext_of(lexer->context)->lines;

	if (!lines->cautioned_teeth)
		caution(lexer->at, column,
			"FZ counts as the feed of one tooth: how many the tool has is not known here, and times are "
			"longer than they are");
	lines->cautioned_teeth = true;
}

/* Reads FZ (feed per tooth). The setup does not give the number of teeth; only times depend on it. */
static bool read_tooth_feed(struct lexer *lexer, struct klartext_words *words, int column)
{
	lexer_take(lexer);
	if (words->feed != KLARTEXT_FEED_NONE)
		return refuse_twice(lexer, column, "F");
	klartext_words_caution_teeth(lexer, column);
	words->feed = KLARTEXT_FEED_VALUE;
	words->feed_column = column;
	words->feed_per_revolution = true;
	return klartext_value(lexer, &words->feed_bare);
}

/* Reads F500, F MAX, FMAX, F AUTO or F alone. An F after an M-function with its own feed belongs to the function. */
static bool read_feed(struct lexer *lexer, struct klartext_words *words, int column)
{
	struct interp *interp = lexer->context;
	const struct klartext_m *m = words->m_count ? &words->m[words->m_count - 1] : NULL;
	bool belongs = m && (m->number == 128 || m->number == 140 || m->number == 103);
	enum klartext_feed feed = KLARTEXT_FEED_VALUE;
	double value = 0;
	bool per_revolution = false;

	lexer_take(lexer);
	if (klartext_take(lexer, "MAX")) {
		feed = KLARTEXT_FEED_MAX;
	} else if (klartext_take(lexer, "AUTO")) {
		feed = KLARTEXT_FEED_AUTO;
	} else if (next_byte(lexer) == 'Z') {
		return read_tooth_feed(lexer, words, column);
	} else if (next_byte(lexer) == 'U') {
		lexer_take(lexer);
		per_revolution = true;
		if (!klartext_value(lexer, &value))
			return false;
	} else if (next_byte(lexer) == 'T') {
		return fault(lexer->at, column, "FT: the time that a block takes is not supported; write F");
	} else if (!klartext_value_follows(lexer)) {
		/* The operator gave no feed in the editor: the feed in force stays. */
		return true;
	} else if (!klartext_value(lexer, &value)) {
		return false;
	} else if (value < 0) {
		return fault(lexer->at, column, "a feed rate cannot be negative");
	}
	if (belongs)
		return true;
	if (words->feed != KLARTEXT_FEED_NONE)
		return refuse_twice(lexer, column, "F");
	words->feed = feed;
	words->feed_column = column;
	words->feed_bare = value;
	words->feed_per_revolution = per_revolution;
	/* iTNC 530 user's manual, "Feed rate F": mm/min, or tenths of an inch a minute. Only times depend on it. */
	words->feed_value = interp->state.scale > 1 ? value * interp->state.scale / 10 : value;
	return true;
}

static bool read_speed(struct lexer *lexer, struct klartext_words *words, int column)
{
	lexer_take(lexer);
	if (words->has_speed)
		return refuse_twice(lexer, column, "S");
	if (!klartext_value(lexer, &words->speed))
		return false;
	if (words->speed < 0)
		return fault(lexer->at, column, "a spindle speed cannot be negative");
	words->has_speed = true;
	return true;
}

/* Reads R0, RL, RR, R alone, or R with a number. */
static bool read_r(struct lexer *lexer, struct klartext_words *words, int column)
{
	struct interp *interp = lexer->context;
	char byte = byte_after(lexer, 1), behind = byte == '\0' ? '\0' : byte_after(lexer, 2);
	enum klartext_comp comp = byte == 'L' ? KLARTEXT_RL : byte == 'R' ? KLARTEXT_RR : KLARTEXT_R_NONE;

	if (byte == '0' && (behind == '\0' || strchr(" \t;", behind)))
		comp = KLARTEXT_R0;
	if (comp != KLARTEXT_R_NONE) {
		if (words->comp != KLARTEXT_R_NONE)
			return refuse_twice(lexer, column, "the radius compensation");
		words->comp = comp;
		words->comp_column = column;
		lexer->position += 2;
		return true;
	}
	lexer_take(lexer);
	/* Older controls write R alone for the compensation in force. */
	if (byte == ' ' || byte == '\t' || byte == '\0' || byte == ';')
		return true;
	if ((byte == '+' || byte == '-') && (behind == ' ' || behind == '\0'))
		return fault(lexer->at, column, "R%c: the radius compensation of a single axis is not supported",
			     byte);
	if (words->has_size)
		return refuse_twice(lexer, column, "R");
	if (!klartext_value(lexer, &words->size))
		return false;
	words->size *= interp->state.scale;
	words->has_size = true;
	words->size_column = column;
	return true;
}

/* Reads MB50 or MB MAX, which follows M140. */
static bool read_way(struct lexer *lexer, struct klartext_words *words, int column)
{
	struct interp *interp = lexer->context;
	struct klartext_m *m = words->m_count ? &words->m[words->m_count - 1] : NULL;

	if (!m || m->number != 140)
		return fault(lexer->at, column, "MB belongs to M140");
	if (m->has_way)
		return refuse_twice(lexer, column, "MB");
	lexer->position += 2;
	m->has_way = true;
	if (klartext_take(lexer, "MAX")) {
		m->to_limit = true;
		return true;
	}
	if (!klartext_value(lexer, &m->way))
		return false;
	m->way *= interp->state.scale;
	return true;
}

/* M-functions of which one ends the other: in one block it is not known which one comes last. */
static bool check_opposite(struct lexer *lexer, const struct klartext_words *words, int number, int column)
{
	static const short groups[][5] = {{3, 4, 5, 13, 14}, {126, 127}, {128, 129}, {136, 137}};

	for (size_t i = 0; i < sizeof(groups) / sizeof(groups[0]); i++) {
		bool belongs = false;
		int other = 0;

		for (int k = 0; k < 5 && groups[i][k]; k++) {
			belongs |= groups[i][k] == number;
			if (klartext_words_m(words, groups[i][k]))
				other = groups[i][k];
		}
		if (belongs && other)
			return fault(lexer->at, column, "M%d and M%d in one block", other, number);
	}
	return true;
}

static bool read_m(struct lexer *lexer, struct klartext_words *words, int column)
{
	int number;

	if (byte_after(lexer, 1) == 'B')
		return read_way(lexer, words, column);
	lexer_take(lexer);
	/* The operator gave no number in the editor. */
	if (!klartext_value_follows(lexer))
		return true;
	if (!klartext_integer(lexer, "an M-function", 0, 9999, &number))
		return false;
	if (words->m_count == KLARTEXT_M_MAX)
		return fault(lexer->at, column, "a block can have at most %d M-functions", KLARTEXT_M_MAX);
	if (klartext_words_m(words, number))
		return fault(lexer->at, column, "M%d stands twice in the block", number);
	if (!check_opposite(lexer, words, number, column))
		return false;
	words->m[words->m_count++] = (struct klartext_m){.number = number, .column = column};
	/* The axis letters after M138 and M94 belong to the function. */
	while (words->m_count && (number == 138 || number == 94) && strchr("ABCUVW", next_byte(lexer)) &&
	       !klartext_ends(lexer)) {
		struct interp *interp = lexer->context;
		int slot = slot_of_letter(next_byte(lexer));

		if (slot < 0 || !interp->config->has_axis[slot])
			return fault(lexer->at, lexer_next_column(lexer), "the machine has no %c axis",
				     next_byte(lexer));
		words->m[words->m_count - 1].way += (double)(1U << slot);
		lexer_take(lexer);
	}
	return true;
}

/* Reads NX, NY, NZ, TX, TY or TZ. */
static bool read_vector(struct lexer *lexer, struct klartext_words *words, int column)
{
	bool tool = next_byte(lexer) == 'T';
	int axis = byte_after(lexer, 1) - 'X';
	unsigned *given = tool ? &words->tool_given : &words->normal_given;

	if (axis < 0 || axis > 2)
		return fault(lexer->at, column, "%cX, %cY or %cZ is needed here", tool ? 'T' : 'N', tool ? 'T' : 'N',
			     tool ? 'T' : 'N');
	if (*given & 1U << axis)
		return fault(lexer->at, column, "%c%c stands twice in the block", tool ? 'T' : 'N', 'X' + axis);
	lexer->position += 2;
	*given |= 1U << axis;
	return klartext_value(lexer, tool ? &words->tool[axis] : &words->normal[axis]);
}

static bool read_length(struct lexer *lexer, struct klartext_words *words, int column)
{
	struct interp *interp = lexer->context;

	if (words->has_length)
		return refuse_twice(lexer, column, "LEN");
	words->has_length = true;
	if (!klartext_value(lexer, &words->length))
		return false;
	words->length *= interp->state.scale;
	return true;
}

/* Reads LA, which follows M120: the number of blocks to look ahead. */
static bool read_look_ahead(struct lexer *lexer, struct klartext_words *words, int column)
{
	struct klartext_m *m = words->m_count ? &words->m[words->m_count - 1] : NULL;

	if (!m || m->number != 120)
		return fault(lexer->at, column, "LA belongs to M120");
	return klartext_value(lexer, &m->way);
}

/* Reads a word of several letters: LEN, LA, CCA or DR. */
static bool read_long(struct lexer *lexer, struct klartext_words *words, int column)
{
	if (klartext_take(lexer, "LEN"))
		return read_length(lexer, words, column);
	if (klartext_take(lexer, "LA"))
		return read_look_ahead(lexer, words, column);
	if (klartext_take(lexer, "CCA")) {
		if (words->has_centre_angle)
			return refuse_twice(lexer, column, "CCA");
		words->has_centre_angle = true;
		return klartext_value(lexer, &words->centre_angle);
	}
	if (klartext_take(lexer, "DR+") || klartext_take(lexer, "DR-")) {
		const bool given = words->direction != 0;

		words->direction = lexer->at->text[lexer->position - 1] == '+' ? 1 : -1;
		return !given || refuse_twice(lexer, column, "DR");
	}
	return fault(lexer->at, column, "this is no word of a positioning block");
}

static int last_m(const struct klartext_words *words)
{
	return words->m_count ? words->m[words->m_count - 1].number : 0;
}

/* Axis letters after M118 limit the handwheel. The axis words of the block stand before M118. */
static bool is_handwheel(struct lexer *lexer, const struct klartext_words *words)
{
	const char byte = next_byte(lexer);

	return last_m(words) == 118 && byte && strchr("IXYZABCUVW", byte);
}

static bool read_handwheel(struct lexer *lexer, struct klartext_words *words, int column)
{
	const int slot = slot_of_letter(next_byte(lexer));
	double limit;

	if (slot >= 0)
		lexer_take(lexer);
	if (slot < 0 || words->handwheel & 1U << slot || lexer_peek(lexer) == '+' || lexer_peek(lexer) == '-')
		return fault(lexer->at, column,
			     "behind M118 stand the limits of the handwheel, each once and without a sign, as in M118 "
			     "X1 Y1: coordinates of the block belong before M118");
	words->handwheel |= 1U << slot;
	if (!klartext_value(lexer, &limit))
		return false;
	words->m[words->m_count - 1].way += fabs(limit);
	return true;
}

/* A T after M112 or M124 belongs to that function, which is refused or ignored. */
static bool belongs_to_m(struct lexer *lexer, const struct klartext_words *words)
{
	const int last = last_m(words);

	return (last == 112 || last == 124) && next_byte(lexer) == 'T';
}

static bool read_word(struct lexer *lexer, struct klartext_words *words)
{
	char byte = next_byte(lexer), next = byte_after(lexer, 1);
	int column = lexer_column(lexer), slot;
	bool increment = byte == 'I';
	double unused;

	if (is_handwheel(lexer, words))
		return read_handwheel(lexer, words, column);
	if (belongs_to_m(lexer, words)) {
		lexer_take(lexer);
		return klartext_value(lexer, &unused);
	}
	if (increment) {
		lexer_take(lexer);
		byte = next;
		next = byte_after(lexer, 1);
	}
	slot = byte ? slot_of_letter(byte) : -1;
	if (byte == 'P' && (next == 'R' || next == 'A'))
		return read_polar(lexer, words, increment, column);
	if (slot >= 0 && next != 'C')
		return read_axis(lexer, words, slot, increment, column);
	if (increment)
		return fault(lexer->at, column, "I needs an axis, PR or PA");
	switch (byte) {
	case 'F':
		return read_feed(lexer, words, column);
	case 'S':
		return read_speed(lexer, words, column);
	case 'R':
		return read_r(lexer, words, column);
	case 'M':
		return read_m(lexer, words, column);
	case 'N':
	case 'T':
		return read_vector(lexer, words, column);
	default:
		return read_long(lexer, words, column);
	}
}

bool klartext_words_read(struct lexer *lexer, struct klartext_words *words)
{
	memset(words, 0, offsetof(struct klartext_words, m));
	words->first_column = lexer_next_column(lexer);
	while (!klartext_ends(lexer)) {
		if (!read_word(lexer, words))
			return false;
	}
	return true;
}
