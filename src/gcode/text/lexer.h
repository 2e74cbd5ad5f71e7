/* lexer.h - the words of one line: a letter and its number, comments and blanks left out. */
#ifndef FIVECHECK_GCODE_TEXT_LEXER_H
#define FIVECHECK_GCODE_TEXT_LEXER_H

#include <stdbool.h>
#include <stddef.h>

#include "gcode/text/fault.h"

struct interp;

struct word {
	char letter;	/* upper case */
	bool point;	/* the number has a decimal point */
	int column;	/* of the letter, from 1 */
	double value;
	bool vacant;	/* of a variable without a value: the word counts as not written */
};

enum lexer_result { LEXER_WORD, LEXER_END, LEXER_FAULT };

/* What a value of Fanuc's and Haas's macros behind a letter is. */
enum lexer_macro {
	MACRO_NONE,
	MACRO_WORDS,	/* of a block: rounded to the increment of its address */
	MACRO_ARGUMENTS	/* of a call: not rounded */
};

struct lexer {
	const struct line_place *at;	/* borrowed */
	size_t position;
	bool semicolon_ends_block;	/* else it starts a comment */
	struct interp *interp;	/* of parameters and expressions; NULL: they are faults */
	enum lexer_macro macro;	/* MACRO_NONE: they are LinuxCNC's */
	double steps;	/* a unit has so many for a macro's ROUND */
	int depth;	/* of the value that is being read */
	int assignments;	/* of parameters, so far */
};

void lexer_init(struct lexer *lexer, const struct line_place *at, bool semicolon_ends_block);

/* The next byte that is no blank, without taking it; '\0' at the end of the line. */
char lexer_peek(struct lexer *lexer);

/* Takes the byte that lexer_peek showed. */
void lexer_take(struct lexer *lexer);

/* Takes the word, in lower case here, if it comes next, blanks or not in between. */
bool lexer_keyword(struct lexer *lexer, const char *keyword);

/* Steps over blanks and comments. False: reported. */
bool lexer_skip_comments(struct lexer *lexer);

/* Column of the next byte. */
int lexer_column(const struct lexer *lexer);

/*
 * The next word. Faults are reported: an unclosed or nested comment, a letter
 * without a value, a byte that starts no word, and what is known but not
 * supported. Assignments on the way are remembered (expr.h). On LEXER_END the
 * whole line has been looked at.
 */
enum lexer_result lexer_next(struct lexer *lexer, struct word *word);

#endif
