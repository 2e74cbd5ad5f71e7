#include "gcode/execute/nurbs_move.h"

#include <math.h>

#include "base/mem.h"
#include "base/same_double.h"
#include "gcode/execute/endpoint.h"
#include "gcode/execute/motion_commands.h"
#include "gcode/execute/rotated_frame.h"
#include "gcode/execute/spline.h"
#include "geom/tolerance.h"

/* Fanuc 15i/150i-MA operator's manual (B-63324EN), "NURBS Interpolation (G06.2)". */
#define RANK_DEFAULT 4
#define RANK_MAX 4

/* mm: the greatest half width of a box, unless its piece is as short as this share of the interval between knots. */
#define BESIDE 1e-3
#define PART_MIN (1.0 / 4096)

static bool refuse(struct interp *interp, const char *why)
{
	return fault(&interp->at, block_motion_column(&interp->block), "%s", why);
}

/* Refuses what the manual does not allow, and what the boxes would not cover. */
static bool check_allowed(struct interp *interp)
{
	const struct state *state = &interp->state;
	const struct block *block = &interp->block;

	if (state->tcp != TCP_OFF || interp->comp.side != 0 || state->feed_mode != FEED_PER_MINUTE)
		return refuse(interp,
			      "G6.2 is not supported under tool centre point control, cutter compensation, G93 or G95");
	if (state->incremental || state->frame.on || state->polar.on)
		return refuse(interp, "G6.2 is not supported in G91 or in rotated, scaled or polar coordinates");
	if (block->m[M_TOOL] != CODE_NONE)
		return fault(&interp->at, block->m_column[M_TOOL], "M%d beside G6.2 is not supported; write two blocks",
			     block->m[M_TOOL]);
	for (int slot = SLOT_A; slot < SLOT_COUNT; slot++) {
		if (block_has(block, AXIS_LETTERS[slot]))
			return fault(&interp->at, block_column(block, AXIS_LETTERS[slot]),
				     "%c with G6.2 is not supported; its curve moves X, Y and Z", AXIS_LETTERS[slot]);
	}
	return true;
}

static bool begin(struct interp *interp)
{
	struct spline_memory *memory = &interp->spline;
	int rank = RANK_DEFAULT;

	if (block_has(&interp->block, 'P') && !block_integer(&interp->block, &interp->at, 'P', 2, RANK_MAX, &rank))
		return false;
	if (!memory->points)
		memory->points = mem_alloc(SPLINE_POINTS_MAX * sizeof(*memory->points));
	if (!memory->knots)
		memory->knots = mem_alloc((SPLINE_POINTS_MAX + RANK_MAX) * sizeof(*memory->knots));
	memory->open = memory->nurbs = true;
	memory->order = rank;
	memory->count = memory->knot_count = 0;
	memory->axes = 0;
	interp->state.motion = G6_2;
	return true;
}

static bool add_knot(struct interp *interp)
{
	struct spline_memory *memory = &interp->spline;
	double knot;

	if (!block_has(&interp->block, 'K'))
		return refuse(interp, "every block of G6.2 needs K (knot)");
	knot = block_value(&interp->block, 'K');
	if (memory->knot_count > 0 && knot < memory->knots[memory->knot_count - 1])
		return fault(&interp->at, block_column(&interp->block, 'K'),
			     "this knot (K) is smaller than the one before");
	memory->knots[memory->knot_count++] = knot;
	return true;
}

/* The manual: the first point is the present position of the tool, and each point names the axes of the curve. */
static bool add_point(struct interp *interp, vec3 here)
{
	struct spline_memory *memory = &interp->spline;
	const struct block *block = &interp->block;
	struct spline_point point = {here, 1};
	const uint32_t axes = block->letters & AXIS_BITS;
	slot_values target;

	if (memory->knot_count > memory->count + 1)
		return refuse(interp, "a control point of G6.2 after knots without points, which end the curve");
	if (memory->count == SPLINE_POINTS_MAX)
		return fault(&interp->at, block_motion_column(block), "more than %d control points in a G6.2 curve",
			     SPLINE_POINTS_MAX);
	if (!endpoint_find(interp, false, &target))
		return false;
	point.at = slot_values_linear(&target);
	if (memory->count == 0 && vec3_norm(vec3_sub(point.at, here)) > SAME_COORDINATE)
		return refuse(interp, "the first control point of G6.2 must be the present position");
	if (axes && memory->axes && axes != memory->axes)
		return refuse(interp,
			      "each control point of G6.2 needs a word for every axis of the curve and for no other "
			      "axis");
	memory->axes |= axes;
	/* The weight of a point without R is always 1. */
	if (block_has(block, 'R') && !(block->points & letter_bit('R')) &&
	    !same_double(interp->config->controller.least_input, 1))
		return fault(&interp->at, block_column(block, 'R'),
			     "R (weight of a control point) needs a decimal point: it is not known whether 1 means 1.0 "
			     "or one least input increment");
	if (block_has(block, 'R'))
		point.weight = block_value(block, 'R');
	if (!(point.weight > 0))
		return fault(&interp->at, block_column(block, 'R'),
			     "R (weight of a control point) must be greater than 0");
	memory->points[memory->count++] = point;
	return true;
}

