/* text_lines.h - the lines of a text, and the words of G-code on a line: a letter and its number. */
#ifndef FIVECHECK_MACHINE_LIBRARY_TEXT_LINES_H
#define FIVECHECK_MACHINE_LIBRARY_TEXT_LINES_H

#include <stdbool.h>
#include <stddef.h>

/* Begin with {.next = text}. */
struct text_lines {
	const char *next;
	const char *line;	/* the current one; it is not ended by a NUL */
	size_t length;	/* without the end of the line */
	long number;	/* of the line, from 1 */
};

/* Goes on to the next line. False: there is none. */
bool text_lines_next(struct text_lines *lines);

struct letter_word {
	char letter;	/* upper case */
	double value;
	bool has_point;	/* the number has a decimal point */
};

/*
 * Reads the next word at *at, before `end`, and moves *at past it. Blanks and comments in parentheses before it are
 * passed over. The result is -1 for something else, with *at there; 0 where no word is left, a semicolon included.
 */
int letter_word_next(const char **at, const char *end, struct letter_word *word);

#endif
