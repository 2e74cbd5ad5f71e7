/* macro_b_call.h - calls of subprograms and macros: G65, G66, M97, M98, M99. */
#ifndef FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_CALL_H
#define FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_CALL_H

#include <stdbool.h>

#include "gcode/dialect/fanuc/macro_b_state.h"
#include "gcode/text/lexer.h"

/*
 * G65 and G66, behind which the lexer stands; `column` is the G's. *done is false if a block has to be carried out
 * for a program of the machine's builder (builder_macro.h). False: reported.
 */
bool macro_b_call_g65(struct interp *interp, struct lexer *lexer, int column, bool *done);
/* The same of a G-code that calls a program of the machine's builder. */
bool macro_b_call_by_code(struct interp *interp, struct lexer *lexer, int column, const struct builder_macro *macro,
			  bool *done);
bool macro_b_call_g66(struct interp *interp, struct lexer *lexer, int column);

/* "O100", "N10": the call's program; lives in the buffer, which has MACRO_B_TITLE bytes. */
#define MACRO_B_TITLE 16
const char *macro_b_call_title(const struct macro_b_call *call, char *buffer);

/* After a block that has been carried out: M97, M98 and M99 of it, or the call that G66 makes. False: reported. */
bool macro_b_call_after_block(struct interp *interp);

/* The file in hand has ended. False: inside of a subprogram, which was reported. */
bool macro_b_call_end_of_file(struct interp *interp);

/* The calls under way (struct dialect). */
bool macro_b_call_caller(const struct interp *interp, size_t level, struct srcloc *at, struct strbuf *title);

#endif
