#include "scene/pairs.h"

#include <stdlib.h>

#include "base/mem.h"
#include "base/parallel_for.h"
#include "base/strbuf.h"
#include "geom/tolerance.h"
#include "scene/cutter_depth.h"
#include "scene/pair_rules.h"
#include "scene/reach_search.h"
#include "scene/static_query.h"

/* mm: the tolerance of the test whether neighbours are near each other. */
#define NEAR_TOLERANCE 1e-3

static void decide(struct scene_pair *pair, enum pair_status status, const char *format, ...)
	__attribute__((format(printf, 3, 4)));

static void decide(struct scene_pair *pair, enum pair_status status, const char *format, ...)
{
	struct strbuf text = {0};
	va_list args;

	va_start(args, format);
	strbuf_addv(&text, format, args);
	va_end(args);
	pair->status = status;
	pair->reason = text.text;
}

static bool is_with(const struct body *a, const struct body *b, enum body_role role)
{
	return a->role == role || b->role == role;
}

static bool is_cutting(const struct body *a, const struct body *b)
{
	return is_with(a, b, ROLE_CUTTER) && is_with(a, b, ROLE_PART);
}

static void decide_reach(struct scene_pair *pair, bool apart)
{
	if (apart)
		decide(pair, PAIR_OUT_OF_REACH, "proved apart over the whole travel");
	else
		decide(pair, PAIR_CHECKED, "within reach of each other");
}

/* Derives the pair's status from the joints and the meshes. */
static void derive_from_geometry(struct scene *scene, struct scene_pair *pair, struct reach_search *search)
{
	const struct body *a = scene->bodies[pair->a].body, *b = scene->bodies[pair->b].body;
	const axis_values home = machine_home(scene->machine);
	const double within = scene->machine->adjacent_within;
	struct body_pair bodies;
	bool neighbours = pair->chain.count == 1 && a->role == ROLE_MACHINE && b->role == ROLE_MACHINE;

	if (b->profile && !a->profile) {
		const enum reach reach = reach_search_tool(search, scene, pair, scene_body_bvh(scene, pair->a));

		if (reach != REACH_UNKNOWN) {
			decide_reach(pair, reach == REACH_APART);
			return;
		}
	}
	bodies = scene_pair_bodies(scene, pair);
	if (neighbours && !(sweep_distance(&search->sweep, &bodies, &home, 0.7, within, 0) > within)) {
		struct chord still = {.q0 = home, .q1 = home};
		struct contact contact;
		vec3 point;

		/* The lower bound may be too small here, so ask for the distance itself. */
		if (sweep_chord(&search->sweep, &bodies, &still, within, NEAR_TOLERANCE, &contact) !=
			SWEEP_APART ||
		    static_query_contained(scene, pair, &home, &point) == INSIDE_YES) {
			decide(pair, PAIR_ADJACENT, "neighbours by axis %c, within %g mm of each other at home",
			       AXIS_LETTERS[pair->chain.joints[0].slot], within);
			return;
		}
	}
	decide_reach(pair, reach_search_proves(search, scene, pair, &bodies));
}

/* Replaces the cutter of the pair by its core. Returns the depth of the core in mm: `depth`, or less if it is thin. */
static double set_core(struct scene *scene, struct scene_pair *pair, double depth)
{
	int *cutter = scene->bodies[pair->a].body->role == ROLE_CUTTER ? &pair->a : &pair->b;
	const double core = cutter_depth(scene, *cutter, depth);

	*cutter = scene_core(scene, *cutter, core);
	return core;
}

/* The classes of steps in which a cutter must stay out of the part, and those in which its contact is cutting. */
struct contact_rule {
	unsigned apart, work;
	const char *when;	/* `apart` in words */
};

