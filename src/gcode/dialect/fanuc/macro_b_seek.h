/* macro_b_seek.h - finds blocks and programs by their numbers, and jumps there. */
#ifndef FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_SEEK_H
#define FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_SEEK_H

#include <stdbool.h>

#include "gcode/text/source.h"

struct interp;

/* Jumps to the line at `to`; loops that the jump leaves are closed. False: reported at the column. */
bool macro_b_seek_jump(struct interp *interp, const struct position *to, int column);

/*
 * Jumps to the block N<number> of the current program. Fanuc searches forward and then from the start (B-63944EN,
 * unconditional branch); Haas's manual does not give the order, so the block must be unique.
 */
bool macro_b_seek_goto(struct interp *interp, int number, int column);

/* Finds the block N<number> of the current program, which must be unique. */
bool macro_b_seek_only(struct interp *interp, int number, int column, struct position *found);

/* Finds the line of the END that belongs to the DO of the current line. */
bool macro_b_seek_end(struct interp *interp, int number, int column, struct position *found);

/* Finds the program O<number>: in the main program's file, in the current file, or in a file of its name. */
bool macro_b_seek_program(struct interp *interp, int number, int column, struct position *found);

/* *has: macro_b_seek_program would find a program O<number>. False: reported at the column. */
bool macro_b_seek_has_program(struct interp *interp, int number, int column, bool *has);

#endif
