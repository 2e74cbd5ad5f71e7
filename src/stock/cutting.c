#include "stock/cutting.h"

#include <math.h>

#include "base/minmax.h"

/*
 * A step is divided into at most this number of pieces. If they are still too coarse, less material is removed for
 * certain.
 */
#define PIECES_MAX 4096

static struct cutter_place place_of(const struct cutting *cutting, const axis_values *q)
{
	const xform pose = body_pair_pose(cutting->bodies, q);

	return (struct cutter_place){pose.translation, pose.rotation.z};
}

static struct chain_state state_at(const struct cutting *cutting, const axis_values *q)
{
	const struct body_pair *bodies = cutting->bodies;
	struct chain_state state;

	chain_state_init(&state, bodies->chain, q, &bodies->ball_a, &bodies->ball_b);
	return state;
}

static struct chord_bound bound_of(const struct cutting *cutting, const axis_values *q0, const axis_values *q1)
{
	const struct chain_state start = state_at(cutting, q0), end = state_at(cutting, q1);
	struct chord_bound bound;

	chord_bound_init(&bound, &(struct joint_chord){
		.chain = cutting->bodies->chain, .start = &start, .end = &end,
		.q0 = q0, .q1 = q1, .chord_error = &cutting->chord.chord_error, .tolerance = cutting->chord.tolerance,
	});
	return bound;
}

/*
 * mm: the largest distance of a point of the true cutter from its position in the cut. Each point of the axis stays
 * within `chord_error` of the straight line between its ends. The cut takes the line through those points as its axis
 * and normalises the direction, which moves points of the axis toward the origin, by the cosine of half the rotation.
 * If the error of both ends of the cutter's axis is at most x, that of its direction is at most 2 x / length, and that
 * of a point at the radius r at most x + r 2 x / length.
 */
static double axis_error(const struct cutter *cutter, const struct cutter_way *way, double chord_error)
{
	const struct revolved *whole = &cutter->whole;
	const double top = whole->bands[0].top, bottom = whole->bands[whole->count - 1].bottom;
	const double farthest = larger(fabs(top), fabs(bottom));
	const double cosine = vec3_dot(way->from.up, way->to.up);
	const double shrink = cosine < 1 ? farthest * (1 - sqrt(larger(0.5 * (1 + cosine), 0))) : 0;
	const double off = chord_error + shrink;

	return off > 0 ? 2 * off * (1 + whole->radius / (top - bottom)) : 0;
}

static bool misses_blank(const struct cutting *cutting, vec3 low, vec3 high)
{
	return low.x > cutting->high.x || high.x < cutting->low.x || low.y > cutting->high.y ||
	       high.y < cutting->low.y || low.z > cutting->high.z || high.z < cutting->low.z;
}

/* The stock is fixed in view 0 (motion_bound.h), in which the cutter moves. */
static void log_piece(const struct cutting *cutting, struct cut_log *log, double s0, double s1)
{
	const axis_values q0 = axis_values_between(&cutting->chord.q0, &cutting->chord.q1, s0);
	const axis_values q1 = axis_values_between(&cutting->chord.q0, &cutting->chord.q1, s1);
	const struct chord_bound bound = bound_of(cutting, &q0, &q1);
	const struct cutter *cutter = &log->cutters[cutting->cutter];
	struct cut cut = {
		.cutter = cutting->cutter,
		.from = (1 - s0) * cutting->from + s0 * cutting->to,
		.to = (1 - s1) * cutting->from + s1 * cutting->to,
		.way = {place_of(cutting, &q0), place_of(cutting, &q1)},
	};
	const double rounding = body_pair_rounding(cutting->bodies, &q0, cut.way.from.origin) +
				body_pair_rounding(cutting->bodies, &q1, cut.way.to.origin);
	vec3 low, high, error;

	cut.error = axis_error(cutter, &cut.way, bound.chord_error[0]) + bound.displacement[0] + bound.path[0] +
		    rounding;
	cutter_way_bounds(cutter, &cut.way, &low, &high);
	error = (vec3){cut.error, cut.error, cut.error};
	if (!misses_blank(cutting, vec3_sub(low, error), vec3_add(high, error)))
		cut_log_add(log, &cut);
}

void cutting_log(const struct cutting *cutting, struct cut_log *log)
{
	const struct chord_bound bound = bound_of(cutting, &cutting->chord.q0, &cutting->chord.q1);
	const struct cutter_way way = {place_of(cutting, &cutting->chord.q0), place_of(cutting, &cutting->chord.q1)};
	const double error = axis_error(&log->cutters[cutting->cutter], &way, bound.chord_error[0]);
	/* The deviation of a chord decreases with the square of its length. */
	const double wanted = ceil(sqrt(error / cutting->chord_error));
	const int pieces = wanted > PIECES_MAX ? PIECES_MAX : wanted > 1 ? (int)wanted : 1;

	for (int i = 0; i < pieces; i++)
		log_piece(cutting, log, (double)i / pieces, (double)(i + 1) / pieces);
}

void cutting_log_region(const struct cutting *cutting, struct cut_log *log)
{
	const struct body_pair *bodies = cutting->bodies;
	const struct chord *chord = &cutting->chord;
	const axis_values middle = axis_values_between(&chord->q0, &chord->q1, 0.5);
	axis_values half;
	struct chain_state state;
	struct box_bound bound;
	xform pose;
	vec3 centre, size;
	double reach;

	for (int i = 0; i < SLOT_COUNT; i++)
		half.v[i] = 0.5 * fabs(chord->q1.v[i] - chord->q0.v[i]) + chord->chord_error.v[i] +
			    (chord->tolerance ? chord->tolerance->v[i] : 0);
	state = state_at(cutting, &middle);
	box_bound_init(&bound, bodies->chain, &state, &half);
	pose = body_pair_pose(bodies, &middle);
	reach = bodies->b->radius + bound.reach[0] + body_pair_rounding(bodies, &middle, pose.translation);
	centre = xform_apply(&pose, bodies->b->origin);
	size = (vec3){reach, reach, reach};
	if (!misses_blank(cutting, vec3_sub(centre, size), vec3_add(centre, size)))
		cut_log_add_region(log, &(struct cut_region){cutting->cutter, cutting->from, cutting->to,
							     vec3_sub(centre, size), vec3_add(centre, size)});
}
