#include "scene/setup_check.h"

#include <math.h>
#include <stdlib.h>

#include "base/mem.h"
#include "machine/chain.h"
#include "machine/kinematics_check.h"
#include "scene/corner_depth.h"
#include "scene/placed_box.h"

/* mm: a body within this distance of another one is held by it. */
static const double HELD_WITHIN = 2;
/* mm: the largest overlap of drawn bodies that is accepted (a clamp that presses, a rounded coordinate). */
static const double SUNK_BY = 1;
/* The size of a part divided by the longest travel of the machine. */
static const double PART_LEAST = 0.015, PART_MOST = 1.5;
/* The length of a tool divided by the travel along the spindle. */
static const double TOOL_LEAST = 0.02, TOOL_MOST = 1.5;
/* mm: something is reported only if it is out of reach by more than this. */
static const double OUT_OF_REACH = 10;
/*
 * The largest distance of a program zero from everything that is set up, in mm and as a share of the size of the setup.
 */
static const double ZERO_OFF = 50, ZERO_OFF_SHARE = 0.25;

static bool is_set_up(const struct scene *scene, int body)
{
	enum body_role role = scene->bodies[body].body->role;

	return role == ROLE_FIXTURE || role == ROLE_PART || role == ROLE_STOCK;
}

/* The machine's own bodies that move with the workholding. */
static bool is_table(const struct scene *scene, int body)
{
	return body_is_of_link(scene->bodies[body].body, scene->machine->workholding.link);
}

/* A lower bound of the distance of two bodies on one link, at least 0.9 of the distance. */
static double distance_apart(struct scene *scene, int a, int b)
{
	const struct chain rigid = {0};
	const axis_values home = {{0}};
	struct body_pair bodies;

	body_pair_init(&bodies, scene->bodies[a].bvh, scene->bodies[b].bvh, &scene->bodies[a].body->placement,
		       &scene->bodies[b].body->placement, &rigid);
	return sweep_distance(&scene->sweep, &bodies, &home, 0.9, HELD_WITHIN, 0);
}

/* ---------------------------------------------------------------- what holds what */

/* Does a body hold another one? The part is inside the stock, perhaps far from its surface. */
static bool holds(struct scene *scene, int body, int other)
{
	const double overlap = placed_box_overlap(placed_box_of(scene, body), placed_box_of(scene, other));

	if (overlap > 0 && scene->bodies[body].body->role == ROLE_STOCK && scene->bodies[other].body->role == ROLE_PART)
		return true;
	return overlap >= -HELD_WITHIN && distance_apart(scene, body, other) <= HELD_WITHIN;
}

/* Marks all bodies that are held by a held body, until none is added. */
static void spread_hold(struct scene *scene, bool *held)
{
	bool added = true;

	while (added) {
		added = false;
		for (int i = 0; i < (int)scene->body_count; i++) {
			for (int k = 0; k < (int)scene->body_count && is_set_up(scene, i) && !held[i]; k++) {
				if (held[k] && holds(scene, k, i))
					held[i] = added = true;
			}
		}
	}
}

static void add_floating(struct scene *scene, int body, const bool *held, struct doubts *doubts)
{
	struct doubt doubt = {.kind = DOUBT_FLOATS, .body = body, .value = INFINITY};

	for (int k = 0; k < (int)scene->body_count; k++) {
		double d = held[k] ? distance_apart(scene, body, k) : INFINITY;

		if (d < doubt.value) {
			doubt.value = d;
			doubt.against = k;
		}
	}
	doubts_add(doubts, &doubt);
}

/* If neither a table nor a fixture is drawn, nothing can be decided. */
static void check_held(struct scene *scene, struct doubts *doubts)
{
	bool *held = mem_zalloc(scene->body_count + 1, sizeof(*held)), any = false;

	for (int i = 0; i < (int)scene->body_count; i++)
		any |= held[i] = is_table(scene, i);
	for (int i = 0; i < (int)scene->body_count && !any; i++)
		held[i] = scene->bodies[i].body->role == ROLE_FIXTURE;
	spread_hold(scene, held);
	for (int i = 0; i < (int)scene->body_count; i++)
		any |= held[i];
	for (int i = 0; i < (int)scene->body_count && any; i++) {
		if (is_set_up(scene, i) && !held[i] && !scene->bodies[i].body->checked)
			add_floating(scene, i, held, doubts);
	}
	free(held);
}

