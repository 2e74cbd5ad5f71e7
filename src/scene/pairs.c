#include "scene/pairs.h"

#include <math.h>
#include <stdlib.h>

#include "base/mem.h"
#include "base/strbuf.h"
#include "base/units.h"
#include "geom/tolerance.h"
#include "scene/contact_search.h"
#include "scene/mesh_reading.h"
#include "scene/pair_rules.h"
#include "scene/static_query.h"
#include "scene/tool_contact.h"

/*
 * The most node pairs that a proof of "out of reach" may look at, which takes some milliseconds. If nothing is proved
 * the pair is checked.
 */
#define REACH_VISITS 30000

/*
 * So many of them settle most proofs. Only then it is looked whether the bodies meet at some of their positions, and
 * after as many as SECOND_VISITS for a position at which they do: no proof is possible then.
 */
#define FIRST_VISITS 450
#define SECOND_VISITS 1800

/* The most for a tool's piece with few triangles: these are looked at once more if it is not enough. */
#define COARSE_VISITS 3000

/*
 * So many steps are made from where similar bodies met. Measured on a setup with 30 tools: 3, 6 and 10 take the same
 * time to within 3 percent.
 */
enum { RECALL_STEPS = 6 };

/* mm: such a proof does not halve intervals of travel that are smaller than this. */
#define REACH_TOLERANCE 1.0

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

/* The whole travel of the pair's joints; false: a linear joint has no limits. */
static bool travel_of(const struct scene *scene, const struct chain *chain, axis_values *low, axis_values *high)
{
	*low = *high = (axis_values){{0}};
	for (size_t i = 0; i < chain->count; i++) {
		const struct axis *axis = machine_axis(scene->machine, chain->joints[i].slot);
		bool full_turn = axis->rotary && !(axis->limit_max - axis->limit_min <= 2 * PI);

		low->v[axis->slot] = full_turn ? -PI : axis->limit_min - REACH_MARGIN;
		high->v[axis->slot] = full_turn ? PI : axis->limit_max + REACH_MARGIN;
		if (!isfinite(low->v[axis->slot]) || !isfinite(high->v[axis->slot]))
			return false;
	}
	return true;
}

/* mm: how much larger than its mesh the stock may be. */
static double uncertainty_of(const struct scene *scene, const struct scene_pair *pair)
{
	return scene->bodies[pair->a].body->uncertainty + scene->bodies[pair->b].body->uncertainty;
}

/* Where a body last met one of each role. The holders of all tools meet a table at much the same place. */
struct last_contact {
	axis_values at;
	bool known;
};

/* What was found last for a body and a tool's piece that is made of sections, of each role. */
struct last_tool {
	struct tool_contact contact;
	bool apart;	/* they were out of each other's reach */
};

/* The derivation of all pairs. */
struct derivation {
	struct contact_search search;
	struct last_contact *last;	/* ROLES of them for each body */
	struct last_tool *tools;	/* likewise */
};

enum { ROLES = ROLE_CUTTER + 1 };

static struct last_contact *last_contact_of(const struct derivation *derivation, const struct scene *scene, int body,
					    int other)
{
	return &derivation->last[body * ROLES + (int)scene->bodies[other].body->role];
}

/* Do they meet near where either of them met a body like the other one? */
static bool meets_again(struct scene *scene, const struct scene_pair *pair, const struct body_pair *bodies,
			double apart, const axis_values *low, const axis_values *high, struct derivation *derivation)
{
	const struct last_contact *last[2] = {last_contact_of(derivation, scene, pair->a, pair->b),
					      last_contact_of(derivation, scene, pair->b, pair->a)};

	for (int i = 0; i < 2; i++) {
		if (last[i]->known && contact_search_recalls(&derivation->search, &scene->sweep, bodies, apart, low,
							     high, &last[i]->at, RECALL_STEPS))
			return true;
	}
	return false;
}

static void keep_contact(const struct scene *scene, const struct scene_pair *pair, struct derivation *derivation)
{
	const struct last_contact last = {derivation->search.met[0], true};

	*last_contact_of(derivation, scene, pair->a, pair->b) = last;
	*last_contact_of(derivation, scene, pair->b, pair->a) = last;
}

