#include "gcode/execute/tool_vector.h"

#include <math.h>

#include "base/same_double.h"
#include "base/units.h"
#include "gcode/execute/tool_length.h"
#include "geom/tolerance.h"

/* mm: a shorter vector has no direction. */
#define LEAST_VECTOR 1e-9

static double word_or_zero(const struct block *block, char letter)
{
	return block_has(block, letter) ? block_value(block, letter) : 0;
}

static double way_of(const struct interp *interp, const struct kinematics_solution *solution, int slot)
{
	return fabs(solution->rotary.v[slot] - interp->state.canonical.v[slot]);
}

/* -1: a is smaller; 1: b is smaller; 0: equal within rounding. */
static int compare(double a, double b)
{
	return fabs(a - b) <= radians(SAME_DEGREES) ? 0 : a < b ? -1 : 1;
}

/*
 * Fanuc 30i-A, "Tool Center Point Control for 5-Axis Machining" (A-79348E), movement judgement: the smaller move of the
 * first rotary axis decides, then that of the second, then the position that is nearer to a full turn.
 */
static int prefer(const struct interp *interp, const struct kinematics_solutions *found)
{
	const struct kinematics_solution *a = &found->items[0], *b = &found->items[1];
	int by = compare(way_of(interp, a, found->primary), way_of(interp, b, found->primary));

	for (int slot = SLOT_A; slot <= SLOT_C && by == 0; slot++)
		by = compare(way_of(interp, a, slot), way_of(interp, b, slot));
	if (by == 0)
		by = compare(fabs(remainder(a->rotary.v[found->primary], 2 * PI)),
			     fabs(remainder(b->rotary.v[found->primary], 2 * PI)));
	for (int slot = SLOT_A; slot <= SLOT_C && by == 0; slot++)
		by = compare(fabs(remainder(a->rotary.v[slot], 2 * PI)), fabs(remainder(b->rotary.v[slot], 2 * PI)));
	return by;
}

static bool choose(struct interp *interp, int column, const struct kinematics_solutions *found,
		   const struct kinematics_solution **chosen)
{
	const struct kinematics_solution *items = found->items;
	bool both = found->count == 2 && items[0].within_limits && items[1].within_limits;
	int by = both ? prefer(interp, found) : 0;

	*chosen = found->count == 0 ? NULL
		  : both	    ? &items[by > 0]
				    : &items[found->count == 2 && !items[0].within_limits];
	if (!*chosen || !(*chosen)->within_limits)
		return fault(&interp->at, column,
			     "the rotary axes of this machine cannot turn the tool to the direction I, J, K%s",
			     found->count ? " within their limits" : "");
	if (both && by == 0 && compare(way_of(interp, &items[0], found->primary), 0) != 0)
		return fault(
		    &interp->at, column,
		    "two positions of the rotary axes give the tool the direction I, J, K and are equally near");
	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		if ((*chosen)->tie[slot])
			return fault(&interp->at, column,
				     "%c can turn in both directions to I, J, K, equally far: set half_turn=\"\" for "
				     "this axis in the machine file",
				     AXIS_LETTERS[slot]);
	}
	return true;
}

static bool check_words(struct interp *interp)
{
	const struct block *block = &interp->block;

	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		if (block_has(block, AXIS_LETTERS[slot]))
			return fault(&interp->at, block_column(block, AXIS_LETTERS[slot]),
				     "%c under G43.5, where I, J and K turn the tool", AXIS_LETTERS[slot]);
	}
	if (block_has(block, 'Q') && !same_double(block_value(block, 'Q'), 0))
		return fault(&interp->at, block_column(block, 'Q'),
			     "Q of G43.5 (inclination towards the path) is not supported");
	return true;
}

static bool check_way(struct interp *interp, int column)
{
	switch (interp->config->controller.orientation_interpolation) {
	case ORIENTATION_INTERPOLATION_AXES:
		return true;
	case ORIENTATION_INTERPOLATION_VECTOR:
		return fault(&interp->at, column, "a great circle of the tool under G43.5 is not supported");
	default:
		return fault(
		    &interp->at, column,
		    "an option of the control decides how the tool turns under G43.5: set "
		    "orientation_interpolation=\"axes\" (the rotary axes turn evenly) or \"vector\" (the tool turns on "
		    "a great circle: tool posture control) in the machine file's <controller>");
	}
}

/* A-79348E, "Specifying tool center point control (type 2)": an omitted word is 0; without all three nothing turns. */
bool tool_vector_take(struct interp *interp, slot_values *target)
{
	const struct block *block = &interp->block;
	const vec3 vector = {word_or_zero(block, 'I'), word_or_zero(block, 'J'), word_or_zero(block, 'K')};
	const struct kinematics *kinematics = interp->kinematics;
	struct kinematics_orientation orientation = {
	    .rotary_zero = tool_length_rotary_zero(interp), .rotary = interp->state.canonical, .command = "G43.5"};
	const struct kinematics_solution *chosen = NULL;
	struct kinematics_solutions found;
	int column = block_motion_column(block);
	bool turns = false;

	if (!check_words(interp))
		return false;
	if (!block_has(block, 'I') && !block_has(block, 'J') && !block_has(block, 'K'))
		return true;
	if (!(vec3_norm(vector) > LEAST_VECTOR))
		return fault(&interp->at, column, "the direction I, J, K has length 0");
	orientation.direction = vec3_unit(vector);
	if (!kinematics->orientations(kinematics->context, line_loc(&interp->at, column), &orientation, &found) ||
	    !choose(interp, column, &found, &chosen))
		return false;
	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		turns = turns || compare(way_of(interp, chosen, slot), 0) != 0;
		if (interp->config->has_axis[slot])
			target->v[slot] = state_from_canonical(slot, chosen->rotary.v[slot]);
	}
	return !turns || check_way(interp, column);
}

bool tool_vector_check_block(struct interp *interp)
{
	const struct block *block = &interp->block;
	bool straight = (block->motion == G0 || block->motion == G1) && block->g[G_NONMODAL] == CODE_NONE &&
			block->g[G_APPROACH] == CODE_NONE;
	bool cycle = block->motion != CODE_NONE && code_is_cycle(block->motion);

	for (const char *letter = "IJKQ"; *letter && !straight; letter++) {
		if (block_has(block, *letter) && !(cycle && *letter == 'Q'))
			return fault(&interp->at, block_column(block, *letter),
				     "%c under G43.5 needs a straight move (G0 or G1)", *letter);
	}
	return true;
}
