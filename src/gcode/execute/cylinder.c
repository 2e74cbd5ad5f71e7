#include "gcode/execute/cylinder.h"

#include <math.h>

#include "base/math/math_functions.h"
#include "base/same_double.h"
#include "base/units.h"
#include "gcode/execute/arc.h"
#include "gcode/execute/cutter_comp/cutter_comp.h"
#include "gcode/execute/endpoint.h"
#include "gcode/execute/motion_commands.h"
#include "gcode/execute/rotated_frame.h"

/* mm: the greatest distance of a piece of an arc from its chord. A smaller value: a tighter proof, more pieces. */
#define BESIDE 0.002
#define PIECES_MAX 100000

/*
 * Fanuc B-64484EN, "Cylindrical Interpolation": G7.1 with the rotary axis and the radius of the cylinder starts it,
 * G7.1 with 0 ends it. The word is a length.
 */
bool cylinder_switch(struct interp *interp)
{
	struct state *state = &interp->state;
	const struct block *block = &interp->block;
	const double increment = interp->config->controller.least_input;
	int slot = -1, words = 0, column = block->g_column[G_NONMODAL];
	double radius;
	char letter;

	for (int i = 0; i < SLOT_COUNT; i++) {
		words += block_has(block, AXIS_LETTERS[i]);
		slot = block_has(block, AXIS_LETTERS[i]) ? i : slot;
	}
	if (words != 1 || !slot_is_rotary(slot))
		return fault(&interp->at, column,
			     "G7.1 needs one rotary axis, with the radius of the cylinder, or 0 to cancel");
	letter = AXIS_LETTERS[slot];
	/* The word was read as an angle: in inches, an increment of a length is smaller. */
	if (!(block->points & letter_bit(letter)) && state->scale > 1 && increment < 1 &&
	    !same_double(block_value(block, letter), 0))
		return fault(&interp->at, block_column(block, letter),
			     "the radius of G7.1 in inches without a decimal point is not supported; write the point");
	radius = block_value(block, letter) * state->scale;
	if (state->tcp != TCP_OFF || state->frame.on || state->polar.on || cutter_comp_is_on(interp))
		return fault(&interp->at, column,
			     "G7.1 is not supported in changed coordinates, under tool centre point control or under "
			     "cutter compensation");
	if (radius < 0 || (radius > 0 && state->cylinder.on))
		return fault(&interp->at, column,
			     radius < 0 ? "the radius of G7.1 must not be negative"
					: "G7.1 inside another G7.1; cancel the first one before");
	state->cylinder = (struct cylinder){.on = radius > 0, .slot = slot, .radius = radius};
	return true;
}

/* The same section: no positioning, canned cycles, offsets or reference positions; compensation is not supported. */
bool cylinder_check_block(struct interp *interp)
{
	const struct block *block = &interp->block;
	const int groups[] = {G_CUTTER,	 G_LENGTH, G_SYSTEM,   G_ROTATION, G_MIRROR,
			      G_SCALING, G_POLAR,  G_APPROACH, G_UNITS};
	int code = block->g[G_NONMODAL];

	if (!interp->state.cylinder.on || code == G7_1)
		return true;
	for (size_t i = 0; i < sizeof(groups) / sizeof(groups[0]); i++) {
		int given = block->g[groups[i]];

		if (given != CODE_NONE && given != G40 && given != G69 && given != G50 && given != G15)
			return fault(&interp->at, block->g_column[groups[i]],
				     "G%g under cylindrical interpolation (G7.1) is not supported", given / 10.0);
	}
	if (code != CODE_NONE && code != G4)
		return fault(&interp->at, block->g_column[G_NONMODAL],
			     "G%g under cylindrical interpolation (G7.1); cancel G7.1 first", code / 10.0);
	if (block->m[M_TOOL] != CODE_NONE || block->m[M_TCP] != CODE_NONE || block_has(block, 'H') || block->corner)
		return fault(&interp->at, 1,
			     "a tool, its length or a corner with ,C or ,R under cylindrical interpolation (G7.1) is "
			     "not supported");
	if (block->motion == CODE_NONE || block->motion == G80 || (block->motion >= G1 && block->motion <= G3))
		return true;
	return fault(&interp->at, block_motion_column(block),
		     "G%g under cylindrical interpolation (G7.1), which allows only feed moves", block->motion / 10.0);
}

