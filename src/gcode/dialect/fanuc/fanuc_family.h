/* fanuc_family.h - rows of codes that Fanuc's and Haas's controls have in common. */
#ifndef FIVECHECK_GCODE_DIALECT_FANUC_FANUC_FAMILY_H
#define FIVECHECK_GCODE_DIALECT_FANUC_FANUC_FAMILY_H

#include "gcode/dialect.h"

extern const struct word_set fanuc_family_words;
extern const struct code_set fanuc_family_g_codes, fanuc_family_m_codes;

#endif
