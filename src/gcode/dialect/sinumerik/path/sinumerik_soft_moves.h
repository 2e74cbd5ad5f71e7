/* sinumerik_soft_moves.h - the heights, speeds and moves of a soft approach or retraction. */
#ifndef FIVECHECK_GCODE_DIALECT_SINUMERIK_PATH_SINUMERIK_SOFT_MOVES_H
#define FIVECHECK_GCODE_DIALECT_SINUMERIK_PATH_SINUMERIK_SOFT_MOVES_H

#include "gcode/dialect/sinumerik/block/sinumerik_block.h"
#include "gcode/dialect/sinumerik/path/sinumerik_soft_path.h"

/* Functions that can fail report the reason and return false. Positions are straight (rotated_frame.h), in mm. */

/* Reads DISCL and DISRP of the block. */
bool sinumerik_soft_moves_read_heights(struct interp *interp, const struct sinumerik_block *block,
				       struct sinumerik_soft_words *words);

/* The heights of P1 and P2, where those of P4 and P0 are `base` and `outer`; NAN: the motion ends in P2. */
bool sinumerik_soft_moves_find_heights(struct interp *interp, const struct sinumerik_soft_words *words, double base,
				       double outer, double *upper, double *lower);

/* Finds the speeds that the block gives, and that of the block before it. */
bool sinumerik_soft_moves_find_feeds(struct interp *interp, const struct sinumerik_block *block,
				     struct sinumerik_soft_words *words);

/* Sets the position without a move. */
void sinumerik_soft_moves_put_at(struct interp *interp, const slot_values *straight);

/* A point of the plane at a height; the other axes are those of `like`. */
slot_values sinumerik_soft_moves_place(const struct interp *interp, const slot_values *like, struct plane_point point,
				       double height);

/* A straight move, if the tool is not there; without a feed it is a rapid. */
bool sinumerik_soft_moves_line(struct interp *interp, const slot_values *target, const struct canon_feed *feed);

/* The path between P3 and P4, in one direction or the other. */
bool sinumerik_soft_moves_path(struct interp *interp, const slot_values *target, const struct sinumerik_soft_path *path,
			       const struct canon_feed *feed);

#endif
