#include "gcode/text/block.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/ascii.h"
#include "base/same_double.h"
#include "gcode/text/lexer.h"

/* LinuxCNC's limit, "Number of M codes in a block". */
#define M_COUNT_MAX 4

void block_clear(struct block *block)
{
	block->words = 0;
	block->letters = 0;
	block->points = 0;
	block->m_count = 0;
	block->m_ignored = false;
	block->motion = CODE_NONE;
	block->idle = CODE_NONE;
	block->corner = '\0';
	block->polar = 0;
	block->has_next_tool = false;
	block->vectors = false;
	block->plain = false;
	for (int i = 0; i < G_GROUPS; i++)
		block->g[i] = CODE_NONE;
	for (int i = 0; i < M_GROUPS; i++)
		block->m[i] = CODE_NONE;
}

/* "G43.4", or "G41" without tenths. */
static bool fault_g(const struct line_place *at, const struct word *word, int number, const char *text)
{
	if (number % 10)
		return fault(at, word->column, "G%d.%d%s", number / 10, number % 10, text);
	return fault(at, word->column, "G%d%s", number / 10, text);
}

/* Does a later code of the group replace an earlier one? On controls, path accuracy and cycles may be other groups. */
static bool gives_way(int group, int before, int number)
{
	return group != G_CONTOUR && (group != G_MOTION || (before <= G3 && number <= G3));
}

/* Rigid taps are taps: the motion of the spindle moves no other axis. G107, G112 and G113 are alternative names. */
static int as_executed(int number)
{
	static const int names[][2] = {{842, G84}, {843, G74}, {1070, G7_1}, {1120, G12_1}, {1130, G13_1}};

	for (size_t i = 0; number >= names[0][0] && i < sizeof(names) / sizeof(names[0]); i++) {
		if (names[i][0] == number)
			return names[i][1];
	}
	return number;
}

const struct code *block_find_g(struct block *block, const struct dialect *dialect, int number)
{
	if (!block->recent || block->recent->number != number)
		block->recent = code_find(dialect->g_codes, number);
	return block->recent;
}

/* Finds the code of a word. False, reported: the code is not known, not supported, or not allowed there. */
static bool find_code_of_word(struct block *block, const struct line_place *at, const struct word *word,
			      const struct dialect *dialect, const struct code **found)
{
	const double tenths = word->value * 10;
	const int number = tenths < 10000 ? (int)(tenths + 0.5) : 10000;
	const struct code *code;
	char text[256];

	if (tenths < 0)
		return fault(at, word->column, "a G-code must not be negative");
	/* LinuxCNC accepts numbers within 0.0001 of a code. */
	if (number == 10000 || fabs(tenths - number) > 0.001)
		return fault(at, word->column, "%g is not a G-code", word->value);
	*found = code = block_find_g(block, dialect, number);
	if (code && code->group != GROUP_STATEMENT && code->state != CODE_REFUSED)
		return true;
	if (!code)
		snprintf(text, sizeof(text), " is not a G-code of the %s dialect%s", dialect->name,
			 dialect->traits.call_letters
			     ? "; if the machine builder made it, set <macro code=\"\"/> in the machine file's "
			       "<controller>"
			     : "");
	else if (code->group == GROUP_STATEMENT)
		snprintf(text, sizeof(text), " must be the first word of its block after N");
	else
		snprintf(text, sizeof(text), ": %s is not supported; post the program without it", code->what);
	return fault_g(at, word, number, text);
}

static bool add_g(struct block *block, const struct line_place *at, const struct word *word,
		  const struct dialect *dialect)
{
	const struct code *code;
	char text[256];
	int number;

	if (!find_code_of_word(block, at, word, dialect, &code))
		return false;
	number = code->number;
	if (code->group == GROUP_NONE) {
		block->idle = number;
		block->idle_column = word->column;
		return true;
	}
	number = as_executed(number);
	/* Another motion of the block replaces G80 (LinuxCNC's manual, "G80"). */
	if (number == G80 && block->g[code->group] != CODE_NONE && block->g[code->group] != G80)
		return true;
	/* On some of these controls a parameter makes G90 or G91 valid only for the words after it. */
	if (code->group == G_DISTANCE && block->g[G_DISTANCE] != CODE_NONE && block->g[G_DISTANCE] != number &&
	    (block->letters & AXIS_BITS))
		return fault(at, word->column,
			     "G90 and G91 in one block, with axis words before the second one: controls differ in "
			     "which of them applies to these words; write two blocks");
	if (dialect->traits.last_of_group == ANSWER_YES && gives_way(code->group, block->g[code->group], number))
		block->g[code->group] = CODE_NONE;
	if (block->g[code->group] != CODE_NONE && (block->g[code->group] != G80 || number == G80)) {
		snprintf(text, sizeof(text),
			 " and the G-code at column %d belong to the same modal group; a block can have only one of "
			 "them",
			 block->g_column[code->group]);
		return fault_g(at, word, number, text);
	}
	block->g[code->group] = number;
	block->g_column[code->group] = word->column;
	return true;
}

