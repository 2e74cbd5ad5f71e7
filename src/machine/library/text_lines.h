/* text_lines.h - the lines of a text, and the words of G-code on a line: a letter and its number. */
#ifndef FIVECHECK_MACHINE_LIBRARY_TEXT_LINES_H
#define FIVECHECK_MACHINE_LIBRARY_TEXT_LINES_H

#include <stdbool.h>
#include <stddef.h>

/* Initialise it with {.next = text}. */
struct text_lines {
	const char *next;
	const char *line;	/* the current one, not terminated by a NUL */
	size_t length;	/* without the end of the line */
	long number;	/* of the line, from 1 */
};

/* Advances to the next line. False: there is none. */
bool text_lines_next(struct text_lines *lines);

struct letter_word {
	char letter;	/* upper case */
	double value;
	bool has_point;	/* the number has a decimal point */
};

/*
 * Reads the next word between *at and `end`, and moves *at past it. Skips blanks and comments in parentheses before it.
 * Returns -1 if something else is there, with *at at its start; 0 at the end of the words, or at a semicolon.
 */
int letter_word_next(const char **at, const char *end, struct letter_word *word);

#endif
