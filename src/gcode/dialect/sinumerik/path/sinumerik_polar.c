#include "gcode/dialect/sinumerik/path/sinumerik_polar.h"

#include <math.h>

#include "base/math/math_functions.h"
#include "base/units.h"
#include "gcode/dialect/sinumerik/frames/sinumerik_frame.h"
#include "gcode/dialect/sinumerik/frames/sinumerik_open_place.h"
#include "gcode/dialect/sinumerik/frames/sinumerik_place_check.h"
#include "gcode/execute/cutter_comp/comp_moves.h"

/* A line whose slope to the other axis is less does not determine the coordinate. */
#define LEAST_SLOPE 1e-9

static char letter_a(const struct interp *interp)
{
	return AXIS_LETTERS[comp_slot_a(interp)];
}

static char letter_b(const struct interp *interp)
{
	return AXIS_LETTERS[comp_slot_b(interp)];
}

/* A pole belongs to the plane in which it was given. In every plane the first pole is the workpiece zero. */
struct plane_point sinumerik_polar_pole(const struct interp *interp)
{
	const struct sinumerik_polar *polar = &sinumerik_of(interp)->polar;

	return polar->plane == interp->state.plane ? polar->pole : (struct plane_point){0, 0};
}

/* RP is modal, absolute and not negative. AP is relative to the first axis of the plane, or with IC to the last AP. */
static bool take_words(struct interp *interp, const struct sinumerik_block *block)
{
	struct sinumerik_polar *polar = &sinumerik_of(interp)->polar;
	const enum sinumerik_way radius_way = (enum sinumerik_way)block->address_way[SINUMERIK_RP];
	const enum sinumerik_way way = (enum sinumerik_way)block->address_way[SINUMERIK_AP];
	const bool radius = sinumerik_block_has_address(block, SINUMERIK_RP);
	const bool angle = sinumerik_block_has_address(block, SINUMERIK_AP);
	const int column = block->address_column[radius ? SINUMERIK_RP : SINUMERIK_AP];

	if (radius && (radius_way > SINUMERIK_WAY_AC || block->address_value[SINUMERIK_RP] < 0))
		return fault(&interp->at, column, "RP= is an absolute radius that is not negative");
	if (!radius && !polar->has_radius)
		return fault(&interp->at, column, "AP= without any RP= before");
	if (!angle && !polar->has_angle)
		return fault(&interp->at, column, "RP= without any AP= before");
	if (angle && way == SINUMERIK_WAY_MODAL && interp->state.incremental)
		return fault(&interp->at, column, "AP= under G91: write AP=AC() or AP=IC()");
	if (angle && way == SINUMERIK_WAY_IC && !polar->has_angle)
		return fault(&interp->at, column, "AP=IC() without any AP= before");
	if (radius)
		polar->radius = block->address_value[SINUMERIK_RP] * interp->state.scale;
	if (angle)
		polar->angle = block->address_value[SINUMERIK_AP] + (way == SINUMERIK_WAY_IC ? polar->angle : 0);
	polar->has_radius = polar->has_angle = true;
	return true;
}

static struct plane_point away(const struct interp *interp, struct plane_point from)
{
	const struct sinumerik_polar *polar = &sinumerik_of(interp)->polar;

	return (struct plane_point){from.a + polar->radius * math_cos(radians(polar->angle)),
				    from.b + polar->radius * math_sin(radians(polar->angle))};
}

bool sinumerik_polar_find(struct interp *interp, const struct sinumerik_block *block, slot_values *target)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	const enum axis_slot a = comp_slot_a(interp), b = comp_slot_b(interp);
	struct plane_point end;

	if (sinumerik_block_has(block, letter_a(interp)) || sinumerik_block_has(block, letter_b(interp)))
		return fault(&interp->at, sinumerik_block_axis_column(block),
			     "AP= and RP= stand in place of the coordinates %c and %c", letter_a(interp),
			     letter_b(interp));
	if (!take_words(interp, block))
		return false;
	end = away(interp, sinumerik_polar_pole(interp));
	target->v[a] = end.a;
	target->v[b] = end.b;
	sinumerik->place.shifted[a] = sinumerik->place.shifted[b] = false;
	return true;
}

bool sinumerik_polar_is_shifted(const struct interp *interp)
{
	const struct sinumerik *sinumerik = sinumerik_of(interp);

	return sinumerik->place.shifted[comp_slot_a(interp)] || sinumerik->place.shifted[comp_slot_b(interp)];
}

