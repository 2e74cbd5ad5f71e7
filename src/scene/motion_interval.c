#include "scene/motion_interval.h"

#include <math.h>

#include "geom/moved_tri.h"
#include "geom/tolerance.h"

static struct ball ball_around(const struct bvh *bvh, const xform *place)
{
	return (struct ball){xform_apply(place, bvh->origin), bvh->radius};
}

void body_pair_init(struct body_pair *pair, const struct bvh *a, const struct bvh *b, const xform *place_a,
		    const xform *place_b, const struct chain *chain)
{
	*pair = (struct body_pair){
		.a = a,
		.b = b,
		.place_a = *place_a,
		.to_a = xform_inverse(place_a),
		.place_b = *place_b,
		.turned = {!mat3_is_identity(&place_a->rotation), !mat3_is_identity(&place_b->rotation)},
		.chain = chain,
		.ball_a = ball_around(a, place_a),
		.ball_b = ball_around(b, place_b),
		.rounding = a->mesh.rounding + b->mesh.rounding,
		.extent = vec3_norm(a->origin) + a->radius + vec3_norm(b->origin) + b->radius,
	};
}

/* b's mesh coordinates in a's; `pose` is that of B's link in A's. */
static xform mesh_pose(const struct body_pair *pair, const xform *pose)
{
	const xform of_b = body_pair_place_b(pair, pose);

	return body_pair_in_a(pair, &of_b);
}

xform body_pair_place_b(const struct body_pair *pair, const xform *pose)
{
	return pair->turned[1] ? xform_mul(pose, &pair->place_b)
			       : (xform){pose->rotation, xform_apply(pose, pair->place_b.translation)};
}

xform body_pair_in_a(const struct body_pair *pair, const xform *place)
{
	return xform_mul_turned(&pair->to_a, pair->turned[0], place);
}

xform body_pair_pose(const struct body_pair *pair, const axis_values *q)
{
	xform pose = chain_pose(pair->chain, q);

	return mesh_pose(pair, &pose);
}

double body_pair_rounding(const struct body_pair *pair, const axis_values *q, vec3 t)
{
	double turned = 0, size = vec3_norm(t) + pair->extent + vec3_norm(pair->place_a.translation) +
				  vec3_norm(pair->place_b.translation);

	for (size_t i = 0; i < pair->chain->count; i++) {
		const struct joint *joint = &pair->chain->joints[i];

		size += vec3_norm(joint->location) + (joint->rotary ? 0 : fabs(q->v[joint->slot]));
		turned += joint->rotary ? fabs(q->v[joint->slot]) : 0;
	}
	/*
	 * The 256 units of POSE_ROUNDING cover a few turns. An angle of many turns has a larger rounding error itself.
	 */
	return POSE_ROUNDING * size * (1 + turned / 64) + pair->rounding;
}

double body_pair_path_displacement(const struct body_pair *pair, const axis_values *q, const axis_values *tolerance)
{
	const struct mesh *meshes[VIEWS] = {&pair->b->mesh, &pair->a->mesh};
	xform to_machine[VIEWS] = {xform_identity(), pair->place_a};
	double most[VIEWS] = {0, 0};
	struct chain_state state;

	chain_state_init(&state, pair->chain, q, &pair->ball_a, &pair->ball_b);
	to_machine[0] = xform_mul(&state.pose, &pair->place_b);
	for (int view = 0; view < VIEWS; view++) {
		for (size_t i = 0; i < meshes[view]->count; i++) {
			tri t = tri_of(meshes[view], i);

			for (int k = 0; k < 3; k++)
				most[view] = fmax(most[view],
						  path_displacement(pair->chain, &state,
								    xform_apply(&to_machine[view], t.p[k]), tolerance));
		}
	}
	return fmin(most[0], most[1]);
}

static void state_at(struct chain_state *state, xform *pose, const struct body_pair *pair, const axis_values *q)
{
	chain_state_init(state, pair->chain, q, &pair->ball_a, &pair->ball_b);
	*pose = mesh_pose(pair, &state->pose);
}

