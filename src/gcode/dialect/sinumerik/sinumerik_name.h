/* sinumerik_name.h - names, and single bytes between them, in a line. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_NAME_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_SINUMERIK_NAME_H

#include "gcode/text/lexer.h"

/* 840D sl, NC programming: 32 bytes a name. */
#define SINUMERIK_NAME 32

/* An upper-case letter; other bytes stay as they are. */
static inline char sinumerik_upper(char byte)
{
	return byte >= 'a' && byte <= 'z' ? (char)(byte - 'a' + 'A') : byte;
}

static inline bool sinumerik_is_digit(char byte)
{
	return byte >= '0' && byte <= '9';
}

/* Letters and '_': what a name starts with. */
static inline bool sinumerik_is_letter(char byte)
{
	return (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') || byte == '_';
}

static inline bool sinumerik_is_name(char byte)
{
	return sinumerik_is_letter(byte) || sinumerik_is_digit(byte);
}

/* All of these read at the lexer's position. */

/*
 * A name in upper case: letters, digits and '_'; or with a '$' before it, a system variable. Its length, or 0 if none
 * comes next or it is too long; nothing was taken then. The name may have blanks before it.
 */
size_t sinumerik_name_read(struct lexer *lexer, char name[SINUMERIK_NAME + 1]);

/* Takes this name, in upper case, if it comes next as a whole. */
bool sinumerik_name_take(struct lexer *lexer, const char *name);

/* Takes the byte if it is the next that is no blank. */
bool sinumerik_name_take_byte(struct lexer *lexer, char byte);

/* Steps over "(...)", strings included, if '(' comes next. False: it is not closed, reported. */
bool sinumerik_name_step_over_call(struct lexer *lexer);

/* The byte has to come next; `after` says in the message behind what. */
bool sinumerik_name_need(struct lexer *lexer, char byte, const char *after);

#endif