static const struct contact_rule *contact_rule(const struct scene *scene, const struct body *cutter)
{
	static const struct contact_rule rules[] = {
		[TOOL_TURNS] = {STEP_RAPID | STEP_FEED_STANDING | STEP_FEED_REVERSED, STEP_FEED_TURNING,
				"at rapid or standing"},
		[TOOL_STANDS] = {STEP_RAPID, STEP_FEED_TURNING | STEP_FEED_STANDING, "at rapid"},
		[TOOL_PROBES] = {STEP_RAPID | STEP_PROBE_TRAVEL, STEP_FEED_STANDING, "unless it measures"},
	};

	return &rules[setup_tool(scene->setup, cutter->tool)->kind];
}

static void derive_cutting(struct scene *scene, struct scene_pair *pair)
{
	const struct body *a = scene->bodies[pair->a].body, *b = scene->bodies[pair->b].body;
	const struct body *cutter = a->role == ROLE_CUTTER ? a : b, *part = cutter == a ? b : a;
	const struct contact_rule *rule = contact_rule(scene, cutter);
	double depth;

	pair->clearance = 0;
	pair->fault = PAIR_RAPID_CONTACT;
	if (!cutter->profile) {
		pair->steps = 0;
		decide(pair, PAIR_CUTTING,
		       "the cutter is a mesh, so the depth to which it enters the part is not checked");
		return;
	}
	depth = set_core(scene, pair, part->rapid_allowance);
	pair->steps = rule->apart;
	decide(pair, PAIR_CUTTING, "the cutter cuts the part; %s it may enter it %g mm deep", rule->when, depth);
}

/* Each cell of the stock gives its own depth in the cutter, so no core is needed. */
static void derive_stock_cutting(struct scene *scene, struct scene_pair *pair)
{
	const struct body *a = scene->bodies[pair->a].body, *b = scene->bodies[pair->b].body;
	const struct body *cutter = a->role == ROLE_CUTTER ? a : b, *stock = cutter == a ? b : a;
	const struct contact_rule *rule = contact_rule(scene, cutter);

	pair->clearance = 0;
	pair->fault = PAIR_RAPID_CONTACT;
	pair->inset = cutter_depth(scene, cutter == a ? pair->a : pair->b, stock->rapid_allowance);
	pair->steps = rule->apart;
	decide(pair, PAIR_CUTTING, "the cutter %s the stock; %s it may enter it %g mm deep",
	       rule->work == STEP_FEED_TURNING && cutter->profile ? "cuts" : "may touch", rule->when,
	       pair->inset);
}

/* Adds a second pair of a cutter and a part: while the cutter cuts, it must not enter deeper than the part's gouge. */
static void add_gouge(struct scene *scene, const struct scene_pair *cutting)
{
	const struct body *a = scene->bodies[cutting->a].body, *b = scene->bodies[cutting->b].body;
	const struct body *cutter = a->role == ROLE_CUTTER ? a : b, *part = cutter == a ? b : a;
	const struct contact_rule *rule = contact_rule(scene, cutter);
	struct scene_pair *pair;

	if (part->gouge < 0 || !cutter->profile)
		return;
	pair = &scene->pairs[scene->pair_count++];
	*pair = *cutting;
	pair->fault = PAIR_GOUGE;
	pair->steps = rule->work;
	decide(pair, PAIR_CUTTING, "while the cutter cuts the part, it may enter it %g mm deep",
	       set_core(scene, pair, part->gouge));
}

static bool are_of_two_tools(const struct body *a, const struct body *b)
{
	return a->tool && b->tool && a->tool != b->tool;
}

