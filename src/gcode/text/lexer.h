/* lexer.h - splits a line into words, a letter and its number each; skips comments and blanks, evaluates nothing. */
#ifndef FIVECHECK_GCODE_TEXT_LEXER_H
#define FIVECHECK_GCODE_TEXT_LEXER_H

#include <stdbool.h>
#include <stddef.h>

#include "control/controller.h"
#include "gcode/text/fault.h"
#include "gcode/text/number.h"

struct lexer;

struct word {
	char letter;	/* upper case */
	bool point;	/* the number has a decimal point */
	int column;	/* of the letter, from 1 */
	double value;
	bool comma;	/* a comma stands before its letter */
	bool vacant;	/* its value is a variable without a value: the word counts as not written */
};

enum lexer_result { LEXER_WORD, LEXER_END, LEXER_FAULT };

/* A byte that starts no word, and the message for it, in place of "unexpected". */
struct lexer_refusal {
	char byte;
	const char *message;
};

/*
 * How a dialect writes its lines. Constant data. The lexer itself reads plain
 * numbers only: the hooks read and compute whatever else a dialect has. A hook
 * that is NULL: the dialect has no such thing. False from a hook: the fault was reported.
 */
struct lexer_rules {
	enum semicolon semicolon;	/* not known: it is a fault */
	bool comma_words;	/* a comma may stand before a word, which then means something else */
	bool comments_nest;	/* a comment inside of one that ends the line is text; no: a fault everywhere */
	/*
	 * Reads the value of a word that has no plain number behind its letter;
	 * letter and column are given. LEXER_END: no value comes next, and
	 * nothing was taken.
	 */
	enum lexer_result (*value)(struct lexer *lexer, struct word *word);
	/* Reads an assignment that stands among the words, at this byte. */
	char assignment_start;
	bool (*assignment)(struct lexer *lexer);
	/* Refuses a comment that the control obeys, such as (ABORT, ...). NULL: it obeys none. */
	bool (*check_comment)(const struct lexer *lexer, const char *text);
	const struct lexer_refusal *refusals;
	size_t refusal_count;
};

struct lexer {
	const struct line_place *at;	/* borrowed, as is all below */
	const struct lexer_rules *rules;
	void *context;	/* of the hooks */
	size_t position;
	int assignments;	/* that stood among the words so far */
};

void lexer_init(struct lexer *lexer, const struct line_place *at, const struct lexer_rules *rules, void *context);

/* The next byte that is no blank, without taking it; '\0' at the end of the line. */
static inline char lexer_peek(struct lexer *lexer)
{
	const char *text = lexer->at->text;

	while (text[lexer->position] == ' ' || text[lexer->position] == '\t')
		lexer->position++;
	return text[lexer->position];
}

/* Takes the byte that lexer_peek showed. */
static inline void lexer_take(struct lexer *lexer)
{
	lexer->position++;
}

/* Takes this keyword, which is given in lower case, if it comes next; there may be blanks between its letters. */
bool lexer_keyword(struct lexer *lexer, const char *keyword);

/* Steps over blanks and comments. False: reported. */
bool lexer_skip_comments(struct lexer *lexer);

/* Column of the next byte. */
static inline int lexer_column(const struct lexer *lexer)
{
	return (int)lexer->position + 1;
}

/* lexer_next for whatever comes next. */
enum lexer_result lexer_next_any(struct lexer *lexer, struct word *word);

/*
 * The next word. Faults are reported: an unclosed or nested comment, a letter
 * without a value, a byte that starts no word, and what is known but not
 * supported. Assignments on the way are left to the dialect and counted. On
 * LEXER_END the whole line has been looked at.
 */
static inline enum lexer_result lexer_next(struct lexer *lexer, struct word *word)
{
	const char letter = lexer_peek(lexer), *text = lexer->at->text, *end;

	/* Nearly all words: a capital letter and a number. */
	if (letter < 'A' || letter > 'Z' ||
	    !(end = number_read_usual(text + lexer->position + 1, &word->value, &word->point)))
		return letter ? lexer_next_any(lexer, word) : LEXER_END;
	word->letter = letter;
	word->column = lexer_column(lexer);
	word->comma = word->vacant = false;
	lexer->position = (size_t)(end - text);
	return LEXER_WORD;
}

#endif
