/* klartext_formula.h - assignments to Q parameters: formulas, FN 0 to FN 8 and FN 13; conditions of FN 9 to FN 12. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_VALUES_KLARTEXT_FORMULA_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_VALUES_KLARTEXT_FORMULA_H

#include <stdbool.h>

#include "gcode/text/lexer.h"

/* Reads Q5 = formula; the lexer is at the Q. False: reported. */
bool klartext_formula_assign(struct lexer *lexer);

/* Reads the text after the colon of FN 0 to FN 8 and FN 13. False: reported. */
bool klartext_formula_function(struct lexer *lexer, int number);

/*
 * Reads the text after the colon of FN 9 to FN 12: "IF Q1 EQU 5", or "IF Q1 IS UNDEFINED" of FN 9, up to GOTO. False:
 * reported; also if the result of the condition is not known.
 */
bool klartext_formula_condition(struct lexer *lexer, int number, bool *holds);

#endif
