#include "gcode/dialect/klartext/planes/klartext_free_axis.h"

#include <math.h>

#include "base/math/math_functions.h"
#include "base/units.h"
#include "gcode/execute/tool_length.h"
#include "geom/tolerance.h"

double klartext_free_axis_zero(const struct interp *interp, int slot)
{
	const double zero = interp->state.offset.v[slot], here = interp->state.position.v[slot] - zero;
	const double left = remainder(here, 360);

	if (interp->config->wrap[slot] != WRAP_SHORTEST || fabs(left) > 180 - SAME_DEGREES)
		return zero;
	return zero + here - left;
}

/* The component of the machine's X along the tilted X when this axis is at this angle. */
static bool along_tilted_x(struct interp *interp, int column, struct kinematics_turn *turn, int slot, double angle,
			   const mat3 *tilt, double *found)
{
	turn->rotary.v[slot] = radians(angle);
	if (!interp->kinematics->turn(interp->kinematics->context, line_loc(&interp->at, column), turn))
		return false;
	*found = vec3_dot(turn->turn.x, tilt->x);
	return true;
}

/*
 * TNC7 user's manual, "TABLE ROT": a free rotary axis turns until the tilted coordinates lie along the machine's
 * coordinates. The X of the machine turns with the axis, so its components at two positions give the angle.
 */
static bool turn_table(struct interp *interp, int column,
		       const struct kinematics_solution *chosen, const mat3 *tilt, int slot, double *to)
{
	struct kinematics_turn turn = {.rotary_zero = tool_length_rotary_zero(interp), .rotary = chosen->rotary};
	const double zero = interp->state.offset.v[slot], here = interp->state.position.v[slot];
	double at_zero, at_quarter, reached, angle;

	if (!along_tilted_x(interp, column, &turn, slot, zero, tilt, &at_zero) ||
	    !along_tilted_x(interp, column, &turn, slot, zero + 90, tilt, &at_quarter))
		return false;
	angle = math_atan2_degrees(at_quarter, at_zero) + zero;
	angle = here + remainder(angle - here, 360);
	if (!along_tilted_x(interp, column, &turn, slot, angle, tilt, &reached))
		return false;
	if (reached < 1 - DIRECTION_REACHED)
		return fault(
		    &interp->at, column,
		    "TABLE ROT: how far %c turns is not known here; turn it in a block before, or write COORD ROT",
		    AXIS_LETTERS[slot]);
	if (fabs(angle - here) > 180 - SAME_DEGREES && !interp->config->half_turn[slot])
		return fault(&interp->at, column,
			     "half a turn of %c: either way is as short; set half_turn=\"positive\" or \"negative\" of "
			     "this axis in the machine file",
			     AXIS_LETTERS[slot]);
	if (fabs(angle - here) > 180 - SAME_DEGREES)
		angle = here + interp->config->half_turn[slot] * fabs(angle - here);
	if (interp->config->wrap[slot] == WRAP_NONE && fabs(angle - zero) > 180 + SAME_DEGREES)
		return fault(
		    &interp->at, column,
		    "PLANE turns %c to %.6g or to an angle whole turns away: which one the control takes is not "
		    "known here; turn %c towards 0 before, or set wrap=\"shortest\" of this axis in the machine "
		    "file",
		    AXIS_LETTERS[slot], angle - zero, AXIS_LETTERS[slot]);
	*to = angle;
	return true;
}

/* COORD ROT leaves a free axis where it is on some controls and takes it to 0 on others. */
static bool turn_coordinates(struct interp *interp, int column, int slot, double *to)
{
	const double here = interp->state.position.v[slot] - interp->state.offset.v[slot];
	const double zero = klartext_free_axis_zero(interp, slot);
	const enum swivel_pole pole = interp->config->controller.swivel_pole;

	if (fabs(remainder(here, 360)) > SAME_DEGREES && !pole)
		return fault(&interp->at, column,
			     "any angle of %c suits this plane, and it stands at %.6g: whether the control leaves "
			     "it there or turns it to 0 depends on its generation: set swivel_pole=\"stays\" or "
			     "\"zero\" in the machine file's <controller>, or turn %c to 0 in a block before",
			     AXIS_LETTERS[slot], here, AXIS_LETTERS[slot]);
	if (pole == SWIVEL_POLE_ZERO && fabs(interp->state.position.v[slot] - zero) > 180 + SAME_DEGREES)
		return fault(&interp->at, column,
			     "PLANE turns %c to 0 or to a whole turn: which one the control takes is not known "
			     "here; turn %c towards 0 in a block before",
			     AXIS_LETTERS[slot], AXIS_LETTERS[slot]);
	if (pole == SWIVEL_POLE_ZERO)
		*to = zero;
	return true;
}

/*
 * The rotation that the machine file gives. swivel_pole="zero" describes TNC 640, which turns only the coordinates
 * (TNC7 user's manual, "Transformation type").
 */
static enum plane_rotation find_rotation(const struct controller *controller)
{
	if (!controller->plane_rotation && controller->swivel_pole == SWIVEL_POLE_ZERO)
		return PLANE_ROTATION_COORDINATES;
	return controller->plane_rotation;
}

bool klartext_free_axis_turn(struct interp *interp, int column, enum plane_rotation asked,
			     const struct kinematics_solution *chosen, const mat3 *tilt, int slot, double *angle)
{
	const enum plane_rotation rotation = asked ? asked : find_rotation(&interp->config->controller);

	/* If the tilted X lies along the X of the workpiece, no coordinates turn. */
	if (!rotation && fabs(tilt->x.y) + fabs(tilt->x.z) > DIRECTION_REACHED)
		return fault(&interp->at, column,
			     "any angle of %c suits this plane: a parameter of the control decides whether the "
			     "table turns or only the coordinates: set plane_rotation=\"coordinates\" or \"table\" "
			     "in the machine file's <controller>, or write COORD ROT or TABLE ROT in PLANE",
			     AXIS_LETTERS[slot]);
	/* TNC7: a tilted plane leaves a free axis where it is; its coordinates are as programmed. */
	if (rotation == PLANE_ROTATION_TABLE && fabs(tilt->z.x) + fabs(tilt->z.y) > DIRECTION_REACHED)
		return true;
	if (rotation == PLANE_ROTATION_TABLE)
		return turn_table(interp, column, chosen, tilt, slot, angle);
	return turn_coordinates(interp, column, slot, angle);
}
