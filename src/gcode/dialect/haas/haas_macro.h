/* haas_macro.h - custom macro of Haas's controls. */
#ifndef FIVECHECK_GCODE_DIALECT_HAAS_HAAS_MACRO_H
#define FIVECHECK_GCODE_DIALECT_HAAS_HAAS_MACRO_H

#include "gcode/dialect/fanuc/macro_b_rules.h"

extern const struct macro_b_rules haas_macro_rules;

#endif
