#include "machine/motion_bound.h"

#include <assert.h>
#include <float.h>
#include <math.h>

#include "base/ablation.h"
#include "base/units.h"

static double distance_to_axis(const struct joint *joint, vec3 point)
{
	vec3 to = vec3_sub(point, joint->location);

	return vec3_norm(vec3_cross(joint->direction, to));
}

void chain_state_init(struct chain_state *state, const struct chain *chain, const axis_values *q,
		      const struct ball *fixed, const struct ball *moved)
{
	xform motions[SLOT_COUNT];	/* of linear joints the translation only */
	bool turned = false;
	vec3 at;

	state->pose = xform_identity();
	at = fixed->centre;
	for (size_t i = 0; i < chain->count; i++) {
		const struct joint *joint = &chain->joints[i];
		double value = q->v[joint->slot];
		xform back;

		state->direction[i] =
		    turned ? mat3_apply(&state->pose.rotation, joint->direction) : joint->direction;
		if (!joint->rotary) {
			const vec3 way = vec3_scale(value, joint->direction);

			motions[i].translation = way;
			state->pose.translation = vec3_add(turned ? mat3_apply(&state->pose.rotation, way) : way,
							   state->pose.translation);
			state->rho[1][i] = 0;
			at = vec3_sub(at, motions[i].translation);
			continue;
		}
		motions[i] = xform_turn(joint->location, joint->direction, value);
		state->location[i] = xform_apply(&state->pose, joint->location);
		state->pose = xform_mul_turned(&state->pose, turned, &motions[i]);
		turned = true;
		state->rho[1][i] = distance_to_axis(joint, at) + fixed->radius;
		back = xform_inverse(&motions[i]);
		at = xform_apply(&back, at);
	}
	at = moved->centre;
	for (size_t i = chain->count; i-- > 0;) {
		const struct joint *joint = &chain->joints[i];

		state->rho[0][i] = joint->rotary ? distance_to_axis(joint, at) + moved->radius : 0;
		at = joint->rotary ? xform_apply(&motions[i], at) : vec3_add(at, motions[i].translation);
	}
}

size_t linear_run_end(const struct chain *chain, size_t first)
{
	while (first < chain->count && !chain->joints[first].rotary)
		first++;
	return first;
}

double linear_displacement(const struct chain *chain, size_t first, size_t last, const axis_values *amount)
{
	double square = 0;

	for (size_t i = first; i < last; i++) {
		const struct joint *a = &chain->joints[i];
		double along = 0.5 * amount->v[a->slot] * vec3_norm2(a->direction);

		for (size_t j = i + 1; j < last; j++) {
			const struct joint *b = &chain->joints[j];

			along += amount->v[b->slot] * fabs(vec3_dot(a->direction, b->direction));
		}
		square += 2 * amount->v[a->slot] * along;
	}
	return sqrt(square);
}

double linear_way(const struct chain *chain, size_t first, size_t last, const axis_values *q0, const axis_values *q1)
{
	vec3 step = {0, 0, 0};

	for (size_t i = first; i < last; i++) {
		const struct joint *joint = &chain->joints[i];

		step = vec3_mad(step, q1->v[joint->slot] - q0->v[joint->slot], joint->direction);
	}
	return vec3_norm(step);
}

/*
 * The chain in the order of a view, beginning at the view's fixed body. Each rotary joint and each run of linear joints
 * is one stage.
 */
struct stage {
	size_t first, last;	/* joints of the chain */
	bool rotary;
};

static size_t stages_of(const struct chain *chain, int view, struct stage out[SLOT_COUNT])
{
	size_t count = 0;

	for (size_t i = 0; i < chain->count;) {
		bool rotary = chain->joints[i].rotary;
		size_t end = rotary ? i + 1 : linear_run_end(chain, i);

		out[count++] = (struct stage){i, end, rotary};
		i = end;
	}
	for (size_t i = 0; view == 1 && i < count / 2; i++) {
		struct stage keep = out[i];

		out[i] = out[count - 1 - i];
		out[count - 1 - i] = keep;
	}
	return count;
}

/* The motion of the points that one stage carries. */
struct share {
	double angle;	/* |dq| of a rotary joint, radians */
	double way;	/* u, mm */
	double displacement;	/* mm, by the chord error */
	double path, path_growth;	/* mm, by the path tolerance */
	double rho;
};

/*
 * Computes the shares, beginning at the moving body: the later stages change a point's distance from an axis. Every
 * instant is within half of the motion of one of the two ends, where rho is known.
 */
