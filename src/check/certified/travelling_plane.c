#include "check/certified/travelling_plane.h"

#include <math.h>

#include "base/minmax.h"
#include "base/same_double.h"
#include "check/step.h"
#include "geom/tolerance.h"

void plane_pose_init(struct plane_pose *pose, const struct body_pair *bodies, const axis_values *q)
{
	const struct chain *chain = bodies->chain;
	xform at = xform_identity(), in_a;
	double angle = 0;
	bool turned = false;

	pose->bodies = bodies;
	pose->q = *q;
	pose->turned[0] = at.rotation;
	for (size_t i = 0; i < chain->count; i++) {
		const struct joint *joint = &chain->joints[i];
		const double value = q->v[joint->slot];

		pose->direction[i] = turned ? mat3_apply(&at.rotation, joint->direction) : joint->direction;
		pose->location[i] = at.translation;
		if (joint->rotary) {
			const xform turn = xform_turn(joint->location, joint->direction, value);

			pose->location[i] = xform_apply(&at, joint->location);
			at = xform_mul_turned(&at, turned, &turn);
			turned = true;
			/* As in body_pair_rounding. */
			angle += fabs(value);
		} else {
			at.translation = vec3_mad(at.translation, value, pose->direction[i]);
		}
		pose->turned[i + 1] = at.rotation;
	}
	pose->places[0] = bodies->place_a;
	pose->places[1] = body_pair_place_b(bodies, &at);
	in_a = body_pair_in_a(bodies, &pose->places[1]);
	pose->slack = POSE_ROUNDING * (1 + angle / 64);
	pose->rounding = body_pair_rounding(bodies, q, in_a.translation);
}

vec3 travelling_plane_normal(const struct travelling_plane *plane, const struct plane_pose *pose)
{
	return vec3_unit(mat3_apply(&pose->turned[plane->link], plane->normal));
}

bool travelling_plane_is_at(const struct travelling_plane *plane, const struct chain *chain, const axis_values *q)
{
	for (size_t i = 0; i < chain->count; i++)
		if (!same_double(plane->at[i], q->v[chain->joints[i].slot]))
			return false;
	return true;
}

double travelling_plane_gap(const struct plane_pose *pose, const struct convex *a, const struct convex *b, vec3 n,
			    double slack, long *visits)
{
	return -convex_support(b, vec3_scale(-1, n), slack, NULL, visits) - convex_support(a, n, slack, NULL, visits) -
	       pose->rounding;
}

/*
 * The permitted error of a lever as a share of the part's radius. It is a hundredth of the joint's effect on the gap.
 */
#define LEVER_SHARE 0x1p-5

/* The effect of a rotary joint on the part of the body that it carries. */
static void add_rotary(struct travelling_plane *plane, const struct plane_pose *pose, const struct convex *part,
		       size_t i, vec3 n, long *visits)
{
	vec3 axis = pose->direction[i], location = pose->location[i];
	vec3 lever = vec3_cross(n, axis);
	double from = vec3_dot(lever, location), slack = LEVER_SHARE * part->radius;
	struct convex roughly = *part;

	/* So coarse a support costs less than a look at the seen corners, and would replace better ones. */
	roughly.seen = NULL;
	plane->high[i] = convex_support(&roughly, lever, slack, NULL, visits) - from + pose->rounding;
	plane->low[i] = -convex_support(&roughly, vec3_scale(-1, lever), slack, NULL, visits) - from - pose->rounding;
	plane->turn[i] = vec3_norm(lever) + pose->slack;
	plane->lever[i] =
	    vec3_norm(vec3_cross(axis, vec3_sub(part->centre, location))) + part->radius + pose->rounding;
}

void travelling_plane_init(struct travelling_plane *plane, const struct plane_pose *pose, const struct convex *a,
			   const struct convex *b, vec3 n, size_t link, double gap, long *visits)
{
	const struct chain *chain = pose->bodies->chain;

	plane->gap = gap;
	plane->rounding = pose->rounding;
	plane->link = link;
	plane->normal = mat3_apply_transposed(&pose->turned[link], n);
	for (size_t i = 0; i < chain->count; i++) {
		const struct convex *part = i < link ? a : b;
		bool next = part == a ? i == 0 : i + 1 == chain->count;

		plane->at[i] = pose->q.v[chain->joints[i].slot];
		plane->low[i] = plane->high[i] = plane->turn[i] = plane->lever[i] = 0;
		if (!chain->joints[i].rotary) {
			double along = vec3_dot(n, pose->direction[i]);

			plane->low[i] = along - pose->slack;
			plane->high[i] = along + pose->slack;
		} else if (!part->profile || !next) {
			add_rotary(plane, pose, part, i, n, visits);
		}
		plane->rate[i] = larger(fabs(plane->low[i]), fabs(plane->high[i]));
	}
}

axis_values plane_motion_middle(const struct plane_motion *motion)
{
	return axis_values_middle(&motion->q0, &motion->q1);
}

static bool leaves_path(const struct chain *chain, const struct position_errors *errors)
{
	for (size_t i = 0; i < chain->count && errors->any; i++)
		if (errors->path.v[chain->joints[i].slot] > 0)
			return true;
	return false;
}

double plane_motion_path(const struct plane_motion *motion, const struct body_pair *bodies,
			 const struct position_errors *errors)
{
	const axis_values middle = plane_motion_middle(motion);
	struct chain_state state;
	axis_values half;

	if (!leaves_path(bodies->chain, errors))
		return 0;
	for (int i = 0; i < SLOT_COUNT; i++)
		half.v[i] = 0.5 * fabs(motion->q1.v[i] - motion->q0.v[i]) + motion->chord_error.v[i];
	chain_state_init(&state, bodies->chain, &middle, &bodies->ball_a, &bodies->ball_b);
	return box_path_displacement(bodies->chain, &state, &half, &errors->path) * BOUND_SLACK;
}

