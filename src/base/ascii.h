/* ascii.h - letters, digits and blanks as programs and files have them: ASCII, whatever the locale is. */
#ifndef FIVECHECK_BASE_ASCII_H
#define FIVECHECK_BASE_ASCII_H

#include <stdbool.h>
#include <stddef.h>

static inline bool ascii_is_digit(char byte)
{
	return byte >= '0' && byte <= '9';
}

static inline bool ascii_is_letter(char byte)
{
	return (byte >= 'A' && byte <= 'Z') || (byte >= 'a' && byte <= 'z');
}

static inline bool ascii_is_alphanumeric(char byte)
{
	return ascii_is_letter(byte) || ascii_is_digit(byte);
}

/* A blank, a tab, or one of the bytes that end lines and pages. */
static inline bool ascii_is_space(char byte)
{
	return byte == ' ' || (byte >= '\t' && byte <= '\r');
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

/* Are the texts the same, if a letter in upper case and in lower case are the same? */
bool ascii_same(const char *a, const char *b);

/* The same for the first `count` bytes; a text that ends before them is the same only if the other ends there, too. */
bool ascii_same_start(const char *a, const char *b, size_t count);

#endif
