/* macro_b_seek.h - finds blocks and programs by their numbers, and goes there. */
#ifndef FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_SEEK_H
#define FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_SEEK_H

#include <stdbool.h>

#include "gcode/text/source.h"

struct interp;

/* The next line in hand is the one at `to`; loops that it leaves are closed. False: reported at the column. */
bool macro_b_seek_jump(struct interp *interp, const struct position *to, int column);

/*
 * To the block N<number> of the program in hand. Fanuc searches forward and then
 * from the start (B-63944EN, unconditional branch); Haas's manual does not say
 * in which order, so that there must be one such block only.
 */
bool macro_b_seek_goto(struct interp *interp, int number, int column);

/* The block N<number> of the program in hand, which must be the only one. */
bool macro_b_seek_only(struct interp *interp, int number, int column, struct position *found);

/* The line of the END that belongs to the DO of the line in hand. */
bool macro_b_seek_end(struct interp *interp, int number, int column, struct position *found);

/* The program O<number>: in the program's own file, in the one in hand, or in a file of its name. */
bool macro_b_seek_program(struct interp *interp, int number, int column, struct position *found);

/* *has: macro_b_seek_program would find a program O<number>. False: reported at the column. */
bool macro_b_seek_has_program(struct interp *interp, int number, int column, bool *has);

#endif
