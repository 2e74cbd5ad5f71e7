#include "gcode/execute/spline.h"

#include <math.h>

/* mm: a shorter derivative has no direction. */
#define LEAST_TANGENT 1e-9

/* Pieces are longer than 1 / (4 * 1000). */
#define SAME_PARAMETER 1e-9

/* LinuxCNC 2.8 and 2.9 (emccanon.cc, NURBS_FEED) make 4 pieces for each point. */
#define PIECES_A_POINT 4

/* A point times its weight, and the weight: the homogeneous coordinates of rational curves. */
struct weighted {
	vec3 at;
	double weight;
};

static double last_knot(const struct spline *spline)
{
	return (double)spline->count - spline->order + 1;
}

static double knot(const struct spline *spline, size_t index)
{
	double value = (double)index - spline->order + 1;

	if (spline->knots)
		return spline->knots[index];
	return fmin(fmax(value, 0), last_knot(spline));
}

static struct weighted mix(struct weighted a, struct weighted b, double part)
{
	return (struct weighted){vec3_mad(a.at, part, vec3_sub(b.at, a.at)),
				 a.weight + part * (b.weight - a.weight)};
}

/*
 * The blossom of the polynomial between the knots `span` and `span` + 1, which must differ: `first` of its arguments
 * are u0, the others u1 (L. Ramshaw, "Blossoming"; de Boor's algorithm with another argument at each step).
 */
static struct weighted blossom(const struct spline *spline, size_t span, double u0, double u1, int first)
{
	struct weighted d[SPLINE_ORDER_MAX] = {{{0, 0, 0}, 0}};
	const int degree = spline->order - 1;

	for (int i = 0; i <= degree; i++) {
		const struct spline_point *point = &spline->points[span - (size_t)(degree - i)];

		d[i] = (struct weighted){vec3_scale(point->weight, point->at), point->weight};
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

static vec3 project(struct weighted point)
{
	return (vec3){point.at.x / point.weight, point.at.y / point.weight, point.at.z / point.weight};
}

/* Widens the boxes so that they contain the point. They also contain the hull of all points that they contain. */
static void widen_boxes(struct spline_piece *piece, vec3 point)
{
	vec3 way = vec3_sub(piece->end, piece->start), off = vec3_sub(point, piece->start);
	double square = vec3_dot(way, way), part = 0;

	if (square > 0)
		part = fmin(fmax(vec3_dot(off, way) / square, 0), 1);
	off = vec3_mad(off, -part, way);
	piece->beside.x = fmax(piece->beside.x, fabs(off.x));
	piece->beside.y = fmax(piece->beside.y, fabs(off.y));
	piece->beside.z = fmax(piece->beside.z, fabs(off.z));
}

/* The direction from the first of the points to the next one at another place. False: there is none. */
static bool direction(const vec3 *points, int count, int step, vec3 *unit)
{
	for (int i = 1; i < count; i++) {
		vec3 way = vec3_sub(points[i * step], points[0]);
		double length = vec3_norm(way);

		if (length > LEAST_TANGENT) {
			*unit = vec3_scale(step / length, way);
			return true;
		}
	}
	return false;
}

/*
 * Two arcs that leave the start along t0, arrive at the end along t1, and meet such that both tangents have the same
 * length d: the distance between the ends of the tangents is then 2 d. The arcs are in the hull of both ends and both
 * tangents.
 */
static bool hold_arcs(struct spline_piece *piece, vec3 t0, vec3 t1)
{
	vec3 back = vec3_sub(piece->start, piece->end);
	double a = 2 * (vec3_dot(t0, t1) - 1), b = 2 * vec3_dot(back, vec3_add(t0, t1));
	double c = vec3_dot(back, back), d;

	if (!(c > 0))
		return true;
	if (!(b < 0))
		return false;
	d = 2 * c / (-b + sqrt(fmax(b * b - 4 * a * c, 0)));
	widen_boxes(piece, vec3_mad(piece->start, d, t0));
	widen_boxes(piece, vec3_mad(piece->end, -d, t1));
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

/* The control points of the part from u0 to u1, both between the knots `span` and `span` + 1. */
static void find_hull(const struct spline *spline, size_t span, double u0, double u1, vec3 hull[SPLINE_ORDER_MAX])
{
	for (int i = 0; i < spline->order; i++)
		hull[i] = project(blossom(spline, span, u0, u1, spline->order - 1 - i));
}

/* The same for uniform knots. */
static void find_uniform_hull(const struct spline *spline, double u0, double u1, vec3 hull[SPLINE_ORDER_MAX])
{
	find_hull(spline, span_of(spline, (u0 + u1) / 2), u0, u1, hull);
}

struct spline_piece spline_part(const struct spline *spline, size_t span, double u0, double u1)
{
	vec3 hull[SPLINE_ORDER_MAX];
	struct spline_piece piece = {0};

	find_hull(spline, span, u0, u1, hull);
	piece.start = hull[0];
	piece.end = hull[spline->order - 1];
	for (int i = 1; i < spline->order - 1; i++)
		widen_boxes(&piece, hull[i]);
	return piece;
}

/* The parameter at the start of piece `index`. A parameter that differs from a knot only by rounding is the knot. */
static double parameter(const struct spline *spline, size_t index)
{
	const double u = last_knot(spline) * (double)index / (double)spline_piece_count(spline);

	return fabs(u - round(u)) < SAME_PARAMETER ? round(u) : u;
}

bool spline_piece_find(const struct spline *spline, size_t index, struct spline_piece *piece)
{
	const double u0 = parameter(spline, index), u1 = parameter(spline, index + 1);
	struct spline_piece found = {0};
	vec3 hull[SPLINE_ORDER_MAX], t0, t1;
	double from = u0, to;

	find_uniform_hull(spline, u0, fmin(u1, floor(u0) + 1), hull);
	found.start = hull[0];
	if (!direction(hull, spline->order, 1, &t0))
		return false;
	find_uniform_hull(spline, fmax(u0, ceil(u1) - 1), u1, hull);
	found.end = hull[spline->order - 1];
	if (!direction(&hull[spline->order - 1], spline->order, -1, &t1))
		return false;
	while (from < u1) {
		to = fmin(u1, floor(from) + 1);
		find_uniform_hull(spline, from, to, hull);
		for (int i = 0; i < spline->order; i++)
			widen_boxes(&found, hull[i]);
		from = to;
	}
	if (!hold_arcs(&found, t0, t1))
		return false;
	*piece = found;
	return true;
}
