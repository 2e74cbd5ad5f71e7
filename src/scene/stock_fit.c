#include "scene/stock_fit.h"

#include <math.h>

#include "scene/corner_depth.h"
#include "scene/placed_box.h"

/* mm: a finished surface may be a surface of the blank, whose mesh approximates round surfaces only roughly. */
static const double OUT_BY = 1;

/*
 * A blank is seldom more than some times as large as the part. A part in cm, or in inches, among lengths in mm is 10 or
 * 25 times too small.
 */
static const double TIMES_LARGER = 8;

static bool is_part(const struct scene *scene, int body)
{
	return scene->bodies[body].body->role == ROLE_PART;
}

static bool meet(const struct scene *scene, int part, int stock)
{
	return placed_box_overlap(placed_box_of(scene, part), placed_box_of(scene, stock)) > 0;
}

/* The sides of the box around a body's mesh, the shortest first. */
static void sides_of(const struct scene *scene, int body, double sides[3])
{
	const vec3 half = scene->bodies[body].bvh->half;

	sides[0] = 2 * fmin(half.x, fmin(half.y, half.z));
	sides[2] = 2 * fmax(half.x, fmax(half.y, half.z));
	sides[1] = 2 * (half.x + half.y + half.z) - sides[0] - sides[2];
}

/* The one part of a blank that is many times as large in every direction. Several parts may share a blank. */
static void check_size(struct scene *scene, int stock, struct doubts *doubts)
{
	struct doubt doubt = {.kind = DOUBT_PART_BELOW_STOCK, .body = -1, .against = stock};
	double of_part[3], of_stock[3];

	for (int i = 0; i < (int)scene->body_count; i++) {
		if (is_part(scene, i) && doubt.body >= 0)
			return;
		if (is_part(scene, i))
			doubt.body = i;
	}
	if (doubt.body < 0 || scene->bodies[doubt.body].body->checked)
		return;
	sides_of(scene, doubt.body, of_part);
	sides_of(scene, stock, of_stock);
	for (int k = 0; k < 3; k++)
		if (of_part[k] * TIMES_LARGER > of_stock[k])
			return;
	doubt.value = of_part[2];
	doubt.limit = of_stock[2];
	doubts_add(doubts, &doubt);
}

void stock_fit_check(struct scene *scene, struct doubts *doubts)
{
	const axis_values zero = {{0}};
	const int stock = scene_stock(scene);
	bool any = false;

	if (stock < 0 || scene->bodies[stock].body->checked)
		return;
	check_size(scene, stock, doubts);
	for (int i = 0; i < (int)scene->body_count; i++)
		any |= is_part(scene, i) && meet(scene, i, stock);
	for (int i = 0; i < (int)scene->body_count; i++) {
		struct doubt doubt = {.kind = DOUBT_OUT_OF_STOCK, .body = i, .against = stock};

		if (!is_part(scene, i) || scene->bodies[i].body->checked || (any && !meet(scene, i, stock)))
			continue;
		doubt.value = corner_depth(scene, i, stock, &zero, INSIDE_NO, 0) -
			      scene->bodies[stock].body->uncertainty;
		if (doubt.value > OUT_BY)
			doubts_add(doubts, &doubt);
	}
}
