#include "machine/kinematics_check.h"

#include <math.h>

#include "geom/xform.h"
#include "machine/chain.h"

/* Cosines. Directions within 10 degrees count as one line; directions more than 60 degrees apart count as different. */
static const double ONE_LINE = 0.985;
static const double RATHER_ALONG = 0.5;
/* Slanted beds and nutating axes are between two letters, so only a clear case is doubted. */
static const double CLEARLY_ALONG = 0.9;

/* The directions of the letters X Y Z, A B C and U V W in the drawing. */
static const vec3 drawing[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

static int letter_of(const struct axis *axis)
{
	return axis->slot % 3;
}

static int place_of(const struct machine *machine, const struct axis *axis)
{
	return (int)(axis - machine->axes);
}

int kinematics_side(const struct machine *machine, const struct axis *axis)
{
	const int link = place_of(machine, axis) + 1;
	bool tool = machine->spindle.present && machine_link_is_on(machine, machine->spindle.link, link);
	bool work = machine->workholding.present && machine_link_is_on(machine, machine->workholding.link, link);

	return tool - work;
}

vec3 kinematics_direction(const struct machine *machine, const struct axis *axis)
{
	return vec3_scale(kinematics_side(machine, axis), axis->direction);
}

/* The letter whose direction is nearest to that of `v` or of -v. */
static int nearest_letter(vec3 v)
{
	int nearest = 0;

	for (int k = 1; k < 3; k++) {
		if (fabs(vec3_dot(v, drawing[k])) > fabs(vec3_dot(v, drawing[nearest])))
			nearest = k;
	}
	return nearest;
}

/* The machine's X Y Z, which determine the letters of its rotary axes. */
struct frame {
	bool whole;	/* all three axes move the tool or the work; else the vectors are the drawing's */
	bool checked;	/* one of them is marked checked="" */
	vec3 v[3];
};

static struct frame find_frame(const struct machine *machine)
{
	struct frame frame = {true, false, {drawing[0], drawing[1], drawing[2]}};

	for (int k = 0; k < 3; k++) {
		const struct axis *axis = machine_axis(machine, k);

		if (!axis || !kinematics_side(machine, axis))
			return (struct frame){false, false, {drawing[0], drawing[1], drawing[2]}};
		frame.checked |= axis->checked != NULL;
		frame.v[k] = kinematics_direction(machine, axis);
	}
	return frame;
}

static double hand(const struct frame *frame)
{
	return vec3_dot(frame->v[0], vec3_cross(frame->v[1], frame->v[2]));
}

/* Are the axes right-handed and perpendicular, but along other lines than the drawing's letters? */
static bool is_turned(const struct frame *frame)
{
	bool other = false;

	for (int k = 0; k < 3; k++)
		other |= nearest_letter(frame->v[k]) != k;
	return frame->whole && other && hand(frame) > CLEARLY_ALONG;
}

static void check_frame(const struct frame *frame, struct doubts *doubts)
{
	if (!frame->whole || frame->checked)
		return;
	if (hand(frame) < -0.1)
		doubts_add(doubts, &(struct doubt){.kind = DOUBT_LEFT_HANDED});
	if (is_turned(frame))
		doubts_add(doubts, &(struct doubt){.kind = DOUBT_TURNED});
}

/* X and U, Y and V, Z and W may share a line. */
static void check_parallel(const struct machine *machine, struct doubts *doubts)
{
	for (size_t i = 0; i < machine->axis_count; i++) {
		for (size_t j = i + 1; j < machine->axis_count; j++) {
			const struct axis *a = &machine->axes[i], *b = &machine->axes[j];
			double along = vec3_dot(kinematics_direction(machine, a), kinematics_direction(machine, b));

			if (a->rotary || b->rotary || a->checked || b->checked || letter_of(a) == letter_of(b) ||
			    fabs(along) < ONE_LINE)
				continue;
			doubts_add(doubts, &(struct doubt){.kind = DOUBT_PARALLEL, .axis = (int)i, .other = (int)j});
		}
	}
}

/* If the machine's frame is rotated, its letters are used; else the drawing's. */
static void check_axis(const struct machine *machine, const struct axis *axis, const struct frame *frame,
		       struct doubts *doubts)
{
	const vec3 *letters = is_turned(frame) ? frame->v : drawing;
	vec3 v = kinematics_direction(machine, axis);
	struct doubt doubt = {.axis = place_of(machine, axis), .direction = v};
	double own = vec3_dot(v, letters[letter_of(axis)]);

	for (int k = 1; k < 3; k++) {
		if (fabs(vec3_dot(v, letters[k])) > fabs(vec3_dot(v, letters[doubt.other])))
			doubt.other = k;
	}
	if (fabs(own) < RATHER_ALONG && fabs(vec3_dot(v, letters[doubt.other])) > CLEARLY_ALONG)
		doubt.kind = DOUBT_LETTER;
	else if (own < -RATHER_ALONG)
		doubt.kind = axis->rotary ? DOUBT_ROTARY_SIGN : DOUBT_SIGN;
	else
		return;
	doubts_add(doubts, &doubt);
}

/* X, Y and Z must move the tool relative to the work; U, V and W may move a magazine or a tailstock. */
static void check_idle(const struct machine *machine, struct doubts *doubts)
{
	for (int slot = SLOT_X; slot <= SLOT_Z && machine->spindle.present && machine->workholding.present; slot++) {
		const struct axis *axis = machine_axis(machine, slot);

		if (axis && !axis->checked && !kinematics_side(machine, axis))
			doubts_add(doubts, &(struct doubt){.kind = DOUBT_IDLE, .axis = place_of(machine, axis)});
	}
}

/* mm: the spindle's line and an axis' line are the same if the gauge point is within this distance of the axis. */
static const double ON_LINE = 0.01;

/* Of the rotary axes that carry a tool, the one next to it must change its direction, or shift it. */
static void check_next_to_tool(const struct machine *machine, struct doubts *doubts)
{
	const struct spindle *spindle = &machine->spindle;
	const struct axis *next = NULL;

	for (int link = spindle->link; spindle->present && link > 0; link = machine->axes[link - 1].parent) {
		const struct axis *axis = &machine->axes[link - 1];
		vec3 off = vec3_sub(spindle->location, axis->location);

		if (!axis->rotary)
			continue;
		if (next) {
			doubts_add(doubts, &(struct doubt){.kind = DOUBT_TURNS_ITSELF,
							   .axis = place_of(machine, next),
							   .other = place_of(machine, axis)});
			return;
		}
		if (axis->checked || vec3_norm(vec3_cross(axis->direction, spindle->direction)) > 1e-6 ||
		    vec3_norm(vec3_cross(axis->direction, off)) > ON_LINE)
			return;
		next = axis;
	}
}

static void check_spindle_and_z(const struct machine *machine, struct doubts *doubts)
{
	const struct axis *z = machine_axis(machine, SLOT_Z);
	double along;

	if (!z || z->checked || machine->spindle.checked || !machine->spindle.present || !kinematics_side(machine, z))
		return;
	along = vec3_dot(kinematics_direction(machine, z), machine->spindle.direction);
	if (along > RATHER_ALONG)
		doubts_add(doubts, &(struct doubt){.kind = DOUBT_SPINDLE_TOWARD, .axis = place_of(machine, z)});
	else if (along > -RATHER_ALONG)
		doubts_add(doubts, &(struct doubt){.kind = DOUBT_SPINDLE_ACROSS, .axis = place_of(machine, z)});
}

void kinematics_range(const struct machine *machine, vec3 along, double *least, double *greatest)
{
	vec3 apart = vec3_sub(machine->spindle.location, machine->workholding.frame.translation);

	*least = *greatest = vec3_dot(apart, along);
	for (size_t i = 0; i < machine->axis_count; i++) {
		const struct axis *axis = &machine->axes[i];
		double step = axis->rotary ? 0 : vec3_dot(kinematics_direction(machine, axis), along);

		if (!(fabs(step) > 1e-9))
			continue;
		*least += step > 0 ? step * axis->limit_min : step * axis->limit_max;
		*greatest += step > 0 ? step * axis->limit_max : step * axis->limit_min;
	}
}

void kinematics_sideways(const struct machine *machine, vec3 out[2])
{
	const vec3 tip = machine->spindle.direction;

	out[0] = vec3_unit(vec3_cross(tip, drawing[nearest_letter(tip) == 0 ? 1 : 0]));
	out[1] = vec3_cross(tip, out[0]);
}

double kinematics_longest_travel(const struct machine *machine)
{
	double longest = 0;

	for (size_t i = 0; i < machine->axis_count; i++) {
		const struct axis *axis = &machine->axes[i];
		double travel = axis->limit_max - axis->limit_min;

		if (!axis->rotary && kinematics_side(machine, axis) && !isinf(travel))
			longest = fmax(longest, travel);
	}
	return longest;
}

/*
 * The rotary axes are at 0. There the work must be drawn in front of the tool, even if a rotation could bring it there.
 */
static void check_places(const struct machine *machine, struct doubts *doubts)
{
	const vec3 tip = machine->spindle.direction;
	double least, greatest, worst = 0;
	vec3 sideways[2];

	if (!machine->spindle.present || !machine->workholding.present || machine->spindle.checked ||
	    machine->workholding.checked)
		return;
	kinematics_range(machine, tip, &least, &greatest);
	if (least > 0)
		doubts_add(doubts, &(struct doubt){.kind = DOUBT_SPINDLE_AWAY, .value = least});
	kinematics_sideways(machine, sideways);
	for (int k = 0; k < 2; k++) {
		double room;

		kinematics_range(machine, sideways[k], &least, &greatest);
		/* The origin of the workholding may be at the edge of a table; such a distance is not a mistake. */
		room = fmax(100, 0.5 * (greatest - least));
		worst = fmax(worst, fmax(least, -greatest) > room ? fmax(least, -greatest) : 0);
	}
	if (worst > 0)
		doubts_add(doubts, &(struct doubt){.kind = DOUBT_WORKHOLDING_BESIDE, .value = worst});
}

void kinematics_check(const struct machine *machine, struct doubts *doubts)
{
	const struct frame frame = find_frame(machine);

	check_frame(&frame, doubts);
	check_parallel(machine, doubts);
	for (size_t i = 0; i < machine->axis_count; i++) {
		const struct axis *axis = &machine->axes[i];

		if (!axis->checked && kinematics_side(machine, axis))
			check_axis(machine, axis, &frame, doubts);
	}
	check_idle(machine, doubts);
	check_next_to_tool(machine, doubts);
	check_spindle_and_z(machine, doubts);
	check_places(machine, doubts);
}
