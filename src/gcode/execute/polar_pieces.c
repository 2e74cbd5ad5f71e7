#include "gcode/execute/polar_pieces.h"

#include <math.h>

#include "base/math/math_functions.h"
#include "gcode/execute/path_rounding.h"

/* mm: the greatest deviation of an axis from its piece. A smaller value: a tighter proof, more pieces. */
#define BESIDE 0.002

/* A move in the plane, relative to its centre: for t from 0 to 1. */
struct curve {
	bool arc;
	double start[2], end[2];
	double centre[2], radius[2], angle, sweep;	/* of an arc; radius: at its start and its end */
	double length;	/* mm, of the path of X, Y and Z */
	double rate, bend;	/* upper bounds of its first and second derivatives, mm */
};

static void find_arc(const struct polar_interpolation *polar, const struct canon_move *move, struct curve *curve)
{
	double change;

	curve->arc = true;
	curve->centre[0] = move->arc.centre.x - polar->zero[0];
	curve->centre[1] = move->arc.centre.y - polar->zero[1];
	for (int i = 0; i < 2; i++) {
		const double *point = i ? curve->end : curve->start;

		curve->radius[i] = math_hypot(point[0] - curve->centre[0], point[1] - curve->centre[1]);
	}
	curve->angle = math_atan2(curve->start[1] - curve->centre[1], curve->start[0] - curve->centre[0]);
	curve->sweep = move->arc.normal.z < 0 ? -move->arc.sweep : move->arc.sweep;
	change = fabs(curve->radius[1] - curve->radius[0]);
	curve->rate = fmax(curve->radius[0], curve->radius[1]) * fabs(curve->sweep) + change;
	curve->bend = fmax(curve->radius[0], curve->radius[1]) * curve->sweep * curve->sweep +
		      2 * change * fabs(curve->sweep);
}

static struct curve find_curve(const struct polar_interpolation *polar, const struct canon_move *move)
{
	const double rise = move->end.v[SLOT_Z] - polar->told.v[SLOT_Z];
	struct curve curve = {.arc = false};

	for (int i = 0; i < 2; i++) {
		curve.start[i] = polar->at[i];
		curve.end[i] = move->end.v[SLOT_X + i] - polar->zero[i];
	}
	if (move->kind == CANON_ARC)
		find_arc(polar, move, &curve);
	else
		curve.rate = math_hypot(curve.end[0] - curve.start[0], curve.end[1] - curve.start[1]);
	curve.length = math_hypot(curve.rate, rise);
	return curve;
}

static void point_of(const struct curve *curve, double t, double point[2])
{
	if (t >= 1) {
		point[0] = curve->end[0];
		point[1] = curve->end[1];
	} else if (curve->arc) {
		const double angle = curve->angle + t * curve->sweep;
		const double radius = curve->radius[0] + t * (curve->radius[1] - curve->radius[0]);

		point[0] = curve->centre[0] + radius * math_cos(angle);
		point[1] = curve->centre[1] + radius * math_sin(angle);
	} else {
		point[0] = curve->start[0] + t * (curve->end[0] - curve->start[0]);
		point[1] = curve->start[1] + t * (curve->end[1] - curve->start[1]);
	}
}

/* The feed is that in the plane: each piece takes its share of the time. */
static struct canon_feed feed_of(const struct canon_feed *feed, const struct curve *curve, double part)
{
	struct canon_feed piece = *feed;

	if (feed->inverse_time)
		piece.seconds = feed->seconds * part;
	else if (curve->length > 0)
		piece = (struct canon_feed){.inverse_time = true, .seconds = curve->length * part / feed->linear};
	return piece;
}

/*
 * For a point p(t) of the plane with derivatives of at most v and b, at a distance of at least r from the centre, the
 * second derivative of this distance is at most v^2 / r + b, and that of the angle at most v^2 / r^2 + b / r. The
 * deviation of a chord over dt is at most dt^2 / 8 times the second derivative.
 */
