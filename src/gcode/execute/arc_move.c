#include "gcode/execute/arc_move.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>

#include "base/math/math_functions.h"
#include "base/same_double.h"
#include "gcode/execute/arc.h"
#include "gcode/execute/corner_insert.h"
#include "gcode/execute/cutter_comp/cutter_comp.h"
#include "gcode/execute/cylinder.h"
#include "gcode/execute/endpoint.h"
#include "gcode/execute/motion_commands.h"
#include "gcode/execute/probed_axes.h"
#include "gcode/execute/rotated_frame.h"
#include "geom/tolerance.h"

/* LinuxCNC's min_arc_angle (emccanon.cc). */
#define SAME_ANGLE 1e-12

/* The axes of an arc's plane, and the letters of its centre. */
struct arc_plane {
	int code;
	enum axis_slot a, b;
	char centre_a, centre_b, not_used;
	vec3 normal;
};

static const struct arc_plane *find_plane(int code)
{
	static const struct arc_plane planes[] = {{G17, SLOT_X, SLOT_Y, 'I', 'J', 'K', {0, 0, 1}},
						  {G18, SLOT_Z, SLOT_X, 'K', 'I', 'J', {0, 1, 0}},
						  {G19, SLOT_Y, SLOT_Z, 'J', 'K', 'I', {1, 0, 0}}};

	return &planes[code == G17 ? 0 : code == G18 ? 1 : 2];
}

/* A coordinate of the centre: an offset from the start (G91.1), or a program coordinate (G90.1). */
static bool centre_word(struct interp *interp, char letter, enum axis_slot slot, double start, double *value)
{
	const struct block *block = &interp->block;
	const struct state *state = &interp->state;

	if (state->arc_absolute && !block_has(block, letter))
		return fault(&interp->at, block_motion_column(block),
			     "an arc with an absolute centre (G90.1) needs both centre words; %c is missing", letter);
	*value = block_has(block, letter) ? block_value(block, letter) * state->scale : 0;
	*value += state->arc_absolute ? state->offset.v[slot] : start;
	return true;
}

/*
 * If a word of the arc without a decimal point counts increments, this is the probable reason for different radii. The
 * hint is appended to a message; otherwise it is "".
 */
static const char *whole_number_hint(const struct interp *interp, char *text, size_t size)
{
	const struct block *block = &interp->block;
	const uint32_t whole = block->letters & ~block->points;
	const double increment = interp->config->controller.least_input;

	*text = '\0';
	if (traits_of(interp)->whole_numbers != WHOLE_NUMBERS_INCREMENTS || !(increment > 0 && increment < 1))
		return text;
	for (const char *letter = "XYZIJK"; *letter && *text == '\0'; letter++) {
		if ((whole & letter_bit(*letter)) && !same_double(block_value(block, *letter), 0))
			snprintf(text, size, "; %c has no decimal point and means %.6g (least_input)", *letter,
				 block_value(block, *letter));
	}
	return text;
}

/*
 * Fanuc B-63324EN and B-64484EN, "Circular Interpolation": if the end is not on the arc, the radius changes linearly
 * with the angle, up to a difference that parameter 3410 gives.
 */
static bool check_spiral(struct interp *interp, double r0, double r1)
{
	double most = interp->config->controller.arc_radius_tolerance;
	int column = block_motion_column(&interp->block);
	char text[80];
	const char *hint = whole_number_hint(interp, text, sizeof(text));

	if (traits_of(interp)->arc_spirals != ANSWER_YES)
		return fault(&interp->at, column,
			     "the radius of the arc is %.6g mm at its start and %.6g mm at its end%s", r0, r1, hint);
	if (!(most > 0))
		return fault(&interp->at, column,
			     "the radius of the arc is %.6g mm at its start and %.6g mm at its end; if this control "
			     "makes a spiral of it, set arc_radius_tolerance=\"\" (largest difference) in the machine "
			     "file's <controller>%s",
			     r0, r1, hint);
	if (fabs(r0 - r1) > most)
		return fault(&interp->at, column,
			     "the radius of the arc is %.6g mm at its start and %.6g mm at its end; "
			     "arc_radius_tolerance in the machine file allows less%s",
			     r0, r1, hint);
	if (cutter_comp_is_on(interp) || corner_insert_concerns(interp))
		return fault(&interp->at, column,
			     "the radius of the arc is %.6g mm at its start and %.6g mm at its end; a spiral is not "
			     "supported under cutter compensation or beside a corner with ,C or ,R",
			     r0, r1);
	return true;
}

static bool find_arc_by_centre(struct interp *interp, const struct arc_plane *plane, struct plane_point start,
			       struct plane_point end, struct plane_point *centre)
{
	const struct state *state = &interp->state;
	const struct arc_tolerance *tolerance = state->scale > 1 ? &arc_tolerance_inch : &arc_tolerance_mm;
	int column = block_motion_column(&interp->block);
	double r0, r1;

