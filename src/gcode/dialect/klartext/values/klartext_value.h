/* klartext_value.h - numbers and Q parameters as values. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_VALUES_KLARTEXT_VALUE_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_VALUES_KLARTEXT_VALUE_H

#include <stdbool.h>

#include "gcode/dialect/klartext/state/klartext_state.h"
#include "gcode/text/lexer.h"

/* Reads a parameter, "Q5", "QL5" or "QR5", and its number; its value may be vacant. NULL: reported. */
struct klartext_q *klartext_q_find(struct lexer *lexer, int *number);

/* Reads a parameter and its value. False: it has none, or the value is not known, which was reported. */
bool klartext_q_read(struct lexer *lexer, double *value);

/* Assigns a value to Q<number> on behalf of the control. */
void klartext_q_set(struct klartext *klartext, int number, double value);

/* Call if the control has assigned an unknown value to Q<number>: its use is an error. */
void klartext_q_forget(struct klartext *klartext, int number);

/* The value of Q<number>; false: it has none. */
bool klartext_q_get(const struct klartext *klartext, int number, double *value);

/* "ID50 NR3 IDX1". */
void klartext_query_name(const struct klartext_query *query, char *name, size_t size);

/* Is the query for data of a table of the control that no program changes? */
bool klartext_query_is_table(const struct klartext_query *query);

/* Reads a number or a signed Q parameter. False: reported. */
bool klartext_value(struct lexer *lexer, double *value);

/* Does a number or a Q parameter come next? */
bool klartext_value_follows(struct lexer *lexer);

/* Reads a whole number in [least, greatest]. False: reported. */
bool klartext_integer(struct lexer *lexer, const char *what, int least, int greatest, int *value);

#endif
