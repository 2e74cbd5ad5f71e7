/* comp_queue.h - moves under cutter compensation that wait until the next corner determines where they end. */
#ifndef FIVECHECK_GCODE_EXECUTE_CUTTER_COMP_COMP_QUEUE_H
#define FIVECHECK_GCODE_EXECUTE_CUTTER_COMP_COMP_QUEUE_H

#include <stdbool.h>
#include <stddef.h>

#include "gcode/canon.h"
#include "gcode/execute/arc.h"

enum comp_item_kind {
	COMP_LINE,
	COMP_ARC,
	COMP_PAUSE,	/* a move that leads nowhere */
	COMP_BLOCK	/* the end of a block whose moves stand before it */
};

struct comp_item {
	enum comp_item_kind kind;
	struct canon_move move;	/* but for its origin, which is: */
	struct canon_origin origin;	/* comp_queue_add copies it from the move; BLOCK: none */
	struct plane_point end;	/* LINE, ARC: where the move ends; comp_queue_settle writes it into the move */
	struct plane_point direction;	/* LINE: of the programmed path; 0 if it does not move in the plane */
	struct plane_point centre;	/* ARC */
	bool clockwise;
	int turns;
	double programmed_sweep;	/* radians; the compensated arc may not turn farther. 0: it may */
	char *text;	/* BLOCK; owned */
	struct call_chain callers;	/* BLOCK */
};

/* One plane move and what follows it up to the next. */
struct comp_queue {
	struct comp_item *items;	/* owned */
	size_t count, capacity;
	struct plane_point start;	/* where the first move starts */
};

void comp_queue_release(struct comp_queue *queue);

/* Appends an item, which is filled in by the caller; false: there is no room for more. */
bool comp_queue_add(struct comp_queue *queue, const struct comp_item *item);

enum comp_end { COMP_END_GOOD, COMP_END_BEFORE_START, COMP_END_PAST_ARC, COMP_END_OFF_ARC };

/*
 * Ends every move of the queue at a point of the plane. An arc may turn `slack`
 * radians too far. On a fault *faulty is the move that cannot be made.
 */
enum comp_end comp_queue_end_at(struct comp_queue *queue, struct plane_point end, double slack,
				const struct comp_item **faulty);

/* Writes the ends into the moves, on these two slots, and gives the arcs their sweep. */
void comp_queue_settle(struct comp_queue *queue, enum axis_slot a, enum axis_slot b);

#endif
