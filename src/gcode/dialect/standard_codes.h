/* standard_codes.h - rows of codes with the same meaning on several controls. */
#ifndef FIVECHECK_GCODE_DIALECT_STANDARD_CODES_H
#define FIVECHECK_GCODE_DIALECT_STANDARD_CODES_H

#include "gcode/dialect.h"

/* A dialect has these only if its own table names them. */
extern const struct code_set standard_g_codes, standard_m_codes;

/* M0 to M9, the beginning of the standard M-codes. */
extern const struct code_set basic_m_codes;

#endif