	if (block_has(&interp->block, plane->not_used) &&
	    !(traits_of(interp)->arc_idle_zero == ANSWER_YES &&
	      same_double(block_value(&interp->block, plane->not_used), 0)))
		return fault(&interp->at, block_column(&interp->block, plane->not_used),
			     "%c does not belong to the centre of an arc in the plane of G%d", plane->not_used,
			     plane->code / 10);
	if (!centre_word(interp, plane->centre_a, plane->a, start.a, &centre->a) ||
	    !centre_word(interp, plane->centre_b, plane->b, start.b, &centre->b))
		return false;
	switch (arc_check_centre(start, end, *centre, tolerance, &r0, &r1)) {
	case ARC_ZERO_RADIUS:
		return fault(&interp->at, column,
			     "the radius of the arc is 0: %.6g mm at its start, %.6g mm at its end", r0,
			     r1);
	case ARC_RADII_DIFFER:
		return check_spiral(interp, r0, r1);
	default:
		return true;
	}
}

static bool find_arc_by_radius(struct interp *interp, const struct arc_plane *plane, struct plane_point start,
			       struct plane_point end, struct plane_point *centre)
{
	const struct block *block = &interp->block;
	const struct arc_tolerance *tolerance = interp->state.scale > 1 ? &arc_tolerance_inch : &arc_tolerance_mm;
	double radius = block_value(block, 'R') * interp->state.scale;
	int column = block_column(block, 'R');
	char a = AXIS_LETTERS[plane->a], b = AXIS_LETTERS[plane->b];

	if ((block->letters & (letter_bit('I') | letter_bit('J') | letter_bit('K'))) &&
	    traits_of(interp)->arc_radius_wins != ANSWER_YES)
		return fault(&interp->at, column, "an arc has either a radius (R) or a centre (I, J, K), not both");
	if (!block_has(block, a) && !block_has(block, b))
		return fault(&interp->at, column, "an arc with a radius (R) needs %c or %c", a, b);
	switch (arc_find_centre(start, end, radius, block->motion == G2, tolerance, centre)) {
	case ARC_NO_CHORD:
		return fault(&interp->at, column,
			     "an arc with a radius (R) must not end at its start; for a full circle, give the centre "
			     "(I, J, K)");
	case ARC_RADIUS_TOO_SMALL:
		return fault(&interp->at, column,
			     "the radius of %.6g mm is too small to reach the end of the arc", fabs(radius));
	default:
		return true;
	}
}

static vec3 centre_in_space(const struct state *state, const slot_values *start, const struct arc_plane *plane,
			    struct plane_point centre)
{
	double xyz[3] = {start->v[SLOT_X], start->v[SLOT_Y], start->v[SLOT_Z]};

	xyz[plane->a] = centre.a;
	xyz[plane->b] = centre.b;
	return rotated_frame_point(state, (vec3){xyz[0], xyz[1], xyz[2]});
}

/* The number of full turns in the block's P, on controls where P is this number. */
static bool find_turns(struct interp *interp, int *turns)
{
	enum answer has_turns = traits_of(interp)->arcs_have_turns;

	return is_answered(interp, block_column(&interp->block, 'P'), has_turns,
			   "whether P of G2 and G3 is the number of turns") &&
	       (has_turns == ANSWER_NO || block_integer(&interp->block, &interp->at, 'P', 1, INT_MAX, turns));
}

/* Has the block neither a centre nor a radius, and does the control then move on a straight line? */
static bool is_line(const struct interp *interp)
{
	const uint32_t words = letter_bit('I') | letter_bit('J') | letter_bit('K') | letter_bit('R');

	return !(interp->block.letters & words) &&
	       traits_of(interp)->arc_without_centre == ARC_WITHOUT_CENTRE_LINE;
}

static bool go_straight(struct interp *interp)
{
	struct canon_move move = {.kind = CANON_FEED};
	slot_values target;

	if (!(interp->block.letters & AXIS_BITS))
		return true;
	if (!interp->cautioned_line)
		caution(&interp->at, block_motion_column(&interp->block),
			"an arc without centre (I, J, K) and radius (R): this control moves straight to the end point "
			"or stops with an alarm; the straight move is checked, here and further on");
	interp->cautioned_line = true;
	if (!motion_commands_feed(interp, &move.feed) || !endpoint_find(interp, false, &target))
		return false;
	return cutter_comp_is_on(interp) ? cutter_comp_line(interp, &target, &move)
					 : motion_commands_go(interp, &target, &move);
}

