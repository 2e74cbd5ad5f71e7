#include "scene/tool_check.h"

#include <math.h>
#include <stdlib.h>

#include "base/math/math_functions.h"
#include "base/mem.h"
#include "base/minmax.h"
#include "machine/tool_core.h"
#include "machine/tool_name.h"
#include "machine/tool_solid.h"

/*
 * A holder is thickest at its flange, near the gauge line. If it is thinner there than this share, the holder is upside
 * down.
 */
static const double FLANGE_LEAST = 0.6;
/* A drawn cutter ends at the tip, to within this many mm or this share of the length. */
static const double TIP_OFF = 1, TIP_OFF_SHARE = 0.01;
/* A tool without a cutter is drawn over at least this share of its length. */
static const double DRAWN_LEAST = 0.1;
/* The middle of a holder is on the spindle's line, to within this share of its half width. */
static const double ASIDE_MOST = 0.5;
/* A D above this share of the tool's diameter is not a radius. */
static const double RADIUS_MOST = 0.75;
/* A point or a rim without a core is worth a doubt above this many times the depth, and above this length in mm. */
static const double CORELESS_MOST = 7, CORELESS_LEAST = 0.3;

static void check_holder(const struct body *body, size_t item, struct doubts *doubts)
{
	struct doubt doubt = {.kind = DOUBT_HOLDER_TURNED, .item = item};

	if (body->role != ROLE_HOLDER || !body->profile)
		return;
	doubt.value = body->profile->sections[0].diameter;
	for (size_t i = 0; i < body->profile->count; i++) {
		const struct tool_section *section = &body->profile->sections[i];

		doubt.limit = fmax(doubt.limit, fmax(section->diameter, section->diameter_end));
	}
	if (doubt.value < FLANGE_LEAST * doubt.limit)
		doubts_add(doubts, &doubt);
}

/* mm: the extent of the body from the gauge line toward the tip. A mesh has the gauge point at its origin. */
static double end_of(const struct scene_body *b)
{
	return b->body->profile ? -tool_solid_bottom(b->body->profile) : b->bvh->half.z - b->bvh->origin.z;
}

static void check_aside(const struct scene *scene, int body, size_t item, struct doubts *doubts)
{
	const struct scene_body *b = &scene->bodies[body];
	struct doubt doubt = {.kind = DOUBT_TOOL_ASIDE, .item = item, .body = body};

	if (b->body->profile || b->body->role == ROLE_CUTTER)
		return;
	doubt.value = math_hypot(b->bvh->origin.x, b->bvh->origin.y);
	if (doubt.value > ASIDE_MOST * fmax(b->bvh->half.x, b->bvh->half.y))
		doubts_add(doubts, &doubt);
}

/* The sections must add up to the length, or the file is rejected; so only tools with a mesh can end elsewhere. */
static void check_end(const struct scene *scene, size_t item, struct doubts *doubts)
{
	const struct tool *tool = &scene->setup->tools[item];
	struct doubt doubt = {.kind = DOUBT_TOOL_ENDS, .item = item, .value = -INFINITY, .limit = tool->length};
	const double off = fmax(TIP_OFF, TIP_OFF_SHARE * tool->length);
	bool drawn = false, cutter = false;

	for (size_t i = 0; i < scene->body_count; i++) {
		const struct scene_body *b = &scene->bodies[i];

		if (b->body->tool != tool->number)
			continue;
		drawn |= !b->body->profile;
		cutter |= b->body->role == ROLE_CUTTER;
		doubt.value = fmax(doubt.value, end_of(b));
	}
	if (drawn && (doubt.value > tool->length + off ||
		      doubt.value < (cutter ? tool->length - off : DRAWN_LEAST * tool->length)))
		doubts_add(doubts, &doubt);
}

static void check_radius(const struct setup *setup, size_t item, struct doubts *doubts)
{
	const struct tool *tool = &setup->tools[item];

	for (size_t i = 0; i < setup->radius_count; i++) {
		if (setup->radii[i].number == tool->number && tool->diameter > 0 &&
		    setup->radii[i].radius > RADIUS_MOST * tool->diameter)
			doubts_add(doubts, &(struct doubt){.kind = DOUBT_RADIUS_OFFSET,
							   .item = item,
							   .value = setup->radii[i].radius,
							   .limit = tool->diameter});
	}
}