/* Are the boxes around the bodies apart in some corner of the travel? */
static bool are_boxes_parted(const struct body_pair *bodies, const axis_values *low, const axis_values *high)
{
	const struct box a = box_whole(bodies->a), b = box_whole(bodies->b);
	const vec3 no_axis_displacement[VIEWS] = {{0, 0, 0}, {0, 0, 0}};
	const double no_displacement[VIEWS] = {0, 0};

	for (size_t corner = 0; corner < (size_t)1 << bodies->chain->count; corner++) {
		struct box_motion boxes;
		axis_values q = *low;
		xform ends[2];
		float lost;

		for (size_t i = 0; i < bodies->chain->count; i++) {
			int slot = bodies->chain->joints[i].slot;

			q.v[slot] = (corner >> i & 1 ? high : low)->v[slot];
		}
		ends[0] = ends[1] = body_pair_pose(bodies, &q);
		box_motion_init(&boxes, bodies->a, bodies->b, ends, no_axis_displacement, no_displacement);
		if (box_pair_apart(&boxes, &a, &b, &lost) > 0)
			return true;
	}
	return false;
}

/*
 * Is neither body inside the other one, where their surfaces stay apart over the whole travel? Then that is the same
 * everywhere: where the boxes are apart it is seen at once, without the topology of the meshes.
 */
static bool is_outside(struct scene *scene, const struct scene_pair *pair, const struct body_pair *bodies,
		       const axis_values *low, const axis_values *high, struct diag *diag)
{
	const axis_values home = machine_home(scene->machine);
	vec3 point;

	return are_boxes_parted(bodies, low, high) ||
	       static_query_contained(scene, pair, &home, &point, diag) == INSIDE_NO;
}

/*
 * Is it proved that the pair stays apart over the whole travel? A contact shows that no proof is possible, and saves
 * the time of looking for one.
 */
static bool out_of_reach(struct scene *scene, const struct scene_pair *pair, const struct body_pair *bodies,
			 struct derivation *derivation, struct diag *diag)
{
	static const long visits[] = {FIRST_VISITS, SECOND_VISITS, REACH_VISITS};
	const double apart = pair->clearance + uncertainty_of(scene, pair);
	struct sweep *sweep = &scene->sweep;
	enum sweep_answer answer = SWEEP_UNDECIDED;
	axis_values low, high;
	struct contact contact;

	if (!travel_of(scene, &pair->chain, &low, &high))
		return false;
	if (meets_again(scene, pair, bodies, apart, &low, &high, derivation)) {
		keep_contact(scene, pair, derivation);
		return false;
	}
	for (size_t i = 0; i < sizeof(visits) / sizeof(*visits) && answer == SWEEP_UNDECIDED; i++) {
		if (i > 0 && contact_search_finds(&derivation->search, sweep, bodies, apart, &low, &high, i > 1)) {
			keep_contact(scene, pair, derivation);
			return false;
		}
		answer = sweep_box(sweep, bodies, &low, &high, apart, REACH_TOLERANCE, visits[i], &contact);
	}
	return answer == SWEEP_APART && is_outside(scene, pair, bodies, &low, &high, diag);
}

/* Is a tool's piece proved out of reach by the few triangles that enclose it? */
static bool is_coarse_apart(struct scene *scene, const struct scene_pair *pair, const struct bvh *tree,
			    const axis_values *low, const axis_values *high, struct diag *diag)
{
	const axis_values home = machine_home(scene->machine);
	const struct bvh *shell = scene_body_coarse(scene, pair->b);
	const struct body *a = scene->bodies[pair->a].body, *b = scene->bodies[pair->b].body;
	struct body_pair bodies;
	struct contact contact;

	body_pair_init(&bodies, tree, shell, &a->placement, &b->placement, &pair->chain);
	return sweep_box(&scene->sweep, &bodies, low, high, pair->clearance + uncertainty_of(scene, pair),
			 REACH_TOLERANCE, COARSE_VISITS, &contact) == SWEEP_APART &&
	       (are_boxes_parted(&bodies, low, high) ||
		static_query_is_outside(scene, pair, shell, &home, diag));
}

enum reach { REACH_APART, REACH_MEETS, REACH_UNKNOWN };

/*
 * Looks at a tool's piece by its sections, which takes a small part of the time that its triangles would take. A corner
 * of the other body inside it means that no proof over the travel is possible. What was found last for a piece of this
 * role is looked for first.
 */
