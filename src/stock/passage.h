/* passage.h - everything that a tool's piece passes on a straight way, as one obstacle that stands still. */
#ifndef FIVECHECK_STOCK_PASSAGE_H
#define FIVECHECK_STOCK_PASSAGE_H

#include <stdbool.h>

#include "geom/xform.h"
#include "stock/obstacle.h"

/*
 * Along its own axis a solid of revolution that widens upward passes the same solid with its top raised. Square to the
 * axis, whatever the solid, only the distance from the axis counts, at each height.
 */
struct passage {
	struct obstacle obstacle;
	struct revolved stretched;	/* owned */
	xform pose;	/* where the obstacle stands: its coordinates to the stock's */
	double error;	/* mm: the true way leaves the passage by less */
};

/*
 * The piece goes straight from one pose to another, without turning. False: the way is neither along its axis nor
 * square to it, to within `error` mm, or the piece is not of that kind.
 */
bool passage_init(struct passage *passage, const struct obstacle *obstacle, const xform *from, const xform *to,
		  double error);
void passage_release(struct passage *passage);

#endif
