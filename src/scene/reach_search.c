#include "scene/reach_search.h"

#include <math.h>
#include <stdlib.h>

#include "base/mem.h"
#include "base/units.h"
#include "geom/tolerance.h"
#include "scene/box_query.h"
#include "scene/static_query.h"
#include "scene/tool_contact.h"

/*
 * The largest number of node pairs for a proof of "out of reach", which takes some milliseconds. If the proof fails the
 * pair is checked.
 */
#define REACH_VISITS 30000

/*
 * Most proofs are complete after FIRST_VISITS. Only then the search tests whether the bodies meet at some positions;
 * after SECOND_VISITS it also searches for a position at which they meet. If they meet, no proof is possible.
 */
#define FIRST_VISITS 450
#define SECOND_VISITS 1800

/* The largest number for a tool's piece with few triangles. If this is not enough they are examined once more. */
#define COARSE_VISITS 3000

/*
 * The number of steps from a position at which similar bodies met. Measured on a setup with 30 tools: 3, 6 and 10 take
 * the same time to within 3 percent.
 */
enum { RECALL_STEPS = 6 };

/* mm: such a proof does not halve intervals of travel that are smaller than this. */
#define REACH_TOLERANCE 1.0

/* See struct swept_box. Measured on the machines of machines/: 0.2 needs 1.06 times the instructions, 0.4 1.4 times. */
#define LOST 0.1

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

/* mm: an upper bound of the excess of the stock over its mesh. */
static double uncertainty_of(const struct scene *scene, const struct scene_pair *pair)
{
	return scene->bodies[pair->a].body->uncertainty + scene->bodies[pair->b].body->uncertainty;
}

enum { ROLES = ROLE_CUTTER + 1 };

/*
 * The last contact of a body with one body of each role. The holders of all tools meet a table at much the same place.
 */
struct last_contact {
	axis_values at;
	bool known;
};

/* The last result for a body and a tool's piece that is made of sections, for each role. */
struct last_tool {
	struct tool_contact contact;
	bool apart;	/* they were out of each other's reach */
};

void reach_search_init(struct reach_search *search, const struct scene *scene)
{
	*search = (struct reach_search){.last = mem_zalloc(scene->body_count * ROLES, sizeof(*search->last)),
					.tools = mem_zalloc(scene->body_count * ROLES, sizeof(*search->tools))};
}

void reach_search_release(struct reach_search *search)
{
	free(search->last);
	free(search->tools);
	sweep_release(&search->sweep);
}

static struct last_contact *last_contact_of(const struct reach_search *search, const struct scene *scene, int body,
					    int other)
{
	return &search->last[body * ROLES + (int)scene->bodies[other].body->role];
}

/* Do they meet near a position at which either of them met a similar body? */
static bool meets_again(struct scene *scene, const struct scene_pair *pair, const struct body_pair *bodies,
			double apart, const axis_values *low, const axis_values *high, struct reach_search *search)
{
	const struct last_contact *last[2] = {last_contact_of(search, scene, pair->a, pair->b),
					      last_contact_of(search, scene, pair->b, pair->a)};

	for (int i = 0; i < 2; i++) {
		if (last[i]->known && contact_search_recalls(&search->contacts, &search->sweep, bodies, apart,
							     low, high, &last[i]->at, RECALL_STEPS))
			return true;
	}
	return false;
}

static void keep_contact(const struct scene *scene, const struct scene_pair *pair, struct reach_search *search)
{
	const struct last_contact last = {search->contacts.met[0], true};

	*last_contact_of(search, scene, pair->a, pair->b) = last;
	*last_contact_of(search, scene, pair->b, pair->a) = last;
}

/* Are the boxes around the bodies apart at a corner of the travel? */
static bool are_boxes_parted(const struct body_pair *bodies, const axis_values *low, const axis_values *high)
{
	for (size_t corner = 0; corner < (size_t)1 << bodies->chain->count; corner++) {
		struct box_query boxes;
		axis_values q = *low;
		xform pose;

		for (size_t i = 0; i < bodies->chain->count; i++) {
			int slot = bodies->chain->joints[i].slot;

			q.v[slot] = (corner >> i & 1 ? high : low)->v[slot];
		}
		pose = body_pair_pose(bodies, &q);
		box_query_init(&boxes, bodies->a, bodies->b, &pose);
		if (box_query_parts_boxes(&boxes))
			return true;
	}
	return false;
}

