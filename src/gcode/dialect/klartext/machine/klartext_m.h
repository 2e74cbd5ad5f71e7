/* klartext_m.h - the M-functions of a Heidenhain control, which act at the start or the end of a block. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_MACHINE_KLARTEXT_M_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_MACHINE_KLARTEXT_M_H

#include <stdbool.h>

#include "gcode/dialect/klartext/words/klartext_words.h"

/* Carries out S and the M-functions at the start of the block. False: reported, or the sink wants no more. */
bool klartext_m_start(struct interp *interp, const struct klartext_words *words);

/* Carries out the M-functions at the end of the block, including cycle calls. False: the same. */
bool klartext_m_end(struct interp *interp, const struct klartext_words *words);

/*
 * Checks that no M-function of the block acts at its end or moves an axis. With `ends`, M-functions at the end that
 * move no axis are allowed. False: reported; `where` describes the place of the block.
 */
bool klartext_m_check_harmless(struct interp *interp, const struct klartext_words *words, const char *where, bool ends);

/* M91 or M92 of the block, whose coordinates are then those of the machine; NULL: neither. */
static inline const struct klartext_m *klartext_m_machine(const struct klartext_words *words)
{
	const struct klartext_m *m = words->m_count ? klartext_words_m(words, 91) : NULL;

	return m || !words->m_count ? m : klartext_words_m(words, 92);
}

#endif