static void chord_shares(struct share *shares, const struct stage *stages, size_t count, int view,
			 const struct joint_chord *chord)
{
	const struct chain *chain = chord->chain;
	const axis_values *tolerance = chord->tolerance;
	double later = 0;

	for (size_t n = count; n-- > 0;) {
		size_t i = stages[n].first;
		struct share *share = &shares[n];

		*share = (struct share){0};
		if (stages[n].rotary) {
			int slot = chain->joints[i].slot;

			share->angle = fabs(chord->q1->v[slot] - chord->q0->v[slot]);
			share->rho = fmax(chord->start->rho[view][i], chord->end->rho[view][i]) + later;
			share->way = share->angle * share->rho;
			share->displacement = chord->chord_error->v[slot] * share->rho;
			share->path = tolerance ? tolerance->v[slot] * share->rho : 0;
			share->path_growth = tolerance ? tolerance->v[slot] * later : 0;
		} else {
			share->way = linear_way(chain, i, stages[n].last, chord->q0, chord->q1);
			share->displacement = linear_displacement(chain, i, stages[n].last, chord->chord_error);
			share->path = tolerance ? linear_displacement(chain, i, stages[n].last, tolerance) : 0;
		}
		later += 0.5 * share->way + share->displacement;
	}
}

void chord_bound_init(struct chord_bound *bound, const struct joint_chord *chord)
{
	double lengths[VIEWS];

	for (int view = 0; view < VIEWS; view++) {
		struct stage stages[SLOT_COUNT];
		struct share shares[SLOT_COUNT];
		size_t count = stages_of(chord->chain, view, stages);
		double turned = 0, acceleration = 0;

		chord_shares(shares, stages, count, view, chord);
		lengths[view] = bound->displacement[view] = bound->path[view] = bound->path_growth[view] = 0;
		for (size_t n = 0; n < count; n++) {
			const struct share *share = &shares[n];

			acceleration += 2 * turned * share->way + share->angle * share->way;
			turned += share->angle;
			lengths[view] += share->way;
			bound->displacement[view] += share->displacement;
			bound->path[view] += share->path;
			bound->path_growth[view] += share->path_growth;
		}
		/*
		 * From the length only: |x(s) - chord(s)| <= (1-s) |x(s) - x(0)| + s |x(s) - x(1)| <= 2 s (1-s) length.
		 */
		bound->chord_error[view] = WITH_SECOND_ORDER ? acceleration / 8 : 0.5 * lengths[view];
	}
	bound->length = fmin(lengths[0], lengths[1]);
}

double path_displacement(const struct chain *chain, const struct chain_state *state, vec3 x,
			 const axis_values *tolerance)
{
	double sum = 0;

	for (size_t i = 0; i < chain->count;) {
		const struct joint *joint = &chain->joints[i];
		size_t end = joint->rotary ? i + 1 : linear_run_end(chain, i);

		if (joint->rotary)
			sum += tolerance->v[joint->slot] *
			       vec3_norm(vec3_cross(state->direction[i], vec3_sub(x, state->location[i])));
		else
			sum += linear_displacement(chain, i, end, tolerance);
		i = end;
	}
	return sum;
}

/*
 * An upper bound of the sine of y, from 0 to PI / 2: the first terms of its series, the last of which is added. It is
 * too large by at most 4e-6. A bound needs no more, and this takes a tenth of the time of math_sin.
 */
static double sine_at_most(double y)
{
	double yy = y * y;

	return y * (1 - yy / 6 * (1 - yy / 20 * (1 - yy / 42 * (1 - yy / 72)))) * (1 + 8 * DBL_EPSILON);
}

/* A rotation by at most `angle` moves a point at distance rho by at most the chord of the arc. */
static double turn_of(double angle, double rho)
{
	return angle >= PI ? 2 * rho : 2 * sine_at_most(angle / 2) * rho;
}

void box_bound_init(struct box_bound *bound, const struct chain *chain, const struct chain_state *state,
		    const axis_values *half)
{
	for (int view = 0; view < VIEWS; view++) {
		struct stage stages[SLOT_COUNT];
		size_t count = stages_of(chain, view, stages);
		double later = 0;

		for (size_t n = count; n-- > 0;) {
			size_t i = stages[n].first;
			double way;

			if (stages[n].rotary) {
				way = turn_of(half->v[chain->joints[i].slot], state->rho[view][i] + later);
				bound->turn[view][i] = way;
			} else {
				way = linear_displacement(chain, i, stages[n].last, half);
				for (size_t k = i; k < stages[n].last; k++)
					bound->turn[view][k] = 0;
			}
			later += way;
		}
		bound->reach[view] = later;
	}
}

double box_path_displacement(const struct chain *chain, const struct chain_state *state, const axis_values *half,
			     const axis_values *tolerance)
{
	double most[VIEWS] = {0, 0};

	for (int view = 0; view < VIEWS; view++) {
		struct stage stages[SLOT_COUNT];
		size_t count = stages_of(chain, view, stages);
		double later = 0;

		/* Only the later joints change a point's distance from an axis. */
		for (size_t n = count; n-- > 0;) {
			size_t i = stages[n].first;
			int slot = chain->joints[i].slot;

			if (stages[n].rotary) {
				double lever = state->rho[view][i] + later;

				most[view] += tolerance->v[slot] * lever;
				later += turn_of(half->v[slot], lever);
			} else {
				most[view] += linear_displacement(chain, i, stages[n].last, tolerance);
				later += linear_displacement(chain, i, stages[n].last, half);
			}
		}
	}
	return fmin(most[0], most[1]);
}
