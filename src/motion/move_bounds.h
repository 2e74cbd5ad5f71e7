/* move_bounds.h - what is computed of a move at all: how far it may go, how long it may take, how curved it may be. */
#ifndef FIVECHECK_MOTION_MOVE_BOUNDS_H
#define FIVECHECK_MOTION_MOVE_BOUNDS_H

#include <stdbool.h>

#include "base/diag.h"
#include "gcode/canon.h"
#include "motion/path.h"

/* Each returns false when the move is beyond, which it reports; `program` is the file of moves that name none. */

/* Its place in its file. */
static inline struct srcloc move_place(const struct canon_move *move, const char *program)
{
	return (struct srcloc){move->file ? move->file : program, move->line, 0};
}

/* Are its end and its arc no farther than 1e7 mm or radians? */
bool move_is_in_reach(const struct canon_move *move, struct diag *diag, const char *program);

/* Does it take at most 1e9 seconds? */
bool move_is_bearable(const struct canon_move *move, double seconds, struct diag *diag, const char *program);

/* Do at most 1e8 straight pieces keep its path within flatness (mm, radians)? */
bool move_is_countable(const struct canon_move *move, const struct path *path, double flatness, struct diag *diag,
		       const char *program);

#endif
