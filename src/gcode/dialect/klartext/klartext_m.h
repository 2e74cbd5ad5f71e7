/* klartext_m.h - the M-functions of a Heidenhain control, those of a block's start and those of its end. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_M_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_M_H

#include <stdbool.h>

#include "gcode/dialect/klartext/klartext_words.h"

/* Carries out S and what takes effect at the start of the block. False: reported, or the sink wants no more. */
bool klartext_m_start(struct interp *interp, const struct klartext_words *words);

/* What takes effect at the end of the block, cycle calls included. False: the same. */
bool klartext_m_end(struct interp *interp, const struct klartext_words *words);

/*
 * Does no M-function of the block act at its end, or move an axis? With `ends` those of the end that move none may
 * stand there. False: reported, with `where` the block stands.
 */
bool klartext_m_check_harmless(struct interp *interp, const struct klartext_words *words, const char *where, bool ends);

/* M91 or M92 of the block, whose coordinates are then those of the machine; NULL: neither. */
static inline const struct klartext_m *klartext_m_machine(const struct klartext_words *words)
{
	const struct klartext_m *m = words->m_count ? klartext_words_m(words, 91) : NULL;

	return m || !words->m_count ? m : klartext_words_m(words, 92);
}

#endif
