#include "report/glb/glb.h"

#include <jansson.h>
#include <math.h>
#include <stdlib.h>

#include "base/math/math_functions.h"
#include "base/mem.h"
#include "machine/chain.h"
#include "report/format/json.h"
#include "report/glb/glb_buffer.h"

/* Radians: a rotary axis turns less than this between two keys, because glTF uses the shorter way. */
#define TURN_MAX 1.5

struct glb {
	const struct glb_scene *scene;
	struct glb_buffer buffer;
	json_t *meshes, *nodes, *samplers, *channels;
};

/* ------------------------------------------------------------------ meshes */

enum material { MATERIAL_MACHINE, MATERIAL_FIXTURE, MATERIAL_PART, MATERIAL_TOOL, MATERIAL_A, MATERIAL_B, MATERIALS };

static enum material material_of(const struct glb_scene *scene, int body)
{
	if (body == scene->a)
		return MATERIAL_A;
	if (body == scene->b)
		return MATERIAL_B;
	switch (scene->scene->bodies[body].body->role) {
	case ROLE_MACHINE:
		return MATERIAL_MACHINE;
	case ROLE_FIXTURE:
		return MATERIAL_FIXTURE;
	case ROLE_PART:
	case ROLE_STOCK:
		return MATERIAL_PART;
	case ROLE_HOLDER:
	case ROLE_SHANK:
	case ROLE_CUTTER:
		break;
	}
	return MATERIAL_TOOL;
}

static json_t *materials(void)
{
	static const struct {
		const char *name;
		double colour[3];
	} all[MATERIALS] = {
		[MATERIAL_MACHINE] = {"machine", {0.45, 0.55, 0.65}},
		[MATERIAL_FIXTURE] = {"fixture", {0.45, 0.5, 0.52}},
		[MATERIAL_PART] = {"part", {0.75, 0.6, 0.35}}, [MATERIAL_TOOL] = {"tool", {0.6, 0.6, 0.6}},
		[MATERIAL_A] = {"first body", {0.8, 0.02, 0.02}}, [MATERIAL_B] = {"second body", {0.95, 0.45, 0.0}},
	};
	json_t *array = json_array();

	for (int i = 0; i < MATERIALS; i++) {
		json_t *object = json_object(), *pbr = json_object(),
		       *colour = glb_three(all[i].colour[0], all[i].colour[1], all[i].colour[2]);

		json_push(colour, json_real(1));
		json_put(pbr, "baseColorFactor", colour);
		json_put(pbr, "metallicFactor", json_real(0.1));
		json_put(pbr, "roughnessFactor", json_real(0.7));
		json_put(object, "name", json_string(all[i].name));
		json_put(object, "pbrMetallicRoughness", pbr);
		json_put(object, "doubleSided", json_true());
		json_push(array, object);
	}
	return array;
}

/* The origin of the vertices of a link and of the motion of its node. */
static vec3 origin_of(const struct machine *machine, int link)
{
	while (link && !machine->axes[link - 1].rotary)
		link = machine->axes[link - 1].parent;
	return link ? machine->axes[link - 1].location : (vec3){0, 0, 0};
}

/* The mesh of a body; -1: the body has none. */
static int add_mesh(struct glb *glb, int body)
{
	const struct scene_body *it = &glb->scene->scene->bodies[body];
	const bool cut = glb->scene->stock && it->body->role == ROLE_STOCK;
	xform place = it->body->placement;
	json_t *mesh, *primitives, *primitive, *attributes;
	int positions, indices;

	place.translation = vec3_sub(place.translation, origin_of(glb->scene->scene->machine, it->body->link));
	if (!glb_mesh(&glb->buffer, cut ? glb->scene->stock : &it->bvh->mesh, &place, &positions, &indices))
		return -1;
	mesh = json_object();
	primitives = json_array();
	primitive = json_object();
	attributes = json_object();
	json_put(attributes, "POSITION", json_integer(positions));
	json_put(primitive, "attributes", attributes);
	json_put(primitive, "indices", json_integer(indices));
	json_put(primitive, "material", json_integer((json_int_t)material_of(glb->scene, body)));
	json_push(primitives, primitive);
	json_put(mesh, "name", json_text(it->body->name));
	json_put(mesh, "primitives", primitives);
	json_push(glb->meshes, mesh);
	return (int)json_array_size(glb->meshes) - 1;
}

