/* klartext_formula.h - what assigns Q parameters: formulas, FN 0 to FN 8 and FN 13; what FN 9 to FN 12 ask. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_FORMULA_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_FORMULA_H

#include <stdbool.h>

#include "gcode/text/lexer.h"

/* Q5 = formula; the Q comes next. False: reported. */
bool klartext_formula_assign(struct lexer *lexer);

/* Behind the colon of FN 0 to FN 8 and FN 13. False: reported. */
bool klartext_formula_function(struct lexer *lexer, int number);

/*
 * Behind the colon of FN 9 to FN 12: "IF Q1 EQU 5", or "IF Q1 IS UNDEFINED" of FN 9, up to GOTO. False: reported, or
 * it is not known whether it holds, which was reported, too.
 */
bool klartext_formula_condition(struct lexer *lexer, int number, bool *holds);

#endif
