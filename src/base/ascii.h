/* ascii.h - letters and digits as programs and files have them: ASCII, whatever the locale is. */
#ifndef FIVECHECK_BASE_ASCII_H
#define FIVECHECK_BASE_ASCII_H

#include <stdbool.h>

static inline bool ascii_is_digit(char byte)
{
	return byte >= '0' && byte <= '9';
}

static inline bool ascii_is_letter(char byte)
{
	return (byte >= 'A' && byte <= 'Z') || (byte >= 'a' && byte <= 'z');
}

/* The upper-case letter of a letter; other bytes stay as they are. */
static inline char ascii_upper(char byte)
{
	return byte >= 'a' && byte <= 'z' ? (char)(byte - 'a' + 'A') : byte;
}

/* The lower-case letter of a letter; other bytes stay as they are. */
static inline char ascii_lower(char byte)
{
	return byte >= 'A' && byte <= 'Z' ? (char)(byte - 'A' + 'a') : byte;
}

#endif
