/* klartext_cycle_words.h - the words of a cycle: Q200=2, or X+10 and the like in the lines of older cycles. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_WORDS_KLARTEXT_CYCLE_WORDS_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_WORDS_KLARTEXT_CYCLE_WORDS_H

#include <stdbool.h>

#include "gcode/dialect/klartext/state/klartext_state.h"
#include "gcode/text/lexer.h"

/* Does a parameter with its number, "Q200", come next? */
bool klartext_cycle_words_is_q(struct lexer *lexer);

/* Adds the words up to the end of the line to the cycle: parameters if it is by_q. False: reported. */
bool klartext_cycle_words_read(struct lexer *lexer, struct klartext_cycle *cycle);

/* Adds a word. False: there is no room. */
bool klartext_cycle_words_add_axis(struct klartext_cycle *cycle, char letter, double value);

#endif