static bool set_m(struct block *block, const struct line_place *at, const struct word *word, int group, int code)
{
	if (block->m[group] != CODE_NONE)
		return fault(at, word->column,
			     "M%g and the M-code at column %d belong to the same modal group; a block can have only "
			     "one of them",
			     word->value, block->m_column[group]);
	block->m[group] = code;
	block->m_column[group] = word->column;
	return true;
}

/* An M-code whose meaning the machine file defines. */
static bool set_machine_m(struct block *block, const struct line_place *at, const struct word *word,
			  enum mcode_action action)
{
	switch (action) {
	case MCODE_TCP_ON:
	case MCODE_TCP_OFF:
		return set_m(block, at, word, M_TCP, (int)action);
	case MCODE_SPINDLE_ON:
		return set_m(block, at, word, M_SPINDLE, 3);
	case MCODE_SPINDLE_OFF:
		return set_m(block, at, word, M_SPINDLE, 5);
	case MCODE_IGNORE:
		break;
	}
	block->m_ignored = true;
	return true;
}

static bool add_m(struct block *block, const struct line_place *at, const struct word *word,
		  const struct gcode_config *config)
{
	const struct code *code;
	int number;

	if (word->value < 0)
		return fault(at, word->column, "an M-code must not be negative");
	if (word->value > 32767 || word->value != floor(word->value))
		return fault(at, word->column, "%g is not an M-code", word->value);
	if (++block->m_count > M_COUNT_MAX)
		return fault(at, word->column, "a block can have at most %d M-codes", M_COUNT_MAX);
	number = (int)word->value;
	for (size_t i = 0; i < config->controller.mcode_count; i++)
		if (config->controller.mcodes[i].number == number)
			return set_machine_m(block, at, word, config->controller.mcodes[i].action);
	code = code_find(config->dialect->m_codes, number);
	if (!code)
		return fault(at, word->column,
			     "M%d is not known; if it moves no axis, set <mcode number=\"%d\" action=\"ignore\"/> in "
			     "the machine file's <controller>",
			     number, number);
	if (code->group == GROUP_STATEMENT)
		return fault(at, word->column, "M%d must be at the start of its block", number);
	if (code->state == CODE_REFUSED)
		return fault(at, word->column,
			     "M%d: %s is not supported; post the program without it or, if it moves no axis, set "
			     "<mcode number=\"%d\" action=\"ignore\"/> in the machine file's <controller>",
			     number, code->what, number);
	if (code->group == GROUP_OUTPUT)
		block->m_ignored = true;
	if (code->group == GROUP_OUTPUT || code->group == GROUP_NONE)
		return true;
	return set_m(block, at, word, code->group, number);
}

/* Called after all words were read, because only then is it known whether X is an axis or the time of a dwell. */
static bool check_axis_words(const struct block *block, const struct line_place *at, const struct gcode_config *config)
{
	bool dwell = config->dialect->traits.dwell_alone == ANSWER_YES && block->g[G_NONMODAL] == G4;
	uint32_t left = dwell ? 0 : block->letters & AXIS_BITS;

	for (int slot = 0; left; slot++) {
		char letter = AXIS_LETTERS[slot];

		if (!config->has_axis[slot] && (left & letter_bit(letter)))
			return fault(at, block_column(block, letter), "the machine has no %c axis%s", letter,
				     letter == 'U' || letter == 'W' ? "; on a lathe U and W are increments of X and Z, "
								      "but lathe programs are not supported"
								    : "");
		left &= ~letter_bit(letter);
	}
	return true;
}