/* Decides the pair as far as bodies, joints and rules do. False: its geometry must be examined. */
static bool derive(struct scene *scene, struct scene_pair *pair, double clearance)
{
	const struct body *a = scene->bodies[pair->a].body, *b = scene->bodies[pair->b].body;
	struct pair_ruling ruling = pair_rules_apply(scene->machine, a, b);

	chain_init(&pair->chain, scene->machine, a->link, b->link);
	pair->clearance = ruling.clearance >= 0 ? ruling.clearance : clearance;
	pair->steps = STEP_ANY;
	pair->stock = is_with(a, b, ROLE_STOCK);
	/* check="always" applies to rigid pairs and to cutting pairs, too. */
	if (ruling.check == PAIR_ALWAYS && are_of_two_tools(a, b))
		decide(pair, PAIR_RIGID, "two tools are never in the spindle at once");
	else if (ruling.check == PAIR_ALWAYS)
		decide(pair, PAIR_CHECKED, "check=\"always\" in the machine file");
	else if (chain_is_rigid(&pair->chain))
		decide(pair, PAIR_RIGID, "no joint between them");
	else if (ruling.check == PAIR_NEVER)
		decide(pair, PAIR_WAIVED, "%s", ruling.reason);
	else if (is_cutting(a, b))
		derive_cutting(scene, pair);
	else if (pair->stock && is_with(a, b, ROLE_CUTTER))
		derive_stock_cutting(scene, pair);
	else
		return false;
	return true;
}

/* A pair whose geometry must be examined. */
struct open_pair {
	size_t pair;
	double size;	/* triangles, the product of both bodies: roughly proportional to the time */
};

struct geometry_work {
	struct scene *scene;
	struct reach_search *searches;	/* one for each thread */
	struct open_pair *pairs;
};

static double triangles_of(const struct scene *scene, int body)
{
	const struct bvh *bvh = scene->bodies[body].bvh;

	return bvh ? (double)bvh->mesh.count : 0;
}

static int by_size(const void *a, const void *b)
{
	const struct open_pair *x = a, *y = b;

	if (x->size < y->size || x->size > y->size)
		return x->size > y->size ? -1 : 1;
	return x->pair < y->pair ? -1 : x->pair > y->pair;
}

static void derive_one(void *context, int worker, size_t i)
{
	const struct geometry_work *work = context;

	derive_from_geometry(work->scene, &work->scene->pairs[work->pairs[i].pair], &work->searches[worker]);
}

static void derive_all_from_geometry(struct geometry_work *work, size_t count, int threads)
{
	/*
	 * The pairs that take long come first: then no thread still works on one of them while the others have nothing
	 * to do.
	 */
	if (count)
		qsort(work->pairs, count, sizeof(*work->pairs), by_size);
	for (int i = 0; i < threads; i++)
		reach_search_init(&work->searches[i], work->scene);
	parallel_for(count, threads, derive_one, work);
	for (int i = 0; i < threads; i++)
		reach_search_release(&work->searches[i]);
}

void pairs_derive(struct scene *scene, double clearance, int threads)
{
	size_t n = scene->body_count, count = 0;
	struct geometry_work work = {.scene = scene,
				     .searches = mem_zalloc((size_t)threads, sizeof(*work.searches)),
				     .pairs = mem_alloc((n * n + 1) * sizeof(*work.pairs))};

	/* A cutter and a part may have two pairs. */
	scene->pairs = mem_zalloc(n * n, sizeof(*scene->pairs));
	for (size_t a = 0; a < n; a++) {
		for (size_t b = a + 1; b < n; b++) {
			struct scene_pair *pair = &scene->pairs[scene->pair_count++];

			pair->a = (int)a;
			pair->b = (int)b;
			if (!derive(scene, pair, clearance))
				work.pairs[count++] = (struct open_pair){
					scene->pair_count - 1,
					triangles_of(scene, pair->a) * triangles_of(scene, pair->b)};
			if (pair->status == PAIR_CUTTING && !pair->stock)
				add_gouge(scene, pair);
		}
	}
	derive_all_from_geometry(&work, count, threads);
	free(work.searches);
	free(work.pairs);
}

const char *pair_status_name(enum pair_status status)
{
	static const char *const names[] = {"checked", "rigid", "adjacent", "out of reach", "waived", "cutting"};

	return names[status];
}
