#include "scene/stock_fit.h"

#include "scene/corner_depth.h"
#include "scene/placed_box.h"

/* mm: a finished surface may be a surface of the blank, whose mesh approximates round surfaces only roughly. */
static const double OUT_BY = 1;

static bool is_part(const struct scene *scene, int body)
{
	return scene->bodies[body].body->role == ROLE_PART;
}

static bool meet(const struct scene *scene, int part, int stock)
{
	return placed_box_overlap(placed_box_of(scene, part), placed_box_of(scene, stock)) > 0;
}

void stock_fit_check(struct scene *scene, struct doubts *doubts)
{
	const axis_values zero = {{0}};
	const int stock = scene_stock(scene);
	bool any = false;

	if (stock < 0 || scene->bodies[stock].body->checked)
		return;
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