/*
 * Is neither body inside the other, if their surfaces stay apart over the whole travel? The answer is then the same at
 * every position. A position where the boxes are apart decides this at once, without the topology of the meshes.
 */
static bool is_outside(struct scene *scene, const struct scene_pair *pair, const struct body_pair *bodies,
		       const axis_values *low, const axis_values *high)
{
	const axis_values home = machine_home(scene->machine);
	vec3 point;

	return are_boxes_parted(bodies, low, high) ||
	       static_query_contained(scene, pair, &home, &point) == INSIDE_NO;
}

/* A contact shows that no proof is possible and saves the search for one. */
bool reach_search_proves(struct reach_search *search, struct scene *scene, const struct scene_pair *pair,
			 const struct body_pair *bodies)
{
	static const long visits[] = {FIRST_VISITS, SECOND_VISITS, REACH_VISITS};
	const double apart = pair->clearance + uncertainty_of(scene, pair);
	struct sweep *sweep = &search->sweep;
	enum sweep_answer answer = SWEEP_UNDECIDED;
	axis_values low, high;
	struct swept_box box = {.low = &low, .high = &high, .lost = LOST};
	struct contact contact;

	if (!travel_of(scene, &pair->chain, &low, &high))
		return false;
	if (meets_again(scene, pair, bodies, apart, &low, &high, search)) {
		keep_contact(scene, pair, search);
		return false;
	}
	for (size_t i = 0; i < sizeof(visits) / sizeof(*visits) && answer == SWEEP_UNDECIDED; i++) {
		if (i > 0 && contact_search_finds(&search->contacts, sweep, bodies, apart, &low, &high, i > 1)) {
			keep_contact(scene, pair, search);
			return false;
		}
		box.max_visits = visits[i];
		answer = sweep_box(sweep, bodies, &box, apart, REACH_TOLERANCE, &contact);
	}
	return answer == SWEEP_APART && is_outside(scene, pair, bodies, &low, &high);
}

/* Is a tool's piece proved out of reach by the few triangles that enclose it? */
static bool is_coarse_apart(struct scene *scene, const struct scene_pair *pair, const struct bvh *tree,
			    struct sweep *sweep, const axis_values *low, const axis_values *high)
{
	const axis_values home = machine_home(scene->machine);
	const struct bvh *shell = scene_body_coarse(scene, pair->b);
	const struct body *a = scene->bodies[pair->a].body, *b = scene->bodies[pair->b].body;
	const struct swept_box box = {.low = low, .high = high, .lost = LOST, .max_visits = COARSE_VISITS};
	struct body_pair bodies;
	struct contact contact;

	body_pair_init(&bodies, tree, shell, &a->placement, &b->placement, &pair->chain);
	return sweep_box(sweep, &bodies, &box, pair->clearance + uncertainty_of(scene, pair), REACH_TOLERANCE,
			 &contact) == SWEEP_APART &&
	       (are_boxes_parted(&bodies, low, high) ||
		static_query_is_outside(scene, pair, shell, &home));
}

/* The last result for a piece of this role is tried first. */
enum reach reach_search_tool(struct reach_search *search, struct scene *scene, const struct scene_pair *pair,
			     const struct bvh *tree)
{
	const struct body *body = scene->bodies[pair->a].body, *piece = scene->bodies[pair->b].body;
	struct last_tool *last = &search->tools[pair->a * ROLES + (int)piece->role];
	axis_values low, high;

	if (!travel_of(scene, &pair->chain, &low, &high))
		return REACH_UNKNOWN;
	for (int k = 0; k < 2; k++) {
		if (last->apart == (k == 0) &&
		    is_coarse_apart(scene, pair, tree, &search->sweep, &low, &high)) {
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
