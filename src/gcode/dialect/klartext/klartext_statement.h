/* klartext_statement.h - the kinds of blocks: the word that each begins with, and the function that carries it out. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_STATEMENT_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_STATEMENT_H

#include <stdbool.h>

#include "gcode/text/lexer.h"

/* Is this upper-case word the first one of a statement, or of a further line of a pattern's definition? */
bool klartext_statement_is_known(const char *word);

/* The same without the further lines of a pattern's definition, which are no blocks. */
bool klartext_statement_begins(const char *word);

/*
 * Does a positioning block without L begin with this word: "X+10 R0 FMAX", "R0 FMAX M99", "M3"? `behind` is the byte
 * after the word.
 */
bool klartext_statement_starts_word(const char *word, char behind);

/* Carries out a block that begins with a letter. *bare: no event is sent for it. False: reported. */
bool klartext_statement_run(struct lexer *lexer, bool *bare);

/* Carries out the text after END. False: reported. */
bool klartext_statement_end(struct lexer *lexer);

#endif
