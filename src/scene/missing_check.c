#include "scene/missing_check.h"

#include <math.h>

#include "machine/kinematics_check.h"
#include "scene/placed_box.h"

/* A travel divided by the extent of all bodies along it. Of 285 axes of real machines the largest is 0.83. */
static const double TRAVEL_MOST = 1.5;

static bool has_bodies(const struct scene *scene, int link)
{
	for (size_t i = 0; i < scene->body_count; i++) {
		if (body_is_of_link(scene->bodies[i].body, link))
			return true;
	}
	return false;
}

enum { LINKS_LEAST = 3 };

bool missing_is_drawn(const struct scene *scene)
{
	int links = 0;

	for (int link = 0; link <= (int)scene->machine->axis_count; link++)
		links += has_bodies(scene, link);
	return links >= LINKS_LEAST;
}

/* Tools and parts are closest to the links that hold the spindle and the work. */
static void check_links(const struct scene *scene, struct doubts *doubts)
{
	const struct spindle *spindle = &scene->machine->spindle;
	const struct workholding *workholding = &scene->machine->workholding;

	if (!spindle->checked && !has_bodies(scene, spindle->link))
		doubts_add(doubts, &(struct doubt){.kind = DOUBT_SPINDLE_BARE});
	if (!workholding->checked && !has_bodies(scene, workholding->link))
		doubts_add(doubts, &(struct doubt){.kind = DOUBT_WORKHOLDING_BARE});
	if (!scene->machine->base_checked && workholding->link != 0 && !has_bodies(scene, 0))
		doubts_add(doubts, &(struct doubt){.kind = DOUBT_BASE_BARE});
}

/* The extent of the machine's own bodies along a direction. */
static double extent_along(const struct scene *scene, vec3 along)
{
	struct placed_box box = placed_box_empty();
	vec3 size;

	for (size_t i = 0; i < scene->body_count; i++) {
		if (scene->bodies[i].body->role == ROLE_MACHINE)
			box = placed_box_union(box, placed_box_of(scene, (int)i));
	}
	size = vec3_sub(box.greatest, box.least);
	return fabs(along.x) * size.x + fabs(along.y) * size.y + fabs(along.z) * size.z;
}

/* An axis without limits is doubted only if others have limits: a file without any travel is a sketch. */
static void check_travels(const struct scene *scene, struct doubts *doubts)
{
	const struct machine *machine = scene->machine;
	const bool limited = kinematics_longest_travel(machine) > 0;

	for (size_t i = 0; i < machine->axis_count; i++) {
		const struct axis *axis = &machine->axes[i];
		struct doubt doubt = {.kind = DOUBT_TRAVEL_LONG, .axis = (int)i};

		if (axis->rotary || axis->checked || !kinematics_side(machine, axis))
			continue;
		doubt.value = axis->limit_max - axis->limit_min;
		doubt.limit = extent_along(scene, axis->direction);
		if (isinf(doubt.value))
			doubt.kind = DOUBT_TRAVEL_ENDLESS;
		if (isinf(doubt.value) ? limited : doubt.limit > 0 && doubt.value > TRAVEL_MOST * doubt.limit)
			doubts_add(doubts, &doubt);
	}
}

/* The mesh of a tool may include its holder; nozzles and probes may have none. */
static bool may_lack_holder(const struct setup *setup, const struct tool *tool)
{
	if (tool->kind != TOOL_TURNS)
		return true;
	for (size_t i = 0; i < setup->body_count; i++) {
		const struct body *body = &setup->bodies[i];

		if (body->tool == tool->number && (body->role == ROLE_HOLDER || !body->profile))
			return true;
	}
	return false;
}

/* One doubt for all tools: the first of them, and the number of the others. */
static void check_holders(const struct setup *setup, struct doubts *doubts)
{
	struct doubt doubt = {.kind = DOUBT_TOOL_BARE};
	size_t bare = 0;

	for (size_t i = setup->tool_count; i-- > 0;) {
		if (setup->tools[i].checked || may_lack_holder(setup, &setup->tools[i]))
			continue;
		doubt.item = i;
		doubt.value = (double)bare++;
	}
	if (bare)
		doubts_add(doubts, &doubt);
}

void missing_check(const struct scene *scene, struct doubts *doubts)
{
	const struct machine *machine = scene->machine;

	if (!machine->spindle.present || !machine->workholding.present || !missing_is_drawn(scene))
		return;
	check_links(scene, doubts);
	check_travels(scene, doubts);
	if (scene->setup)
		check_holders(scene->setup, doubts);
}
