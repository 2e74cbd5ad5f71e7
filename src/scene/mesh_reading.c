#include "scene/mesh_reading.h"

#include <stdlib.h>

#include "base/diag_queue.h"
#include "base/mem.h"
#include "base/parallel_for.h"

/* One body's mesh. */
struct reading {
	struct scene_body *body;
	struct mesh mesh;
	bool good;
	struct diag_queue diags;
};

static void read_one(void *context, int worker, size_t i)
{
	struct reading *reading = &((struct reading *)context)[i];

	(void)worker;
	reading->good = scene_read_mesh(reading->body->body, &reading->mesh, &reading->diags.diag);
}

static bool is_large(const struct reading *reading)
{
	return reading->mesh.count >= BVH_LARGE;
}

static void build_one(void *context, int worker, size_t i)
{
	struct reading *reading = &((struct reading *)context)[i];

	(void)worker;
	if (reading->good && !reading->body->bvh)
		reading->body->bvh = bvh_new(&reading->mesh);
}

/*
 * One thread for each tree is fastest. If there are fewer large trees than threads, the threads build each of them
 * together.
 */
static void build_trees(struct reading *readings, size_t count, int threads)
{
	size_t large = 0;

	for (size_t i = 0; i < count; i++)
		large += is_large(&readings[i]);
	for (size_t i = 0; i < count && large < (size_t)threads; i++)
		if (is_large(&readings[i]))
			readings[i].body->bvh = bvh_new_by(&readings[i].mesh, threads);
	parallel_for(count, threads, build_one, readings);
}

bool mesh_reading_run(struct scene *scene, int threads, struct diag *diag)
{
	struct reading *readings = mem_zalloc(scene->body_count + 1, sizeof(*readings));
	bool good = true;
	size_t count = 0;

	for (size_t i = 0; i < scene->body_count; i++) {
		if (scene->bodies[i].body->profile)
			continue;
		readings[count].body = &scene->bodies[i];
		diag_queue_init(&readings[count++].diags);
	}
	parallel_for(count, threads, read_one, readings);
	for (size_t i = 0; i < count; i++) {
		diag_queue_deliver(&readings[i].diags, diag, 0);
		diag_queue_release(&readings[i].diags);
		scene->meshes_read += readings[i].good;
		good &= readings[i].good;
	}
	build_trees(readings, count, threads);
	free(readings);
	return good;
}
