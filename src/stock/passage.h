/* passage.h - everything that a tool's piece sweeps along a straight path, as one obstacle at rest. */
#ifndef FIVECHECK_STOCK_PASSAGE_H
#define FIVECHECK_STOCK_PASSAGE_H

#include <stdbool.h>

#include "geom/xform.h"
#include "stock/obstacle.h"

/*
 * Along its own axis a solid of revolution that widens upward sweeps the same solid with its top raised. Perpendicular
 * to the axis, for any such solid, only the distance from the axis counts, at each height.
 */
struct passage {
	struct obstacle obstacle;
	struct revolved stretched;	/* owned */
	xform pose;	/* the obstacle's coordinates to the stock's */
	double error;	/* mm: the true path leaves the passage by less */
};

/*
 * The piece moves straight from one pose to another, without turning. False: the path is neither along its axis nor
 * perpendicular to it, to within `error` mm, or the piece is not of this kind.
 */
bool passage_init(struct passage *passage, const struct obstacle *obstacle, const xform *from, const xform *to,
		  double error);
void passage_release(struct passage *passage);

#endif
