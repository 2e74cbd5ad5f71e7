#include "scene/model_check.h"

#include <math.h>

#include "base/parallel_for.h"
#include "machine/chain.h"
#include "machine/kinematics_check.h"
#include "machine/value_check.h"
#include "scene/head_check.h"
#include "scene/joint_check.h"
#include "scene/missing_check.h"
#include "scene/neighbour_check.h"
#include "scene/open_check.h"
#include "scene/placed_box.h"
#include "scene/placement_check.h"
#include "scene/ring_check.h"
#include "scene/setup_check.h"
#include "scene/size_check.h"
#include "scene/stock_fit.h"
#include "scene/tool_check.h"

/*
 * mm: the largest distance of a gauge point or a workholding from the body that it belongs to (nose rings, cut-outs).
 */
static const double SPINDLE_OFF = 30;
static const double WORKHOLDING_OFF = 50;

/* The body of a link whose box is nearest to a point; -1: the link has no body. */
static int nearest_body(const struct scene *scene, int link, vec3 point, double *distance)
{
	int nearest = -1;

	*distance = INFINITY;
	for (size_t i = 0; i < scene->body_count; i++) {
		const struct body *body = scene->bodies[i].body;
		double d;

		if (!body_is_of_link(body, link))
			continue;
		d = placed_box_distance(placed_box_of(scene, (int)i), point);
		if (d < *distance) {
			*distance = d;
			nearest = (int)i;
		}
	}
	return nearest;
}

static void check_mount(const struct scene *scene, enum doubt_kind kind, int link, vec3 point, double most,
			struct doubts *doubts)
{
	struct doubt doubt = {.kind = kind};

	doubt.body = nearest_body(scene, link, point, &doubt.value);
	if (doubt.body >= 0 && doubt.value > most)
		doubts_add(doubts, &doubt);
}

/*
 * A workholding at the drawing's origin does not say where it is. If a fixture or part is drawn, setup_check tests
 * whether it is held: the origin may be the middle of a rotary axis, far from its table.
 */
static bool claims_place(const struct scene *scene)
{
	for (size_t i = 0; i < scene->body_count; i++) {
		enum body_role role = scene->bodies[i].body->role;

		if (role == ROLE_FIXTURE || role == ROLE_PART)
			return false;
	}
	return vec3_norm(scene->machine->workholding.frame.translation) > 0;
}

/* The distance of a line from a box. The distance is convex along the line, so a ternary search finds its minimum. */
static double line_to_box(vec3 point, vec3 along, struct placed_box box)
{
	double reach = placed_box_distance(box, point) + 2 * placed_box_size(box), low = -reach, high = reach;

	for (int i = 0; i < 200; i++) {
		double a = low + (high - low) / 3, b = high - (high - low) / 3;

		if (placed_box_distance(box, vec3_mad(point, a, along)) <
		    placed_box_distance(box, vec3_mad(point, b, along)))
			high = b;
		else
			low = a;
	}
	return placed_box_distance(box, vec3_mad(point, low, along));
}

/* The box of all bodies of the machine that move with the link; false: there are none. */
static bool carried_box(const struct scene *scene, int link, struct placed_box *box)
{
	*box = placed_box_empty();
	for (size_t k = 0; k < scene->body_count; k++) {
		const struct body *body = scene->bodies[k].body;

		if (body->role != ROLE_MACHINE || !machine_link_is_on(scene->machine, body->link, link))
			continue;
		*box = placed_box_union(*box, placed_box_of(scene, (int)k));
	}
	return !isinf(box->least.x);
}

static void check_turning(const struct scene *scene, struct doubts *doubts)
{
	const struct machine *machine = scene->machine;

	for (size_t i = 0; i < machine->axis_count; i++) {
		const struct axis *axis = &machine->axes[i];
		struct doubt doubt = {.kind = DOUBT_ROTARY_MISSES, .axis = (int)i};
		struct placed_box box;

		if (!axis->rotary || axis->checked || !carried_box(scene, (int)i + 1, &box))
			continue;
		doubt.value = line_to_box(axis->location, axis->direction, box);
		if (doubt.value > 1)
			doubts_add(doubts, &doubt);
	}
}

/* Are the links, the spindle and the work where their motions require? */
static void check_places(struct scene *scene, struct doubts *doubts)
{
	const struct machine *machine = scene->machine;
	const struct spindle *spindle = &machine->spindle;
	const struct workholding *workholding = &machine->workholding;

	open_check(scene);
	kinematics_check(machine, doubts);
	value_check(machine, doubts);
	check_turning(scene, doubts);
	ring_check(scene, doubts);
	if (spindle->present && !spindle->checked) {
		head_check(scene, doubts);
		check_mount(scene, DOUBT_SPINDLE_FAR, spindle->link, spindle->location, SPINDLE_OFF, doubts);
	}
	if (workholding->present && !workholding->checked && claims_place(scene))
		check_mount(scene, DOUBT_WORKHOLDING_FAR, workholding->link, workholding->frame.translation,
			    WORKHOLDING_OFF, doubts);
	size_check(scene, doubts);
	if (missing_is_drawn(scene))
		joint_check(scene, doubts);
}

/* The two checks that take longest; both take about the same time. Only the first uses the scene's sweep. */
enum { PLACES, NEIGHBOURS, LONG_CHECKS };

struct long_checks {
	struct scene *scene;
	struct doubts doubts[LONG_CHECKS];
};

/* First the balances of all bodies, one by one, then the checks that ask for them. */
static void run_long_check(void *context, int worker, size_t i)
{
	struct long_checks *checks = context;
	const size_t bodies = checks->scene->body_count;

	(void)worker;
	if (i < bodies) {
		open_check_prepare(checks->scene, (int)i);
		return;
	}
	i -= bodies;
	if (i == PLACES)
		check_places(checks->scene, &checks->doubts[i]);
	else if (missing_is_drawn(checks->scene))
		neighbour_check(checks->scene, &checks->doubts[i]);
}

void model_check(struct scene *scene, int threads)
{
	struct long_checks checks = {.scene = scene};
	struct doubts *doubts = &scene->doubts;

	parallel_for(scene->body_count + LONG_CHECKS, threads, run_long_check, &checks);
	for (int i = 0; i < LONG_CHECKS; i++) {
		doubts_add_all(doubts, &checks.doubts[i]);
		doubts_release(&checks.doubts[i]);
	}
	missing_check(scene, doubts);
	placement_check(scene, doubts);
	setup_check(scene, doubts);
	stock_fit_check(scene, doubts);
	tool_check(scene, doubts);
}
