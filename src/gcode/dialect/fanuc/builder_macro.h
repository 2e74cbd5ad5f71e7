/* builder_macro.h - calls of programs of the machine's builder, of which the machine file says what they do. */
#ifndef FIVECHECK_GCODE_DIALECT_FANUC_BUILDER_MACRO_H
#define FIVECHECK_GCODE_DIALECT_FANUC_BUILDER_MACRO_H

#include <stdbool.h>

#include "gcode/dialect/fanuc/macro_b_state.h"

/* The machine file's answer to this program number, or to a G-code that calls one; NULL: it says nothing. */
const struct builder_macro *builder_macro_of_program(const struct interp *interp, int number);
const struct builder_macro *builder_macro_of_code(const struct interp *interp, double code);

/*
 * MACRO_MOVE is carried out as a block: this fills it with the straight move that the call stands for. What is modal
 * before is so afterwards (builder_macro_end).
 */
void builder_macro_begin(struct interp *interp);

/* The block has been carried out: MACRO_AROUND moves, and modes are as they were. False: reported. */
bool builder_macro_end(struct interp *interp);

/* MACRO_AROUND: all of the box around the present place is covered. False: reported at the column. */
bool builder_macro_around(struct interp *interp, const struct builder_macro *macro, int column);

#endif