/* Computes everything that follows from the states and the chord. */
static void finish_chord(struct motion_interval *interval, const struct body_pair *pair)
{
	double rounding = fmax(body_pair_rounding(pair, &interval->chord.q0, interval->poses[0].translation),
			       body_pair_rounding(pair, &interval->chord.q1, interval->poses[1].translation));
	const struct joint_chord joints = {
		.chain = pair->chain, .start = &interval->states[0], .end = &interval->states[1],
		.q0 = &interval->chord.q0, .q1 = &interval->chord.q1,
		.chord_error = &interval->chord.chord_error, .tolerance = interval->chord.tolerance,
	};
	struct chord_bound bound;

	chord_bound_init(&bound, &joints);
	interval->path = fmin(bound.path[0], bound.path[1]);
	for (int v = 0; v < VIEWS; v++) {
		interval->displacement[v] = bound.chord_error[v] + bound.displacement[v] + rounding;
		interval->path_growth[v] = bound.path_growth[v];
		interval->axis_displacement[v] = (vec3){0, 0, 0};
	}
	interval->reach = 0.5 * bound.length + fmin(bound.displacement[0], bound.displacement[1]) + rounding;
	box_motion_init(&interval->boxes, pair->a, pair->b, interval->poses, interval->axis_displacement,
			interval->displacement);
}

static axis_values half_sizes(const struct chord *box)
{
	axis_values half;

	for (int i = 0; i < SLOT_COUNT; i++)
		half.v[i] = 0.5 * (box->q1.v[i] - box->q0.v[i]);
	return half;
}

static axis_values middle_of(const struct chord *box)
{
	return axis_values_middle(&box->q0, &box->q1);
}

/*
 * mm: how far a joint with direction d moves points along each axis of a frame. A linear joint moves them by `half`
 * along d, a rotary one by `turn` across d.
 */
static vec3 joint_displacement(double half, double turn, bool rotary, vec3 d)
{
	if (!rotary)
		return (vec3){half * fabs(d.x), half * fabs(d.y), half * fabs(d.z)};
	/* The sines are lengths of vectors; computed from the cosines they would lose half of their digits. */
	return (vec3){turn * sqrt(d.y * d.y + d.z * d.z), turn * sqrt(d.z * d.z + d.x * d.x),
		      turn * sqrt(d.x * d.x + d.y * d.y)};
}

static void finish_box(struct motion_interval *interval, const struct body_pair *pair)
{
	const struct chain *chain = pair->chain;
	axis_values middle = middle_of(&interval->chord), half = half_sizes(&interval->chord);
	double rounding;

	state_at(&interval->states[0], &interval->poses[0], pair, &middle);
	interval->poses[1] = interval->poses[0];
	rounding = body_pair_rounding(pair, &middle, interval->poses[0].translation);
	box_bound_init(&interval->bound, chain, &interval->states[0], &half);
	interval->path = 0;
	interval->axis_displacement[0] = interval->axis_displacement[1] = (vec3){0, 0, 0};
	interval->displacement[0] = interval->displacement[1] = rounding;
	for (size_t i = 0; i < chain->count; i++) {
		vec3 in_a = mat3_apply_transposed(&pair->place_a.rotation, interval->states[0].direction[i]);
		vec3 in_b = mat3_apply_transposed(&interval->poses[0].rotation, in_a);
		double h = half.v[chain->joints[i].slot];
		bool rotary = chain->joints[i].rotary;

		interval->axis_displacement[0] = vec3_add(
		    interval->axis_displacement[0], joint_displacement(h, interval->bound.turn[0][i], rotary, in_a));
		interval->axis_displacement[1] = vec3_add(
		    interval->axis_displacement[1], joint_displacement(h, interval->bound.turn[1][i], rotary, in_b));
	}
	interval->reach = fmin(interval->bound.reach[0], interval->bound.reach[1]) + rounding;
	box_motion_init(&interval->boxes, pair->a, pair->b, interval->poses, interval->axis_displacement,
			interval->displacement);
}

