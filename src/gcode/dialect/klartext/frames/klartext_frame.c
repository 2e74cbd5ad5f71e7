#include "gcode/dialect/klartext/frames/klartext_frame.h"

#include <math.h>

#include "base/same_double.h"
#include "base/units.h"
#include "gcode/dialect/klartext/text/klartext_lexis.h"
#include "gcode/execute/tool_length.h"
#include "geom/tolerance.h"

/* --------------------------------------------------------------- the frame */

static bool is_one(double factor)
{
	return same_double(factor, 1);
}

static vec3 times(vec3 a, vec3 b)
{
	return (vec3){a.x * b.x, a.y * b.y, a.z * b.z};
}

static bool is_same_turn(const mat3 *a, const mat3 *b)
{
	return vec3_norm(vec3_sub(a->x, b->x)) + vec3_norm(vec3_sub(a->y, b->y)) + vec3_norm(vec3_sub(a->z, b->z)) <=
	       DIRECTION_TOLERANCE;
}

void klartext_frame_update(struct interp *interp)
{
	struct klartext_frame *frame = &klartext_of(interp)->frame;
	const double sign[3] = {frame->mirror[0] ? -1 : 1, frame->mirror[1] ? -1 : 1, frame->mirror[2] ? -1 : 1};
	mat3 turn = mat3_turn((vec3){0, 0, 1}, radians(frame->rotation)), mirror = mat3_identity();
	vec3 fixed = times(vec3_sub((vec3){1, 1, 1}, frame->factor), frame->centre);

	mirror.x.x = sign[0];
	mirror.y.y = sign[1];
	mirror.z.z = sign[2];
	turn = mat3_mul(&turn, &mirror);
	frame->scale = frame->factor;
	frame->origin = vec3_add(frame->inner, mat3_apply(&turn, fixed));
	if (frame->tilted) {
		frame->origin = mat3_apply(&frame->tilt, frame->origin);
		turn = mat3_mul(&frame->tilt, &turn);
	}
	/* The end direction of the last move belongs to the coordinates before the change. */
	if (!is_same_turn(&frame->turn, &turn))
		klartext_of(interp)->last.known = false;
	frame->turn = turn;
	frame->origin = vec3_add(frame->origin, frame->shift);
	frame->any = frame->tilted || klartext_frame_is_inner(frame) || !vec3_is_zero(frame->shift);
	interp->state.own_frame = frame->any;
}

bool klartext_frame_is_inner(const struct klartext_frame *frame)
{
	return frame->mirror[0] || frame->mirror[1] || frame->mirror[2] || !same_double(frame->rotation, 0) ||
	       !is_one(frame->factor.x) || !is_one(frame->factor.y) || !is_one(frame->factor.z) ||
	       !vec3_is_zero(frame->inner);
}

static vec3 offset_of(const struct interp *interp)
{
	const double *v = interp->state.offset.v;

	return (vec3){v[SLOT_X], v[SLOT_Y], v[SLOT_Z]};
}

/* Converts a programmed point to coordinates from the work offset. The function `back` converts the other way. */
static vec3 forth(const struct klartext_frame *frame, vec3 point)
{
	return frame->any ? vec3_add(frame->origin, mat3_apply(&frame->turn, times(frame->scale, point))) : point;
}

static vec3 back(const struct klartext_frame *frame, vec3 point)
{
	if (!frame->any)
		return point;
	point = mat3_apply_transposed(&frame->turn, vec3_sub(point, frame->origin));
	return (vec3){point.x / frame->scale.x, point.y / frame->scale.y, point.z / frame->scale.z};
}

vec3 klartext_frame_position(const struct interp *interp, vec3 point)
{
	return vec3_add(offset_of(interp), forth(&klartext_of(interp)->frame, point));
}

vec3 klartext_frame_point(const struct interp *interp)
{
	const double *v = interp->state.position.v;

	return back(&klartext_of(interp)->frame, vec3_sub((vec3){v[SLOT_X], v[SLOT_Y], v[SLOT_Z]}, offset_of(interp)));
}

static vec3 work_of(const struct interp *interp)
{
	const double *v = interp->state.work[interp->state.system].v;

	return (vec3){v[SLOT_X], v[SLOT_Y], v[SLOT_Z]};
}

