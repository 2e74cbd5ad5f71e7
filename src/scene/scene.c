#include "scene/scene.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "base/same_double.h"
#include "geom/edge_balance.h"
#include "geom/near_zero.h"
#include "geom/stl.h"
#include "geom/tolerance.h"
#include "geom/topology.h"
#include "machine/tool_core.h"
#include "machine/tool_solid.h"
#include "scene/body_shapes.h"

/* mm: the radius of the tool directly above a cutter given by sections; INFINITY: it is not known. */
static double radius_above(const struct scene *scene, const struct body *cutter)
{
	for (size_t i = 0; i < scene->body_count; i++) {
		const struct body *other = scene->bodies[i].body;
		const struct tool_solid *solid = other->profile;

		if (other->tool == cutter->tool && other->role != ROLE_CUTTER && solid &&
		    fabs(tool_solid_bottom(solid) - cutter->profile->top) < TOOL_SECTION_MIN)
			return solid->sections[solid->count - 1].diameter_end / 2;
	}
	return INFINITY;
}

int scene_core(struct scene *scene, int body, double depth)
{
	const struct body *cutter = scene->bodies[body].body;
	struct scene_body *added;
	struct tool_solid *solid;
	struct body *core;

	for (size_t i = scene->body_count; i < scene->body_count + scene->core_count; i++) {
		const struct scene_body *other = &scene->bodies[i];

		if (other->body->profile == cutter->profile && same_double(other->depth, depth))
			return (int)i;
	}
	solid = arena_alloc(&scene->cores, sizeof(*solid));
	*solid = tool_core(cutter->profile, depth, radius_above(scene, cutter), &scene->cores);
	core = arena_alloc(&scene->cores, sizeof(*core));
	*core = *cutter;
	core->solid = NULL;
	added = &scene->bodies[scene->body_count + scene->core_count];
	*added = (struct scene_body){.body = core, .depth = depth, .core = solid};
	pthread_mutex_init(&added->building, NULL);
	return (int)(scene->body_count + scene->core_count++);
}

void scene_free(struct scene *scene)
{
	if (!scene)
		return;
	for (size_t i = 0; i < scene->body_count + scene->core_count; i++) {
		bvh_free(scene->bodies[i].bvh);
		bvh_free(scene->bodies[i].coarse);
		if (scene->bodies[i].topology)
			topology_release(scene->bodies[i].topology);
		free(scene->bodies[i].topology);
		body_shapes_release(scene->bodies[i].shapes);
		pthread_mutex_destroy(&scene->bodies[i].building);
	}
	for (size_t i = 0; i < scene->pair_count; i++)
		free(scene->pairs[i].reason);
	doubts_release(&scene->doubts);
	sweep_release(&scene->sweep);
	arena_release(&scene->cores);
	free(scene->bodies);
	free(scene->pairs);
	free(scene);
}

static bool within_bounds(const struct mesh *mesh)
{
	vec3 least, greatest;

	mesh_bounds(mesh, &least, &greatest);
	return fmin(least.x, fmin(least.y, least.z)) >= -COORDINATE_MAX &&
	       fmax(greatest.x, fmax(greatest.y, greatest.z)) <= COORDINATE_MAX;
}

static struct mesh copy_of(const struct mesh *mesh)
{
	struct mesh copy = *mesh;

	copy.triangles = mem_realloc(NULL, mesh->count, sizeof(*copy.triangles));
	memcpy(copy.triangles, mesh->triangles, mesh->count * sizeof(*copy.triangles));
	return copy;
}

typedef void tessellate_fn(const struct tool_solid *solid, struct arena *arena, struct mesh *out);

static struct mesh tessellated(tessellate_fn *tessellate, const struct tool_solid *solid)
{
	struct arena arena = {0};
	struct mesh mesh, copy;

	tessellate(solid, &arena, &mesh);
	copy = copy_of(&mesh);
	arena_release(&arena);
	return copy;
}

bool scene_read_mesh(const struct body *body, struct mesh *out, struct diag *diag)
{
	struct mesh mesh = {0};

	if (body->solid) {
		mesh = copy_of(body->solid);
	} else if (body->profile) {
		mesh = tessellated(tool_solid_mesh, body->profile);
	} else {
		if (!stl_read_below(&mesh, body->mesh_root, body->mesh_path, diag)) {
			diag_note(diag, body->loc, "body '%s' uses this mesh", body->name);
			return false;
		}
		near_zero_close(&mesh);
		if (body->scale > 1 || body->scale < 1)
			mesh_scale(&mesh, body->scale);
		if (!within_bounds(&mesh)) {
			diag_error(diag, (struct srcloc){body->mesh_path, 0, 0},
				   "coordinates beyond %g mm: body '%s' cannot be so large; check its units",
				   COORDINATE_MAX, body->name);
			mesh_release(&mesh);
			return false;
		}
	}
	*out = mesh;
	return true;
}

