#include "gcode/dialect/sinumerik/sinumerik_swivel.h"

#include <math.h>
#include <string.h>

#include "base/same_double.h"
#include "base/units.h"
#include "gcode/dialect/sinumerik/sinumerik_frame.h"
#include "gcode/execute/motion_commands.h"
#include "gcode/execute/tool_length.h"
#include "geom/tolerance.h"

/* 840D sl, "Swivel plane (CYCLE800)": the arguments in their order. */
enum { FR, TC, ST, MODE, X0, Y0, Z0, A, B, C, X1, Y1, Z1, DIR, FR_I, DMODE };

struct swivel {
	struct interp *interp;
	int column;
	const double *arguments;
	size_t count;
};

static double value(const struct swivel *s, size_t i)
{
	return i < s->count && !isnan(s->arguments[i]) ? s->arguments[i] : 0;
}

static vec3 point(const struct swivel *s, size_t i)
{
	return vec3_scale(s->interp->state.scale, (vec3){value(s, i), value(s, i + 1), value(s, i + 2)});
}

static bool whole(const struct swivel *s, size_t i, const char *name, long *number)
{
	const double given = value(s, i);

	if (fabs(given) > 1e9 || floor(given) < given)
		return fault(&s->interp->at, s->column, "%s of CYCLE800 must be a whole number, not %.15g", name, given);
	*number = (long)given;
	return true;
}

static struct sinumerik_frame shift_by(vec3 by)
{
	struct sinumerik_frame frame = sinumerik_frame_none();

	frame.shift.v[SLOT_X] = by.x;
	frame.shift.v[SLOT_Y] = by.y;
	frame.shift.v[SLOT_Z] = by.z;
	return frame;
}

/* ------------------------------------------------------------------- plane */

/*
 * MODE, axis by axis: bits 0 and 1, 2 and 3, 4 and 5 name the axes of the first, second and third turn (1 X, 2 Y, 3 Z),
 * each about the axis as the turns before have left it; A, B and C are the angles in the order of the turns.
 */
static bool find_turn(const struct swivel *s, long mode, mat3 *turn)
{
	*turn = mat3_identity();
	for (int i = 0; i < 3; i++) {
		const long axis = mode >> 2 * i & 3;
		const double angle = value(s, A + (size_t)i);
		mat3 one;

		if (axis == 0 && !same_double(angle, 0))
			return fault(&s->interp->at, s->column, "MODE=%ld of CYCLE800 names no axis for angle %d", mode, i + 1);
		one = mat3_turn((vec3){axis == 1, axis == 2, axis == 3 || axis == 0}, radians(angle));
		*turn = mat3_mul(turn, &one);
	}
	return true;
}

static bool find_plane(const struct swivel *s, long mode, bool added, struct sinumerik_frame *plane)
{
	static const char *const modes[] = {"", "solid angles", "projection angles", "positions of the rotary axes"};
	const struct sinumerik *sinumerik = sinumerik_of(s->interp);
	struct sinumerik_frame before = shift_by(point(s, X0)), turn = sinumerik_frame_none(), after = shift_by(point(s, X1));

	if (mode < 0 || mode > 255)
		return fault(&s->interp->at, s->column, "MODE of CYCLE800 must lie between 0 and 255, not %ld", mode);
	if (mode >> 6)
		return fault(&s->interp->at, s->column,
			     "MODE=%ld of CYCLE800, a plane by %s, is not supported yet; axis by axis, as MODE=57, is", mode,
			     modes[mode >> 6]);
	if (!find_turn(s, mode, &turn.matrix))
		return false;
	before = sinumerik_frame_chain(&before, &turn);
	*plane = sinumerik_frame_chain(&before, &after);
	if (added)
		*plane = sinumerik_frame_chain(&sinumerik->swivel, plane);
	return true;
}

/* --------------------------------------------------------------- positions */

static bool has_sign(double angle, long direction)
{
	return direction > 0 ? angle >= -radians(SAME_DEGREES) : angle <= radians(SAME_DEGREES);
}

static bool ask(const struct swivel *s, struct kinematics_orientation *orientation)
{
	struct interp *interp = s->interp;

	return interp->kinematics->orient(interp->kinematics->context, line_loc(&interp->at, s->column), orientation);
}

/*
 * The rotary positions for the plane. Of the two solutions DIR takes the one in which the axis that the swivel data
 * names (swivel_axis) is positive or negative; the kinematics gives the nearer one, so that it is asked from both sides.
 */
static bool find_position(const struct swivel *s, const struct sinumerik_frame *plane, long direction,
			  axis_values *rotary)
{
	const struct interp *interp = s->interp;
	const int slot = interp->config->controller.swivel_axis;
	struct kinematics_orientation orientation = {.direction = plane->matrix.z,
						     .rotary_zero = tool_length_rotary_zero(interp),
						     .rotary = interp->state.canonical}, other;

	if (!slot)
		return fault(&interp->at, s->column,
			     "DIR of CYCLE800 chooses one of two positions of the rotary axes by the sign of one of them: "
			     "swivel_axis=\"A\", \"B\" or \"C\" of the machine's <controller> says which axis its swivel data "
			     "name");
	if (!ask(s, &orientation))
		return false;
	if (!has_sign(orientation.rotary.v[slot], direction)) {
		other = orientation;
		other.rotary.v[slot] = -orientation.rotary.v[slot];
		for (int k = SLOT_A; k <= SLOT_C; k++)
			other.rotary.v[k] += k == slot || !interp->config->has_axis[k] ? 0 : radians(180);
		if (!ask(s, &other))
			return false;
		if (!has_sign(other.rotary.v[slot], direction))
			return fault(&interp->at, s->column,
				     "CYCLE800 with DIR=%ld: no position within the limits stands the tool on the plane with %c "
				     "%s", direction, AXIS_LETTERS[slot], direction > 0 ? "positive" : "negative");
		orientation = other;
	}
	*rotary = orientation.rotary;
	return true;
}

