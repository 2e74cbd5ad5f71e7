/* klartext_lexis.h - the lexical elements of a Klartext line: keywords, numbers, names, the end of the line. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_TEXT_KLARTEXT_LEXIS_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_TEXT_KLARTEXT_LEXIS_H

#include <stdbool.h>
#include <stddef.h>

#include "base/ascii.h"
#include "gcode/state.h"
#include "gcode/text/lexer.h"

/* Letters of the longest keyword. */
#define KLARTEXT_WORD 16

/* A lexer for the current line, whose context is the interpreter. */
struct lexer klartext_lexer(struct interp *interp);

/* Is the next byte a '~' that only blanks follow? */
bool klartext_ends_by_tilde(const struct lexer *lexer);

/* Has the rest of the line only a comment or the '~' that continues it? */
static inline bool klartext_ends(struct lexer *lexer)
{
	const char byte = lexer_peek(lexer);

	return byte == '\0' || byte == ';' || (byte == '~' && klartext_ends_by_tilde(lexer));
}

/* Checks that nothing more follows. False: reported. */
bool klartext_expect_end(struct lexer *lexer);

/* Does the next line continue this line? */
bool klartext_continues(const char *text);

/* Reads the next letters, in upper case; longer words are cut off. Returns their number. */
size_t klartext_word(struct lexer *lexer, char word[KLARTEXT_WORD]);

/* Consumes this upper-case word if it comes next and no letter follows, except a parameter, as in REPQ5. */
bool klartext_take(struct lexer *lexer, const char *word);

/* Reads a name in quotes, or up to the next blank. False: reported. */
bool klartext_name(struct lexer *lexer, const char *what, char *name, size_t size);

#endif
