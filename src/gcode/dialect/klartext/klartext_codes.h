/* klartext_codes.h - the M-functions and words of a Heidenhain control, and how each is treated. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_CODES_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_CODES_H

#include "gcode/code.h"

extern const struct code_set klartext_m_codes;
extern const struct word_set klartext_word_set;

#endif
