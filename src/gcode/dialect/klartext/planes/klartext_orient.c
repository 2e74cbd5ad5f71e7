#include "gcode/dialect/klartext/planes/klartext_orient.h"

#include <math.h>

#include "gcode/dialect/klartext/frames/klartext_frame.h"
#include "gcode/dialect/klartext/planes/klartext_tilt.h"
#include "gcode/execute/tool_length.h"
#include "geom/tolerance.h"

bool klartext_orient_is_no_farther(const axis_values *from, const struct kinematics_solution *a,
				   const struct kinematics_solution *b)
{
	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		if (fabs(a->rotary.v[slot] - from->v[slot]) > fabs(b->rotary.v[slot] - from->v[slot]) + TIE_TOLERANCE)
			return false;
	}
	return true;
}

/* The largest error in the length of a unit vector that posts write with a few decimals. */
#define NORMALISED 0.01

/*
 * Chooses the nearer position, as the control does. The choice is certain if no axis has a longer way to it. False:
 * reported.
 */
static bool choose(struct interp *interp, int column, const struct kinematics_solutions *solutions,
		   const struct kinematics_solution **chosen)
{
	const struct kinematics_solution *fitting[2] = {NULL, NULL};
	size_t count = 0;
	bool first, second;

	for (size_t i = 0; i < solutions->count; i++) {
		if (solutions->items[i].within_limits)
			fitting[count++] = &solutions->items[i];
	}
	if (count == 0)
		return fault(
		    &interp->at, column,
		    "within the limits of their travel, the rotary axes cannot stand the tool in this direction");
	*chosen = fitting[0];
	if (count == 1)
		return true;
	first = klartext_orient_is_no_farther(&interp->state.canonical, fitting[0], fitting[1]);
	second = klartext_orient_is_no_farther(&interp->state.canonical, fitting[1], fitting[0]);
	if (first == second)
		return fault(
		    &interp->at, column,
		    "the rotary axes can stand the tool in this direction in two ways, and which one the control "
		    "takes is not known here; post the positions of the rotary axes");
	*chosen = first ? fitting[0] : fitting[1];
	return true;
}

/*
 * "Three-dimensional tool compensation": TX, TY and TZ are the direction from the tip to the spindle in coordinates of
 * the workpiece. "FUNCTION TCPM", AXIS SPAT: A, B and C turn this direction as PLANE SPATIAL does; the first block must
 * have all three.
 */
static bool find_direction(struct interp *interp, const struct klartext_words *words, vec3 *direction)
{
	const struct klartext_tcpm *tcpm = &klartext_of(interp)->tcpm;
	const int column = words->first_column;

	if (words->tool_given && (words->spatial || words->axes >> SLOT_A))
		return fault(&interp->at, column, "TX, TY and TZ beside words of rotary axes");
	*direction = (vec3){words->tool[0], words->tool[1], words->tool[2]};
	if (words->tool_given)
		return fabs(vec3_norm(*direction) - 1) < NORMALISED ||
		       fault(&interp->at, column, "TX, TY and TZ have to be a vector of length 1");
	for (int i = 0; i < 3; i++) {
		if (!tcpm->given[i])
			return fault(&interp->at, column,
				     "the first block behind AXIS SPAT needs all of A, B and C: %c is missing",
				     'A' + i);
	}
	*direction = klartext_tilt_spatial(tcpm->angle).z;
	return true;
}

bool klartext_orient_target(struct interp *interp, const struct klartext_words *words, struct klartext_target *target)
{
	struct kinematics_orientation orientation = {.rotary_zero = tool_length_rotary_zero(interp),
						     .rotary = interp->state.canonical,
						     .command = words->tool_given ? "LN" : "AXIS SPAT"};
	struct kinematics_solutions solutions;
	const struct kinematics_solution *chosen = NULL;
	const int column = words->first_column;
	vec3 tool;

	if (interp->state.tcp != TCP_BY_MCODE)
		return fault(&interp->at, column,
			     "TX, TY and TZ turn the rotary axes while M128 or TCPM is in force only; write it before");
	if (!find_direction(interp, words, &tool))
		return false;
	orientation.direction = vec3_unit(klartext_frame_direction(interp, tool));
	if (!interp->kinematics->orientations(interp->kinematics->context, line_loc(&interp->at, column), &orientation,
					      &solutions) ||
	    !choose(interp, column, &solutions, &chosen))
		return false;
	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		if (!interp->config->has_axis[slot])
			continue;
		if (chosen->tie[slot])
			return fault(
			    &interp->at, column,
			    "half a turn of %c: either way is as short; set half_turn=\"positive\" or \"negative\" "
			    "of this axis in the machine file",
			    AXIS_LETTERS[slot]);
		target->others.v[slot] = state_from_canonical(slot, chosen->rotary.v[slot]);
	}
	target->turns = true;
	return true;
}

bool klartext_orient_along_z(struct interp *interp, int column, bool *along)
{
	const axis_values zero = tool_length_rotary_zero(interp);
	const vec3 z = klartext_frame_direction(interp, (vec3){0, 0, 1});
	vec3 tool;

	if (!interp->kinematics->direction(interp->kinematics->context, line_loc(&interp->at, column), &zero,
					   &interp->state.canonical, &tool))
		return false;
	*along = vec3_norm(vec3_sub(tool, z)) <= DIRECTION_REACHED;
	return true;
}
