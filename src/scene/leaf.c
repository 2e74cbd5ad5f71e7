#include "scene/leaf.h"

#include <math.h>

#include "base/ablation.h"
#include "geom/moved_tri.h"
#include "geom/separating_axis.h"
#include "scene/memory.h"

/* Two triangles at one instant: their distance and the unit direction of it (0 when they meet). */
struct spelling {
	double distance;
	vec3 direction;
	vec3 middle;
};

static struct spelling nearest_of(const tri *a, const tri *b)
{
	vec3 on_a, on_b;
	struct spelling n = {.distance = tri_distance(a, b, &on_a, &on_b)};

	n.middle = vec3_lerp(on_a, on_b, 0.5);
	if (n.distance > 0)
		n.direction = vec3_unit(vec3_sub(on_b, on_a));
	return n;
}

static void record(struct contact *contact, double s, const axis_values *q, const struct spelling *n)
{
	if (s >= contact->s)
		return;
	*contact = (struct contact){s, *q, n->distance, n->middle};
}

/* The axis helped: it is worth trying first on the neighbours, and on the next move. */
static enum leaf_answer apart_along(const struct body_pair *pair, vec3 n, const xform *pose)
{
	if (pair->memory)
		memory_learn(pair->memory, n, pose);
	return LEAF_APART;
}

/*
 * What a distance proves at least. A gap along its direction proves less where the triangles are close and long: the
 * direction is known only to the share that rounding has in the distance, and a far corner takes that times its reach.
 */
static double proven(const struct spelling *n, const tri *a, const tri *b)
{
	return n->distance - TRI_DISTANCE_ERROR * tri_pair_size(a, b);
}

static enum leaf_answer prove_chord(const struct region *region, const struct body_pair *pair, const tri *a,
				    const tri *b, double clearance, bool final, struct contact *contact)
{
	tri b0 = tri_transform(b, &region->poses[0]), b1 = tri_transform(b, &region->poses[1]);
	double apart = clearance + region->stray[0];
	struct spelling n0, n1;

	if (tri_box_gap(a, &b0, &b1) > apart)
		return LEAF_APART;
	if (pair->memory && memory_parts_triangles(pair->memory, region, a, &b0, &b1, clearance))
		return LEAF_APART;
	n0 = nearest_of(a, &b0);
	if (n0.distance <= clearance) {
		record(contact, region->s0, &region->chord.q0, &n0);
		return LEAF_TOUCHES;
	}
	if (separating_axis_fixed(a, &b0, &b1, n0.direction, apart))
		return apart_along(pair, n0.direction, &region->poses[0]);
	n1 = nearest_of(a, &b1);
	if (n1.distance <= clearance) {
		record(contact, region->s1, &region->chord.q1, &n1);
	} else {
		if (separating_axis_fixed(a, &b0, &b1, n1.direction, apart) ||
		    (WITH_INTERPOLATED_AXES &&
		     separating_axis_interpolated(a, &b0, &b1, n0.direction, n1.direction, apart)) ||
		    proven(&n0, a, &b0) + proven(&n1, a, &b1) > 2 * (clearance + region->reach))
			return apart_along(pair, n1.direction, &region->poses[1]);
	}
	if (!final)
		return LEAF_OPEN;
	if (n0.distance <= n1.distance)
		record(contact, region->s0, &region->chord.q0, &n0);
	else
		record(contact, region->s1, &region->chord.q1, &n1);
	return LEAF_TOUCHES;
}

static axis_values box_middle(const struct region *region)
{
	axis_values q;

	for (int i = 0; i < SLOT_COUNT; i++)
		q.v[i] = 0.5 * region->chord.q0.v[i] + 0.5 * region->chord.q1.v[i];
	return q;
}

static enum leaf_answer prove_box(const struct region *region, const struct body_pair *pair, const tri *a,
				  const tri *b, double clearance, bool final, struct contact *contact)
{
	tri at = tri_transform(b, &region->poses[0]);
	struct spelling n;

	if (tri_box_gap(a, &at, &at) > clearance + region->reach)
		return LEAF_APART;
	n = nearest_of(a, &at);
	if (n.distance > clearance) {
		if (proven(&n, a, &at) > clearance + region->reach ||
		    tri_gap(a, &at, n.direction) >
			    clearance + region->stray[0] + region_play_along(region, pair, n.direction))
			return LEAF_APART;
		if (!final)
			return LEAF_OPEN;
	}
	*contact = (struct contact){0, box_middle(region), n.distance, n.middle};
	return LEAF_TOUCHES;
}

enum leaf_answer leaf_prove(const struct region *region, const struct body_pair *pair, struct leaf a, struct leaf b,
			    double clearance, bool final, struct contact *contact, long *certificates)
{
	enum leaf_answer worst = LEAF_APART;

	for (size_t i = a.first; i < (size_t)a.first + a.count; i++) {
		tri of_a = tri_of(&pair->a->mesh, i);

		for (size_t j = b.first; j < (size_t)b.first + b.count; j++) {
			tri of_b = tri_of(&pair->b->mesh, j);
			enum leaf_answer answer =
				region->kind == REGION_BOX
					? prove_box(region, pair, &of_a, &of_b, clearance, final, contact)
					: prove_chord(region, pair, &of_a, &of_b, clearance, final, contact);

			if (answer == LEAF_TOUCHES)
				return answer;
			if (answer == LEAF_OPEN)
				worst = answer;
			else
				++*certificates;
		}
	}
	return worst;
}