/* Fixtures stand on the fixtures before them, part and stock on all of them. */
static bool is_below(const struct scene *scene, int fixture, int other)
{
	return scene->bodies[fixture].body->role == ROLE_FIXTURE &&
	       (scene->bodies[other].body->role != ROLE_FIXTURE || fixture < other);
}

static void check_sunk(struct scene *scene, struct doubts *doubts)
{
	const axis_values zero = {{0}};

	for (int i = 0; i < (int)scene->body_count; i++) {
		struct doubt doubt = {.kind = DOUBT_SINKS, .body = i};

		if (!is_set_up(scene, i) || scene->bodies[i].body->checked)
			continue;
		for (int k = 0; k < (int)scene->body_count; k++) {
			if (k == i || !(is_table(scene, k) || is_below(scene, k, i)) ||
			    placed_box_overlap(placed_box_of(scene, i), placed_box_of(scene, k)) < SUNK_BY)
				continue;
			doubt.value = fmax(corner_depth(scene, i, k, &zero, INSIDE_YES, 0),
					   corner_depth(scene, k, i, &zero, INSIDE_YES, 0));
			doubt.against = k;
			if (doubt.value > SUNK_BY)
				doubts_add(doubts, &doubt);
		}
	}
}

/* ---------------------------------------------------------------- sizes and reach */

static double thinnest_cutter(const struct setup *setup)
{
	double thinnest = INFINITY;

	for (size_t i = 0; i < setup->tool_count; i++) {
		if (setup->tools[i].diameter > 0)
			thinnest = fmin(thinnest, setup->tools[i].diameter);
	}
	return thinnest;
}

static void check_sizes(const struct scene *scene, struct doubts *doubts)
{
	double travel = kinematics_longest_travel(scene->machine), cutter = thinnest_cutter(scene->setup);

	for (int i = 0; i < (int)scene->body_count; i++) {
		struct doubt doubt = {.kind = DOUBT_PART_LARGE, .body = i, .limit = travel};

		if (!is_set_up(scene, i) || scene->bodies[i].body->checked)
			continue;
		doubt.value = placed_box_size(placed_box_of(scene, i));
		if (travel > 0 && doubt.value < PART_LEAST * travel) {
			doubt.kind = DOUBT_BODY_SMALL;
		} else if (doubt.value < cutter && !isinf(cutter) && scene->bodies[i].body->role == ROLE_PART) {
			doubt.kind = DOUBT_PART_BELOW_CUTTERS;
			doubt.limit = cutter;
		} else if (!(travel > 0) || doubt.value < PART_MOST * travel) {
			continue;
		}
		doubts_add(doubts, &doubt);
	}
}

/* The part's extent along a direction, as seen from the workholding's origin. */
static void extent(const struct scene *scene, struct placed_box box, vec3 along, double *least, double *greatest)
{
	vec3 middle = vec3_scale(0.5, vec3_add(box.least, box.greatest)), half = vec3_sub(box.greatest, middle);
	double at = vec3_dot(vec3_sub(middle, scene->machine->workholding.frame.translation), along);
	double reach = fabs(along.x) * half.x + fabs(along.y) * half.y + fabs(along.z) * half.z;

	*least = at - reach;
	*greatest = at + reach;
}

/* Checks positions across the spindle, which do not depend on the tool. */
static void check_beside(const struct scene *scene, struct doubts *doubts)
{
	vec3 across[2];

	kinematics_sideways(scene->machine, across);
	for (int i = 0; i < (int)scene->body_count; i++) {
		struct doubt doubt = {.kind = DOUBT_PART_BESIDE, .body = i};

		if (scene->bodies[i].body->role != ROLE_PART || scene->bodies[i].body->checked)
			continue;
		for (int k = 0; k < 2; k++) {
			double from, to, least, greatest;

			extent(scene, placed_box_of(scene, i), across[k], &from, &to);
			kinematics_range(scene->machine, across[k], &least, &greatest);
			doubt.value = fmax(doubt.value, fmax(from - greatest, least - to));
		}
		if (doubt.value > OUT_OF_REACH)
			doubts_add(doubts, &doubt);
	}
}

