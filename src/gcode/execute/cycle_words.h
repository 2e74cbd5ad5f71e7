/* cycle_words.h - words of canned cycles, which some controls keep from block to block. */
#ifndef FIVECHECK_GCODE_EXECUTE_CYCLE_WORDS_H
#define FIVECHECK_GCODE_EXECUTE_CYCLE_WORDS_H

#include <stdbool.h>

#include "gcode/execute/cycle_hole.h"

/*
 * The number of the word in the block; if the block has none and words are kept, of an earlier block of the cycle. The
 * number is kept for later blocks. False: there is no such word, which was reported.
 */
bool cycle_words_take(struct canned_cycle *cycle, char letter, bool kept, double *value);

/* Is there such a word? */
bool cycle_words_know(const struct canned_cycle *cycle, char letter, bool kept);

/* The number of the word, or 0 without the word. */
double cycle_words_or_zero(struct canned_cycle *cycle, char letter, bool kept);

#endif
