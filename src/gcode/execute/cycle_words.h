/* cycle_words.h - words of canned cycles, which some controls keep from block to block. */
#ifndef FIVECHECK_GCODE_EXECUTE_CYCLE_WORDS_H
#define FIVECHECK_GCODE_EXECUTE_CYCLE_WORDS_H

#include <stdbool.h>

#include "gcode/execute/cycle_hole.h"

/*
 * The bare number of the word: of the block; without one, and if words are kept, of an earlier block of the cycle. It
 * is kept from now on. False: there is none, which was reported.
 */
bool cycle_words_take(struct canned_cycle *cycle, char letter, bool kept, double *value);

/* Is there such a word? */
bool cycle_words_know(const struct canned_cycle *cycle, char letter, bool kept);

/* The word, or 0 where there is none. */
double cycle_words_or_zero(struct canned_cycle *cycle, char letter, bool kept);

#endif