static enum reach reach_of_tool(struct scene *scene, const struct scene_pair *pair, const struct bvh *tree,
				struct derivation *derivation, struct diag *diag)
{
	const struct body *body = scene->bodies[pair->a].body, *piece = scene->bodies[pair->b].body;
	struct last_tool *last = &derivation->tools[pair->a * ROLES + (int)piece->role];
	axis_values low, high;

	if (!travel_of(scene, &pair->chain, &low, &high))
		return REACH_UNKNOWN;
	for (int k = 0; k < 2; k++) {
		if (last->apart == (k == 0) && is_coarse_apart(scene, pair, tree, &low, &high, diag)) {
			last->apart = true;
			return REACH_APART;
		}
		if (last->apart == (k == 1) && tool_contact_finds(&last->contact, body, tree, piece, &pair->chain, &low,
								  &high)) {
			last->apart = false;
			return REACH_MEETS;
		}
	}
	return REACH_UNKNOWN;
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

/* Derives the pair's status from the joints and the meshes, which it reads. */
static bool derive_from_geometry(struct scene *scene, struct scene_pair *pair, struct derivation *derivation,
				 struct diag *diag)
{
	const struct body *a = scene->bodies[pair->a].body, *b = scene->bodies[pair->b].body;
	const axis_values home = machine_home(scene->machine);
	const double within = scene->machine->adjacent_within;
	struct body_pair bodies;
	bool neighbours = pair->chain.count == 1 && a->role == ROLE_MACHINE && b->role == ROLE_MACHINE;

	if (b->profile && !a->profile) {
		const struct bvh *tree = scene_body_bvh(scene, pair->a, diag);
		enum reach reach = tree ? reach_of_tool(scene, pair, tree, derivation, diag) : REACH_UNKNOWN;

		if (reach != REACH_UNKNOWN) {
			decide_reach(pair, reach == REACH_APART);
			return true;
		}
	}
	if (!scene_pair_bodies(scene, pair, &bodies, diag))
		return false;
	if (neighbours && !(sweep_distance(&scene->sweep, &bodies, &home, 0.7, within, 0) > within)) {
		struct chord still = {.q0 = home, .q1 = home};
		struct contact contact;
		vec3 point;

		/* The lower bound may be too small here, so ask for the distance itself. */
		if (sweep_chord(&scene->sweep, &bodies, &still, within, REACH_TOLERANCE * 1e-3, &contact) != SWEEP_APART ||
		    static_query_contained(scene, pair, &home, &point, diag) == INSIDE_YES) {
			decide(pair, PAIR_ADJACENT, "neighbours by axis %c, within %g mm of each other at home",
			       AXIS_LETTERS[pair->chain.joints[0].slot], within);
			return true;
		}
	}
	decide_reach(pair, out_of_reach(scene, pair, &bodies, derivation, diag));
	return true;
}

/* Replaces the cutter of the pair by its core. */
static void set_core(struct scene *scene, struct scene_pair *pair, double depth)
{
	int *cutter = scene->bodies[pair->a].body->role == ROLE_CUTTER ? &pair->a : &pair->b;

	*cutter = scene_core(scene, *cutter, depth);
}

/* In which classes of steps a cutter has to stay out of the part, and in which its contact is work. */
struct contact_rule {
	unsigned apart, work;
	const char *when;	/* `apart` in words */
};

static const struct contact_rule *contact_rule(const struct scene *scene, const struct body *cutter)
{
	static const struct contact_rule rules[] = {
		[TOOL_TURNS] = {STEP_RAPID | STEP_FEED_STANDING | STEP_FEED_REVERSED, STEP_FEED_TURNING, "at rapid or standing"},
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

	pair->clearance = 0;
	pair->fault = PAIR_RAPID_CONTACT;
	if (!cutter->profile) {
		pair->steps = 0;
		decide(pair, PAIR_CUTTING, "the cutter is a mesh: how deep it enters the part is not checked");
		return;
	}
	set_core(scene, pair, part->rapid_allowance);
	pair->steps = rule->apart;
	decide(pair, PAIR_CUTTING, "the cutter cuts the part; %s it may enter it %g mm deep", rule->when,
	       part->rapid_allowance);
}

/* The stock's cells know how deep they are in the cutter, so no core is needed. */
static void derive_stock_cutting(struct scene *scene, struct scene_pair *pair)
{
	const struct body *a = scene->bodies[pair->a].body, *b = scene->bodies[pair->b].body;
	const struct body *cutter = a->role == ROLE_CUTTER ? a : b, *stock = cutter == a ? b : a;
	const struct contact_rule *rule = contact_rule(scene, cutter);

	pair->clearance = 0;
	pair->fault = PAIR_RAPID_CONTACT;
	pair->inset = stock->rapid_allowance;
	pair->steps = rule->apart;
	decide(pair, PAIR_CUTTING, "the cutter %s the stock; %s it may enter it %g mm deep",
	       rule->work == STEP_FEED_TURNING && cutter->profile ? "cuts" : "may touch", rule->when,
	       stock->rapid_allowance);
}

/* Adds a second pair of a cutter and a part: while the cutter cuts it may not enter deeper than the part's gouge. */
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
	set_core(scene, pair, part->gouge);
	decide(pair, PAIR_CUTTING, "while the cutter cuts the part it may enter it %g mm deep", part->gouge);
}

static bool derive(struct scene *scene, struct scene_pair *pair, double clearance, struct derivation *derivation,
		   struct diag *diag)
{
	const struct body *a = scene->bodies[pair->a].body, *b = scene->bodies[pair->b].body;
	struct pair_ruling ruling = pair_rules_apply(scene->machine, a, b);