/* The block has the letter already. */
static bool repeat_value(struct block *block, const struct line_place *at, const struct word *word,
			 const struct gcode_config *config, struct block_cautions *cautions)
{
	const int first = block->column[word->letter - 'A'];
	const bool asks = word->letter == 'T' && config->dialect->traits.m6_loads_own_t == ANSWER_NO;

	if (!config->read.last_duplicate_wins)
		return fault(at, word->column, "the word %c occurs twice in the block, at columns %d and %d%s",
			     word->letter, first, word->column,
			     asks ? "; if M6 loads the first tool and the second one is preselected, set "
				    "m6_with_t=\"first\" in the machine file's <controller>"
				  : "");
	if (!cautions->duplicate)
		caution(at, word->column,
			"the word %c occurs twice in the block, at columns %d and %d; the last one is used, here and "
			"further on",
			word->letter, first, word->column);
	cautions->duplicate = true;
	return true;
}

static bool add_value(struct block *block, const struct line_place *at, const struct word *word,
		      const struct gcode_config *config, struct block_cautions *cautions)
{
	const int index = word->letter - 'A';
	const uint32_t bit = letter_bit(word->letter);

	if (block_has(block, word->letter)) {
		if (word->letter == 'T' && config->controller.m6_with_t == M6_LOADS_FIRST_T && !block->has_next_tool) {
			block->has_next_tool = true;
			block->next_tool = word->value;
			block->next_tool_column = word->column;
			return true;
		}
		if (!repeat_value(block, at, word, config, cautions))
			return false;
	}
	block->letters |= bit;
	block->points = word->point ? block->points | bit : block->points & ~bit;
	block->value[index] = word->value;
	block->column[index] = word->column;
	return true;
}

/* ",C" and ",R". */
static bool add_corner(struct block *block, const struct line_place *at, const struct word *word)
{
	if (word->letter != 'C' && word->letter != 'R')
		return fault(at, word->column, ",%c is not supported", word->letter);
	if (block->corner)
		return fault(at, word->column, "a block can have only one word after a comma");
	block->corner = word->letter;
	block->corner_value = word->value;
	block->corner_point = word->point;
	block->corner_column = word->column;
	return true;
}

#define PLANE_BITS (letter_bit('X') | letter_bit('Y'))

static bool is_polar(char letter)
{
	return letter == '@' || letter == '^';
}

/* A radius takes the place of X, an angle that of Y: LinuxCNC's manual, "Polar Coordinates". */
static bool add_polar(struct block *block, const struct line_place *at, const struct word *word)
{
	const char letter = word->letter == '@' ? 'X' : 'Y';

	if (block->polar & letter_bit(letter))
		return fault(at, word->column, "%c occurs twice in the block", word->letter);
	block->polar |= letter_bit(letter);
	block->letters |= letter_bit(letter);
	block->points |= letter_bit(letter);
	block->value[letter - 'A'] = word->value;
	block->column[letter - 'A'] = word->column;
	return true;
}

static bool add_word(struct block *block, const struct line_place *at, const struct word *word,
		     const struct gcode_config *config, struct block_cautions *cautions)
{
	block->words++;
	/* B-63944EN, undefined variable; Haas, address substitution: the word is ignored. */
	if (word->vacant)
		return true;
	if (word->comma)
		return add_corner(block, at, word);
	if (is_polar(word->letter) ? block->letters & ~block->polar & PLANE_BITS
				   : block->polar && (word->letter == 'X' || word->letter == 'Y'))
		return fault(at, word->column, "X and Y cannot stand beside polar coordinates (@, ^)");
	if (is_polar(word->letter))
		return add_polar(block, at, word);
	switch (word->letter) {
	case 'G':
		return add_g(block, at, word, config->dialect) || config->read.all_faults;
	case 'M':
		return add_m(block, at, word, config) || config->read.all_faults;
	case 'N':
		return fault(at, word->column, "N is allowed only at the start of a block");
	case 'O':
		return fault(at, word->column, "O is allowed only at the start of a block");
	default:
		return add_value(block, at, word, config, cautions);
	}
}

/* One label at the start of the line: "O1234", ":1234" or N. */
static bool read_label(struct block *block, struct lexer *lexer, const char *what)
{
	struct word word;
	int column;

	if (lexer_peek(lexer) == ':') {
		const char *text = lexer->at->text + lexer->position + 1;

		column = lexer_column(lexer);
		if (!strspn(text + strspn(text, " \t"), "0123456789"))
			return fault(lexer->at, column, "':' without a number");
		lexer_take(lexer);
		while (ascii_is_digit(lexer_peek(lexer)))
			lexer_take(lexer);
		block->words++;
		return true;
	}
	if (lexer_next(lexer, &word) != LEXER_WORD)
		return false;
	block->words++;
	if (word.point || word.value < 0 || word.vacant)
		return fault(lexer->at, word.column, "%s must be a whole number that is not negative", what);
	return true;
}

