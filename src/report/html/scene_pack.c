#include "report/html/scene_pack.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "base/mem.h"
#include "report/format/format_units.h"
#include "report/format/json.h"
#include "report/format/seven_bit.h"
#include "report/html/pack_mesh.h"
#include "report/html/page.h"
#include "report/html/recorder.h"
#include "report/html/shown_body.h"
#include "report/html/turned.h"

/* "machine", "fixture", "part", "stock", "holder", "shank", "cutter" */
static const char *role_name(enum body_role role)
{
	return role == ROLE_MACHINE ? "machine" : body_roles[role];
}

/* A value of an axis that may be unlimited. */
static json_t *limit_of(int slot, double value)
{
	return isfinite(value) ? json_real(format_units_value(slot, value)) : json_null();
}

static json_t *axis_of(const struct axis *axis)
{
	json_t *object = json_object();

	json_put(object, "name", json_text(axis->name));
	json_put(object, "title", json_text(axis->title));
	json_put(object, "type", json_string(axis->rotary ? "rotary" : "linear"));
	json_put(object, "parent", json_integer(axis->parent));
	json_put(object, "direction", json_point(axis->direction));
	json_put(object, "location", json_point(axis->location));
	json_put(object, "limit_min", limit_of(axis->slot, axis->limit_min));
	json_put(object, "limit_max", limit_of(axis->slot, axis->limit_max));
	json_put(object, "rate_max", json_real(format_units_value(axis->slot, 60 * axis->rate_max)));
	json_put(object, "home", json_real(format_units_value(axis->slot, axis->home)));
	return object;
}

static json_t *spindle_of(const struct spindle *spindle)
{
	json_t *object = json_object();

	json_put(object, "link", json_integer(spindle->link));
	json_put(object, "location", json_point(spindle->location));
	json_put(object, "direction", json_point(spindle->direction));
	return object;
}

static json_t *machine_of(const struct machine *machine)
{
	json_t *object = json_object(), *axes = json_array(), *links = json_array();

	for (size_t i = 0; i < machine->axis_count; i++)
		json_push(axes, axis_of(&machine->axes[i]));
	for (int link = 0; (size_t)link <= machine->axis_count; link++)
		json_push(links, json_text(machine_link_name(machine, link)));
	json_put(object, "name", json_text(machine->name));
	json_put(object, "file", json_text(machine->path));
	json_put(object, "axes", axes);
	json_put(object, "links", links);
	json_put(object, "spindle", spindle_of(&machine->spindle));
	json_put(object, "workholding", json_integer(machine->workholding.link));
	return object;
}

static json_t *tools_of(const struct setup *setup)
{
	json_t *array = json_array();

	for (size_t i = 0; setup && i < setup->tool_count; i++) {
		const struct tool *tool = &setup->tools[i];
		json_t *object = json_object();

		json_put(object, "number", json_integer(tool->number));
		json_put(object, "name", json_text(tool->name && *tool->name ? tool->name : NULL));
		json_put(object, "length", json_real(tool->length));
		json_push(array, object);
	}
	return array;
}

static json_t *offsets_of(const struct machine *machine, const struct setup *setup)
{
	json_t *array = json_array();

	for (size_t i = 0; setup && i < setup->offset_count; i++) {
		json_t *object = json_object();

		json_put(object, "name", json_text(setup->offsets[i].name));
		json_put(object, "axes", json_axes(machine, &setup->offsets[i].value));
		json_push(array, object);
	}
	return array;
}

static json_t *pairs_of(const struct scene *scene)
{
	json_t *array = json_array();

	for (size_t i = 0; i < scene->pair_count; i++) {
		const struct scene_pair *pair = &scene->pairs[i];
		json_t *object = json_object();

		json_put(object, "a", json_integer(shown_body(scene, pair->a)));
		json_put(object, "b", json_integer(shown_body(scene, pair->b)));
		json_put(object, "status",
			 json_string(pair->status == PAIR_CUTTING ? "cutting" : pair_status_name(pair->status)));
		json_put(object, "clearance", json_real(pair->clearance));
		json_put(object, "reason", json_text(pair->reason));
		json_push(array, object);
	}
	return array;
}

/* ----------------------------------------------------------------- meshes */

/* A body's mesh, packed. */
struct packed_body {
	struct turned turned;	/* of a tool: without corners if it is packed as a mesh */
	struct packed_mesh mesh;
	struct strbuf blob;	/* as text */
	bool left_out;
};

json_t *scene_pack_mesh(const struct packed_mesh *mesh, int blob)
{
	json_t *object = json_object();

	json_put(object, "blob", json_integer(blob));
	json_put(object, "vertices", json_integer((json_int_t)mesh->vertices));
	json_put(object, "triangles", json_integer((json_int_t)mesh->triangles));
	json_put(object, "origin", json_point(mesh->origin));
	json_put(object, "step", json_point((vec3){mesh->step, mesh->step, mesh->step}));
	return object;
}

