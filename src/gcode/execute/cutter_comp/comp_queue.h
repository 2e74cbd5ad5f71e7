/* comp_queue.h - a queue of compensated moves that wait until the next corner determines their ends. */
#ifndef FIVECHECK_GCODE_EXECUTE_CUTTER_COMP_COMP_QUEUE_H
#define FIVECHECK_GCODE_EXECUTE_CUTTER_COMP_COMP_QUEUE_H

#include <stdbool.h>
#include <stddef.h>

#include "gcode/canon.h"
#include "gcode/execute/arc.h"

enum comp_item_kind {
	COMP_LINE,
	COMP_ARC,
	COMP_PAUSE,	/* a move without a path, such as a dwell */
	COMP_BLOCK	/* the end of a block, after its moves */
};

struct comp_item {
	enum comp_item_kind kind;
	struct canon_move move;	/* without its origin, which is: */
	struct canon_origin origin;	/* comp_queue_add copies it from the move; BLOCK: none */
	struct plane_point end;	/* LINE, ARC: the end; comp_queue_settle writes it into the move */
	struct plane_point direction;	/* LINE: of the programmed path; 0 without a move in the plane */
	struct plane_point centre;	/* ARC */
	bool clockwise;
	int turns;
	double programmed_sweep;	/* radians: the limit for the compensated arc; 0: no limit */
	char *text;	/* BLOCK; owned */
	struct call_chain callers;	/* BLOCK */
};

/* One move in the plane and all items before the next one. */
struct comp_queue {
	struct comp_item *items;	/* owned */
	size_t count, capacity;
	struct plane_point start;	/* of the first move */
};

void comp_queue_release(struct comp_queue *queue);

/* Appends a copy of the item. False: the queue is full. */
bool comp_queue_add(struct comp_queue *queue, const struct comp_item *item);

enum comp_end { COMP_END_GOOD, COMP_END_BEFORE_START, COMP_END_PAST_ARC, COMP_END_OFF_ARC };

/*
 * Ends every move of the queue at a point of the plane. An arc may exceed its limit by `slack` radians. On a fault
 * *faulty is the move that is not possible.
 */
enum comp_end comp_queue_end_at(struct comp_queue *queue, struct plane_point end, double slack,
				const struct comp_item **faulty);

/* Writes the ends into these two slots of the moves, and sets the sweep of the arcs. */
void comp_queue_settle(struct comp_queue *queue, enum axis_slot a, enum axis_slot b);

#endif