/*
 * Reads '/', or, on controls with several switches, "/2" and further ones; one option of the program stands for all
 * switches. False: there is none.
 */
static bool read_slashes(struct lexer *lexer, const struct block_rules *rules)
{
	bool any = false;

	while (lexer_peek(lexer) == '/' && (!any || rules->numbered_switches)) {
		any = true;
		lexer_take(lexer);
		if (rules->numbered_switches && ascii_is_digit(lexer_peek(lexer)))
			lexer_take(lexer);
	}
	return any;
}

/* Reads '/', program number and line number, in this order. */
static bool read_start(struct block *block, struct lexer *lexer, const struct gcode_config *config,
		       const struct block_rules *rules, bool *skipped)
{
	char next;

	*skipped = read_slashes(lexer, rules) && config->read.block_delete;
	if (*skipped)
		return true;
	next = lexer_peek(lexer);
	if (rules->program_numbers && (next == 'O' || next == 'o' || next == ':')) {
		if (!read_label(block, lexer, "a program number"))
			return false;
		next = lexer_peek(lexer);
	}
	if ((next == 'N' || next == 'n') && !read_label(block, lexer, "a line number"))
		return false;
	/* 30i-B operator's manual, optional block skip: a '/' behind N skips the rest of the block. */
	*skipped = rules->numbered_switches && read_slashes(lexer, rules) && config->read.block_delete;
	return true;
}

/* ------------------------------------------------------------ plain blocks */

/* The words that a plain block can have besides N and G. */
static uint32_t plain_letters(const struct gcode_config *config)
{
	uint32_t letters = ARC_BITS | letter_bit('F');

	for (int slot = 0; slot < SLOT_COUNT; slot++)
		letters |= config->has_axis[slot] ? letter_bit(AXIS_LETTERS[slot]) : 0;
	return letters;
}

/* Takes G0 to G3 if it is the block's first G-code and the dialect has it. */
static bool take_plain_motion(struct block *block, double value, int column, const struct dialect *dialect)
{
	const int whole = value >= 0 && value <= 3 ? (int)value : -1;
	const struct code *code;

	if (!same_double(value, whole) || block->g[G_MOTION] != CODE_NONE)
		return false;
	code = block_find_g(block, dialect, 10 * whole);
	if (!code || code->group != G_MOTION || code->state == CODE_REFUSED)
		return false;
	block->g[G_MOTION] = code->number;
	block->g_column[G_MOTION] = column;
	return true;
}

bool block_read_plain(struct block *block, const struct line_place *line, const struct gcode_config *config)
{
	const char *at = line_start(line), *end;
	uint32_t open;
	double value;
	bool point;

	block_clear(block);
	if (!block->plain_letters)
		block->plain_letters = plain_letters(config);
	open = block->plain_letters;
	if (*at == 'N') {
		end = number_read_usual(at + 1, &value, &point);
		if (!end || point || value < 0)
			return false;
		block->words++;
		at = end;
	}
	for (; *at >= 'A' && *at <= 'Z'; at = end) {
		const int index = *at - 'A', column = (int)(at - line->text) + 1;
		const uint32_t bit = letter_bit(*at);

		end = number_read_usual(at + 1, &value, &point);
		if (!end)
			return false;
		block->words++;
		if (open & bit) {
			open &= ~bit;
			block->letters |= bit;
			block->points |= point ? bit : 0;
			block->value[index] = value;
			block->column[index] = column;
		} else if (*at != 'G' || !take_plain_motion(block, value, column, config->dialect)) {
			return false;
		}
	}
	block->plain = *at == '\0' && block->words > 0;
	return block->plain;
}

bool block_read(struct block *block, const struct line_place *at, const struct gcode_config *config,
		const struct block_rules *rules, void *context, struct block_cautions *cautions)
{
	enum lexer_result result;
	struct lexer lexer;
	struct word word;
	bool skipped = false;

	block_clear(block);
	lexer_init(&lexer, at, rules->lexer, context);
	if (!read_start(block, &lexer, config, rules, &skipped))
		return false;
	if (skipped)
		return true;
	while ((result = lexer_next(&lexer, &word)) == LEXER_WORD) {
		if (!add_word(block, at, &word, config, cautions))
			return false;
	}
	if (result == LEXER_FAULT)
		return false;
	block->words += lexer.assignments;
	return check_axis_words(block, at, config);
}
