/* macro_b.h - statements of custom macro B: assignments, IF, WHILE, GOTO, macro calls. */
#ifndef FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_H
#define FIVECHECK_GCODE_DIALECT_FANUC_MACRO_B_H

#include <stdbool.h>

struct interp;

/*
 * Carries out the current line if it is a macro statement: then *done is true. All other lines, including M97, M98 and
 * M99, are blocks. False: reported.
 */
bool macro_b_line(struct interp *interp, bool *done);

/* Fills interp->block from the words of the current line; values may be variables and expressions. False: reported. */
bool macro_b_read_block(struct interp *interp);

#endif