bool sinumerik_polar_find_line(struct interp *interp, const struct sinumerik_block *block, bool shifted,
			       slot_values *target)
{
	const enum axis_slot a = comp_slot_a(interp), b = comp_slot_b(interp);
	const bool by_a = sinumerik_block_has(block, letter_a(interp));
	const bool by_b = sinumerik_block_has(block, letter_b(interp));
	const double angle = block->address_value[SINUMERIK_ANG];
	const double direction[2] = {math_cos_degrees(angle), math_sin_degrees(angle)};
	const int column = block->address_column[SINUMERIK_ANG];
	const double known = direction[by_a ? 0 : 1], sought = direction[by_a ? 1 : 0];
	const slot_values *place = sinumerik_frame_place(interp);
	double way;

	if (by_a == by_b || (block->addresses & SINUMERIK_POLAR_BITS))
		return fault(&interp->at, column,
			     "ANG= is supported beside one coordinate of the plane, %c or %c; where two blocks "
			     "determine each other, write the point where they meet",
			     letter_a(interp), letter_b(interp));
	if (block->address_way[SINUMERIK_ANG] != SINUMERIK_WAY_MODAL)
		return fault(&interp->at, column, "ANG= is an angle from the first axis of the plane");
	if (!sinumerik_open_place_check(interp, column, "a line by ANG="))
		return false;
	if (shifted)
		return fault(&interp->at, column,
			     "ANG= after a change of frames, offsets or the tool: where the line begins depends on "
			     "settings of the control; write a whole position first");
	way = target->v[by_a ? a : b] - place->v[by_a ? a : b];
	if (!(known * way > 0) || fabs(known) < LEAST_SLOPE)
		return fault(&interp->at, column, "a line at %.9g degrees does not lead to this coordinate", angle);
	target->v[by_a ? b : a] = place->v[by_a ? b : a] + way * sought / known;
	return true;
}

/* Does the block give the position of the pole? False: reported. */
static bool names_pole(const struct interp *interp, const struct sinumerik_block *block)
{
	const int code = block->code[SINUMERIK_ONCE], column = block->code_column[SINUMERIK_ONCE];
	const unsigned axes = block->letters & AXIS_BITS, polar = block->addresses & SINUMERIK_POLAR_BITS;
	const char a = letter_a(interp), b = letter_b(interp);

	if (interp->state.unknown_modes & (1U << G_PLANE | 1U << G_UNITS))
		return fault(&interp->at, column, "a pole needs G17, G18 or G19, and G70, G71, G700 or G710 before it");
	if (axes & ~(letter_bit(a) | letter_bit(b)))
		return fault(&interp->at, column, "G%d has coordinates of the plane only, %c and %c", code / 10, a, b);
	if (polar && (axes || polar != SINUMERIK_POLAR_BITS))
		return fault(&interp->at, column, "a pole has AP= and RP=, or coordinates");
	if (!polar && !axes)
		return fault(&interp->at, column, "G%d needs the coordinates of the pole", code / 10);
	return true;
}

/* G110 is relative to the position of the tool, G111 to the workpiece zero, G112 to the last pole. */
bool sinumerik_polar_set_pole(struct interp *interp, const struct sinumerik_block *block)
{
	struct sinumerik_polar *polar = &sinumerik_of(interp)->polar;
	const int code = block->code[SINUMERIK_ONCE], column = block->code_column[SINUMERIK_ONCE];
	const slot_values *place = sinumerik_frame_place(interp);
	const char a = letter_a(interp), b = letter_b(interp);
	struct plane_point from = {0, 0};

	if (!names_pole(interp, block))
		return false;
	if (code == SINUMERIK_G(110) &&
	    (!sinumerik_open_place_check(interp, column, "a pole (G110)") ||
	     !sinumerik_place_check(interp, comp_slot_a(interp), column) ||
	     !sinumerik_place_check(interp, comp_slot_b(interp), column)))
		return false;
	if (code == SINUMERIK_G(110))
		from = (struct plane_point){place->v[comp_slot_a(interp)], place->v[comp_slot_b(interp)]};
	else if (code == SINUMERIK_G(112))
		from = sinumerik_polar_pole(interp);
	if (block->addresses & SINUMERIK_POLAR_BITS) {
		if (!take_words(interp, block))
			return false;
		from = away(interp, from);
	}
	if (sinumerik_block_has(block, a))
		from.a += block->value[a - 'A'] * interp->state.scale;
	if (sinumerik_block_has(block, b))
		from.b += block->value[b - 'A'] * interp->state.scale;
	polar->pole = from;
	polar->plane = interp->state.plane;
	return true;
}