	chain_init(&pair->chain, scene->machine, a->link, b->link);
	pair->clearance = ruling.clearance >= 0 ? ruling.clearance : clearance;
	pair->steps = STEP_ANY;
	pair->stock = is_with(a, b, ROLE_STOCK);
	/* check="always" applies to rigid pairs and to cutting pairs, too. */
	if (ruling.check == PAIR_ALWAYS)
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
		return derive_from_geometry(scene, pair, derivation, diag);
	return true;
}

/* Does the derivation look at the meshes of the pair? As derive() has it. */
static bool needs_meshes(const struct scene *scene, const struct body *a, const struct body *b)
{
	const struct pair_ruling ruling = pair_rules_apply(scene->machine, a, b);
	struct chain chain;

	if (ruling.check == PAIR_ALWAYS || ruling.check == PAIR_NEVER || is_cutting(a, b))
		return false;
	chain_init(&chain, scene->machine, a->link, b->link);
	return !chain_is_rigid(&chain);
}

void pairs_read_meshes(struct scene *scene, int threads, struct diag *diag)
{
	size_t n = scene->body_count, count = 0;
	int *wanted = mem_alloc(n * sizeof(*wanted));
	bool *listed = mem_zalloc(n, sizeof(*listed));

	for (size_t a = 0; a < n; a++) {
		for (size_t b = a + 1; b < n; b++) {
			const size_t pair[2] = {a, b};

			if ((listed[a] && listed[b]) ||
			    !needs_meshes(scene, scene->bodies[a].body, scene->bodies[b].body))
				continue;
			for (int i = 0; i < 2; i++) {
				if (!listed[pair[i]] && !scene->bodies[pair[i]].body->profile)
					wanted[count++] = (int)pair[i];
				listed[pair[i]] = true;
			}
		}
	}
	mesh_reading_run(scene, wanted, count, threads, diag);
	free(wanted);
	free(listed);
}

bool pairs_derive(struct scene *scene, double clearance, struct diag *diag)
{
	size_t n = scene->body_count;
	struct derivation derivation = {.last = mem_zalloc(n * ROLES, sizeof(*derivation.last)),
					.tools = mem_zalloc(n * ROLES, sizeof(*derivation.tools))};
	bool good = true;

	/* A cutter and a part may have two pairs. */
	scene->pairs = mem_zalloc(n * n, sizeof(*scene->pairs));
	for (size_t a = 0; a < n; a++) {
		for (size_t b = a + 1; b < n; b++) {
			struct scene_pair *pair = &scene->pairs[scene->pair_count++];

			pair->a = (int)a;
			pair->b = (int)b;
			good &= derive(scene, pair, clearance, &derivation, diag);
			if (pair->status == PAIR_CUTTING && !pair->stock)
				add_gouge(scene, pair);
		}
	}
	free(derivation.last);
	free(derivation.tools);
	return good;
}

const char *pair_status_name(enum pair_status status)
{
	static const char *const names[] = {"checked", "rigid", "adjacent", "out of reach", "waived", "cutting"};

	return names[status];
}
