/* klartext_codes.h - what becomes of the M-functions and the words of a Heidenhain control. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_CODES_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_CODES_H

#include "gcode/code.h"

extern const struct code_set klartext_m_codes;
extern const struct word_set klartext_word_set;

#endif