/*
 * The tree of a core or of a tool's piece that is made of sections. The first thread that needs the tree builds it:
 * most belong to tools that a program does not use.
 */
static const struct bvh *solid_bvh(struct scene *scene, int body)
{
	struct scene_body *b = &scene->bodies[body];

	pthread_mutex_lock(&b->building);
	if (!b->bvh) {
		struct mesh mesh = tessellated(tool_solid_mesh, b->core ? b->core : b->body->profile);

		b->bvh = bvh_new(&mesh);
	}
	pthread_mutex_unlock(&b->building);
	return b->bvh;
}

const struct bvh *scene_body_coarse(struct scene *scene, int body)
{
	struct scene_body *b = &scene->bodies[body];

	pthread_mutex_lock(&b->building);
	if (!b->coarse) {
		struct mesh mesh = tessellated(tool_solid_coarse_mesh, b->body->profile);

		b->coarse = bvh_new(&mesh);
	}
	pthread_mutex_unlock(&b->building);
	return b->coarse;
}

const struct bvh *scene_body_bvh(struct scene *scene, int body)
{
	const struct scene_body *b = &scene->bodies[body];

	return b->core || b->body->profile ? solid_bvh(scene, body) : b->bvh;
}

bool scene_body_is_balanced(struct scene *scene, int body)
{
	struct scene_body *b = &scene->bodies[body];
	const struct bvh *bvh = scene_body_bvh(scene, body);

	pthread_mutex_lock(&b->building);
	if (!b->balance_known)
		b->balanced = edge_balance_is_closed(&bvh->mesh);
	b->balance_known = true;
	pthread_mutex_unlock(&b->building);
	return b->balanced;
}

const struct topology *scene_body_topology(struct scene *scene, int body)
{
	struct scene_body *b = &scene->bodies[body];
	const struct bvh *bvh = scene_body_bvh(scene, body);

	pthread_mutex_lock(&b->building);
	if (!b->topology) {
		b->topology = mem_zalloc(1, sizeof(*b->topology));
		topology_init(b->topology, &bvh->mesh);
	}
	pthread_mutex_unlock(&b->building);
	return b->topology;
}

static struct body_shapes *shapes_of(struct scene *scene, int body)
{
	struct scene_body *b = &scene->bodies[body];
	const struct bvh *bvh = scene_body_bvh(scene, body);

	pthread_mutex_lock(&b->building);
	if (!b->shapes)
		b->shapes = body_shapes_new(bvh, &b->body->placement);
	pthread_mutex_unlock(&b->building);
	return b->shapes;
}

struct body_pair scene_pair_bodies(struct scene *scene, const struct scene_pair *pair)
{
	struct body_pair bodies;

	body_pair_init(&bodies, scene_body_bvh(scene, pair->a), scene_body_bvh(scene, pair->b),
		       &scene->bodies[pair->a].body->placement, &scene->bodies[pair->b].body->placement, &pair->chain);
	bodies.shapes[0] = shapes_of(scene, pair->a);
	bodies.shapes[1] = shapes_of(scene, pair->b);
	return bodies;
}

bool scene_pair_needs_check(const struct scene_pair *pair)
{
	return pair->status == PAIR_CHECKED || pair->status == PAIR_OUT_OF_REACH ||
	       (pair->status == PAIR_CUTTING && pair->steps);
}

int scene_stock(const struct scene *scene)
{
	for (size_t i = 0; i < scene->body_count; i++)
		if (scene->bodies[i].body->role == ROLE_STOCK)
			return (int)i;
	return -1;
}

size_t scene_count_pairs(const struct scene *scene, enum pair_status status)
{
	size_t count = 0;

	for (size_t i = 0; i < scene->pair_count; i++)
		count += scene->pairs[i].status == status;
	return count;
}

void scene_count_meshes(struct scene *scene, size_t *read, size_t *trees)
{
	*read = scene->meshes_read;
	*trees = 0;
	for (size_t i = 0; i < scene->body_count; i++) {
		struct scene_body *b = &scene->bodies[i];

		pthread_mutex_lock(&b->building);
		*trees += b->bvh != NULL;
		*read += b->bvh && b->body->profile;
		pthread_mutex_unlock(&b->building);
	}
}
