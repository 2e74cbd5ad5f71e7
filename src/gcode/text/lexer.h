/* lexer.h - splits a line into words of a letter and a number; skips comments and blanks, evaluates nothing. */
#ifndef FIVECHECK_GCODE_TEXT_LEXER_H
#define FIVECHECK_GCODE_TEXT_LEXER_H

#include <stdbool.h>
#include <stddef.h>

#include "control/controller.h"
#include "gcode/text/fault.h"
#include "gcode/text/number.h"

struct lexer;

struct word {
	char letter;	/* upper case; @ or ^ */
	bool point;	/* the number has a decimal point */
	int column;	/* of the letter, from 1 */
	double value;
	bool comma;	/* a comma precedes the letter */
	bool vacant;	/* the value is that of a vacant variable: the control ignores the word */
};

enum lexer_result { LEXER_WORD, LEXER_END, LEXER_FAULT };

/* A byte that starts no word, and its message instead of "unexpected". */
struct lexer_refusal {
	char byte;
	const char *message;
};

/*
 * The syntax of a dialect's lines. Constant data. The lexer reads plain numbers only: the hooks read and compute all
 * other values. A hook is NULL if the dialect has no such syntax. A hook reports a fault before it returns false.
 */
struct lexer_rules {
	enum semicolon semicolon;	/* not known: a semicolon is a fault */
	bool comma_words;	/* a comma may precede a word, which then has another meaning */
	bool polar_words;	/* @ and ^ are words: a radius and an angle in the plane of X and Y */
	bool comments_nest;	/* in a comment that ends the line, a nested comment is text; no: it is a fault */
	/*
	 * Reads the value of a word without a plain number after its letter; letter and column are given. LEXER_END: no
	 * value follows, and nothing was consumed.
	 */
	enum lexer_result (*value)(struct lexer *lexer, struct word *word);
	/* Reads an assignment among the words; it starts with this byte. */
	char assignment_start;
	bool (*assignment)(struct lexer *lexer);
	/* Refuses a comment that is a command to the control, such as (ABORT, ...). NULL: there are none. */
	bool (*check_comment)(const struct lexer *lexer, const char *text);
	const struct lexer_refusal *refusals;
	size_t refusal_count;
};

struct lexer {
	const struct line_place *at;	/* borrowed, like all pointers below */
	const struct lexer_rules *rules;
	void *context;	/* of the hooks */
	size_t position;
	int assignments;	/* number of assignments among the words so far */
};

void lexer_init(struct lexer *lexer, const struct line_place *at, const struct lexer_rules *rules, void *context);

/* The next byte that is no blank, without consuming it; '\0' at the end of the line. */
static inline char lexer_peek(struct lexer *lexer)
{
	const char *text = lexer->at->text;

	while (text[lexer->position] == ' ' || text[lexer->position] == '\t')
		lexer->position++;
	return text[lexer->position];
}

/* Consumes the byte that lexer_peek returned. */
static inline void lexer_take(struct lexer *lexer)
{
	lexer->position++;
}

/* Consumes this keyword, given in lower case, if it comes next; there may be blanks between its letters. */
bool lexer_keyword(struct lexer *lexer, const char *keyword);

/* Skips blanks and comments. False: reported. */
bool lexer_skip_comments(struct lexer *lexer);

/* Column of the next byte. */
static inline int lexer_column(const struct lexer *lexer)
{
	return (int)lexer->position + 1;
}

/* Skips blanks. Column of the next byte, which is no blank. */
int lexer_next_column(struct lexer *lexer);

/* lexer_next for every kind of word. */
enum lexer_result lexer_next_any(struct lexer *lexer, struct word *word);

/*
 * Reads the next word. Faults are reported: an unclosed or nested comment, a letter without a value, a byte that starts
 * no word, and known but unsupported syntax. Assignments before the word are passed to the dialect and counted. On
 * LEXER_END the whole line has been read.
 */
static inline enum lexer_result lexer_next(struct lexer *lexer, struct word *word)
{
	const char letter = lexer_peek(lexer), *text = lexer->at->text, *end;

	/* Nearly all words are a capital letter and a number. */
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
