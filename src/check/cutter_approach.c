#include "check/cutter_approach.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "machine/tool_solid.h"
#include "scene/convex.h"

/*
 * mm: a cutter within this distance of the hull of a part, or within its own radius, may be cutting material that is
 * not described, such as the first layers of a blank. The hull includes a pocket that is roughed from its middle. If
 * the stock is described, every tool reaches it.
 */
static const double NEAR_PART = 5, NEAR_STOCK = 1;
/* A new nearest distance matters if it is smaller than this share of the last one. */
static const double SHARE = 0.9;
/* Parts of a step that move the cutter by less than this share of the near distance are measured only at their end. */
static const double SHORT_MOTION = 0.1;
/* The most halvings of a step: axes can turn a million times in one block. */
enum { HALVINGS = 12 };

static bool is_target(const struct scene *scene, size_t body)
{
	const struct body *b = scene->bodies[body].body;

	return (b->role == ROLE_PART || b->role == ROLE_STOCK) && b->link == scene->machine->workholding.link;
}

static void add_targets(struct cutter_approach *approach, const struct scene *scene)
{
	bool all_checked = true;

	approach->targets = mem_zalloc(scene->body_count + 1, sizeof(*approach->targets));
	for (size_t i = 0; i < scene->body_count; i++) {
		const struct body *body = scene->bodies[i].body;
		const struct bvh *bvh;

		if (!is_target(scene, i))
			continue;
		/* Another thread may be building the tree of a tool given by sections. */
		bvh = scene->bodies[i].bvh;
		all_checked &= body->checked != NULL;
		approach->with_stock |= body->role == ROLE_STOCK;
		approach->targets[approach->target_count++] =
		    (struct approach_target){.bvh = bvh, .box = {bvh->origin, bvh->half}, .body = (int)i,
					     .from_machine = xform_inverse(&body->placement)};
	}
	if (all_checked)
		approach->target_count = 0;
}

/* The ball around the boxes of all targets, in the coordinates of the work's link. */
static struct ball ball_around(const struct cutter_approach *approach)
{
	struct ball ball = {{0, 0, 0}, 0};

	for (size_t i = 0; i < approach->target_count; i++) {
		const struct approach_target *target = &approach->targets[i];
		const xform place = xform_inverse(&target->from_machine);
		const vec3 middle = xform_apply(&place, target->box.middle);

		if (i == 0)
			ball.centre = middle;
		ball.radius = fmax(ball.radius, vec3_norm(vec3_sub(middle, ball.centre)) + vec3_norm(target->box.half));
	}
	return ball;
}

/* The cylinder around a cutter, in its mesh coordinates: the gauge point is the origin, the tip points toward -Z. */
static struct cylinder cylinder_around(const struct scene_body *cutter)
{
	const struct tool_solid *profile = cutter->body->profile;
	struct cylinder around = {{0, 0, 0}, {0, 0, -1}, 0, 0};

	if (!profile) {
		const struct bvh *bvh = cutter->bvh;

		around.base = (vec3){bvh->origin.x, bvh->origin.y, bvh->origin.z + bvh->half.z};
		around.length = 2 * bvh->half.z;
		around.radius = fmax(bvh->half.x, bvh->half.y);
		return around;
	}
	around.base.z = profile->top;
	for (size_t i = 0; i < profile->count; i++) {
		const struct tool_section *section = &profile->sections[i];

		around.length += section->length;
		around.radius = fmax(around.radius, 0.5 * fmax(section->diameter, section->diameter_end));
	}
	return around;
}

static void add_tools(struct cutter_approach *approach, const struct scene *scene)
{
	approach->tools = mem_zalloc(scene->body_count + 1, sizeof(*approach->tools));
	for (size_t i = 0; i < scene->body_count; i++) {
		const struct scene_body *cutter = &scene->bodies[i];
		const struct tool *tool = setup_tool(scene->setup, cutter->body->tool);
		struct approach_tool *added = &approach->tools[approach->tool_count];

		if (cutter->body->role != ROLE_CUTTER || !tool || tool->kind != TOOL_TURNS || tool->checked ||
		    cutter->body->link != scene->machine->spindle.link)
			continue;
		added->cutter = cylinder_around(cutter);
		added->cutter.base = xform_apply(&cutter->body->placement, added->cutter.base);
		added->cutter.along = mat3_apply(&cutter->body->placement.rotation, added->cutter.along);
		added->nearest.tool = tool->number;
		added->nearest.distance = INFINITY;
		added->last.distance = -1;
		approach->tool_count++;
	}
}

