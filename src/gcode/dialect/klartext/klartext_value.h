/* klartext_value.h - numbers and Q parameters, wherever a value can stand. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_VALUE_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_KLARTEXT_VALUE_H

#include <stdbool.h>

#include "gcode/dialect/klartext/klartext_state.h"
#include "gcode/text/lexer.h"

/* The parameter that comes next: "Q5", "QL5", "QR5", and its number; its value may be vacant. NULL: reported. */
struct klartext_q *klartext_q_find(struct lexer *lexer, int *number);

/* The value of that parameter. False: it has none, or is not known, which was reported. */
bool klartext_q_read(struct lexer *lexer, double *value);

/* Gives Q<number> a value, as the control itself does. */
void klartext_q_set(struct klartext *klartext, int number, double value);

/* The control has given Q<number> a value that is not known here: using it is an error. */
void klartext_q_forget(struct klartext *klartext, int number);

/* The value of Q<number>; false: none was given. */
bool klartext_q_get(const struct klartext *klartext, int number, double *value);

/* "ID50 NR3 IDX1". */
void klartext_query_name(const struct klartext_query *query, char *name, size_t size);

/* Does it ask for data of a table of the control, which no program changes? */
bool klartext_query_is_table(const struct klartext_query *query);

/* A number or a signed Q parameter. False: reported. */
bool klartext_value(struct lexer *lexer, double *value);

/* Does a number or a Q parameter come next? */
bool klartext_value_follows(struct lexer *lexer);

/* A whole number in [least, greatest]. False: reported. */
bool klartext_integer(struct lexer *lexer, const char *what, int least, int greatest, int *value);

#endif
