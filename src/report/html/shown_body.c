#include "report/html/shown_body.h"

#include <string.h>

int shown_body(const struct scene *scene, int body)
{
	for (int i = 0; (size_t)body >= scene->body_count && (size_t)i < scene->body_count; i++) {
		if (scene->bodies[i].body->profile == scene->bodies[body].body->profile)
			return i;
	}
	return body;
}

int shown_body_named(const struct scene *scene, const char *name)
{
	for (size_t i = 0; name && i < scene->body_count; i++) {
		if (!strcmp(scene->bodies[i].body->name, name))
			return (int)i;
	}
	return -1;
}

xform shown_body_pose(const struct scene *scene, int body, const axis_values *q)
{
	const struct body *it = scene->bodies[body].body;
	const xform link = machine_pose(scene->machine, it->link, q);

	return xform_mul(&link, &it->placement);
}

const struct scene_pair *shown_pair(const struct scene *scene, int a, int b)
{
	for (size_t i = 0; i < scene->pair_count; i++) {
		const struct scene_pair *pair = &scene->pairs[i];

		if (shown_body(scene, pair->a) == a && shown_body(scene, pair->b) == b)
			return pair;
	}
	return NULL;
}