void cutter_approach_init(struct cutter_approach *approach, const struct scene *scene, const char *file)
{
	const struct machine *machine = scene ? scene->machine : NULL;

	*approach = (struct cutter_approach){.file = file, .settled = -1};
	if (!machine || !scene->setup || !machine->spindle.present || !machine->workholding.present)
		return;
	chain_init(&approach->chain, machine, machine->workholding.link, machine->spindle.link);
	add_targets(approach, scene);
	approach->ball = ball_around(approach);
	if (approach->target_count && !chain_is_rigid(&approach->chain))
		add_tools(approach, scene);
}

void cutter_approach_release(struct cutter_approach *approach)
{
	for (size_t i = 0; i < approach->target_count; i++)
		corner_runs_free(approach->targets[i].corners);
	free(approach->targets);
	free(approach->tools);
}

static double near_enough(const struct cutter_approach *approach, const struct approach_tool *tool)
{
	return approach->with_stock ? NEAR_STOCK : fmax(NEAR_PART, tool->cutter.radius);
}

/* A new distance matters if it is smaller than this. */
static double matters(const struct approach_tool *tool)
{
	return SHARE * tool->nearest.distance;
}

/* The gap between a cutter, in the target's mesh coordinates, and the hull of the target; 0: they meet. */
static double gap_to_hull(struct approach_target *target, const struct cylinder *cutter)
{
	const struct profile ring = {.count = 1, .high = {cutter->length}, .rho = {cutter->radius}};
	const struct convex moved = convex_of_profile(&ring, cutter->base, cutter->along);
	const xform here = xform_identity();
	struct convex_search search;
	struct mesh_part whole;
	struct convex hull;
	long visits = 0;

	if (!target->corners)
		target->corners = corner_runs_new(target->bvh);
	whole = mesh_part_of(target->bvh, target->corners, (struct leaf){0, 0});
	hull = convex_of_mesh(&whole, &here, NULL);
	if (!convex_direction(&hull, &moved, &search, &visits))
		return 0;
	return -convex_support(&moved, vec3_scale(-1, search.direction), 0, NULL, &visits) -
	       convex_support(&hull, search.direction, 0, NULL, &visits);
}

/* A lower bound of the distance from a target; exact to a few hundredths if it matters. */
static double distance_to(struct approach_target *target, const struct approach_tool *tool, const xform *pose)
{
	const xform place = xform_mul(&target->from_machine, pose);
	struct cylinder cutter = tool->cutter;
	double to_box;

	cutter.base = xform_apply(&place, cutter.base);
	cutter.along = mat3_apply(&place.rotation, cutter.along);
	to_box = cylinder_box_distance(&cutter, &target->box, 0);
	return to_box >= matters(tool) ? to_box : fmax(to_box, gap_to_hull(target, &cutter));
}

/* Measures at the axis positions q. The tool keeps the smallest distance so far. */
static struct approach_place measure_at(const struct cutter_approach *approach, struct approach_tool *tool,
					const axis_values *q, const struct motion_step *step)
{
	const xform pose = chain_pose(&approach->chain, q);
	double least = INFINITY;

	for (size_t i = 0; i < approach->target_count; i++) {
		const double distance = distance_to(&approach->targets[i], tool, &pose);

		least = fmin(least, distance);
		if (distance >= tool->nearest.distance)
			continue;
		tool->nearest.distance = distance;
		tool->nearest.body = approach->targets[i].body;
		tool->nearest.line = step->line;
		tool->nearest.in_subprogram = strcmp(step->file, approach->file) != 0;
	}
	tool->near |= least <= near_enough(approach, tool);
	tool->last = (struct approach_place){*q, least};
	return tool->last;
}

