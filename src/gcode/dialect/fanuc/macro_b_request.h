/* macro_b_request.h - the words of a macro call: its program, its repetitions and its arguments. */
#ifndef FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_REQUEST_H
#define FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_REQUEST_H

#include <stdbool.h>

#include "gcode/dialect/fanuc/macro_b_state.h"
#include "gcode/text/lexer.h"

/* The words of a G65 or G66 block. */
struct macro_b_request {
	int number, repeats;
	double arguments[MACRO_B_LOCALS + 1];
};

/*
 * Reads the words after the code of a call, whose column this is. `number`: the program that the code calls; 0: P names
 * it. False: reported.
 */
bool macro_b_request_read(struct interp *interp, struct lexer *lexer, int column, int number,
			  struct macro_b_request *request);

#endif