/* ------------------------------------------------------------------- moves */

static bool go_rapid(struct interp *interp, const slot_values *target)
{
	struct canon_move move = {.kind = CANON_RAPID, .machine_coordinates = true};

	return motion_commands_go(interp, target, &move);
}

/* FR: 1, Z of the machine goes to its retracted position; 2, and then X and Y. */
static bool retract(const struct swivel *s, long way)
{
	struct interp *interp = s->interp;
	const struct control_place *place = &interp->config->controller.swivel_retract;
	slot_values target = interp->state.position;

	if (way == 0)
		return true;
	if (way != 1 && way != 2)
		return fault(&interp->at, s->column, "FR=%ld of CYCLE800, retraction along the tool, is not supported yet", way);
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

/* Positions are those of the machine's axes from here on, without any plane. */
static bool lay_flat(const struct swivel *s)
{
	struct sinumerik *sinumerik = sinumerik_of(s->interp);

	sinumerik_frame_place(s->interp);
	if (s->interp->state.tcp == TCP_BY_PLANE && !tool_length_switch_tcp(s->interp, s->column, TCP_OFF))
		return false;
	sinumerik->swivelled = false;
	sinumerik->swivel = sinumerik_frame_none();
	return sinumerik_frame_changed(s->interp, s->column);
}

static bool turn_axes(const struct swivel *s, const axis_values *rotary)
{
	slot_values target = s->interp->state.position;

	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		if (s->interp->config->has_axis[slot])
			target.v[slot] = state_from_canonical(slot, rotary->v[slot]);
	}
	return go_rapid(s->interp, &target);
}

static bool refuse(const struct swivel *s, const char *what)
{
	return fault(&s->interp->at, s->column, "%s", what);
}

/* What of ST, DIR and the state of the program is not supported. */
static bool same_vec3(vec3 a, vec3 b)
{
	return same_double(a.x, b.x) && same_double(a.y, b.y) && same_double(a.z, b.z);
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

static bool check(const struct swivel *s, long status, long direction)
{
	const struct state *state = &s->interp->state;
	const struct sinumerik *sinumerik = sinumerik_of(s->interp);

	if (state->tcp == TCP_BY_LENGTH)
		return refuse(s, "CYCLE800 while TRAORI is on; TRAFOOF first");
	if (sinumerik->edge_unsure)
		return refuse(s, "CYCLE800 needs the tool's edge: write D before it");
	if (!is_none(&sinumerik->frame))
		return refuse(s, "CYCLE800 while TRANS, ROT, SCALE or MIRROR is in force is not supported yet; give the shift "
				 "in X0 Y0 Z0 or behind it");
	if (status < 0 || status % 10 > 1)
		return refuse(s, "the units of ST of CYCLE800 must be 0 (new) or 1 (added)");
	if (status / 10 % 10)
		return refuse(s, "CYCLE800 that guides the tool's tip while it swivels (tens of ST) is not supported yet");
	if (status / 100)
		return refuse(s, "CYCLE800 that sets the tool up or names its axis of DIR (hundreds and more of ST) is not "
				 "supported yet");
	if (direction != 1 && direction != -1)
		return refuse(s, "CYCLE800 needs DIR, 1 or -1; with 0 it only computes, which is not supported yet");
	return true;
}

bool sinumerik_swivel_run(struct interp *interp, int column)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);
	const struct swivel s = {interp, column, sinumerik->arguments, sinumerik->argument_count};
	struct sinumerik_frame plane;
	long way, status, mode, direction;
	axis_values rotary;

	/* Without arguments, or with the swivel data "0", it takes the plane back and moves no axis. */
	if (s.count == 0 || (s.count > TC && !strcmp(sinumerik->argument_texts[TC].bytes, "0") &&
			     sinumerik->argument_is_text[TC]))
		return lay_flat(&s);
	if (!whole(&s, FR, "FR", &way) || !whole(&s, ST, "ST", &status) || !whole(&s, MODE, "MODE", &mode) ||
	    !whole(&s, DIR, "DIR", &direction) || !check(&s, status, direction) ||
	    !find_plane(&s, mode, status % 10 == 1, &plane))
		return false;
	if (!lay_flat(&s) || !find_position(&s, &plane, direction, &rotary) || !retract(&s, way) ||
	    !turn_axes(&s, &rotary))
		return false;
	sinumerik_frame_moved(interp);
	sinumerik_frame_place(interp);
	sinumerik->swivel = plane;
	sinumerik->swivelled = true;
	if (!sinumerik_frame_changed(interp, column) || !tool_length_switch_tcp(interp, column, TCP_BY_PLANE))
		return false;
	sinumerik_frame_moved(interp);
	return true;
}