/* The box of all parts; without parts the box of everything that is set up; false: there is nothing. */
static bool box_of_setup(const struct scene *scene, bool parts_only, struct placed_box *box)
{
	*box = placed_box_empty();
	for (int i = 0; i < (int)scene->body_count; i++) {
		if (is_set_up(scene, i) && (!parts_only || scene->bodies[i].body->role == ROLE_PART))
			*box = placed_box_union(*box, placed_box_of(scene, i));
	}
	return !isinf(box->least.x);
}

/* Heights are measured in the direction from the tool's tip to the spindle. */
static void check_tool_reach(const struct scene *scene, size_t item, struct doubts *doubts)
{
	const vec3 up = vec3_scale(-1, scene->machine->spindle.direction);
	const double length = scene->setup->tools[item].length;
	double low, high, bottom, top;
	struct placed_box box;

	kinematics_range(scene->machine, up, &low, &high);
	if (box_of_setup(scene, true, &box)) {
		extent(scene, box, up, &bottom, &top);
		if (low - length > top + OUT_OF_REACH)
			doubts_add(doubts, &(struct doubt){
					       .kind = DOUBT_TOOL_SHORT, .item = item, .value = low - length - top});
	}
	if (box_of_setup(scene, false, &box)) {
		extent(scene, box, up, &bottom, &top);
		if (high - length < bottom)
			doubts_add(
			    doubts,
			    &(struct doubt){.kind = DOUBT_TOOL_BELOW, .item = item, .value = bottom - (high - length)});
	}
}

static double travel_along_spindle(const struct machine *machine)
{
	double least, greatest;

	kinematics_range(machine, machine->spindle.direction, &least, &greatest);
	return greatest - least;
}

static void check_tool_length(const struct scene *scene, size_t item, struct doubts *doubts)
{
	const struct tool *tool = &scene->setup->tools[item];
	struct doubt doubt = {.item = item, .value = tool->length, .limit = travel_along_spindle(scene->machine)};

	if (!(doubt.limit > 0) || isinf(doubt.limit))
		return;
	if (tool->length > TOOL_MOST * doubt.limit)
		doubt.kind = DOUBT_TOOL_LONG;
	else if (tool->length < TOOL_LEAST * doubt.limit && tool->length < tool->diameter)
		doubt.kind = DOUBT_TOOL_TINY;
	else
		return;
	doubts_add(doubts, &doubt);
}

/* ---------------------------------------------------------------- lengths and offsets */

/*
 * The difference between the tool's H and its length. It is the same for all tools if lengths are measured from another
 * point.
 */
static double length_error(const struct setup *setup, size_t item)
{
	for (size_t i = 0; i < setup->length_count; i++) {
		if (setup->lengths[i].number == setup->tools[item].number)
			return setup->lengths[i].length - setup->tools[item].length;
	}
	return 0;
}

/* A tool with an H of 0 is used without compensation. */
static void check_length_offsets(const struct scene *scene, struct doubts *doubts)
{
	const struct setup *setup = scene->setup;

	for (size_t i = 0; i < setup->tool_count; i++) {
		double error = length_error(setup, i), value = setup->tools[i].length + error;
		size_t alike = 0;

		for (size_t k = 0; k < setup->tool_count; k++)
			alike += fabs(length_error(setup, k) - error) < 0.5;
		if (fabs(error) < 0.5 || fabs(value) < 1e-9 || (alike > 1 && 2 * alike > setup->tool_count) ||
		    setup->tools[i].checked)
			continue;
		doubts_add(doubts, &(struct doubt){.kind = DOUBT_LENGTH_OFFSET, .item = i, .value = value,
						   .limit = setup->tools[i].length});
	}
}

