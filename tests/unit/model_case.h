/* model_case.h - a small mill with its bodies and tools in memory, which can be moved as a whole: for tests of doubts. */
#ifndef FIVECHECK_TESTS_MODEL_CASE_H
#define FIVECHECK_TESTS_MODEL_CASE_H

#include "base/mem.h"
#include "machine/setup.h"
#include "machine/tool_solid.h"
#include "scene/scene.h"
#include "solids.h"

enum { MODEL_BODIES = 24, MODEL_TOOLS = 4, LINK_BASE = 0, LINK_X, LINK_Z, LINK_Y, LINK_C };

/* The machine and the setup borrow from the model, so it must not be copied. */
struct model {
	struct machine machine;
	struct setup setup;
	struct body bodies[MODEL_BODIES];
	struct tool tools[MODEL_TOOLS];
	struct radius_offset radii[MODEL_TOOLS];
	struct scene *scene;
};

/*
 * X carries Z with the spindle, whose gauge point is at 0 0 300 and whose tip points down; Y carries C with the
 * workholding, at 0 0 0. All travels are +-500 mm; C is unlimited.
 */
static inline void model_init(struct model *model)
{
	static const char *const names[] = {"X", "Z", "Y", "C"};
	static const int slots[] = {SLOT_X, SLOT_Z, SLOT_Y, SLOT_C}, parents[] = {LINK_BASE, LINK_X, LINK_BASE, LINK_Y};
	static const vec3 along[] = {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {0, 0, -1}};

	*model = (struct model){.machine = {.axis_count = 4, .adjacent_within = 5}};
	for (int i = 0; i < 4; i++) {
		const double most = i == 3 ? INFINITY : 500;

		model->machine.axes[i] = (struct axis){
			.name = names[i], .slot = slots[i], .rotary = i == 3, .parent = parents[i],
			.direction = along[i], .limit_min = -most, .limit_max = most, .rate_max = 100,
		};
	}
	model->machine.spindle = (struct spindle){
		.present = true, .link = LINK_Z, .location = {0, 0, 300}, .direction = {0, 0, -1},
	};
	model->machine.workholding = (struct workholding){.present = true, .link = LINK_C, .frame = xform_identity()};
	model->setup.tools = model->tools;
	model->setup.radii = model->radii;
	model->scene = mem_zalloc(1, sizeof(*model->scene));
	model->scene->machine = &model->machine;
	model->scene->setup = &model->setup;
	model->scene->bodies = mem_zalloc(MODEL_BODIES, sizeof(*model->scene->bodies));
}

static inline void model_release(struct model *model)
{
	scene_free(model->scene);
}

/* Adds a body of no shape yet, drawn in machine coordinates. Returns its index. */
static inline int model_body(struct model *model, enum body_role role, int link)
{
	static const char *const names[MODEL_BODIES] = {"b0", "b1", "b2", "b3", "b4", "b5", "b6", "b7", "b8", "b9"};
	const size_t body = model->scene->body_count++;

	ck_assert_uint_lt(body, MODEL_BODIES);
	model->bodies[body] = (struct body){.name = names[body] ? names[body] : "b", .role = role, .link = link,
					    .scale = 1, .placement = xform_identity()};
	model->scene->bodies[body].body = &model->bodies[body];
	ck_assert_int_eq(pthread_mutex_init(&model->scene->bodies[body].building, NULL), 0);
	return (int)body;
}

/* Gives a body its mesh, which is taken over. Returns the body. */
static inline int model_mesh(struct model *model, int body, struct mesh *mesh)
{
	bvh_free(model->scene->bodies[body].bvh);
	model->scene->bodies[body].bvh = bvh_new(mesh);
	return body;
}

/* A box between two corners. */
static inline int model_box(struct model *model, enum body_role role, int link, vec3 least, vec3 most)
{
	const vec3 half = vec3_scale(0.5, vec3_sub(most, least));
	xform place = xform_identity();
	struct mesh mesh = {0};

	place.translation = vec3_add(least, half);
	solid_box(&mesh, half);
	solid_place(&mesh, &place);
	return model_mesh(model, model_body(model, role, link), &mesh);
}

/* A tool without bodies. Returns its index. */
static inline size_t model_tool(struct model *model, int number, double length)
{
	const size_t item = model->setup.tool_count++;

	ck_assert_uint_lt(item, MODEL_TOOLS);
	model->tools[item] = (struct tool){.number = number, .name = "", .length = length, .length_offset = length};
	return item;
}

/* A piece of a tool, with the gauge point at its origin and the tip toward -Z. `profile` is borrowed; NULL: a mesh. */
static inline int model_piece(struct model *model, enum body_role role, int tool, const struct tool_solid *profile)
{
	const int body = model_body(model, role, model->machine.spindle.link);

	model->bodies[body].tool = tool;
	model->bodies[body].profile = profile;
	model->bodies[body].placement.translation = model->machine.spindle.location;
	return body;
}

/* Moves all of the machine. */
static inline void model_move(struct model *model, const xform *by)
{
	struct machine *machine = &model->machine;

	for (size_t i = 0; i < machine->axis_count; i++) {
		machine->axes[i].direction = mat3_apply(&by->rotation, machine->axes[i].direction);
		machine->axes[i].location = xform_apply(by, machine->axes[i].location);
	}
	machine->spindle.location = xform_apply(by, machine->spindle.location);
	machine->spindle.direction = mat3_apply(&by->rotation, machine->spindle.direction);
	machine->workholding.frame = xform_mul(by, &machine->workholding.frame);
	for (size_t i = 0; i < model->scene->body_count; i++)
		model->bodies[i].placement = xform_mul(by, &model->bodies[i].placement);
}

/* The one doubt of that kind; NULL: there is none. */
static inline const struct doubt *model_doubt(const struct doubts *doubts, enum doubt_kind kind)
{
	const struct doubt *found = NULL;

	for (size_t i = 0; i < doubts->count; i++) {
		if (doubts->items[i].kind != kind)
			continue;
		ck_assert_msg(!found, "two doubts of kind %d", (int)kind);
		found = &doubts->items[i];
	}
	return found;
}

#endif
