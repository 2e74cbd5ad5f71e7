#include "gcode/execute/spline_move.h"

#include <stdlib.h>

#include "base/mem.h"
#include "gcode/execute/cutter_comp/cutter_comp.h"
#include "gcode/execute/endpoint.h"
#include "gcode/execute/motion_commands.h"
#include "gcode/execute/rotated_frame.h"
#include "gcode/execute/spline.h"

static double length_of(const struct interp *interp, char letter)
{
	return block_value(&interp->block, letter) * interp->state.scale;
}

static bool make_pieces(struct interp *interp, const struct spline *spline)
{
	const size_t pieces = spline_piece_count(spline);
	struct canon_move move = {.kind = CANON_FEED};
	slot_values target = rotated_frame_straight(&interp->state);
	struct spline_piece piece;

	if (!motion_commands_feed(interp, &move.feed))
		return false;
	move.feed.seconds /= (double)pieces;
	for (size_t i = 0; i < pieces; i++) {
		if (!spline_piece_find(spline, i, &piece))
			return fault(
			    &interp->at, block_motion_column(&interp->block),
			    "this spline turns back on itself or has coincident points: it is not known how the "
			    "control moves there");
		target.v[SLOT_X] = piece.end.x;
		target.v[SLOT_Y] = piece.end.y;
		move.spread[0] = piece.beside.x;
		move.spread[1] = piece.beside.y;
		move.spread[2] = 0;
		if (!motion_commands_go(interp, &target, &move))
			return false;
	}
	return true;
}

/* LinuxCNC's manual, "G5 Cubic Spline": I and J may be omitted if the spline continues another one. */
static bool find_first(struct interp *interp, struct spline_point *first, struct spline_point start)
{
	const struct block *block = &interp->block;
	bool i = block_has(block, 'I'), j = block_has(block, 'J');
	const struct spline_memory *memory = &interp->spline;

	if (i != j)
		return fault(&interp->at, block_column(block, i ? 'I' : 'J'), "G5 needs both I and J, or none of them");
	if (!i && !memory->goes_on)
		return fault(&interp->at, block_motion_column(block), "the first G5 in a row needs I and J");
	first->at.x = start.at.x + (i ? length_of(interp, 'I') : -memory->p);
	first->at.y = start.at.y + (i ? length_of(interp, 'J') : -memory->q);
	return true;
}

static bool go_cubic(struct interp *interp, struct spline_point start, struct spline_point end)
{
	const struct block *block = &interp->block;
	struct spline_point points[4] = {start, start, end, end};

	if (!find_first(interp, &points[1], start))
		return false;
	if (!block_has(block, 'P') || !block_has(block, 'Q'))
		return fault(&interp->at, block_motion_column(block), "G5 needs P and Q");
	points[2].at.x += length_of(interp, 'P');
	points[2].at.y += length_of(interp, 'Q');
	if (!make_pieces(interp, &(struct spline){points, 4, 4, NULL}))
		return false;
	interp->spline.goes_on = true;
	interp->spline.p = length_of(interp, 'P');
	interp->spline.q = length_of(interp, 'Q');
	return true;
}

static bool go_quadratic(struct interp *interp, struct spline_point start, struct spline_point end)
{
	const struct block *block = &interp->block;
	struct spline_point points[3] = {start, start, end};

	if (!block_has(block, 'I') && !block_has(block, 'J'))
		return fault(&interp->at, block_motion_column(block), "G5.1 needs I or J");
	points[1].at.x += block_has(block, 'I') ? length_of(interp, 'I') : 0;
	points[1].at.y += block_has(block, 'J') ? length_of(interp, 'J') : 0;
	return make_pieces(interp, &(struct spline){points, 3, 3, NULL});
}

static bool add_point(struct interp *interp, struct spline_point point)
{
	struct spline_memory *memory = &interp->spline;
	const struct block *block = &interp->block;

	point.weight = block_has(block, 'P') ? block_value(block, 'P') : 1;
	if (!(point.weight > 0))
		return fault(&interp->at, block_column(block, 'P'),
			     "P (weight of a control point) must be greater than 0");
	if (memory->count == SPLINE_POINTS_MAX)
		return fault(&interp->at, block_motion_column(block), "more than %d control points after G5.2",
			     SPLINE_POINTS_MAX);
	if (!memory->points)
		memory->points = mem_alloc(SPLINE_POINTS_MAX * sizeof(*memory->points));
	memory->points[memory->count++] = point;
	return true;
}

