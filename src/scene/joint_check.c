#include "scene/joint_check.h"

#include <math.h>

#include "machine/chain.h"

/* mm: guideways, bearings and ball screws that are not drawn leave smaller gaps than a missing body does. */
static const double GAP_MOST = 50;
/* mm: the largest distance of two bodies at a joint. A pair that is excused beyond it should be checked. */
static const double NEIGHBOURS_MOST = 20;

/*
 * A lower bound of the distance of two bodies at home, at least 0.9 of the distance; any lower bound if the distance is
 * below `enough`.
 */
static double distance_at_home(struct scene *scene, size_t a, size_t b, double enough)
{
	const struct body *first = scene->bodies[a].body, *second = scene->bodies[b].body;
	const axis_values home = machine_home(scene->machine);
	struct body_pair bodies;
	struct chain chain;

	chain_init(&chain, scene->machine, first->link, second->link);
	body_pair_init(&bodies, scene->bodies[a].bvh, scene->bodies[b].bvh, &first->placement, &second->placement,
		       &chain);
	return sweep_distance(&scene->sweep, &bodies, &home, 0.9, enough, 0);
}

/*
 * The nearest two bodies of a link and of the links that carry it. The search ends at two bodies within GAP_MOST. The
 * distance is INFINITY if one side has no body or a mesh has not been read.
 */
static struct doubt nearest_of(struct scene *scene, int link)
{
	struct doubt nearest = {.kind = DOUBT_GAP, .axis = link - 1, .value = INFINITY};

	for (size_t i = 0; i < scene->body_count; i++) {
		for (size_t k = 0; k < scene->body_count && body_is_of_link(scene->bodies[i].body, link); k++) {
			const struct body *other = scene->bodies[k].body;
			double distance;

			if (other->role != ROLE_MACHINE || other->link == link ||
			    !machine_link_is_on(scene->machine, link, other->link))
				continue;
			distance = distance_at_home(scene, i, k, GAP_MOST);
			if (distance >= nearest.value)
				continue;
			nearest.value = distance;
			nearest.body = (int)i;
			nearest.against = (int)k;
			if (distance <= GAP_MOST)
				return nearest;
		}
	}
	return nearest;
}

/* Finds the pair excused as neighbours that is farthest apart, if it is too far apart for a joint. */
static void check_excused(struct scene *scene, struct doubts *doubts)
{
	struct doubt doubt = {.kind = DOUBT_EXCUSED_APART, .value = NEIGHBOURS_MOST};
	bool apart = false;

	for (size_t i = 0; i < scene->pair_count && scene->machine->adjacent_within > NEIGHBOURS_MOST; i++) {
		const struct scene_pair *pair = &scene->pairs[i];
		double distance;

		if (pair->status != PAIR_ADJACENT)
			continue;
		distance = distance_at_home(scene, (size_t)pair->a, (size_t)pair->b, doubt.value);
		if (distance <= doubt.value)
			continue;
		apart = true;
		doubt.value = distance;
		doubt.body = pair->a;
		doubt.against = pair->b;
	}
	if (apart)
		doubts_add(doubts, &doubt);
}

void joint_check(struct scene *scene, struct doubts *doubts)
{
	for (int link = 1; link <= (int)scene->machine->axis_count; link++) {
		struct doubt nearest;

		if (scene->machine->axes[link - 1].checked)
			continue;
		nearest = nearest_of(scene, link);
		if (nearest.value > GAP_MOST && !isinf(nearest.value))
			doubts_add(doubts, &nearest);
	}
	check_excused(scene, doubts);
}