/* mm: a lower bound of the growth of the gap by joint i, to first order, at dq from the position of its measurement. */
static inline double first_order(const struct travelling_plane *plane, size_t i, double dq)
{
	return smaller(dq * plane->low[i], dq * plane->high[i]);
}

/* The sum over one body's joints, outward from the link. */
struct second_order {
	double turned;	/* the largest rotation of n relative to the next joint */
	double lost;	/* mm */
};

/* Joint i moves by at most `way`. */
static void add_joint(struct second_order *sum, const struct travelling_plane *plane, size_t i, bool rotary, double way)
{
	if (!rotary) {
		sum->lost += sum->turned * way;
		return;
	}
	sum->lost += plane->lever[i] * way * (sum->turned + plane->turn[i] * way * (0.5 + way / 6));
	sum->turned += plane->turn[i] * way;
}

double travelling_plane_rest(const struct travelling_plane *plane, const struct chain *chain,
			     const struct plane_motion *motion, double beyond)
{
	struct second_order of_a = {0, 0}, of_b = {0, 0};
	double ways[SLOT_COUNT], at0 = 0, at1 = 0, separate = 0, off = 0, size = 0, first;

	for (size_t i = 0; i < chain->count; i++) {
		const int slot = chain->joints[i].slot;
		const double dq0 = motion->q0.v[slot] - plane->at[i], dq1 = motion->q1.v[slot] - plane->at[i];
		const double more0 = first_order(plane, i, dq0), more1 = first_order(plane, i, dq1);
		const double error = motion->chord_error.v[slot];

		at0 += more0;
		at1 += more1;
		separate += smaller(more0, more1);
		ways[i] = larger(fabs(dq0), fabs(dq1)) + error;
		off += plane->rate[i] * error;
		size += plane->rate[i] * ways[i];
	}
	/*
	 * The first-order part is concave in the joints, so its least value on a straight motion is at one of the ends.
	 * The rounding of the sums above is some dozen units in the last place of their numbers.
	 */
	first = plane->gap + (motion->straight ? smaller(at0, at1) : separate);
	if (!(first > beyond))
		return -INFINITY;
	for (size_t i = plane->link; i-- > 0;)
		add_joint(&of_a, plane, i, chain->joints[i].rotary, ways[i]);
	for (size_t i = plane->link; i < chain->count; i++)
		add_joint(&of_b, plane, i, chain->joints[i].rotary, ways[i]);
	return first - (off + of_a.lost + of_b.lost) * BOUND_SLACK - POSE_ROUNDING * size;
}

/* One body's joints, outward from the link. */
struct outward {
	size_t count, joints[SLOT_COUNT];
};

static struct outward outward_of(const struct travelling_plane *plane, const struct chain *chain, int body)
{
	struct outward out = {.count = body ? chain->count - plane->link : plane->link};

	for (size_t k = 0; k < out.count; k++)
		out.joints[k] = body ? plane->link + k : plane->link - 1 - k;
	return out;
}

/* The motion of a joint in a straight motion. */
struct joint_way {
	double dq;	/* of the motion */
	double error;	/* its chord error */
	double off;	/* from the position of the plane's measurement, including the error */
};

/*
 * mm: the largest deviation of a point of one body, along n, from the chord between its ends. *lost receives the share
 * of the chord errors.
 */
static double bulge_of(const struct travelling_plane *plane, const struct chain *chain, const struct outward *out,
		       const struct joint_way *ways, double *lost)
{
	double lever[SLOT_COUNT] = {0}, outer = 0, turned = 0, turning = 0, sum = 0;

	for (size_t k = out->count; k-- > 0;) {
		const size_t i = out->joints[k];

		/* 1 for linear joints, so that u is dq for them, too. Removed joints move nothing. */
		lever[k] = !chain->joints[i].rotary ? 1 : plane->turn[i] > 0 ? plane->lever[i] + outer : 0;
		outer += ways[i].off * lever[k];
	}
	for (size_t k = 0; k < out->count; k++) {
		const size_t i = out->joints[k];
		const double u = ways[i].dq * lever[k], turn = plane->turn[i] + turned;

		sum += 2 * turning * u;
		if (!chain->joints[i].rotary) {
			*lost += ways[i].error * (plane->rate[i] + turned);
			continue;
		}
		*lost += ways[i].error * turn * lever[k];
		sum += ways[i].dq * turn * u;
		turning += ways[i].dq * turn;
		turned += plane->turn[i] * ways[i].off;
	}
	return sum / 8;
}

double travelling_plane_between(const struct travelling_plane *plane, const struct chain *chain,
				const struct plane_motion *motion, double gap0, double gap1)
{
	struct joint_way ways[SLOT_COUNT];
	double bulge = 0, lost = 0;

	for (size_t i = 0; i < chain->count; i++) {
		const int slot = chain->joints[i].slot;
		const double q0 = motion->q0.v[slot], q1 = motion->q1.v[slot], error = motion->chord_error.v[slot];

		ways[i].dq = fabs(q1 - q0);
		ways[i].error = error;
		ways[i].off = larger(fabs(q0 - plane->at[i]), fabs(q1 - plane->at[i])) + error;
	}
	for (int body = 0; body < 2; body++) {
		const struct outward out = outward_of(plane, chain, body);

		bulge += bulge_of(plane, chain, &out, ways, &lost);
	}
	return smaller(gap0, gap1) - (bulge + lost) * BOUND_SLACK;
}
