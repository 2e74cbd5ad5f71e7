#include "gcode/dialect/sinumerik/cycles/sinumerik_swivel.h"

#include <math.h>
#include <string.h>

#include "base/same_double.h"
#include "base/units.h"
#include "gcode/dialect/sinumerik/cycles/sinumerik_swivel_plane.h"
#include "gcode/dialect/sinumerik/frames/sinumerik_frame.h"
#include "gcode/dialect/sinumerik/frames/sinumerik_open_place.h"
#include "gcode/dialect/sinumerik/frames/sinumerik_place_check.h"
#include "gcode/dialect/sinumerik/path/sinumerik_target.h"
#include "gcode/execute/motion_commands.h"
#include "gcode/execute/tool_length.h"
#include "gcode/execute/work_offset_use.h"
#include "geom/tolerance.h"

/* Degrees: programs that turn the axes themselves give three decimals. */
#define STANDS_ON_PLANE 0.001

/* mm per mm along the tool. */
#define UPRIGHT 1e-9

/* FR */
enum { TO_LIMIT = 4, BY_INCREMENT };

static bool whole(const struct sinumerik_swivel *s, size_t i, const char *name, long *number)
{
	const double given = sinumerik_swivel_value(s, i);

	if (fabs(given) > 1e9 || floor(given) < given)
		return fault(&s->interp->at, s->column, "%s of CYCLE800 must be a whole number, not %.15g", name,
			     given);
	*number = (long)given;
	return true;
}

/* --------------------------------------------------------------- positions */

/* If the tool is perpendicular to the plane for any angle of an axis: does this axis move to zero, or stay? */
static bool settle_free(const struct sinumerik_swivel *s, struct kinematics_solution *solution)
{
	const struct controller *controller = &s->interp->config->controller;

	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		if (!solution->free[slot] || fabs(solution->rotary.v[slot]) <= radians(SAME_DEGREES))
			continue;
		if (controller->swivel_pole == SWIVEL_POLE_UNKNOWN)
			return fault(
			    &s->interp->at, s->column,
			    "any position of %c suits the plane of CYCLE800, and the machine's maker decides "
			    "whether %c then goes to 0: set swivel_pole=\"zero\" or \"stays\" in the machine "
			    "file's <controller>",
			    AXIS_LETTERS[slot], AXIS_LETTERS[slot]);
		if (controller->swivel_pole == SWIVEL_POLE_ZERO)
			solution->rotary.v[slot] = 0;
	}
	return true;
}

/* The axis can have either of two positions (degrees) only if they are different positions of the axis. */
static bool differ(double a, double b)
{
	return fabs(a - b) > radians(SAME_DEGREES);
}

static bool has_sign(double angle, long direction)
{
	return direction > 0 ? angle >= -radians(SAME_DEGREES) : angle <= radians(SAME_DEGREES);
}

static bool ask_for_axis(const struct sinumerik_swivel *s)
{
	return fault(&s->interp->at, s->column,
		     "DIR of CYCLE800 chooses one of two positions of the rotary axes by the value of one of them: "
		     "set swivel_axis=\"A\", \"B\" or \"C\" in the machine file's <controller> to the axis that "
		     "its swivel data name");
}

/*
 * "Swivel plane", "Direction (minus/plus)": DIR takes the solution with the smaller or the larger value of the axis
 * that the swivel data name (swivel_axis). If the limits leave one solution, it is taken for any DIR. The values of a
 * modulo axis depend on how they are written: there the signs must differ.
 */
static bool choose_by_direction(const struct sinumerik_swivel *s, struct kinematics_solutions *found, long direction,
				size_t *chosen)
{
	const struct interp *interp = s->interp;
	const int slot = interp->config->controller.swivel_axis;
	const struct kinematics_solution *items = found->items;
	double one, other;

	for (*chosen = 0; *chosen < found->count && !items[*chosen].within_limits;)
		++*chosen;
	if (*chosen == found->count)
		return fault(&interp->at, s->column,
			     "CYCLE800: no position of the rotary axes within their limits stands the tool on the "
			     "plane");
	if (found->count < 2 || *chosen == 1 || !items[1].within_limits)
		return true;
	if (!slot)
		return ask_for_axis(s);
	one = items[0].rotary.v[slot];
	other = items[1].rotary.v[slot];
	if (!differ(one, other))
		return true;
	if (interp->config->wrap[slot] != WRAP_NONE && has_sign(one, direction) == has_sign(other, direction))
		return fault(&interp->at, s->column,
			     "DIR=%ld of CYCLE800: %c would stand at %.9g or at %.9g degrees, and counts modulo 360: "
			     "which of the two is the higher value is not certain",
			     direction, AXIS_LETTERS[slot], degrees(one), degrees(other));
	*chosen = (one > other) == (direction > 0) ? 0 : 1;
	return true;
}

