/* builder_macro.h - calls of the machine builder's programs, whose effect the machine file defines. */
#ifndef FIVECHECK_GCODE_DIALECT_FANUC_BUILDER_MACRO_H
#define FIVECHECK_GCODE_DIALECT_FANUC_BUILDER_MACRO_H

#include <stdbool.h>

#include "gcode/dialect/fanuc/macro_b_state.h"

/* The machine file's entry for this program number, or for a G-code that calls a program; NULL: there is none. */
const struct builder_macro *builder_macro_of_program(const struct interp *interp, int number);
const struct builder_macro *builder_macro_of_code(const struct interp *interp, double code);

/*
 * MACRO_MOVE is carried out as a block: this fills the block with the straight move of the call. builder_macro_end
 * restores the modes.
 */
void builder_macro_begin(struct interp *interp);

/* Call after the block: carries out the moves of MACRO_AROUND and restores the modes. False: reported. */
bool builder_macro_end(struct interp *interp);

/* MACRO_AROUND: covers the whole box around the present position. False: reported at the column. */
bool builder_macro_around(struct interp *interp, const struct builder_macro *macro, int column);

#endif