/* A turned body: its outline in whole numbers of TURNED_UNIT. */
static json_t *turned_of(const struct turned *turned, const xform *place)
{
	json_t *object = json_object(), *profile = json_array();

	for (size_t i = 0; i < turned->count; i++) {
		json_push(profile, json_integer(llround(turned->corners[i].r / TURNED_UNIT)));
		json_push(profile, json_integer(llround(turned->corners[i].z / TURNED_UNIT)));
	}
	json_put(object, "facets", json_integer((json_int_t)turned->facets));
	json_put(object, "profile", profile);
	json_put(object, "x", json_point(place->rotation.x));
	json_put(object, "y", json_point(place->rotation.y));
	json_put(object, "z", json_point(place->rotation.z));
	json_put(object, "origin", json_point(place->translation));
	return object;
}

/* Half the diagonal of a cell of the grid, plus the rounding of the viewer's floats (24 bits). */
double scene_pack_accuracy(const struct packed_mesh *mesh)
{
	const vec3 o = mesh->origin;
	const double farthest = fmax(fabs(o.x), fmax(fabs(o.y), fabs(o.z))) + 65535 * mesh->step;

	return PACK_MESH_ERROR * mesh->step + 4 * FLT_EPSILON * farthest;
}

static void add_body(struct scene_pack *pack, const struct body *body, const struct packed_body *packed)
{
	json_t *object = json_object();

	json_put(object, "name", json_text(body->name));
	json_put(object, "role", json_string(role_name(body->role)));
	json_put(object, "link", json_integer(body->link));
	json_put(object, "tool", json_integer(body->tool));
	if (packed->turned.count) {
		json_put(object, "mesh", turned_of(&packed->turned, &body->placement));
		pack->accuracy = fmax(pack->accuracy, TURNED_ERROR + TURNED_UNIT);
	} else if (packed->left_out || !packed->mesh.triangles) {
		json_put(object, "mesh", json_null());
		pack->left_out += packed->left_out;
	} else {
		json_put(object, "mesh", scene_pack_mesh(&packed->mesh, pack->blobs));
		page_add_blob(&pack->meshes, pack->blobs++, &packed->blob);
		pack->accuracy = fmax(pack->accuracy, scene_pack_accuracy(&packed->mesh));
	}
	json_push(pack->bodies, object);
}

static void pack_body(struct packed_body *packed, const struct body *body, const struct bvh *bvh)
{
	struct strbuf bytes = {0};

	/* Only tools are certain to have the shape of their outline. */
	if (body->tool && turned_init(&packed->turned, &bvh->mesh))
		return;
	pack_mesh_add(&bytes, &bvh->mesh, &body->placement, &packed->mesh);
	seven_bit_add(&packed->blob, strbuf_text(&bytes), bytes.length);
	strbuf_release(&bytes);
}

/* Leaves out the largest meshes until the others fit. */
static void fit(struct packed_body *packed, size_t count, size_t most)
{
	size_t sum = 0;

	for (size_t i = 0; i < count; i++)
		sum += packed[i].blob.length;
	while (sum > most) {
		size_t largest = 0;

		for (size_t i = 1; i < count; i++) {
			if (packed[i].blob.length > packed[largest].blob.length)
				largest = i;
		}
		sum -= packed[largest].blob.length;
		strbuf_release(&packed[largest].blob);
		packed[largest].left_out = true;
	}
}

static void pack_bodies(struct scene_pack *pack, struct scene *scene, struct packed_body *packed, size_t most)
{
	for (size_t i = 0; i < scene->body_count; i++) {
		const struct bvh *bvh = scene_body_bvh(scene, (int)i);

		if (scene->bodies[i].body->role != ROLE_STOCK)
			pack_body(&packed[i], scene->bodies[i].body, bvh);
	}
	fit(packed, scene->body_count, most);
	for (size_t i = 0; i < scene->body_count; i++)
		add_body(pack, scene->bodies[i].body, &packed[i]);
}

void scene_pack_init(struct scene_pack *pack, struct scene *scene, size_t most)
{
	struct packed_body *packed = mem_zalloc(scene->body_count + 1, sizeof(*packed));

	*pack = (struct scene_pack){
		.machine = machine_of(scene->machine),
		.bodies = json_array(),
		.tools = tools_of(scene->setup),
		.offsets = offsets_of(scene->machine, scene->setup),
		.pairs = pairs_of(scene),
	};
	pack_bodies(pack, scene, packed, most);
	for (size_t i = 0; i < scene->body_count; i++) {
		turned_release(&packed[i].turned);
		strbuf_release(&packed[i].blob);
	}
	free(packed);
}

void scene_pack_release(struct scene_pack *pack)
{
	json_decref(pack->machine);
	json_decref(pack->bodies);
	json_decref(pack->tools);
	json_decref(pack->offsets);
	json_decref(pack->pairs);
	strbuf_release(&pack->meshes);
	*pack = (struct scene_pack){0};
}
