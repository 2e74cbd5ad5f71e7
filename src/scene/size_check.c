#include "scene/size_check.h"

#include <math.h>

#include "machine/kinematics_check.h"
#include "scene/missing_check.h"
#include "scene/placed_box.h"

/*
 * The size of the drawing divided by the longest travel. Outside this range the units are doubted; real machines have 1
 * to 8.
 */
static const double SIZE_LEAST = 0.1, SIZE_MOST = 25;

/*
 * The size of one body, and of all bodies of a link, divided by the longest travel. Of 1,487 bodies and 615 links of
 * real machines the smallest values are 0.0025 and 0.026. The smallest of these links measures 421 mm; a link of
 * LINK_LARGE mm is never too small.
 */
static const double BODY_LEAST = 0.001, LINK_LEAST = 0.025, LINK_LARGE = 100;

/* If a body is marked checked="", all bodies may have any size. False: all bodies together may be too small. */
static bool check_all(const struct scene *scene, struct doubts *doubts)
{
	struct placed_box box = placed_box_empty();
	struct doubt doubt = {.limit = kinematics_longest_travel(scene->machine)};

	for (size_t i = 0; i < scene->body_count; i++) {
		const struct body *body = scene->bodies[i].body;

		if (body->role != ROLE_MACHINE)
			continue;
		if (body->checked)
			return true;
		box = placed_box_union(box, placed_box_of(scene, (int)i));
	}
	if (!(doubt.limit > 0) || isinf(box.least.x))
		return true;
	doubt.value = placed_box_size(box);
	doubt.kind = doubt.value < doubt.limit ? DOUBT_BODIES_SMALL : DOUBT_BODIES_LARGE;
	if (doubt.value < SIZE_LEAST * doubt.limit || doubt.value > SIZE_MOST * doubt.limit)
		doubts_add(doubts, &doubt);
	return doubt.value >= SIZE_LEAST * doubt.limit;
}

/* The size of all bodies of a link together. */
static double link_size(const struct scene *scene, int link)
{
	struct placed_box box = placed_box_empty();

	for (size_t i = 0; i < scene->body_count; i++) {
		if (body_is_of_link(scene->bodies[i].body, link))
			box = placed_box_union(box, placed_box_of(scene, (int)i));
	}
	return placed_box_size(box);
}

static void check_bodies(const struct scene *scene, struct doubts *doubts)
{
	struct doubt doubt = {.kind = DOUBT_BODY_SMALL, .limit = kinematics_longest_travel(scene->machine)};

	for (size_t i = 0; i < scene->body_count; i++) {
		if (scene->bodies[i].body->role != ROLE_MACHINE || scene->bodies[i].body->checked)
			continue;
		doubt.body = (int)i;
		doubt.value = placed_box_size(placed_box_of(scene, (int)i));
		if (doubt.value < BODY_LEAST * doubt.limit ||
		    link_size(scene, scene->bodies[i].body->link) < fmin(LINK_LEAST * doubt.limit, LINK_LARGE))
			doubts_add(doubts, &doubt);
	}
}

void size_check(const struct scene *scene, struct doubts *doubts)
{
	/* A wrong unit for all bodies gives one doubt. */
	if (check_all(scene, doubts) && missing_is_drawn(scene))
		check_bodies(scene, doubts);
}
