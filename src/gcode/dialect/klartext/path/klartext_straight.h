/* klartext_straight.h - L and LN: straight lines; blocks of M-functions only; CYCL CALL POS. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_PATH_KLARTEXT_STRAIGHT_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_PATH_KLARTEXT_STRAIGHT_H

#include <stdbool.h>

#include "gcode/text/lexer.h"

/* L: a straight line with M-functions, or a block with only M-functions, S and F. False: reported. */
bool klartext_straight_run(struct lexer *lexer);

/* LN: a straight line with a surface normal. */
bool klartext_straight_run_normal(struct lexer *lexer);

/* After CYCL CALL POS: moves above the position by rapids; *shift is its Z in mm, the shift of the cycle. */
bool klartext_straight_cycle_position(struct lexer *lexer, double *shift);

#endif