/* The linear axis of the arc, and whether the rotary axis stands for the first axis of the plane. */
static bool find_axes(struct interp *interp, int *linear, bool *rotary_first)
{
	const struct state *state = &interp->state;
	const struct block *block = &interp->block;
	const int first = state->plane == G17 ? SLOT_X : state->plane == G18 ? SLOT_Z : SLOT_Y;
	const int second = state->plane == G17 ? SLOT_Y : state->plane == G18 ? SLOT_X : SLOT_Z;
	bool has_first = block_has(block, AXIS_LETTERS[first]), has_second = block_has(block, AXIS_LETTERS[second]);
	int words = 0;

	for (int slot = 0; slot < SLOT_COUNT; slot++)
		words += block_has(block, AXIS_LETTERS[slot]);
	*linear = has_first ? first : second;
	*rotary_first = has_second;
	if (words == 2 && has_first != has_second && block_has(block, AXIS_LETTERS[state->cylinder.slot]) &&
	    block_has(block, 'R') && !block_has(block, 'I') && !block_has(block, 'J') && !block_has(block, 'K'))
		return true;
	return fault(
	    &interp->at, block_motion_column(block),
	    "an arc under cylindrical interpolation (G7.1) needs %c, one linear axis of its plane and a radius (R)",
	    AXIS_LETTERS[state->cylinder.slot]);
}

static struct plane_point surface_point(const struct cylinder *cylinder, const slot_values *at, int linear,
					bool rotary_first)
{
	double way = radians(at->v[cylinder->slot]) * cylinder->radius;

	return rotary_first ? (struct plane_point){way, at->v[linear]} : (struct plane_point){at->v[linear], way};
}

/*
 * The same section: the angle times the radius is a length on the surface that contains the arc. The distance of a
 * chord from its arc, at equal shares of both, is at most R w^2 / 8 for the radius R and the angle w.
 */
bool cylinder_arc(struct interp *interp)
{
	const struct block *block = &interp->block;
	const struct cylinder *cylinder = &interp->state.cylinder;
	const slot_values here = rotated_frame_straight(&interp->state);
	const struct arc_tolerance *tolerance = interp->state.scale > 1 ? &arc_tolerance_inch : &arc_tolerance_mm;
	struct canon_move move = {.kind = CANON_FEED};
	struct plane_point start, end, centre;
	slot_values target, place;
	double radius, sweep, first, beside;
	bool rotary_first = false;
	int linear = 0, pieces;

	interp->state.motion = block->motion;
	if (!find_axes(interp, &linear, &rotary_first) || !motion_commands_feed(interp, &move.feed) ||
	    !endpoint_find(interp, false, &target))
		return false;
	start = surface_point(cylinder, &here, linear, rotary_first);
	end = surface_point(cylinder, &target, linear, rotary_first);
	if (arc_find_centre(start, end, block_value(block, 'R') * interp->state.scale, block->motion == G2, tolerance,
			    &centre) != ARC_OK)
		return fault(&interp->at, block_column(block, 'R'),
			     "the radius is too small to reach the end of the arc on the surface, or start and end are "
			     "the same point");
	radius = math_hypot(start.a - centre.a, start.b - centre.b);
	sweep = arc_sweep(start, end, centre, block->motion == G2, 1, 0);
	pieces = (int)fmax(fmin(ceil(fabs(sweep) / sqrt(8 * BESIDE / radius)), PIECES_MAX), 1);
	beside = radius * (sweep / pieces) * (sweep / pieces) / 8;
	move.spread[linear] = beside;
	move.turn_spread[cylinder->slot - SLOT_A] = beside / cylinder->radius;
	move.feed.seconds /= pieces;
	first = math_atan2(start.b - centre.b, start.a - centre.a);
	place = here;
	for (int i = 1; i <= pieces; i++) {
		double angle = first + sweep * i / pieces;
		double a = centre.a + radius * math_cos(angle), b = centre.b + radius * math_sin(angle);

		place.v[linear] = rotary_first ? b : a;
		place.v[cylinder->slot] = degrees((rotary_first ? a : b) / cylinder->radius);
		if (!motion_commands_go(interp, i < pieces ? &place : &target, &move))
			return false;
	}
	return true;
}
