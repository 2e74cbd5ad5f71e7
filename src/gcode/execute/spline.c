#include "gcode/execute/spline.h"

#include <math.h>

/* mm: a derivative that is shorter has no direction. */
#define LEAST_TANGENT 1e-9

/* Pieces are longer than 1 / (4 * 1000). */
#define SAME_PARAMETER 1e-9

/* LinuxCNC 2.8 and 2.9 (emccanon.cc, NURBS_FEED) make 4 pieces a point. */
#define PIECES_A_POINT 4

/* x, y and weight of a point, times the weight: what is linear in rational curves. */
struct weighted {
	double x, y, weight;
};

struct pair {
	double x, y;
};

static double last_knot(const struct spline *spline)
{
	return (double)spline->count - spline->order + 1;
}

static double knot(const struct spline *spline, size_t index)
{
	double value = (double)index - spline->order + 1;

	return fmin(fmax(value, 0), last_knot(spline));
}

static struct weighted mix(struct weighted a, struct weighted b, double part)
{
	return (struct weighted){a.x + part * (b.x - a.x), a.y + part * (b.y - a.y),
				 a.weight + part * (b.weight - a.weight)};
}

/*
 * The blossom of the polynomial that holds between the knots `span` and `span` + 1, of `first` times u0 and the rest of
 * its arguments u1 (L. Ramshaw, "Blossoming"; de Boor's algorithm with another argument at each step).
 */
static struct weighted blossom(const struct spline *spline, size_t span, double u0, double u1, int first)
{
	struct weighted d[SPLINE_ORDER_MAX] = {{0}};
	const int degree = spline->order - 1;

	for (int i = 0; i <= degree; i++) {
		const struct spline_point *point = &spline->points[span - (size_t)(degree - i)];

		d[i] = (struct weighted){point->x * point->weight, point->y * point->weight, point->weight};
	}
	for (int r = 1; r <= degree; r++) {
		double u = r <= first ? u0 : u1;

		for (int i = degree; i >= r; i--) {
			size_t at = span - (size_t)(degree - i);
			double low = knot(spline, at), high = knot(spline, at + (size_t)(degree - r) + 1);

			d[i] = mix(d[i - 1], d[i], (u - low) / (high - low));
		}
	}
	return d[degree];
}

static struct pair project(struct weighted point)
{
	return (struct pair){point.x / point.weight, point.y / point.weight};
}

/* Widens the boxes so that they hold the point. The hull of points that they hold lies in them, too. */
static void hold(struct spline_piece *piece, struct pair point)
{
	double x = piece->x1 - piece->x0, y = piece->y1 - piece->y0, square = x * x + y * y, part = 0;

	if (square > 0)
		part = fmin(fmax(((point.x - piece->x0) * x + (point.y - piece->y0) * y) / square, 0), 1);
	piece->beside_x = fmax(piece->beside_x, fabs(point.x - piece->x0 - part * x));
	piece->beside_y = fmax(piece->beside_y, fabs(point.y - piece->y0 - part * y));
}

/* The direction from the first of the points to the next one that is elsewhere. False: there is none. */
static bool direction(const struct pair *points, int count, int step, struct pair *unit)
{
	for (int i = 1; i < count; i++) {
		double x = points[i * step].x - points[0].x, y = points[i * step].y - points[0].y;
		double length = sqrt(x * x + y * y);

		if (length > LEAST_TANGENT) {
			*unit = (struct pair){step * x / length, step * y / length};
			return true;
		}
	}
	return false;
}

/*
 * Two arcs that leave the start along t0, arrive at the end along t1, and meet where both tangents are as long: so long
 * that the square of 2 d is the square of the way between the tangents' ends. They lie in the hull of both ends and
 * both tangents.
 */
static bool hold_arcs(struct spline_piece *piece, struct pair t0, struct pair t1)
{
	double vx = piece->x0 - piece->x1, vy = piece->y0 - piece->y1;
	double a = 2 * (t0.x * t1.x + t0.y * t1.y - 1), b = 2 * (vx * (t0.x + t1.x) + vy * (t0.y + t1.y));
	double c = vx * vx + vy * vy, d;

	if (!(c > 0))
		return true;
	if (!(b < 0))
		return false;
	d = 2 * c / (-b + sqrt(fmax(b * b - 4 * a * c, 0)));
	hold(piece, (struct pair){piece->x0 + d * t0.x, piece->y0 + d * t0.y});
	hold(piece, (struct pair){piece->x1 - d * t1.x, piece->y1 - d * t1.y});
	return true;
}

size_t spline_piece_count(const struct spline *spline)
{
	return PIECES_A_POINT * spline->count;
}

static size_t span_of(const struct spline *spline, double u)
{
	double span = fmin(floor(u), last_knot(spline) - 1);

	return (size_t)span + (size_t)spline->order - 1;
}

/* The control points of the piece from u0 to u1, between which there is no knot. */
static void find_hull(const struct spline *spline, double u0, double u1, struct pair hull[SPLINE_ORDER_MAX])
{
	const size_t span = span_of(spline, (u0 + u1) / 2);

	for (int i = 0; i < spline->order; i++)
		hull[i] = project(blossom(spline, span, u0, u1, spline->order - 1 - i));
}

/* The parameter where piece `index` begins. What rounding puts beside a knot is the knot. */
static double parameter(const struct spline *spline, size_t index)
{
	const double u = last_knot(spline) * (double)index / (double)spline_piece_count(spline);

	return fabs(u - round(u)) < SAME_PARAMETER ? round(u) : u;
}

bool spline_piece_find(const struct spline *spline, size_t index, struct spline_piece *piece)
{
	const double u0 = parameter(spline, index), u1 = parameter(spline, index + 1);
	struct pair hull[SPLINE_ORDER_MAX], first, end, t0, t1;
	double from = u0, to;

	find_hull(spline, u0, fmin(u1, floor(u0) + 1), hull);
	first = hull[0];
	if (!direction(hull, spline->order, 1, &t0))
		return false;
	find_hull(spline, fmax(u0, ceil(u1) - 1), u1, hull);
	end = hull[spline->order - 1];
	if (!direction(&hull[spline->order - 1], spline->order, -1, &t1))
		return false;
	*piece = (struct spline_piece){.x0 = first.x, .y0 = first.y, .x1 = end.x, .y1 = end.y};
	while (from < u1) {
		to = fmin(u1, floor(from) + 1);
		find_hull(spline, from, to, hull);
		for (int i = 0; i < spline->order; i++)
			hold(piece, hull[i]);
		from = to;
	}
	return hold_arcs(piece, t0, t1);
}