/*
 * Along the spindle, a program zero may be lower than the lowest gauge point, because the tool's length is added and
 * because the tool need not reach the zero itself.
 */
static void check_offset_travel(const struct scene *scene, size_t item, struct doubts *doubts)
{
	const struct machine *machine = scene->machine;
	double longest = 0;

	for (size_t i = 0; i < scene->setup->tool_count; i++)
		longest = fmax(longest, scene->setup->tools[i].length);
	for (size_t i = 0; i < machine->axis_count; i++) {
		const struct axis *axis = &machine->axes[i];
		double value = scene->setup->offsets[item].value.v[axis->slot], room = axis->rotary ? 0.02 : 1,
		       below = room;
		bool along = !axis->rotary && machine->spindle.present && kinematics_side(machine, axis) &&
			     fabs(vec3_dot(axis->direction, machine->spindle.direction)) > 0.5;

		if (along)
			below += longest + 0.5 * (axis->limit_max - axis->limit_min);
		if (value >= axis->limit_min - below && value <= axis->limit_max + room)
			continue;
		doubts_add(doubts,
			   &(struct doubt){.kind = DOUBT_OFFSET_OUTSIDE, .item = item, .axis = (int)i, .value = value});
	}
}

/* The distance of the tip from the box at program zero; `lift`: by how much the tool is longer than its H. */
static double zero_distance(const struct scene *scene, size_t item, double lift, struct placed_box box)
{
	const struct machine *machine = scene->machine;
	const axis_values *q = &scene->setup->offsets[item].value;
	xform tool = machine_pose(machine, machine->spindle.link, q);
	xform work = machine_pose(machine, machine->workholding.link, q);
	xform back = xform_inverse(&work);
	vec3 gauge = vec3_mad(machine->spindle.location, lift, machine->spindle.direction);

	return placed_box_distance(box, xform_apply(&back, xform_apply(&tool, gauge)));
}

/* Program zero may be where the work rotates, or at the workholding, far from a part that stands on a high fixture. */
static bool is_at_work_zero(const struct scene *scene, size_t item, double lift)
{
	const vec3 holding = scene->machine->workholding.frame.translation;
	const struct placed_box origin = {holding, holding};

	return zero_distance(scene, item, lift, origin) < ZERO_OFF;
}

static void check_zero(const struct scene *scene, size_t item, struct doubts *doubts)
{
	const struct setup *setup = scene->setup;
	struct doubt doubt = {.kind = DOUBT_OFFSET_FAR, .item = item, .value = INFINITY};
	struct placed_box box;

	if (!box_of_setup(scene, false, &box))
		return;
	doubt.limit = placed_box_size(box);
	for (size_t i = 0; i == 0 || i < setup->tool_count; i++) {
		double lift = setup->tool_count ? -length_error(setup, i) : 0;

		if (is_at_work_zero(scene, item, lift))
			return;
		doubt.value = fmin(doubt.value, zero_distance(scene, item, lift, box));
	}
	if (doubt.value > fmax(ZERO_OFF, ZERO_OFF_SHARE * doubt.limit))
		doubts_add(doubts, &doubt);
}

void setup_check(struct scene *scene, struct doubts *doubts)
{
	const struct machine *machine = scene->machine;
	const struct setup *setup = scene->setup;
	bool both = machine->spindle.present && machine->workholding.present;

	if (!setup)
		return;
	if (machine->workholding.present) {
		check_held(scene, doubts);
		check_sunk(scene, doubts);
		check_sizes(scene, doubts);
	}
	if (both && !machine->workholding.checked && !machine->spindle.checked)
		check_beside(scene, doubts);
	for (size_t i = 0; i < setup->tool_count && both; i++) {
		if (setup->tools[i].checked)
			continue;
		check_tool_reach(scene, i, doubts);
		check_tool_length(scene, i, doubts);
	}
	check_length_offsets(scene, doubts);
	for (size_t i = 0; i < setup->offset_count; i++) {
		if (setup->offsets[i].checked)
			continue;
		check_offset_travel(scene, i, doubts);
		if (both)
			check_zero(scene, i, doubts);
	}
}
