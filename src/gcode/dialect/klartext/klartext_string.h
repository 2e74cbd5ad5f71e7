/* klartext_string.h - string parameters QS: texts that programs join, and names that they give. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_STRING_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_STRING_H

#include <stdbool.h>

#include "gcode/dialect/klartext/klartext_state.h"
#include "gcode/text/lexer.h"

/* Does a string parameter come next, "QS5"? */
bool klartext_string_follows(struct lexer *lexer);

/* Carries out QS1 = "A" || QS2, also behind DECLARE STRING. False: reported. */
bool klartext_string_assign(struct lexer *lexer);
bool klartext_string_declare(struct lexer *lexer);

/* Gives QS<number> a text. False: it is too long, or there are too many, which was reported at the column. */
bool klartext_string_set(struct lexer *lexer, int column, int number, const char *text);

/* Behind TONUMB: "( SRC_QS5 )", the number that the string is. False: reported. */
bool klartext_string_number(struct lexer *lexer, double *value);

/* As klartext_name; a string parameter gives the name, too. */
bool klartext_string_name(struct lexer *lexer, const char *what, char name[KLARTEXT_NAME]);

/* The control has given strings values that are not known here: they have none any more. */
void klartext_string_forget(struct klartext *klartext);

#endif