/* LinuxCNC's manual, "G5.2 G5.3 NURBS Block": the first point is the present position, with the P of G5.2. */
static bool begin(struct interp *interp, struct spline_point start)
{
	const struct block *block = &interp->block;

	if (block->letters & AXIS_BITS)
		return fault(&interp->at, block_motion_column(block),
			     "G5.2 with axis words is not supported; its first control point is the present position");
	interp->spline.count = 0;
	interp->spline.order = 3;
	if (block_has(block, 'L') &&
	    !block_integer(block, &interp->at, 'L', 2, SPLINE_ORDER_MAX, &interp->spline.order))
		return false;
	interp->spline.open = true;
	interp->spline.nurbs = false;
	interp->state.motion = G5_2;
	return add_point(interp, start);
}

static bool finish(struct interp *interp)
{
	struct spline_memory *memory = &interp->spline;

	if (!memory->open)
		return fault(&interp->at, block_motion_column(&interp->block), "G5.3 without G5.2 before it");
	memory->open = false;
	interp->state.motion = CODE_NONE;
	if (memory->count < (size_t)memory->order)
		return fault(&interp->at, block_motion_column(&interp->block),
			     "a spline of order %d needs at least as many control points", memory->order);
	return make_pieces(interp, &(struct spline){memory->points, memory->count, memory->order, NULL});
}

static bool check_allowed(struct interp *interp)
{
	const struct state *state = &interp->state;
	const struct block *block = &interp->block;
	int column = block_motion_column(block);

	if (state->plane != G17)
		return fault(&interp->at, column, "a spline needs the plane of G17");
	if (state->incremental || state->tcp != TCP_OFF || cutter_comp_is_on(interp))
		return fault(
		    &interp->at, column,
		    "a spline is not supported in G91, under tool centre point control or under cutter compensation");
	for (int slot = SLOT_Z; slot < SLOT_COUNT; slot++) {
		if (block_has(block, AXIS_LETTERS[slot]))
			return fault(&interp->at, block_column(block, AXIS_LETTERS[slot]),
				     "%c with a spline, which moves only X and Y", AXIS_LETTERS[slot]);
	}
	return true;
}

static struct spline_point place(const slot_values *position)
{
	return (struct spline_point){{position->v[SLOT_X], position->v[SLOT_Y], 0}, 1};
}

bool spline_move_run(struct interp *interp)
{
	const int code = interp->block.motion;
	const bool opens = interp->block.g[G_MOTION] == G5_2;
	const slot_values here = rotated_frame_straight(&interp->state);
	const struct spline_point start = place(&here);
	slot_values target;

	if (!check_allowed(interp))
		return false;
	if (code == G5_3)
		return finish(interp);
	if (code == G5_2 && opens)
		return begin(interp, start);
	if (!endpoint_find(interp, false, &target))
		return false;
	if (code == G5_2)
		return add_point(interp, place(&target));
	interp->state.motion = code;
	return code == G5 ? go_cubic(interp, start, place(&target))
			  : go_quadratic(interp, start, place(&target));
}

/* Codes that change offsets, tools or the program would act before the curve, which is made after the last point. */
static bool has_codes(const struct block *block)
{
	for (int group = 0; group < G_GROUPS; group++) {
		if (block->g[group] != CODE_NONE)
			return true;
	}
	return block->m[M_TOOL] != CODE_NONE || block->m[M_TCP] != CODE_NONE || block->m[M_STOP] != CODE_NONE ||
	       block_has(block, 'H') || block_has(block, 'D');
}

static bool refuse_open(struct interp *interp)
{
	if (interp->spline.nurbs)
		return fault(&interp->at, 1,
			     "the curve of G6.2 is not complete: it needs control points with K, then as many blocks "
			     "with only K as its rank (P, or 4), and nothing else");
	return fault(&interp->at, 1, "only control points (X, Y and P) are allowed between G5.2 and G5.3");
}

bool spline_move_check_block(struct interp *interp)
{
	const int code = interp->block.motion;

	if (interp->block.motion != G5 && interp->block.motion != CODE_NONE)
		interp->spline.goes_on = false;
	if (!interp->spline.open || code == G5_3 || ((code == G5_2 || code == G6_2) && !has_codes(&interp->block)))
		return true;
	return refuse_open(interp);
}

bool spline_move_check_end(struct interp *interp)
{
	return !interp->spline.open || refuse_open(interp);
}
