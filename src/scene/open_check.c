#include "scene/open_check.h"

#include "geom/topology.h"

static bool has_checked_pair(const struct scene *scene, int body)
{
	for (size_t i = 0; i < scene->pair_count; i++) {
		const struct scene_pair *pair = &scene->pairs[i];

		if (pair->status == PAIR_CHECKED && (pair->a == body || pair->b == body))
			return true;
	}
	return false;
}

static bool is_asked_for(const struct scene *scene, int body)
{
	const struct scene_body *b = &scene->bodies[body];

	return b->bvh && !b->body->profile && !b->body->checked;
}

static bool is_open(struct scene *scene, int body)
{
	return is_asked_for(scene, body) && !scene_body_is_balanced(scene, body) && has_checked_pair(scene, body) &&
	       topology_is_open(scene_body_topology(scene, body));
}

void open_check_prepare(struct scene *scene, int body)
{
	if (is_asked_for(scene, body))
		scene_body_is_balanced(scene, body);
}

void open_check(struct scene *scene)
{
	for (int i = (int)scene->body_count; i-- > 0;) {
		if (!is_open(scene, i))
			continue;
		scene->open_bodies++;
		scene->first_open = i;
	}
}
