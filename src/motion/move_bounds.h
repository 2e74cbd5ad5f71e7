/* move_bounds.h - the limits of what is computed for a move: length, duration, curvature. */
#ifndef FIVECHECK_MOTION_MOVE_BOUNDS_H
#define FIVECHECK_MOTION_MOVE_BOUNDS_H

#include <stdbool.h>

#include "base/diag.h"
#include "gcode/canon.h"
#include "motion/path.h"

/* Each returns false if the move exceeds the limit, which it reports; `program` is the file of moves without one. */

/* The place of the move in its file. */
static inline struct srcloc move_place(const struct canon_move *move, const char *program)
{
	return (struct srcloc){move->file ? move->file : program, move->line, 0};
}

/* Are the end and the arc no farther than 1e7 mm or radians? */
bool move_is_in_reach(const struct canon_move *move, struct diag *diag, const char *program);

/* Does the move take at most 1e9 seconds? */
bool move_is_bearable(const struct canon_move *move, double seconds, struct diag *diag, const char *program);

/* Are at most 1e8 straight pieces enough for its path within flatness (mm, radians)? */
bool move_is_countable(const struct canon_move *move, const struct path *path, double flatness, struct diag *diag,
		       const char *program);

#endif
