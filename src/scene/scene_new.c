/* scene_new.c - makes a scene with its pairs; a separate file because pairs.c needs scene.c. */
#include "base/mem.h"
#include "scene/mesh_reading.h"
#include "scene/pairs.h"
#include "scene/scene.h"

static void add_bodies(struct scene *scene, const struct body *bodies, size_t count)
{
	for (size_t i = 0; i < count; i++)
		scene->bodies[scene->body_count++] = (struct scene_body){.body = &bodies[i]};
}

/* The largest number of cores: two for each cutter and part. */
static size_t most_cores(const struct scene *scene)
{
	size_t cutters = 0, parts = 0;

	for (size_t i = 0; i < scene->body_count; i++) {
		cutters += scene->bodies[i].body->role == ROLE_CUTTER;
		parts += scene->bodies[i].body->role == ROLE_PART;
	}
	return 2 * cutters * parts;
}

struct scene *scene_new(const struct machine *machine, const struct setup *setup, double clearance, int threads,
			struct diag *diag)
{
	struct scene *scene = mem_zalloc(1, sizeof(*scene));

	scene->machine = machine;
	scene->setup = setup;
	scene->bodies = mem_zalloc(machine->body_count + (setup ? setup->body_count : 0), sizeof(*scene->bodies));
	add_bodies(scene, machine->bodies, machine->body_count);
	if (setup)
		add_bodies(scene, setup->bodies, setup->body_count);
	scene->bodies = mem_realloc(scene->bodies, scene->body_count + most_cores(scene), sizeof(*scene->bodies));
	for (size_t i = 0; i < scene->body_count; i++)
		pthread_mutex_init(&scene->bodies[i].building, NULL);
	if (!mesh_reading_run(scene, threads > 1 ? threads : 1, diag)) {
		scene_free(scene);
		return NULL;
	}
	pairs_derive(scene, clearance, threads > 1 ? threads : 1);
	return scene;
}