void motion_interval_init(struct motion_interval *interval, const struct body_pair *pair, enum interval_kind kind,
			  const struct chord *chord)
{
	interval->kind = kind;
	interval->chord = *chord;
	interval->s0 = 0;
	interval->s1 = 1;
	interval->depth = 0;
	interval->halved = false;
	if (kind == INTERVAL_BOX) {
		finish_box(interval, pair);
		return;
	}
	state_at(&interval->states[0], &interval->poses[0], pair, &chord->q0);
	state_at(&interval->states[1], &interval->poses[1], pair, &chord->q1);
	finish_chord(interval, pair);
}

static void halve_straight(const struct chord *whole, struct chord *first, struct chord *second)
{
	axis_values middle = middle_of(whole);

	*first = *second = *whole;
	first->q1 = second->q0 = middle;
	first->u1 = second->u0 = 0.5 * (whole->u0 + whole->u1);
}

/* Halves the box across the joint that moves the bodies most. */
static void halve_box(const struct motion_interval *interval, const struct body_pair *pair, struct chord *first,
		      struct chord *second)
{
	axis_values half = half_sizes(&interval->chord), middle = middle_of(&interval->chord);
	double most = -1;
	int slot = 0;

	for (size_t i = 0; i < pair->chain->count; i++) {
		const struct joint *joint = &pair->chain->joints[i];
		double way = half.v[joint->slot];

		if (joint->rotary)
			way *= fmin(interval->states[0].rho[0][i], interval->states[0].rho[1][i]);
		if (way > most) {
			most = way;
			slot = joint->slot;
		}
	}
	*first = *second = interval->chord;
	first->q1.v[slot] = second->q0.v[slot] = middle.v[slot];
}

void motion_interval_halve(struct motion_interval *interval, const struct body_pair *pair,
			   struct motion_interval *first, struct motion_interval *second)
{
	double middle = 0.5 * (interval->s0 + interval->s1);

	interval->halves[0] = first;
	interval->halves[1] = second;
	interval->halved = true;
	first->kind = second->kind = interval->kind;
	first->depth = second->depth = interval->depth + 1;
	first->halved = second->halved = false;
	first->s0 = interval->s0;
	second->s1 = interval->s1;
	if (interval->kind == INTERVAL_BOX) {
		first->s1 = interval->s1;
		second->s0 = interval->s0;
		halve_box(interval, pair, &first->chord, &second->chord);
		finish_box(first, pair);
		finish_box(second, pair);
		return;
	}
	first->s1 = second->s0 = middle;
	(interval->chord.halve ? interval->chord.halve : halve_straight)(&interval->chord, &first->chord,
									 &second->chord);
	first->states[0] = interval->states[0];
	first->poses[0] = interval->poses[0];
	state_at(&first->states[1], &first->poses[1], pair, &first->chord.q1);
	second->states[0] = first->states[1];
	second->poses[0] = first->poses[1];
	second->states[1] = interval->states[1];
	second->poses[1] = interval->poses[1];
	finish_chord(first, pair);
	finish_chord(second, pair);
}

double motion_interval_displacement_along(const struct motion_interval *interval, const struct body_pair *pair, vec3 n)
{
	vec3 in_a_link = mat3_apply(&pair->place_a.rotation, n);
	axis_values half = half_sizes(&interval->chord);
	double displacement = 0;

	for (size_t i = 0; i < pair->chain->count; i++) {
		vec3 d = interval->states[0].direction[i];

		if (pair->chain->joints[i].rotary)
			displacement += interval->bound.turn[0][i] * vec3_norm(vec3_cross(in_a_link, d));
		else
			displacement += half.v[pair->chain->joints[i].slot] * fabs(vec3_dot(in_a_link, d));
	}
	return displacement;
}
