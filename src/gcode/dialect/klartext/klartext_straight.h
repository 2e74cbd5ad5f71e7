/* klartext_straight.h - L and LN: straight lines; blocks of M-functions alone; CYCL CALL POS. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_STRAIGHT_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_STRAIGHT_H

#include <stdbool.h>

#include "gcode/text/lexer.h"

/* L: a straight line with M-functions, or a block of M-functions, S and F alone. False: reported. */
bool klartext_straight_run(struct lexer *lexer);

/* LN: a straight line with a surface normal. */
bool klartext_straight_run_normal(struct lexer *lexer);

/* Behind CYCL CALL POS: rapids over the position; *shift is its Z in mm, by which the cycle is to be shifted. */
bool klartext_straight_cycle_position(struct lexer *lexer, double *shift);

#endif
