/* move_spread.h - how far the axes may be beside the path of a move of which only a set of paths is known. */
#ifndef FIVECHECK_MOTION_MOVE_SPREAD_H
#define FIVECHECK_MOTION_MOVE_SPREAD_H

#include "gcode/canon.h"
#include "machine/machine.h"
#include "motion/path.h"
#include "motion/tcp.h"

struct move_spread {
	bool acts;	/* the axes may be beside the path in a way that counts for the limits, by `room` */
	bool turns;	/* a rotary axis may be beside its path */
	axis_values room;	/* mm, radians; defined if `acts` */
};

/*
 * The spread of a move from this position of the machine's axes; `tcp` is used if the move is under TCP. Adds to
 * *tolerance how far the axes may be beside the path.
 */
void move_spread_find(struct move_spread *spread, const struct machine *machine, const struct tcp *tcp,
		      const axis_values *position, const struct canon_move *move, axis_values *tolerance);

/*
 * For a spread that turns, of a move under TCP: adds how far the linear axes follow the rotary ones, which depends on
 * the path, to the room and to *tolerance.
 */
void move_spread_follow(struct move_spread *spread, const struct tcp *tcp, const struct canon_move *move,
			const struct path *path, axis_values *tolerance);

#endif
