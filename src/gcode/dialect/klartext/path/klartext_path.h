/* klartext_path.h - the common part of path blocks: words, M-functions, corners, the direction at the end. */
#ifndef FIVECHECK_GCODE_DIALECT_KLARTEXT_PATH_KLARTEXT_PATH_H
#define FIVECHECK_GCODE_DIALECT_KLARTEXT_PATH_KLARTEXT_PATH_H

#include <stdbool.h>

#include "gcode/dialect/klartext/moves/klartext_move.h"

/*
 * Carries out a path block: reads its words, carries out the functions at its start, lets `shape` compute the path
 * from words and target, makes the move, and carries out the functions at its end.
 */
typedef bool (*klartext_path_shape)(struct interp *interp, const struct klartext_words *words,
				    struct klartext_target *target, struct klartext_path *path);

/* False: reported, or the sink wants no more. */
bool klartext_path_run(struct lexer *lexer, klartext_path_shape shape);

/* Makes the move of a path in programmed coordinates, now or when the corner after it is known. False: the same. */
bool klartext_path_make(struct interp *interp, const struct klartext_words *words, const struct klartext_target *target,
			struct klartext_path *path);

#endif