/* LinuxCNC's manual, "G2, G3 Arc Move". */
/* Has the machine the axes of the arc's plane, and the block its centre or its radius? False: reported. */
static bool check_words(const struct interp *interp, const struct arc_plane *plane)
{
	const struct block *block = &interp->block;
	const uint32_t offsets = letter_bit('I') | letter_bit('J') | letter_bit('K');
	const bool *has_axis = interp->config->has_axis;

	if (interp->state.polar.on)
		return fault(&interp->at, block_motion_column(block),
			     "an arc in polar coordinates (G16) is not supported; write G15 first");
	if (!has_axis[plane->a] || !has_axis[plane->b])
		return fault(&interp->at, block_motion_column(block),
			     "the machine has no %c axis, which is needed for an arc in the plane of G%d",
			     AXIS_LETTERS[has_axis[plane->a] ? plane->b : plane->a], plane->code / 10);
	if (!block_has(block, 'R') && !(block->letters & offsets))
		return fault(&interp->at, block_motion_column(block),
			     "an arc needs a centre (I, J, K) or a radius (R)");
	return true;
}

/* Is the start of the arc known? Not if a probe has stopped an axis of its plane. False: reported. */
static bool check_start(struct interp *interp, const struct arc_plane *plane)
{
	const bool *bounded = interp->state.probe_bounded;
	const int column = block_motion_column(&interp->block);

	return (!bounded[plane->a] || probed_axes_is_known(interp, (int)plane->a, column)) &&
	       (!bounded[plane->b] || probed_axes_is_known(interp, (int)plane->b, column));
}

static struct plane_point in_plane(const struct arc_plane *plane, const slot_values *position)
{
	return (struct plane_point){position->v[plane->a], position->v[plane->b]};
}

/* Sends the arc from the present position, when no move before it waits. */
static bool send_arc(struct interp *interp, const struct arc_plane *plane, const slot_values *target,
		     struct plane_point centre, int turns, struct canon_move *move)
{
	const slot_values here = rotated_frame_straight(&interp->state);
	const struct plane_point start = in_plane(plane, &here), end = in_plane(plane, target);

	if (cutter_comp_is_on(interp))
		return cutter_comp_arc(interp, target, centre, turns, move);
	move->arc.centre = centre_in_space(&interp->state, &here, plane, centre);
	move->arc.normal = rotated_frame_normal(&interp->state, plane->normal);
	move->arc.sweep = arc_sweep(start, end, centre, interp->block.motion == G2, turns,
				    fmax(SAME_ANGLE, SAME_POINT / math_hypot(start.a - centre.a, start.b - centre.b)));
	return motion_commands_go(interp, target, move);
}

/* After a fault the start of the arc is not known. A line to its end updates the position; no move is sent any more. */
static bool go_from_lost(struct interp *interp, const slot_values *target)
{
	struct canon_move move = {.kind = CANON_FEED};

	return cutter_comp_is_on(interp) ? cutter_comp_line(interp, target, &move)
					 : motion_commands_go(interp, target, &move);
}

bool arc_move_run(struct interp *interp)
{
	const struct block *block = &interp->block;
	const struct arc_plane *plane = find_plane(interp->state.plane);
	const slot_values here = rotated_frame_straight(&interp->state);
	struct canon_move move = {.kind = CANON_ARC};
	struct plane_point start = in_plane(plane, &here), end, centre;
	const uint32_t lost = interp->lost;
	slot_values target;
	int turns = 1;

	if (interp->state.cylinder.on)
		return cylinder_arc(interp);
	interp->state.motion = block->motion;
	if (is_line(interp))
		return go_straight(interp);
	if (!check_words(interp, plane) || !motion_commands_feed(interp, &move.feed) ||
	    !endpoint_find(interp, false, &target))
		return false;
	if (lost & (letter_bit(AXIS_LETTERS[plane->a]) | letter_bit(AXIS_LETTERS[plane->b])))
		return go_from_lost(interp, &target);
	/* On LinuxCNC both the arc and a G64 of the block take P. */
	if ((block_has(block, 'P') && !find_turns(interp, &turns)) || !check_start(interp, plane))
		return false;
	end = in_plane(plane, &target);
	if (block_has(block, 'R') ? !find_arc_by_radius(interp, plane, start, end, &centre)
				  : !find_arc_by_centre(interp, plane, start, end, &centre))
		return false;
	if (interp->comp.arc_refused)
		return fault(&interp->at, block_motion_column(block),
			     "the first move after cutter compensation (G40) must be straight, not an arc");
	if (corner_insert_concerns(interp)) {
		bool waits = false;
		const struct corner_move next = {.target = &target, .move = &move, .is_arc = true, .centre = centre};

		if (!corner_insert_pass(interp, &next, &waits) || waits)
			return waits;
	}
	return send_arc(interp, plane, &target, centre, turns, &move);
}
