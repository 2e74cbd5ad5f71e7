/* fanuc_macro.h - custom macro of Fanuc's controls. */
#ifndef FIVECHECK_GCODE_DIALECT_FANUC_FANUC_MACRO_H
#define FIVECHECK_GCODE_DIALECT_FANUC_FANUC_MACRO_H

#include "gcode/dialect/fanuc/macro_b_rules.h"

extern const struct macro_b_rules fanuc_macro_rules;

#endif