static double widest(const struct tool_solid *solid)
{
	double most = 0;

	for (size_t i = 0; i < solid->count; i++)
		most = larger(most, 0.5 * larger(solid->sections[i].diameter, solid->sections[i].diameter_end));
	return most;
}

/* The larger one of what the core lacks at the tip and all around. */
static double coreless(const struct tool_solid *cutter, const struct tool_solid *core)
{
	return larger(tool_solid_bottom(core) - tool_solid_bottom(cutter), widest(cutter) - widest(core));
}

/* The same for a cutter and a part, or the stock. */
static double coreless_in(const struct scene *scene, const struct scene_pair *pair, const struct body *cutter)
{
	const struct scene_body *a = &scene->bodies[pair->a], *b = &scene->bodies[pair->b];
	const struct tool_solid *core = a->core ? a->core : b->core;
	struct arena arena = {0};
	struct tool_solid made;
	double most;

	if (core)
		return coreless(cutter->profile, core);
	made = tool_core(cutter->profile, pair->inset, INFINITY, &arena);
	most = coreless(cutter->profile, &made);
	arena_release(&arena);
	return most;
}

/* mm: the depth to which the cutter may enter the other body of the pair; 0: the pair has no core. */
static double depth_in(const struct scene_pair *pair, const struct body *other)
{
	if (pair->fault == PAIR_GOUGE)
		return other->gouge;
	return pair->fault == PAIR_RAPID_CONTACT && (pair->steps || pair->stock) ? other->rapid_allowance : 0;
}

/*
 * One doubt for each tool of the setup, the largest; the value 0: none. The caller frees them. Most pairs are of two
 * tools, and their number grows with the square of that of the tools: they are passed once, not for each tool.
 */
static struct doubt *find_sharp(const struct scene *scene)
{
	struct doubt *sharp = mem_zalloc(scene->setup->tool_count, sizeof(*sharp));

	for (size_t i = 0; i < scene->pair_count; i++) {
		const struct scene_pair *pair = &scene->pairs[i];
		const struct body *a = scene->bodies[pair->a].body, *b = scene->bodies[pair->b].body;
		const struct body *cutter = a->role == ROLE_CUTTER ? a : b;
		const double depth = depth_in(pair, cutter == a ? b : a);
		const struct tool *tool;
		size_t item;
		double most;

		if (!(depth > 0) || cutter->role != ROLE_CUTTER || !cutter->profile || !scene_pair_needs_check(pair))
			continue;
		tool = setup_tool(scene->setup, cutter->tool);
		if (!tool || tool->checked)
			continue;
		item = (size_t)(tool - scene->setup->tools);
		most = coreless_in(scene, pair, cutter);
		if (most > larger(CORELESS_MOST * depth, CORELESS_LEAST) && most > sharp[item].value)
			sharp[item] = (struct doubt){
				.kind = DOUBT_TOOL_SHARP, .item = item, .value = most, .limit = depth};
	}
	return sharp;
}

static void check_name(const struct tool *tool, size_t item, struct doubts *doubts)
{
	if (tool_name_tells_twice(tool))
		doubts_add(doubts, &(struct doubt){.kind = DOUBT_TOOL_NAME,
						   .item = item,
						   .value = tool->diameter,
						   .limit = 2 * tool->diameter});
}

void tool_check(const struct scene *scene, struct doubts *doubts)
{
	const struct setup *setup = scene->setup;
	struct doubt *sharp = setup ? find_sharp(scene) : NULL;

	for (size_t item = 0; setup && item < setup->tool_count; item++) {
		if (setup->tools[item].checked)
			continue;
		for (size_t i = 0; i < scene->body_count; i++) {
			const struct body *body = scene->bodies[i].body;

			if (body->tool != setup->tools[item].number || setup->tools[item].kind != TOOL_TURNS)
				continue;
			check_holder(body, item, doubts);
			check_aside(scene, (int)i, item, doubts);
		}
		check_end(scene, item, doubts);
		check_radius(setup, item, doubts);
		check_name(&setup->tools[item], item, doubts);
		if (sharp[item].value > 0)
			doubts_add(doubts, &sharp[item]);
	}
	free(sharp);
}
