#include "gcode/dialect/klartext/words/klartext_cycle_words.h"

#include <stdio.h>
#include <string.h>

#include "base/ascii.h"
#include "gcode/dialect/klartext/text/klartext_lexis.h"
#include "gcode/dialect/klartext/values/klartext_value.h"
#include "gcode/dialect/klartext/words/klartext_global.h"

/* FMAX as a number, as cycles write it. */
#define FMAX_VALUE 99999

static struct klartext_cycle_word *add_word(struct lexer *lexer, struct klartext_cycle *cycle, int column)
{
	struct klartext_cycle_word *word;

	if (cycle->count == KLARTEXT_CYCLE_WORDS) {
		fault_report(lexer->at, column, "a cycle has at most %d parameters", KLARTEXT_CYCLE_WORDS);
		return NULL;
	}
	word = &cycle->words[cycle->count++];
	*word = (struct klartext_cycle_word){.part = cycle->part, .column = column, .line = lexer->at->line};
	return word;
}

/*
 * The control asks for each word of a line once; `word` is the last one, and X and IX are one word. Lines of older
 * cycles may have the same word: F of 4.3 and 4.6 is down and across.
 */
static bool check_once(struct lexer *lexer, const struct klartext_cycle *cycle, const struct klartext_cycle_word *word)
{
	const char *name = word->name + (word->name[0] == 'I' && word->name[1] != '\0' && word->name[2] == '\0');

	for (const struct klartext_cycle_word *other = cycle->words; name[0] && other < word; other++) {
		const char *before = other->name + (other->name[0] == 'I' && !strcmp(other->name + 1, name));

		if (other->part == word->part && !strcmp(before, name))
			return fault(lexer->at, word->column, "%s stands twice in the cycle, already in line %ld",
				     name, other->line);
	}
	return true;
}

/* Q200=2; PREDEF; a feed may be MAX (FMAX), or AUTO (FAUTO) for the feed of TOOL CALL. */
static bool read_q(struct lexer *lexer, struct klartext_cycle *cycle)
{
	struct interp *interp = lexer->context;
	int column = lexer_next_column(lexer), number;
	struct klartext_cycle_word *word;
	char text[KLARTEXT_WORD];

	lexer_take(lexer);
	if (!klartext_integer(lexer, "the number of a parameter", 0, KLARTEXT_Q_COUNT - 1, &number))
		return false;
	if (lexer_peek(lexer) != '=')
		return fault(lexer->at, lexer_column(lexer), "'=' is needed here");
	lexer_take(lexer);
	word = add_word(lexer, cycle, column);
	if (!word)
		return false;
	snprintf(word->name, sizeof(word->name), "Q%d", number);
	if (!check_once(lexer, cycle, word))
		return false;
	if (klartext_ends(lexer))
		return true;
	if (klartext_value_follows(lexer)) {
		if (!klartext_value(lexer, &word->value))
			return false;
	} else if (!klartext_word(lexer, text)) {
		return fault(lexer->at, lexer_next_column(lexer), "a value is needed here");
	} else if (!strcmp(text, "FMAX") || !strcmp(text, "MAX")) {
		word->value = FMAX_VALUE;
	} else if (!strcmp(text, "FAUTO") || !strcmp(text, "AUTO")) {
		word->value = klartext_of(interp)->tool.feed_bare;
	} else if (!klartext_global_value(lexer, column, number, text, &word->value)) {
		return false;
	}
	word->given = true;
	if (!cycle->global)
		klartext_q_set(klartext_of(interp), number, word->value);
	return true;
}

/* Words of the lines n.1, n.2 ... of older cycles: X+10, IX-5, ROT+30, SCL 0.5, SET UP 2, T0.05, F100, #5. */
static bool read_old(struct lexer *lexer, struct klartext_cycle *cycle)
{
	int column = lexer_next_column(lexer);
	struct klartext_cycle_word *word = add_word(lexer, cycle, column);
	char text[KLARTEXT_WORD], more[KLARTEXT_WORD];

	if (!word)
		return false;
	if (lexer_peek(lexer) == '#') {
		lexer_take(lexer);
		snprintf(word->name, sizeof(word->name), "#");
	} else if (klartext_word(lexer, text)) {
		snprintf(word->name, sizeof(word->name), "%.11s", text);
		/* Names of several words: SET UP, V.TIME. A letter that is an axis stands alone, as in 8.1 X Y. */
		while (text[1] != '\0' && !klartext_ends(lexer) && !klartext_value_follows(lexer) &&
		       klartext_word(lexer, more))
			;
	} else if (!klartext_value_follows(lexer)) {
		return fault(lexer->at, column, "this is no word of a cycle");
	}
	/* V.ZEIT, HSC-MODE:1 */
	while ((lexer_peek(lexer) == '.' || lexer_peek(lexer) == '-') &&
	       ascii_is_letter(lexer->at->text[lexer->position + 1])) {
		lexer_take(lexer);
		klartext_word(lexer, more);
	}
	if (!check_once(lexer, cycle, word))
		return false;
	if (lexer_peek(lexer) == ':' || lexer_peek(lexer) == '=')
		lexer_take(lexer);
	/* DR+ */
	if (!klartext_value_follows(lexer)) {
		if (lexer_peek(lexer) == '+' || lexer_peek(lexer) == '-')
			lexer_take(lexer);
		return true;
	}
	word->given = true;
	return klartext_value(lexer, &word->value);
}

bool klartext_cycle_words_is_q(struct lexer *lexer)
{
	const char byte = lexer_peek(lexer);
	const char *text = lexer->at->text + lexer->position;

	return (byte == 'Q' || byte == 'q') && ascii_is_digit(text[1]);
}

bool klartext_cycle_words_read(struct lexer *lexer, struct klartext_cycle *cycle)
{
	while (!klartext_ends(lexer)) {
		if (lexer_peek(lexer) == '~')
			return fault(lexer->at, lexer_next_column(lexer),
				     "'~' is the last sign of a line: write the comment before it");
		if (!(cycle->by_q ? read_q(lexer, cycle) : read_old(lexer, cycle)))
			return false;
	}
	return true;
}

bool klartext_cycle_words_add_axis(struct klartext_cycle *cycle, char letter, double value)
{
	struct klartext_cycle_word *word = &cycle->words[cycle->count];

	if (cycle->count == KLARTEXT_CYCLE_WORDS)
		return false;
	*word =
	    (struct klartext_cycle_word){.value = value, .given = true, .column = cycle->column, .line = cycle->line};
	word->name[0] = letter;
	cycle->count++;
	return true;
}
