/* linuxcnc_expr.h - values of LinuxCNC's programs: numbers, parameters, functions, expressions in brackets. */
#ifndef FIVECHECK_GCODE_DIALECT_LINUXCNC_LINUXCNC_EXPR_H
#define FIVECHECK_GCODE_DIALECT_LINUXCNC_LINUXCNC_EXPR_H

#include <stdbool.h>

#include "gcode/text/lexer.h"

/*
 * LinuxCNC's manual, "Expressions", "Binary Operators", "Functions",
 * "Parameters"; where the manual is silent, what rs274 does. All functions read
 * at the lexer's position and leave it behind what they have read. False: the
 * fault was reported. The context of the lexer is the struct interp.
 */

/* Of blocks and of control flow. */
extern const struct lexer_rules linuxcnc_lexer_rules;

/* A value in brackets; `what` says in the message what lacks them. */
bool linuxcnc_expr_bracket(struct lexer *lexer, const char *what, double *value);

/* A value within 0.0001 of a whole number. */
bool linuxcnc_expr_integer(struct lexer *lexer, int *value);

/*
 * False, reported at the column: value is 0 but for what LinuxCNC's rounding of pi makes of a sine, cosine or tangent;
 * so neither its sign nor whether it is 0 is known, and nothing may depend on them.
 */
bool linuxcnc_expr_sign_is_sure(const struct line_place *at, int column, double value);

/* "<name>", in lower case and without blanks, into a buffer of PARAM_NAME_MAX + 1 bytes. */
bool linuxcnc_expr_name(struct lexer *lexer, char *name);

#endif