/* ------------------------------------------------------------------- nodes */

/* Node 0 is the machine, the node of link i is 1 + i, followed by the bodies. */
enum { NODE_MACHINE, NODE_LINKS };

/* The translation of a link relative to its carrier when its axis is at `value`. */
static vec3 translation_of(const struct machine *machine, int link, double value)
{
	const struct axis *axis = &machine->axes[link - 1];
	const vec3 rest = vec3_sub(origin_of(machine, link), origin_of(machine, axis->parent));

	return axis->rotary ? rest : vec3_add(rest, vec3_scale(value, axis->direction));
}

static void rotation_of(const struct axis *axis, double value, double quaternion[4])
{
	const double s = math_sin(value / 2);

	quaternion[0] = s * axis->direction.x;
	quaternion[1] = s * axis->direction.y;
	quaternion[2] = s * axis->direction.z;
	quaternion[3] = math_cos(value / 2);
}

static json_t *link_node(const struct glb_scene *scene, int link)
{
	const struct machine *machine = scene->scene->machine;
	json_t *node = json_object();

	json_put(node, "name", json_text(machine_link_name(machine, link)));
	json_put(node, "children", json_array());
	if (link) {
		const struct axis *axis = &machine->axes[link - 1];
		const double value = scene->keys[scene->key_count - 1].axes.v[axis->slot];

		json_put(node, "translation", json_point(translation_of(machine, link, value)));
		if (axis->rotary) {
			double q[4];
			json_t *rotation;

			rotation_of(axis, value, q);
			rotation = glb_three(q[0], q[1], q[2]);
			json_push(rotation, json_real(q[3]));
			json_put(node, "rotation", rotation);
		}
	}
	return node;
}

static void add_child(struct glb *glb, int parent, json_int_t child)
{
	json_push(json_object_get(json_array_get(glb->nodes, (size_t)parent), "children"), json_integer(child));
}

static void add_bodies(struct glb *glb)
{
	const struct scene *scene = glb->scene->scene;

	for (int i = 0; (size_t)i < scene->body_count; i++) {
		const struct body *body = scene->bodies[i].body;
		json_t *node;
		int mesh;

		if (body->tool && body->tool != glb->scene->tool)
			continue;
		mesh = add_mesh(glb, i);
		if (mesh < 0)
			continue;
		node = json_object();
		json_put(node, "name", json_text(body->name));
		json_put(node, "mesh", json_integer(mesh));
		add_child(glb, NODE_LINKS + body->link, (json_int_t)json_array_size(glb->nodes));
		json_push(glb->nodes, node);
	}
}

/* glTF does not permit an empty list of children. */
static void drop_empty(const struct glb *glb)
{
	for (size_t i = 0; i < json_array_size(glb->nodes); i++) {
		json_t *node = json_array_get(glb->nodes, i);

		if (!json_array_size(json_object_get(node, "children")))
			json_object_del(node, "children");
	}
}

static void add_nodes(struct glb *glb)
{
	const struct machine *machine = glb->scene->scene->machine;
	const double half = sqrt(0.5);
	json_t *node = json_object(), *rotation = glb_three(-half, 0, 0);

	/* From Z up to Y up, from mm to m. */
	json_push(rotation, json_real(half));
	json_put(node, "name", json_text(machine->name && *machine->name ? machine->name : "machine"));
	json_put(node, "rotation", rotation);
	json_put(node, "scale", glb_three(0.001, 0.001, 0.001));
	json_put(node, "children", json_array());
	json_push(glb->nodes, node);
	for (int link = 0; (size_t)link <= machine->axis_count; link++)
		json_push(glb->nodes, link_node(glb->scene, link));
	add_child(glb, NODE_MACHINE, NODE_LINKS);
	for (int link = 1; (size_t)link <= machine->axis_count; link++)
		add_child(glb, NODE_LINKS + machine->axes[link - 1].parent, NODE_LINKS + link);
	add_bodies(glb);
	drop_empty(glb);
}