static bool refuse_present(const struct sinumerik_swivel *s)
{
	return fault(&s->interp->at, s->column,
		     "CYCLE800 with DIR=0 moves no axis, and the tool does not stand on this plane; turn the rotary "
		     "axes first, or give DIR 1 or -1");
}

/* "Swivel plane", direct: the rotary axes move to the given positions, which are all 0. */
static bool find_zero(const struct sinumerik_swivel *s, long direction, axis_values *rotary)
{
	*rotary = s->interp->state.canonical;
	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		if (!direction && fabs(rotary->v[slot]) > radians(STANDS_ON_PLANE))
			return refuse_present(s);
		rotary->v[slot] = direction ? 0 : rotary->v[slot];
	}
	return true;
}

/* DIR=0 moves no axis: the tool must already be perpendicular to the plane. */
static bool choose_present(const struct sinumerik_swivel *s, struct kinematics_solutions *found, size_t *chosen)
{
	for (*chosen = 0; *chosen < found->count; ++*chosen) {
		const axis_values *here = &s->interp->state.canonical, *there = &found->items[*chosen].rotary;
		double away = 0;

		for (int slot = SLOT_A; slot <= SLOT_C; slot++)
			away = fmax(away, fabs(there->v[slot] - here->v[slot]));
		if (away <= radians(STANDS_ON_PLANE)) {
			found->items[*chosen].rotary = *here;
			return true;
		}
	}
	return refuse_present(s);
}

/* The rotary positions for the plane. A machine without a second solution needs no DIR. */
static bool find_position(const struct sinumerik_swivel *s, const struct sinumerik_frame *plane, long direction,
			  axis_values *rotary)
{
	struct interp *interp = s->interp;
	const struct kinematics_orientation orientation = {.direction = plane->matrix.z,
							   .rotary_zero = tool_length_rotary_zero(interp),
							   .rotary = interp->state.canonical,
							   .command = "CYCLE800"};
	struct kinematics_solutions found;
	size_t chosen;

	/* fivecheck scan knows no machine. On most machines the limits allow both solutions. */
	if (interp->config->any_tool && direction && !interp->config->controller.swivel_axis &&
	    vec3_norm(vec3_cross(plane->matrix.z, (vec3){0, 0, 1})) > UPRIGHT)
		return ask_for_axis(s);
	if (!interp->kinematics->orientations(interp->kinematics->context, line_loc(&interp->at, s->column),
					      &orientation, &found))
		return false;
	if (found.count == 0)
		return fault(&interp->at, s->column,
			     "CYCLE800: the rotary axes of this machine cannot stand the tool on this plane");
	if (direction == 0 ? !choose_present(s, &found, &chosen) : !choose_by_direction(s, &found, direction, &chosen))
		return false;
	for (int slot = SLOT_A; slot <= SLOT_C && direction; slot++) {
		if (found.items[chosen].tie[slot])
			return fault(
			    &interp->at, s->column,
			    "CYCLE800 could turn %c either way, which is as near: turn it towards the position that is "
			    "meant, in a block before, or give half_turn to the axis in the machine file",
			    AXIS_LETTERS[slot]);
	}
	if (direction && !settle_free(s, &found.items[chosen]))
		return false;
	*rotary = found.items[chosen].rotary;
	return true;
}

/* ------------------------------------------------------------------- moves */

static bool go_rapid(struct interp *interp, const slot_values *target)
{
	struct canon_move move = {.kind = CANON_RAPID, .machine_coordinates = true};

	return motion_commands_go(interp, target, &move);
}

/* FR 4 and 5: along the tool, up to the limit of an axis, or by FR_I. */
static bool retract_along_tool(const struct sinumerik_swivel *s, long way)
{
	struct interp *interp = s->interp;
	struct kinematics_retract along = {.to_limit = way == TO_LIMIT,
					   .distance = sinumerik_swivel_value(s, FR_I) * interp->state.scale,
					   .position = interp->state.canonical};
	slot_values target = interp->state.position;

	if (!along.to_limit && !(along.distance >= 0))
		return fault(&interp->at, s->column, "FR=5 of CYCLE800 needs a way FR_I that is not negative");
	if (!interp->kinematics->retract(interp->kinematics->context, line_loc(&interp->at, s->column), &along))
		return false;
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++)
		target.v[slot] = state_from_canonical(slot, along.position.v[slot]);
	return go_rapid(interp, &target);
}

