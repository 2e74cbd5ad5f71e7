/* klartext_string.h - string parameters QS: texts that programs join, and names in them. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_VALUES_KLARTEXT_STRING_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_VALUES_KLARTEXT_STRING_H

#include <stdbool.h>

#include "gcode/dialect/klartext/state/klartext_state.h"
#include "gcode/text/lexer.h"

/* Does a string parameter come next, "QS5"? */
bool klartext_string_follows(struct lexer *lexer);

/* Carries out QS1 = "A" || QS2, also after DECLARE STRING. False: reported. */
bool klartext_string_assign(struct lexer *lexer);
bool klartext_string_declare(struct lexer *lexer);

/*
 * Assigns a text to QS<number>; NULL: the control alone has it. False: it is too long, or there are too many, which was
 * reported at the column.
 */
bool klartext_string_set(struct lexer *lexer, int column, int number, const char *text);

/* Computes TONUMB, STRLEN, INSTR or STRCOMP if one of them comes next (*is_function). False: reported. */
bool klartext_string_compute(struct lexer *lexer, double *value, bool *is_function);

/* Like klartext_name; a string parameter may give the name, too. */
bool klartext_string_name(struct lexer *lexer, const char *what, char name[KLARTEXT_NAME]);

/* Call if the control has assigned unknown values to strings: the strings have no values any more. */
void klartext_string_forget(struct klartext *klartext);

#endif
