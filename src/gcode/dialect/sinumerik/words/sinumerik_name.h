/* sinumerik_name.h - reads names, and single bytes between them, in a line. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_WORDS_SINUMERIK_NAME_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_WORDS_SINUMERIK_NAME_H

#include "base/ascii.h"
#include "gcode/text/lexer.h"

/* 840D sl, NC programming: a name has at most 32 bytes. */
#define SINUMERIK_NAME 32

/* The bytes that a name may start with: letters and '_'. */
static inline bool sinumerik_starts_name(char byte)
{
	return ascii_is_letter(byte) || byte == '_';
}

static inline bool sinumerik_is_name(char byte)
{
	return sinumerik_starts_name(byte) || ascii_is_digit(byte);
}

/* The index of the next byte that is no blank, from `at` on. */
static inline size_t sinumerik_skip_blanks(const char *text, size_t at)
{
	while (text[at] == ' ' || text[at] == '\t')
		at++;
	return at;
}

/* All functions below read at the position of the lexer. */

/*
 * Reads a name, in upper case: letters, digits and '_'; with a '$' before it, a system variable. Blanks may precede
 * it. Returns its length; 0: no name comes next, or it is too long, and nothing is consumed.
 */
size_t sinumerik_name_read(struct lexer *lexer, char name[SINUMERIK_NAME + 1]);

/* Consumes this upper-case name if it comes next as a whole. */
bool sinumerik_name_take(struct lexer *lexer, const char *name);

/* Consumes the byte if it is the next one that is no blank. */
bool sinumerik_name_take_byte(struct lexer *lexer, char byte);

/* Skips "(...)", with the strings in it, if '(' comes next. False: it is not closed, which was reported. */
bool sinumerik_name_step_over_call(struct lexer *lexer);

/* Consumes this byte, which must come next; `after` names in the message what precedes it. False: reported. */
bool sinumerik_name_need(struct lexer *lexer, char byte, const char *after);

#endif