/* FR: 1, Z of the machine moves to its retracted position; 2, then X and Y also do. */
static bool retract(const struct sinumerik_swivel *s, long way)
{
	struct interp *interp = s->interp;
	const struct control_place *place = &interp->config->controller.swivel_retract;
	slot_values target = interp->state.position;

	if (way == 0)
		return true;
	if (way == TO_LIMIT || way == BY_INCREMENT)
		return retract_along_tool(s, way);
	if (way != 1 && way != 2)
		return fault(&interp->at, s->column, "FR of CYCLE800 must be 0, 1, 2, 4 or 5, not %ld", way);
	if (!place->given || !place->has[SLOT_Z] || (way == 2 && !(place->has[SLOT_X] && place->has[SLOT_Y])))
		return fault(&interp->at, s->column,
			     "FR=%ld of CYCLE800 retracts to positions of the swivel data: <swivel_retract %s/> in the "
			     "<controller> of the machine file gives them",
			     way, way == 1 ? "Z=\"\"" : "X=\"\" Y=\"\" Z=\"\"");
	target.v[SLOT_Z] = place->value.v[SLOT_Z];
	if (!go_rapid(interp, &target))
		return false;
	if (way == 1)
		return true;
	target.v[SLOT_X] = place->value.v[SLOT_X];
	target.v[SLOT_Y] = place->value.v[SLOT_Y];
	return go_rapid(interp, &target);
}

static bool is_none(const struct sinumerik_frame *frame)
{
	const struct sinumerik_frame none = sinumerik_frame_none();
	bool same = same_vec3(frame->matrix.x, none.matrix.x) && same_vec3(frame->matrix.y, none.matrix.y) &&
		    same_vec3(frame->matrix.z, none.matrix.z);

	for (size_t slot = 0; slot < sizeof(none.shift.v) / sizeof(none.shift.v[0]); slot++)
		same = same && same_double(frame->shift.v[slot], none.shift.v[slot]);
	return same;
}

/* From here on, positions are those of the machine's axes, without a plane. */
static bool lay_flat(const struct sinumerik_swivel *s, bool deletes_frames)
{
	const enum answer outlive = s->interp->config->controller.frames_outlive_cycle800;
	struct sinumerik *sinumerik = sinumerik_of(s->interp);

	sinumerik_frame_place(s->interp);
	sinumerik_open_place_turned(s->interp);
	if (s->interp->state.tcp == TCP_BY_PLANE && !tool_length_switch_tcp(s->interp, s->column, TCP_OFF))
		return false;
	sinumerik->frames.swivelled = false;
	sinumerik->frames.plane_unsure = false;
	sinumerik->frames.swivel = sinumerik_frame_none();
	if (deletes_frames || outlive == ANSWER_NO)
		sinumerik->frames.programmed = sinumerik_frame_none();
	sinumerik->frames.programmed_unsure = outlive != ANSWER_YES && !is_none(&sinumerik->frames.programmed);
	return sinumerik_frame_changed(s->interp, s->column);
}

/*
 * All angles and shifts are zero. Programs use this to cancel a plane and to turn the axes home: the plane is that of
 * the machine, and nothing is swivelled. The rotary axes are then at exactly zero.
 */
static bool is_home(const struct sinumerik_frame *plane, axis_values *rotary)
{
	if (!is_none(plane))
		return false;
	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		if (fabs(rotary->v[slot]) > radians(SAME_DEGREES))
			return false;
	}
	for (int slot = SLOT_A; slot <= SLOT_C; slot++)
		rotary->v[slot] = 0;
	return true;
}

static bool turn_axes(const struct sinumerik_swivel *s, const axis_values *rotary)
{
	slot_values target = s->interp->state.position;

	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		if (s->interp->config->has_axis[slot])
			target.v[slot] = state_from_canonical(slot, rotary->v[slot]);
	}
	return go_rapid(s->interp, &target);
}

static bool refuse(const struct sinumerik_swivel *s, const char *what)
{
	return fault(&s->interp->at, s->column, "%s", what);
}

/*
 * ST: 1 adds the plane to the active one. The tens guide the tip, the hundreds align the tool. Thousands and ten
 * thousands are for the editor. The hundred thousands select an optimised direction, which matters only if both
 * solutions are equal (settle_free). The units of DMODE: the plane of the cycle; 0 is the active one.
 */
