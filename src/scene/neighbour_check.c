#include "scene/neighbour_check.h"

#include <math.h>

#include "base/units.h"
#include "machine/chain.h"
#include "scene/corner_depth.h"

/* mm: the overlap of guideways, bearings and covers that are drawn through each other changes by less over a travel. */
static const double DEEPER_BY = 25;
/* The number of positions of the joint that are tested, besides home: evenly spaced, including both ends. */
enum { POSITIONS = 5 };
/* Triangles: testing a larger mesh would take longer than reading it. */
enum { MESH_MOST = 50000 };

static const struct axis *joint_of(const struct scene *scene, const struct scene_pair *pair)
{
	return machine_axis(scene->machine, pair->chain.joints[0].slot);
}

/* An endless rotary axis is rotated once; an endless linear axis is not moved. */
static double position_of(const struct axis *axis, int i)
{
	double least = axis->limit_min, most = axis->limit_max;

	if (axis->rotary) {
		least = fmax(least, axis->home - PI);
		most = fmin(most, axis->home + PI);
	}
	if (isinf(least) || isinf(most))
		return axis->home;
	return least + (most - least) * i / (POSITIONS - 1);
}

/* mm; 0: not more than `beyond`. */
static double depth_at(struct scene *scene, const struct scene_pair *pair, const axis_values *q, double beyond)
{
	return fmax(corner_depth(scene, pair->a, pair->b, q, INSIDE_YES, beyond),
		    corner_depth(scene, pair->b, pair->a, q, INSIDE_YES, beyond));
}

static bool is_small(const struct scene *scene, int body)
{
	return scene->bodies[body].bvh->mesh.count <= MESH_MOST;
}

static void check_pair(struct scene *scene, const struct scene_pair *pair, struct doubts *doubts)
{
	const struct axis *axis = joint_of(scene, pair);
	const axis_values home = machine_home(scene->machine);
	struct doubt doubt = {.kind = DOUBT_NEIGHBOURS_MEET, .axis = (int)(axis - scene->machine->axes),
			      .body = pair->a, .against = pair->b};

	for (int i = 0; i < POSITIONS; i++) {
		axis_values q = home;
		double depth;

		q.v[axis->slot] = position_of(axis, i);
		depth = depth_at(scene, pair, &q, fmax(DEEPER_BY, doubt.value));
		if (depth <= doubt.value)
			continue;
		doubt.value = depth;
		doubt.limit = q.v[axis->slot];
	}
	if (doubt.value > DEEPER_BY && doubt.value > DEEPER_BY + depth_at(scene, pair, &home, 0))
		doubts_add(doubts, &doubt);
}

void neighbour_check(struct scene *scene, struct doubts *doubts)
{
	for (size_t i = 0; i < scene->pair_count; i++) {
		const struct scene_pair *pair = &scene->pairs[i];

		if (pair->status == PAIR_ADJACENT && !joint_of(scene, pair)->checked && is_small(scene, pair->a) &&
		    is_small(scene, pair->b))
			check_pair(scene, pair, doubts);
	}
}
