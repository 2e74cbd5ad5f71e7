/* klartext_free_words.h - the words of FK free contour programming. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_WORDS_KLARTEXT_FREE_WORDS_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_WORDS_KLARTEXT_FREE_WORDS_H

#include <stdbool.h>

#include "base/strbuf.h"
#include "gcode/dialect/klartext/state/klartext_paths.h"
#include "gcode/text/lexer.h"

/* Removes the words of the block before; the pole and the start of a closed contour stay. */
void klartext_free_words_clear(struct klartext_free *free);

/* Takes a word that refers to another element or to a point of the element, and returns it; NULL: none comes next. */
const char *klartext_free_words_relation(struct lexer *lexer);

/* Takes one word of FK; *taken: there was one. False: reported. */
bool klartext_free_words_take(struct lexer *lexer, struct klartext_free *free, bool *taken);

/* Moves the words of FK out of the line: blanks take their place in `rest`. False: reported. */
bool klartext_free_words_split(struct lexer *lexer, struct klartext_free *free, struct strbuf *rest);

#endif
