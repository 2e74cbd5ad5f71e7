/* sinumerik_contour.h - CYCLE62 and CYCLE72: the tool follows a contour that another part of the program describes. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_CYCLES_SINUMERIK_CONTOUR_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_CYCLES_SINUMERIK_CONTOUR_H

#include "gcode/dialect/sinumerik/path/sinumerik_circle.h"

/* CYCLE62: selects the next contour by the arguments of the call. False: reported. */
bool sinumerik_contour_select(struct interp *interp, int column);

/*
 * CYCLE72: starts to follow the contour. The exact path of the tool is not known: it may be off by its radius plus the
 * allowance to either side, and at every height down to the depth; all of this is covered. False: reported.
 */
bool sinumerik_contour_mill(struct interp *interp, int column);

/* Do the moves of the current blocks describe a contour? Then sinumerik_contour_take carries them out. */
bool sinumerik_contour_is_read(const struct interp *interp);

/* While a contour is read: has the block only moves? False: it has other words, which was reported. */
bool sinumerik_contour_check(struct interp *interp, const struct sinumerik_block *block);

/* A move of the contour to a place in program coordinates; `circle` is NULL for a straight one. False: reported. */
bool sinumerik_contour_take(struct interp *interp, const slot_values *target, const struct sinumerik_circle *circle);

/* Has the contour ended, and is its CYCLE72 the current line again? */
bool sinumerik_contour_waits(struct interp *interp);

/* Makes the move back to the retraction plane. False: reported. */
bool sinumerik_contour_end(struct interp *interp);

#endif
