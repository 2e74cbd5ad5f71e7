#include "scene/body_shapes.h"

#include <pthread.h>
#include <stdbool.h>
#include <stdlib.h>

#include "base/mem.h"
#include "base/same_double.h"

/* A profile, with the arguments of profile_init that it was made with. */
struct known_profile {
	vec3 location, axis;
	long visits;
	struct profile profile;
};

struct body_shapes {
	const struct bvh *bvh;
	xform place;
	pthread_mutex_t building;	/* protects everything below */
	struct corner_runs *corners;	/* owned; NULL: not needed so far */
	struct known_profile *profiles;	/* owned: about the joints next to the body, in either direction: a few */
	size_t profile_count, profile_capacity;
	int holders;
};

struct body_shapes *body_shapes_new(const struct bvh *bvh, const xform *place)
{
	struct body_shapes *shapes = mem_zalloc(1, sizeof(*shapes));

	shapes->bvh = bvh;
	shapes->place = *place;
	shapes->holders = 1;
	pthread_mutex_init(&shapes->building, NULL);
	return shapes;
}

struct body_shapes *body_shapes_hold(struct body_shapes *shapes)
{
	pthread_mutex_lock(&shapes->building);
	shapes->holders++;
	pthread_mutex_unlock(&shapes->building);
	return shapes;
}

void body_shapes_release(struct body_shapes *shapes)
{
	bool held;

	if (!shapes)
		return;
	pthread_mutex_lock(&shapes->building);
	held = --shapes->holders > 0;
	pthread_mutex_unlock(&shapes->building);
	if (held)
		return;
	pthread_mutex_destroy(&shapes->building);
	corner_runs_free(shapes->corners);
	free(shapes->profiles);
	free(shapes);
}

const struct corner_runs *body_shapes_corners(struct body_shapes *shapes)
{
	pthread_mutex_lock(&shapes->building);
	if (!shapes->corners)
		shapes->corners = corner_runs_new(shapes->bvh);
	pthread_mutex_unlock(&shapes->building);
	return shapes->corners;
}

/* The caller holds the lock. */
static const struct known_profile *find_profile(const struct body_shapes *shapes, vec3 location, vec3 axis)
{
	for (size_t i = 0; i < shapes->profile_count; i++) {
		const struct known_profile *known = &shapes->profiles[i];

		if (same_vec3(known->axis, axis) && same_vec3(known->location, location))
			return known;
	}
	return NULL;
}

/* The caller holds the lock. */
static const struct known_profile *add_profile(struct body_shapes *shapes, vec3 location, vec3 axis)
{
	struct known_profile *known;

	shapes->profiles = mem_grow(shapes->profiles, &shapes->profile_capacity, shapes->profile_count + 1,
				    sizeof(*shapes->profiles));
	known = &shapes->profiles[shapes->profile_count++];
	*known = (struct known_profile){.location = location, .axis = axis};
	profile_init(&known->profile, shapes->bvh, (struct leaf){0, 0}, &shapes->place, location, axis, &known->visits);
	return known;
}

void body_shapes_profile(struct body_shapes *shapes, vec3 location, vec3 axis, struct profile *profile, long *visits)
{
	const struct known_profile *known;

	pthread_mutex_lock(&shapes->building);
	known = find_profile(shapes, location, axis);
	if (!known)
		known = add_profile(shapes, location, axis);
	*profile = known->profile;
	*visits += known->visits;
	pthread_mutex_unlock(&shapes->building);
}
