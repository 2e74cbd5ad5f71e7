#include "scene/tri_pair.h"

#include <math.h>

#include "base/ablation.h"
#include "base/minmax.h"
#include "geom/moved_tri.h"
#include "geom/separating_axis.h"
#include "scene/coherence.h"

/* Two triangles at one instant: their distance and its unit direction (0 if they meet). */
struct closest {
	double distance;
	vec3 direction;
	vec3 middle;
};

static struct closest closest_of(const tri *a, const tri *b)
{
	vec3 on_a, on_b;
	struct closest n = {.distance = tri_distance(a, b, &on_a, &on_b)};

	n.middle = vec3_lerp(on_a, on_b, 0.5);
	if (n.distance > 0)
		n.direction = vec3_unit(vec3_sub(on_b, on_a));
	return n;
}

static void record(struct contact *contact, double s, const axis_values *q, const struct closest *n)
{
	if (s >= contact->s)
		return;
	*contact = (struct contact){s, *q, n->distance, n->middle, 0};
}

/* The axis proved the triangles apart, so it is tried first for the neighbours and in the next step. */
static enum tri_pair_answer apart_along(const struct body_pair *pair, vec3 n, const xform *pose)
{
	if (pair->coherence)
		coherence_learn(pair->coherence, n, pose);
	return TRI_PAIR_APART;
}

/*
 * A lower bound of the distance. If the triangles are close and long, the gap along the direction of the distance is
 * smaller than the distance: rounding causes an error of the direction, and its effect grows with the distance of a
 * corner.
 */
static double proven(const struct closest *n, const tri *a, const tri *b)
{
	return n->distance - TRI_DISTANCE_ERROR * tri_pair_size(a, b);
}

/* The distance in mm that two triangles must exceed: the clearance plus what the path tolerance may take from it. */
struct required {
	double at[2];	/* at the ends of the interval; these depend on the positions of the axes alone */
	double throughout;	/* at every instant of the interval */
};

/*
 * The largest displacement at the triangle's corners, in a's mesh coordinates. No point of the triangle has a larger
 * one.
 */
static double most_displaced(const struct body_pair *pair, const struct chain_state *state, const tri *t,
			     const axis_values *tolerance)
{
	double most = 0;

	for (int i = 0; i < 3; i++)
		most = larger(most,
			      path_displacement(pair->chain, state, xform_apply(&pair->place_a, t->p[i]), tolerance));
	return most;
}

static struct required required_of(const struct motion_interval *interval, const struct body_pair *pair, const tri *a,
				   const tri *b0, const tri *b1, double clearance)
{
	const axis_values *tolerance = interval->chord.tolerance;
	double throughout[VIEWS], at[VIEWS][2];

	if (!(interval->path > 0))
		return (struct required){{clearance, clearance}, clearance};
	for (int end = 0; end < 2; end++) {
		at[0][end] = most_displaced(pair, &interval->states[end], end ? b1 : b0, tolerance);
		at[1][end] = most_displaced(pair, &interval->states[end], a, tolerance);
	}
	for (int view = 0; view < VIEWS; view++)
		throughout[view] = larger(at[view][0], at[view][1]) + interval->path_growth[view];
	return (struct required){{clearance + smaller(at[0][0], at[1][0]), clearance + smaller(at[0][1], at[1][1])},
				 clearance + smaller(throughout[0], throughout[1])};
}

/*
 * The remembered axes depend on earlier proofs. Because they must prove the tolerance in addition, they decide only
 * triangles that no final interval would report. So remembering changes no result.
 */
static bool apart_by_coherence(const struct motion_interval *interval, const struct body_pair *pair, const tri *a,
			       const tri *b0, const tri *b1, const struct required *required, double margin)
{
	return pair->coherence &&
	       coherence_separates_triangles(pair->coherence, interval, a, b0, b1, required->throughout + margin);
}

