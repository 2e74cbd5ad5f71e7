#include "gcode/execute/cycle_words.h"

bool cycle_words_take(struct canned_cycle *cycle, char letter, bool kept, double *value)
{
	struct interp *interp = cycle->interp;
	struct cycle_memory *memory = &interp->state.cycle;
	bool given = block_has(&interp->block, letter);

	if (!given && !(kept && (memory->known & letter_bit(letter))))
		return fault(&interp->at, block_motion_column(&interp->block), "G%g needs %c", cycle->code / 10.0,
			     letter);
	*value = given ? block_value(&interp->block, letter) : memory->word[letter - 'A'];
	memory->known |= letter_bit(letter);
	memory->word[letter - 'A'] = *value;
	return true;
}

bool cycle_words_know(const struct canned_cycle *cycle, char letter, bool kept)
{
	return block_has(&cycle->interp->block, letter) ||
	       (kept && (cycle->interp->state.cycle.known & letter_bit(letter)));
}

double cycle_words_or_zero(struct canned_cycle *cycle, char letter, bool kept)
{
	double value = 0;

	if (cycle_words_know(cycle, letter, kept))
		cycle_words_take(cycle, letter, kept, &value);
	return value;
}