/* --------------------------------------------------------------- animation */

/* The number of pieces between two keys for which no axis turns too far in one piece. */
static int pieces_of(const struct machine *machine, const struct glb_key *from, const struct glb_key *to)
{
	double farthest = 0;

	for (size_t i = 0; i < machine->axis_count; i++) {
		const int slot = machine->axes[i].slot;

		if (machine->axes[i].rotary)
			farthest = fmax(farthest, fabs(to->axes.v[slot] - from->axes.v[slot]));
	}
	return 1 + (int)fmin(floor(farthest / TURN_MAX), 10000);
}

/* All instants of the animation: the keys and those between them. */
static struct glb_key *instants_of(const struct glb_scene *scene, size_t *count)
{
	struct glb_key *all = NULL;
	size_t capacity = 0;

	*count = 0;
	for (size_t i = 0; i < scene->key_count; i++) {
		const struct glb_key *to = &scene->keys[i], *from = i ? to - 1 : to;
		const int pieces = i ? pieces_of(scene->scene->machine, from, to) : 1;

		for (int k = 1; k <= pieces; k++) {
			const double share = (double)k / pieces;
			struct glb_key *key;

			all = mem_grow(all, &capacity, *count + 1, sizeof(*all));
			key = &all[(*count)++];
			key->time = from->time + share * (to->time - from->time) - scene->keys[0].time;
			for (int slot = 0; slot < SLOT_COUNT; slot++)
				key->axes.v[slot] =
				    from->axes.v[slot] + share * (to->axes.v[slot] - from->axes.v[slot]);
		}
	}
	return all;
}

static void add_channel(struct glb *glb, int input, int output, int node, const char *path)
{
	json_t *sampler = json_object(), *channel = json_object(), *target = json_object();

	json_put(sampler, "input", json_integer(input));
	json_put(sampler, "output", json_integer(output));
	json_put(sampler, "interpolation", json_string("LINEAR"));
	json_put(target, "node", json_integer(node));
	json_put(target, "path", json_string(path));
	json_put(channel, "sampler", json_integer((json_int_t)json_array_size(glb->samplers)));
	json_put(channel, "target", target);
	json_push(glb->samplers, sampler);
	json_push(glb->channels, channel);
}

static int add_times(struct glb *glb, const struct glb_key *keys, size_t count)
{
	const size_t start = glb->buffer.binary.length;
	json_t *bounds = json_object(), *low = json_array(), *high = json_array();

	for (size_t i = 0; i < count; i++)
		glb_add_float(&glb->buffer.binary, keys[i].time);
	json_push(low, json_real((double)(float)keys[0].time));
	json_push(high, json_real((double)(float)keys[count - 1].time));
	json_put(bounds, "min", low);
	json_put(bounds, "max", high);
	return glb_accessor(&glb->buffer, start, GLB_NO_TARGET, GLB_FLOATS, "SCALAR", count, bounds);
}

static void animate(struct glb *glb, int link, const struct glb_key *keys, size_t count, int input)
{
	const struct machine *machine = glb->scene->scene->machine;
	const struct axis *axis = &machine->axes[link - 1];
	const size_t start = glb->buffer.binary.length;

	for (size_t i = 0; i < count; i++) {
		const double value = keys[i].axes.v[axis->slot];
		double q[4];

		if (!axis->rotary) {
			glb_add_vec3(&glb->buffer.binary, translation_of(machine, link, value));
			continue;
		}
		rotation_of(axis, value, q);
		for (int k = 0; k < 4; k++)
			glb_add_float(&glb->buffer.binary, q[k]);
	}
	add_channel(glb, input,
		    glb_accessor(&glb->buffer, start, GLB_NO_TARGET, GLB_FLOATS, axis->rotary ? "VEC4" : "VEC3", count,
				 NULL),
		    NODE_LINKS + link, axis->rotary ? "rotation" : "translation");
}