static bool check(const struct sinumerik_swivel *s, long status, long direction)
{
	const struct state *state = &s->interp->state;
	const struct sinumerik *sinumerik = sinumerik_of(s->interp);
	const double plane = fmod(fabs(sinumerik_swivel_value(s, DMODE)), 10);

	if (state->tcp == TCP_BY_LENGTH)
		return refuse(s, "CYCLE800 while TRAORI is on; TRAFOOF first");
	if (!sinumerik_place_check_edge(s->interp, s->column))
		return false;
	if (state->work_assigned)
		return work_offset_use_fault(s->interp, s->column);
	if (plane > 1 || (plane == 0 && state->plane != G17))
		return refuse(s, "CYCLE800 with G18 or G19 turns another axis towards the tool than Z, which is not "
				 "supported; G17 before it, or 1 in the units of DMODE");
	if (status < 0 || status % 10 > 1)
		return refuse(s, "the units of ST of CYCLE800 must be 0 (new) or 1 (added)");
	if (status % 10 && sinumerik->frames.plane_unsure)
		return refuse(s, "CYCLE800 that adds a plane (units of ST 1) to one that another work offset may have "
				 "changed");
	if (status / 10 % 10)
		return refuse(s,
			      "CYCLE800 that guides the tool's tip while it swivels (tens of ST) is not supported");
	if (status / 100 % 10)
		return refuse(s, "CYCLE800 that sets the tool up (hundreds of ST) is not supported");
	if (status / 100000 > 2)
		return refuse(s, "the hundred thousands of ST of CYCLE800 must be 0, 1 or 2");
	if (direction < -1 || direction > 1)
		return refuse(s, "DIR of CYCLE800 must be -1, 0 or 1");
	return true;
}

/* Is the tool parallel to Z, as on a machine whose table turns? Positions are those of the machine's axes here. */
static bool look_at_tool(const struct sinumerik_swivel *s)
{
	struct interp *interp = s->interp;
	struct kinematics_retract along = {.distance = 1, .position = interp->state.canonical};

	if (!interp->kinematics->retract(interp->kinematics->context, line_loc(&interp->at, s->column), &along))
		return false;
	sinumerik_of(interp)->frames.tool_upright =
	    fabs(along.position.v[SLOT_X] - interp->state.canonical.v[SLOT_X]) <= UPRIGHT &&
	    fabs(along.position.v[SLOT_Y] - interp->state.canonical.v[SLOT_Y]) <= UPRIGHT;
	return true;
}

bool sinumerik_swivel_run(struct interp *interp, int column)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	const struct sinumerik_swivel s = {interp, column, sinumerik->passed.numbers, sinumerik->passed.count};
	struct sinumerik_frame plane;
	long way, status, mode, direction;
	axis_values rotary;
	bool home;

	/* Without arguments, or with the swivel data "0", CYCLE800 cancels the plane and moves no axis. */
	if (sinumerik->frames.tool_frame)
		return refuse(&s, "CYCLE800 while TOROT or TOFRAME is in force; TOROTOF first");
	if (s.count == 0 || (s.count > TC && !strcmp(sinumerik->passed.texts[TC].bytes, "0") &&
			     sinumerik->passed.is_text[TC]))
		return lay_flat(&s, false);
	if (!whole(&s, FR, "FR", &way) || !whole(&s, ST, "ST", &status) || !whole(&s, MODE, "MODE", &mode) ||
	    !whole(&s, DIR, "DIR", &direction) || !check(&s, status, direction) ||
	    !sinumerik_swivel_plane(&s, mode, status % 10 == 1, &plane))
		return false;
	if (!lay_flat(&s, true) || !sinumerik_target_check_rotary_zero(interp, column) ||
	    !(sinumerik_swivel_is_direct(mode) ? find_zero(&s, direction, &rotary)
					  : find_position(&s, &plane, direction, &rotary)) ||
	    !retract(&s, way))
		return false;
	home = is_home(&plane, &rotary);
	if ((direction && !turn_axes(&s, &rotary)) || !look_at_tool(&s))
		return false;
	sinumerik_frame_moved(interp);
	if (home && direction)
		return true;
	sinumerik_frame_place(interp);
	sinumerik->frames.swivel = plane;
	sinumerik->frames.swivelled = true;
	if (!sinumerik_frame_changed(interp, column) || !tool_length_switch_tcp(interp, column, TCP_BY_PLANE))
		return false;
	sinumerik_frame_moved(interp);
	return true;
}