/* mm: an upper bound of the way of any point of the cutter relative to the work between two positions of the axes. */
static double way_between(const struct cutter_approach *approach, const struct approach_tool *tool,
			  const axis_values *q0, const axis_values *q1)
{
	const struct cylinder *cutter = &tool->cutter;
	const struct ball ball = {vec3_mad(cutter->base, 0.5 * cutter->length, cutter->along),
				  0.5 * cutter->length + cutter->radius};
	const axis_values exact = {{0}};
	struct chain_state start, end;
	struct chord_bound bound;
	bool turns = false;
	double way = 0;

	for (size_t i = 0; i < approach->chain.count; i++) {
		const struct joint *joint = &approach->chain.joints[i];
		const double step = fabs(q1->v[joint->slot] - q0->v[joint->slot]);

		turns |= joint->rotary && step > 0;
		way += step;
	}
	/* Three axes need no kinematics. */
	if (!turns)
		return way;
	chain_state_init(&start, &approach->chain, q0, &approach->ball, &ball);
	chain_state_init(&end, &approach->chain, q1, &approach->ball, &ball);
	chord_bound_init(&bound, &(struct joint_chord){
		.chain = &approach->chain, .start = &start, .end = &end,
		.q0 = q0, .q1 = q1, .chord_error = &exact,
	});
	return bound.length;
}

/* Halves the straight path between two measured positions while a part of it may be nearer. */
static void look_between(const struct cutter_approach *approach, struct approach_tool *tool,
			 const struct approach_place *from, const struct approach_place *to,
			 const struct motion_step *step, int halvings)
{
	const double way = way_between(approach, tool, &from->q, &to->q);
	struct approach_place middle;
	axis_values q;

	if (tool->near || halvings == 0 || way < SHORT_MOTION * near_enough(approach, tool) ||
	    0.5 * (from->distance + to->distance - way) >= matters(tool))
		return;
	for (int i = 0; i < SLOT_COUNT; i++)
		q.v[i] = 0.5 * (from->q.v[i] + to->q.v[i]);
	middle = measure_at(approach, tool, &q, step);
	look_between(approach, tool, from, &middle, step, halvings - 1);
	look_between(approach, tool, &middle, to, step, halvings - 1);
}

static struct approach_tool *tool_of(const struct cutter_approach *approach, int number)
{
	for (size_t i = 0; i < approach->tool_count; i++) {
		if (approach->tools[i].nearest.tool == number)
			return &approach->tools[i];
	}
	return NULL;
}

/* Does the whole path stay so close to the last measured position that no distance on it can matter? */
static bool stays_far(const struct cutter_approach *approach, const struct approach_tool *tool, const axis_values *q0,
		      const axis_values *q1)
{
	const double room = tool->last.distance - matters(tool);

	return room > 0 && way_between(approach, tool, &tool->last.q, q0) + way_between(approach, tool, q0, q1) <= room;
}

void cutter_approach_look(struct cutter_approach *approach, const struct motion_step *step)
{
	const axis_values *q0 = &step->span.q0, *q1 = &step->span.q1;
	struct approach_tool *tool = tool_of(approach, step->tool);

	if (tool && !tool->near && !stays_far(approach, tool, q0, q1)) {
		const struct approach_place from = measure_at(approach, tool, q0, step),
					    to = measure_at(approach, tool, q1, step);

		look_between(approach, tool, &from, &to, step, HALVINGS);
	}
	if (!tool || tool->near)
		approach->settled = step->tool;
}

struct far_cutters cutter_approach_result(const struct cutter_approach *approach)
{
	struct far_cutters result = {.distance = INFINITY};
	long fed = 0, far = 0;

	for (size_t i = 0; i < approach->tool_count; i++) {
		const struct approach_tool *tool = &approach->tools[i];

		fed += !isinf(tool->nearest.distance);
		if (isinf(tool->nearest.distance) || tool->near)
			continue;
		far++;
		if (tool->nearest.distance < result.distance)
			result = tool->nearest;
	}
	result.fed = fed;
	result.far = far;
	return result;
}
