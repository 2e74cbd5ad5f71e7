#include "gcode/dialect/sinumerik/frames/sinumerik_open_place.h"

#include <math.h>

#include "gcode/dialect/sinumerik/frames/sinumerik_frame.h"
#include "gcode/execute/rotated_frame.h"

bool sinumerik_open_place_check(const struct interp *interp, int column, const char *what)
{
	const double *loose = interp->comp.loose;

	/* Cutter compensation also makes positions uncertain; it does not start before this uncertainty has ended. */
	if (!sinumerik_of(interp)->open.on || !(loose[SLOT_X] > 0 || loose[SLOT_Y] > 0 || loose[SLOT_Z] > 0))
		return true;
	return fault(&interp->at, column,
		     "%s from where a milling cycle has left the tool: where it stands over its region is not known; "
		     "go to an absolute position in the plane first",
		     what);
}

/* The extent of the box along the controller's axes. */
static void set_loose(struct interp *interp)
{
	const vec3 *side = sinumerik_of(interp)->open.box.half;
	double *loose = interp->comp.loose;

	loose[SLOT_X] = fabs(side[0].x) + fabs(side[1].x) + fabs(side[2].x);
	loose[SLOT_Y] = fabs(side[0].y) + fabs(side[1].y) + fabs(side[2].y);
	loose[SLOT_Z] = fabs(side[0].z) + fabs(side[1].z) + fabs(side[2].z);
}

/* A box with this extent along the axes of the program (mm), in the coordinates of the controller. */
static struct parallel_box box_about_place(const struct interp *interp, const double half[SLOT_Z + 1])
{
	const struct state *state = &interp->state;

	return (struct parallel_box){{rotated_frame_direction(state, (vec3){half[SLOT_X], 0, 0}),
				      rotated_frame_direction(state, (vec3){0, half[SLOT_Y], 0}),
				      rotated_frame_direction(state, (vec3){0, 0, half[SLOT_Z]})}};
}

void sinumerik_open_place_set(struct interp *interp, const double half[SLOT_Z + 1])
{
	struct sinumerik *sinumerik = sinumerik_of(interp);

	sinumerik->open.box = box_about_place(interp, half);
	sinumerik->open.on = true;
	/* In rotated coordinates, only the dialect knows which uncertainty the words of a block end. */
	interp->comp.keeps_loose = true;
	set_loose(interp);
}

void sinumerik_open_place_take_over(struct interp *interp)
{
	struct sinumerik *sinumerik = sinumerik_of(interp);

	if (!sinumerik->open.on)
		sinumerik->open.box = parallel_moves_box(interp->comp.loose);
	sinumerik->open.on = interp->comp.keeps_loose = true;
}

/* The extent of the box along the current axes of the program. */
static void extent(const struct interp *interp, double along[SLOT_Z + 1])
{
	along[SLOT_X] = along[SLOT_Y] = along[SLOT_Z] = 0;
	for (int i = 0; i < 3 && sinumerik_of(interp)->open.on; i++) {
		const vec3 side =
		    rotated_frame_straight_direction(&interp->state, sinumerik_of(interp)->open.box.half[i]);

		along[SLOT_X] += fabs(side.x);
		along[SLOT_Y] += fabs(side.y);
		along[SLOT_Z] += fabs(side.z);
	}
}

#define LINEAR_BITS (letter_bit('X') | letter_bit('Y') | letter_bit('Z'))

void sinumerik_open_place_settle(struct interp *interp, uint32_t letters)
{
	double half[SLOT_Z + 1];

	if (!sinumerik_of(interp)->open.on || !(letters & LINEAR_BITS))
		return;
	extent(interp, half);
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		if (letters & letter_bit(AXIS_LETTERS[slot]))
			half[slot] = 0;
	}
	sinumerik_open_place_set(interp, half);
}

void sinumerik_open_place_settle_machine(struct interp *interp, uint32_t letters)
{
	double *loose = interp->comp.loose;

	if (!sinumerik_of(interp)->open.on || !(letters & LINEAR_BITS))
		return;
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		if (letters & letter_bit(AXIS_LETTERS[slot]))
			loose[slot] = 0;
	}
	sinumerik_of(interp)->open.box = parallel_moves_box(loose);
}

/*
 * The tool is parallel to the Z axis of the machine and perpendicular to the plane, so heights above the plane are
 * heights along Z.
 */
static void lay_upright(struct interp *interp)
{
	const struct sinumerik *sinumerik = sinumerik_of(interp);
	const vec3 up = sinumerik->frames.swivel.matrix.z, *side = sinumerik->open.box.half;
	double *loose = interp->comp.loose;

	loose[SLOT_X] = loose[SLOT_Z] = 0;
	for (int i = 0; i < 3; i++) {
		const double height = vec3_dot(side[i], up);

		loose[SLOT_Z] += fabs(height);
		loose[SLOT_X] += vec3_norm(vec3_mad(side[i], -height, up));
	}
	loose[SLOT_Y] = loose[SLOT_X];
}

void sinumerik_open_place_turned(struct interp *interp)
{
	const struct sinumerik *sinumerik = sinumerik_of(interp);
	double *loose = interp->comp.loose;
	const double most = vec3_norm((vec3){loose[SLOT_X], loose[SLOT_Y], loose[SLOT_Z]});

	if (sinumerik->open.on && sinumerik->frames.swivelled && sinumerik->frames.tool_upright)
		lay_upright(interp);
	else
		loose[SLOT_X] = loose[SLOT_Y] = loose[SLOT_Z] = most;
	sinumerik_of(interp)->open.box = parallel_moves_box(loose);
}

bool sinumerik_open_place_go(struct interp *interp, const slot_values *target, const double half[SLOT_Z + 1],
			     double feed)
{
	struct canon_move move = {.kind = feed > 0 ? CANON_FEED : CANON_RAPID, .feed.linear = feed};
	const slot_values straight = sinumerik_frame_straight(interp, target);
	struct parallel_box about_it;
	double all[SLOT_Z + 1];

	/* The tool is where another cycle has left it. */
	extent(interp, all);
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++)
		all[slot] += half[slot];
	sinumerik_open_place_settle(interp, letter_bit('X') | letter_bit('Y') | letter_bit('Z'));
	about_it = box_about_place(interp, all);
	if (!parallel_moves_go(interp, &straight, &move, &about_it))
		return false;
	sinumerik_of(interp)->place.program = *target;
	sinumerik_of(interp)->place.known = true;
	return true;
}