static void add_animation(struct glb *glb)
{
	size_t count;
	struct glb_key *keys;
	int input;

	if (glb->scene->key_count < 2)
		return;
	keys = instants_of(glb->scene, &count);
	input = add_times(glb, keys, count);
	for (int link = 1; (size_t)link <= glb->scene->scene->machine->axis_count; link++)
		animate(glb, link, keys, count, input);
	free(keys);
}

/* -------------------------------------------------------------------- file */

static json_t *one(const char *key, json_t *value)
{
	json_t *array = json_array(), *object = json_object();

	json_put(object, key, value);
	json_push(array, object);
	return array;
}

static json_t *document(struct glb *glb)
{
	json_t *root = json_object(), *asset = json_object(), *animation, *nodes = json_array();

	json_put(asset, "version", json_string("2.0"));
	json_put(asset, "generator", json_string("fivecheck " FIVECHECK_VERSION));
	json_push(nodes, json_integer(NODE_MACHINE));
	json_put(root, "asset", asset);
	json_put(root, "scene", json_integer(0));
	json_put(root, "scenes", one("nodes", nodes));
	json_put(root, "nodes", glb->nodes);
	json_put(root, "materials", materials());
	json_put(root, "accessors", glb->buffer.accessors);
	json_put(root, "bufferViews", glb->buffer.views);
	json_put(root, "buffers", one("byteLength", json_integer((json_int_t)glb->buffer.binary.length)));
	if (json_array_size(glb->meshes))
		json_put(root, "meshes", glb->meshes);
	else
		json_decref(glb->meshes);
	if (json_array_size(glb->channels)) {
		animation = json_object();
		json_put(animation, "name", json_string("before the finding"));
		json_put(animation, "samplers", glb->samplers);
		json_put(animation, "channels", glb->channels);
		json_put(root, "animations", json_array());
		json_push(json_object_get(root, "animations"), animation);
	} else {
		json_decref(glb->samplers);
		json_decref(glb->channels);
	}
	return root;
}

/* A chunk of the file: its length, its kind, and its bytes, padded to a multiple of four. */
static void add_chunk(struct strbuf *out, uint32_t kind, const struct strbuf *bytes, char pad)
{
	const size_t rest = (4 - bytes->length % 4) % 4;

	glb_add_u32(out, (uint32_t)(bytes->length + rest));
	glb_add_u32(out, kind);
	strbuf_add(out, strbuf_text(bytes), bytes->length);
	for (size_t i = 0; i < rest; i++)
		strbuf_add(out, &pad, 1);
}

void glb_add(struct strbuf *out, const struct glb_scene *scene)
{
	struct glb glb = {.scene = scene, .buffer = {.views = json_array(), .accessors = json_array()},
			  .meshes = json_array(),
			  .nodes = json_array(), .samplers = json_array(), .channels = json_array()};
	struct strbuf text = {0}, chunks = {0};

	add_nodes(&glb);
	add_animation(&glb);
	json_add_line(&text, document(&glb));
	add_chunk(&chunks, 0x4e4f534a, &text, ' ');
	add_chunk(&chunks, 0x004e4942, &glb.buffer.binary, '\0');
	/* The head: "glTF", version, length of all. */
	glb_add_u32(out, 0x46546c67);
	glb_add_u32(out, 2);
	glb_add_u32(out, (uint32_t)(12 + chunks.length));
	strbuf_add(out, strbuf_text(&chunks), chunks.length);
	strbuf_release(&text);
	strbuf_release(&chunks);
	strbuf_release(&glb.buffer.binary);
}