/* Checks that the curve starts at its first point, ends at its last one, and is continuous. */
static bool check_knots(struct interp *interp)
{
	const struct spline_memory *memory = &interp->spline;
	const size_t order = (size_t)memory->order, last = memory->count;
	const double *knots = memory->knots;

	if (memory->count < order)
		return fault(&interp->at, block_motion_column(&interp->block),
			     "a G6.2 curve of rank %d needs at least as many control points", memory->order);
	if (!same_double(knots[0], knots[order - 1]) || !same_double(knots[last], knots[last + order - 1]))
		return fault(&interp->at, block_motion_column(&interp->block),
			     "the first and the last knot of a G6.2 curve of rank %d must occur %d times each",
			     memory->order, memory->order);
	for (size_t i = 0; i < last; i++) {
		if (i > 0 && same_double(knots[i], knots[i + order - 1]))
			return refuse(interp,
				      "a knot inside the G6.2 curve occurs too often: the curve would jump");
	}
	return true;
}

static double width(const struct spline_piece *piece)
{
	return fmax(fmax(piece->beside.x, piece->beside.y), piece->beside.z);
}

static bool make_piece(struct interp *interp, const struct spline_piece *piece, struct canon_move *move)
{
	slot_values target = rotated_frame_straight(&interp->state);

	slot_values_set_linear(&target, piece->end);
	move->spread[0] = piece->beside.x;
	move->spread[1] = piece->beside.y;
	move->spread[2] = piece->beside.z;
	return motion_commands_go(interp, &target, move);
}

/* The end of the next part; the last part is at least half as long as `least`. */
static double part_end(double u, double step, double last, double least)
{
	return last - u <= step + least / 2 ? last : u + step;
}

/* Follows the curve from a knot to the next one, in parts as long as their boxes allow. */
static bool follow_span(struct interp *interp, const struct spline *spline, size_t span, struct canon_move *move)
{
	const double last = spline->knots[span + 1], least = PART_MIN * (last - spline->knots[span]);
	double u = spline->knots[span], step = last - u;

	while (u < last) {
		double end = part_end(u, step, last, least);
		struct spline_piece piece = spline_part(spline, span, u, end);

		while (width(&piece) > BESIDE && step > least) {
			step /= 2;
			end = part_end(u, step, last, least);
			piece = spline_part(spline, span, u, end);
		}
		if (!make_piece(interp, &piece, move))
			return false;
		u = end;
		step *= 2;
	}
	return true;
}

static bool finish(struct interp *interp)
{
	struct spline_memory *memory = &interp->spline;
	const struct spline spline = {memory->points, memory->count, memory->order, memory->knots};
	struct canon_move move = {.kind = CANON_FEED};

	memory->open = false;
	interp->state.motion = CODE_NONE;
	if (!check_knots(interp) || !motion_commands_feed(interp, &move.feed))
		return false;
	for (size_t span = (size_t)spline.order - 1; span < spline.count; span++) {
		if (spline.knots[span + 1] > spline.knots[span] && !follow_span(interp, &spline, span, &move))
			return false;
	}
	return true;
}

bool nurbs_move_run(struct interp *interp)
{
	struct spline_memory *memory = &interp->spline;
	const struct block *block = &interp->block;
	const bool opens = block->g[G_MOTION] == G6_2;
	const slot_values here = rotated_frame_straight(&interp->state);

	if (!check_allowed(interp) || (opens && !begin(interp)))
		return false;
	if (!opens && block_has(block, 'P'))
		return fault(&interp->at, block_column(block, 'P'),
			     "P (rank of the curve) is allowed only in the block with G6.2");
	if (!add_knot(interp))
		return false;
	if (opens || (block->letters & AXIS_BITS))
		return add_point(interp, slot_values_linear(&here));
	if (block_has(block, 'R'))
		return fault(&interp->at, block_column(block, 'R'), "a weight (R) without a control point");
	return memory->knot_count < memory->count + (size_t)memory->order || finish(interp);
}