vec3 klartext_frame_place_of(const struct interp *interp, vec3 point)
{
	return vec3_add(work_of(interp), forth(&klartext_of(interp)->frame, point));
}

vec3 klartext_frame_point_at(const struct interp *interp, vec3 place)
{
	return back(&klartext_of(interp)->frame, vec3_sub(place, work_of(interp)));
}

bool klartext_frame_check_increment(struct interp *interp, int slot, int column)
{
	const vec3 off = vec3_sub(klartext_frame_point(interp), klartext_of(interp)->programmed);
	const double by = slot == SLOT_X ? off.x : slot == SLOT_Y ? off.y : off.z;

	return fabs(by) <= SAME_COORDINATE ||
	       interp->config->controller.increments_after_shift == INCREMENTS_FROM_POSITION ||
	       fault(&interp->at, column,
		     "an increment of %c after a change of coordinates or a move that was not programmed in them: "
		     "from where the control counts is not known here; give %c as an absolute coordinate first, or "
		     "set increments_after_shift=\"stay\" in the machine file's <controller> if it counts from "
		     "where the axis stands",
		     AXIS_LETTERS[slot], AXIS_LETTERS[slot]);
}

vec3 klartext_frame_direction(const struct interp *interp, vec3 direction)
{
	const struct klartext_frame *frame = &klartext_of(interp)->frame;

	return frame->any ? mat3_apply(&frame->turn, direction) : direction;
}

struct parallel_box klartext_frame_turned_box(const struct interp *interp, const double half[3])
{
	return (struct parallel_box){{klartext_frame_direction(interp, (vec3){half[0], 0, 0}),
				      klartext_frame_direction(interp, (vec3){0, half[1], 0}),
				      klartext_frame_direction(interp, (vec3){0, 0, half[2]})}};
}

vec3 klartext_frame_box(const struct interp *interp, const double half[3])
{
	const struct parallel_box box = klartext_frame_turned_box(interp, half);
	const vec3 *side = box.half;

	return (vec3){fabs(side[0].x) + fabs(side[1].x) + fabs(side[2].x),
		      fabs(side[0].y) + fabs(side[1].y) + fabs(side[2].y),
		      fabs(side[0].z) + fabs(side[1].z) + fabs(side[2].z)};
}

bool klartext_frame_check_zero(struct interp *interp, int column)
{
	const struct controller *controller = &interp->config->controller;

	for (int slot = SLOT_A; slot <= SLOT_C; slot++) {
		if (!interp->config->has_axis[slot] || same_double(interp->state.offset.v[slot], 0))
			continue;
		if (controller->tcp_zero_given != ANSWER_YES)
			return fault(
			    &interp->at, column,
			    "%c has a preset or a datum shift: a machine parameter decides whether M128, TCPM and "
			    "PLANE count it from there: set tcp_zero=\"machine\" or \"offset\" in the machine "
			    "file's <controller>",
			    AXIS_LETTERS[slot]);
		if (!controller->tcp_zero_offset && !same_double(interp->state.shift.v[slot], 0))
			return fault(
			    &interp->at, column,
			    "a datum shift of %c with M128, TCPM or PLANE is not supported where these count from "
			    "the machine's zero (tcp_zero=\"machine\")",
			    AXIS_LETTERS[slot]);
	}
	return true;
}

bool klartext_frame_check_shift(const struct interp *interp, unsigned axes, int column)
{
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		if (axes & klartext_of(interp)->shift.open & 1U << slot)
			return fault(&interp->at, column,
				     "the datum of %c was shifted before a tilted plane, and in it again: whether the "
				     "first shift counts behind the plane is not known here; set "
				     "shift_behind_plane=\"keeps\" or \"cancelled\" in the machine file's "
				     "<controller>, write CYCL DEF 7 with %c again, or end the plane before the "
				     "shift",
				     AXIS_LETTERS[slot], AXIS_LETTERS[slot]);
	}
	return true;
}

bool klartext_frame_is_scaled(const struct interp *interp)
{
	const vec3 factor = klartext_of(interp)->frame.factor;

	return !is_one(factor.x) || !is_one(factor.y) || !is_one(factor.z);
}

struct line_place klartext_frame_place(const struct interp *interp, long line)
{
	struct line_place at = interp->at;

	if (at.line != line) {
		at.line = line;
		at.text = "";
	}
	return at;
}
