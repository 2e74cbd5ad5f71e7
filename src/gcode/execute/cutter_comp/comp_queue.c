#include "gcode/execute/cutter_comp/comp_queue.h"

#include <math.h>
#include <stdlib.h>

#include "base/math/math_functions.h"
#include "base/mem.h"
#include "base/units.h"
#include "geom/tolerance.h"

/* The most blocks between two moves in the plane. LinuxCNC has no limit, but no program needs so many. */
#define QUEUE_MAX 10000

/* mm: a compensated arc whose radii differ by more is an error (LinuxCNC, interp_queue.cc). */
#define RADIUS_TOLERANCE 0.01

void comp_queue_release(struct comp_queue *queue)
{
	for (size_t i = 0; i < queue->count; i++)
		free(queue->items[i].text);
	free(queue->items);
	*queue = (struct comp_queue){0};
}

bool comp_queue_add(struct comp_queue *queue, const struct comp_item *item)
{
	if (queue->count == QUEUE_MAX)
		return false;
	queue->items = mem_grow(queue->items, &queue->capacity, queue->count + 1, sizeof(*queue->items));
	queue->items[queue->count] = *item;
	if (item->move.origin)
		queue->items[queue->count].origin = *item->move.origin;
	queue->count++;
	return true;
}

/*
 * Radians: the compensated end of a full or nearly full circle may be this far past its start, because the common point
 * of tangential paths is known only to the square root of the rounding.
 */
#define ENDS_MEET 5e-4

static double sweep_to(const struct comp_queue *queue, const struct comp_item *item, struct plane_point end)
{
	double radius = math_hypot(queue->start.a - item->centre.a, queue->start.b - item->centre.b);
	double sweep = arc_sweep(queue->start, end, item->centre, item->clockwise, item->turns, SAME_POINT / radius);

	/* Compensation does not remove a full turn from an arc. */
	if (fabs(sweep) + 2 * PI <= item->programmed_sweep + ENDS_MEET)
		sweep += copysign(2 * PI, sweep);
	return sweep;
}

enum comp_end comp_queue_end_at(struct comp_queue *queue, struct plane_point end, double slack,
				const struct comp_item **faulty)
{
	for (size_t i = 0; i < queue->count; i++) {
		struct comp_item *item = &queue->items[i];

		*faulty = item;
		if (item->kind == COMP_LINE &&
		    item->direction.a * (end.a - queue->start.a) + item->direction.b * (end.b - queue->start.b) < 0)
			return COMP_END_BEFORE_START;
		if (item->kind == COMP_ARC) {
			double before = math_hypot(item->end.a - item->centre.a, item->end.b - item->centre.b);
			double after = math_hypot(end.a - item->centre.a, end.b - item->centre.b);

			if (fabs(before - after) > RADIUS_TOLERANCE)
				return COMP_END_OFF_ARC;
			if (item->programmed_sweep > 0 &&
			    fabs(sweep_to(queue, item, end)) > item->programmed_sweep + slack)
				return COMP_END_PAST_ARC;
		}
		item->end = end;
	}
	return COMP_END_GOOD;
}

void comp_queue_settle(struct comp_queue *queue, enum axis_slot a, enum axis_slot b)
{
	for (size_t i = 0; i < queue->count; i++) {
		struct comp_item *item = &queue->items[i];

		if (item->kind != COMP_LINE && item->kind != COMP_ARC)
			continue;
		item->move.end.v[a] = item->end.a;
		item->move.end.v[b] = item->end.b;
		if (item->kind == COMP_ARC)
			item->move.arc.sweep = sweep_to(queue, item, item->end);
	}
}