static enum tri_pair_answer prove_chord(const struct motion_interval *interval, const struct body_pair *pair,
					const tri *a, const tri *b, const struct tri_pair_query *question,
					struct contact *contact)
{
	tri b0 = tri_transform(b, &interval->poses[0]), b1 = tri_transform(b, &interval->poses[1]);
	struct required required;
	struct closest n0, n1;
	double apart;

	if (tri_box_gap(a, &b0, &b1) > question->clearance + interval->path + interval->displacement[0])
		return TRI_PAIR_APART;
	required = required_of(interval, pair, a, &b0, &b1, question->clearance);
	apart = required.throughout + interval->displacement[0];
	if (apart_by_coherence(interval, pair, a, &b0, &b1, &required, question->coherence_margin))
		return TRI_PAIR_APART;
	n0 = closest_of(a, &b0);
	if (n0.distance <= required.at[0]) {
		record(contact, interval->s0, &interval->chord.q0, &n0);
		return TRI_PAIR_TOUCHES;
	}
	if (separating_axis_fixed(a, &b0, &b1, n0.direction, apart))
		return apart_along(pair, n0.direction, &interval->poses[0]);
	n1 = closest_of(a, &b1);
	if (n1.distance <= required.at[1]) {
		record(contact, interval->s1, &interval->chord.q1, &n1);
	} else {
		if (separating_axis_fixed(a, &b0, &b1, n1.direction, apart) ||
		    (WITH_INTERPOLATED_AXES &&
		     separating_axis_interpolated(a, &b0, &b1, n0.direction, n1.direction, apart)) ||
		    proven(&n0, a, &b0) + proven(&n1, a, &b1) > 2 * (required.throughout + interval->reach))
			return apart_along(pair, n1.direction, &interval->poses[1]);
	}
	if (!question->final)
		return TRI_PAIR_OPEN;
	if (n0.distance <= n1.distance)
		record(contact, interval->s0, &interval->chord.q0, &n0);
	else
		record(contact, interval->s1, &interval->chord.q1, &n1);
	return TRI_PAIR_TOUCHES;
}

static enum tri_pair_answer prove_box(const struct motion_interval *interval, const struct body_pair *pair,
				      const tri *a, const tri *b, const struct tri_pair_query *question,
				      struct contact *contact)
{
	double clearance = question->clearance;
	tri at = tri_transform(b, &interval->poses[0]);
	struct closest n;

	if (tri_box_gap(a, &at, &at) > clearance + interval->reach)
		return TRI_PAIR_APART;
	n = closest_of(a, &at);
	if (n.distance > clearance) {
		if (proven(&n, a, &at) > clearance + interval->reach ||
		    tri_gap(a, &at, n.direction) > clearance + interval->displacement[0] +
						       motion_interval_displacement_along(interval, pair, n.direction))
			return TRI_PAIR_APART;
		if (!question->final)
			return TRI_PAIR_OPEN;
	}
	*contact = (struct contact){0, axis_values_middle(&interval->chord.q0, &interval->chord.q1), n.distance,
				    n.middle, 0};
	return TRI_PAIR_TOUCHES;
}

enum tri_pair_answer tri_pair_prove(const struct motion_interval *interval, const struct body_pair *pair, struct leaf a,
				    struct leaf b, const struct tri_pair_query *question, struct contact *contact,
				    long *certificates)
{
	enum tri_pair_answer worst = TRI_PAIR_APART;

	for (size_t i = a.first; i < (size_t)a.first + a.count; i++) {
		tri of_a = tri_of(&pair->a->mesh, i);

		for (size_t j = b.first; j < (size_t)b.first + b.count; j++) {
			tri of_b = tri_of(&pair->b->mesh, j);
			enum tri_pair_answer answer =
				interval->kind == INTERVAL_BOX
					? prove_box(interval, pair, &of_a, &of_b, question, contact)
					: prove_chord(interval, pair, &of_a, &of_b, question, contact);

			if (answer == TRI_PAIR_TOUCHES)
				return answer;
			if (answer == TRI_PAIR_OPEN)
				worst = answer;
			else
				++*certificates;
		}
	}
	return worst;
}