static void spread_of(const struct curve *curve, double nearest, double dt, double *beside, double *turn)
{
	const double part = dt * dt / 8;

	*beside = part * (curve->rate * curve->rate / nearest + curve->bend);
	*turn = *beside / nearest;
}

static bool tell_piece(struct interp *interp, const struct canon_move *move, const struct curve *curve, double t,
		       double next)
{
	struct polar_interpolation *polar = &interp->state.polar_interpolation;
	const double part = (next - t) / (1 - t), before = math_hypot(polar->at[0], polar->at[1]);
	const double rounding = path_rounding(interp, move); /* in the plane */
	struct canon_move piece = *move;
	double point[2], radius, nearest, beside, turn;

	point_of(curve, next, point);
	radius = math_hypot(point[0], point[1]);
	polar->angle += math_atan2(polar->at[0] * point[1] - polar->at[1] * point[0],
				   polar->at[0] * point[0] + polar->at[1] * point[1]);
	nearest = fmin(before, radius) - curve->rate * (next - t) / 2;
	if (!(nearest > rounding))
		return fault(&interp->at, 1,
			     "line %ld passes so near to the centre of the rotary axis that the control, which may "
			     "deviate from the path (path_tolerance), can pass the centre on either side",
			     move->line);
	spread_of(curve, nearest, next - t, &beside, &turn);
	piece.kind = CANON_FEED;
	piece.feed = feed_of(&move->feed, curve, next - t);
	for (int slot = 0; slot < SLOT_COUNT; slot++)
		piece.end.v[slot] = polar->told.v[slot] + part * (move->end.v[slot] - polar->told.v[slot]);
	piece.end.v[SLOT_X] = polar->zero[0] + polar->side * radius;
	piece.end.v[SLOT_Y] = polar->told.v[SLOT_Y];
	piece.end.v[polar->rotary] = polar->angle;
	piece.spread[SLOT_X] += beside;
	/* The path tolerance covers X's share of the rounding. */
	turn += math_atan2(rounding, sqrt(nearest * nearest - rounding * rounding));
	piece.turn_spread[polar->rotary - SLOT_A] += turn;
	polar->told = piece.end;
	polar->at[0] = point[0];
	polar->at[1] = point[1];
	return canon_tell_move(interp->sink, &piece);
}

/* The next step of t at this distance from the centre: a path of at most half the distance. */
static double step_of(const struct curve *curve, double radius)
{
	const double curved = 2 * curve->rate * curve->rate / radius + curve->bend;

	return curved > 0 ? fmin(radius / (2 * curve->rate), sqrt(8 * BESIDE / curved)) : 1;
}

bool polar_pieces_tell(struct interp *interp, const struct canon_move *move)
{
	const struct polar_interpolation *polar = &interp->state.polar_interpolation;
	struct curve curve;
	double t = 0;

	if (polar->on && move->kind == CANON_RAPID)
		return fault(&interp->at, 1,
			     "a rapid (perhaps of a builder's macro) under polar coordinate interpolation (G12.1), "
			     "which allows only feed moves; write G13.1 first");
	if (!polar->on || (move->kind != CANON_FEED && move->kind != CANON_ARC))
		return canon_tell_move(interp->sink, move);
	if (move->spread[SLOT_X] > 0 || move->spread[SLOT_Y] > 0)
		return fault(&interp->at, 1,
			     "cutter compensation under polar coordinate interpolation (G12.1): set cutter_comp_start "
			     "and cutter_comp_corner in the machine file's <controller>");
	curve = find_curve(polar, move);
	while (t < 1) {
		const double radius = math_hypot(polar->at[0], polar->at[1]);
		const double next = fmin(t + step_of(&curve, radius), 1);

		if (radius < POLAR_CENTRE)
			return fault(&interp->at, 1,
				     "line %ld moves to the centre of the rotary axis, where the direction of rotation "
				     "is not known",
				     move->line);
		if (!tell_piece(interp, move, &curve, t, next))
			return false;
		t = next;
	}
	return true;
}
