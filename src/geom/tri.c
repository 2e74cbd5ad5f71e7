#include "geom/tri.h"

#include "geom/tolerance.h"

/* A triangle relative to the pair's origin; edge i runs from corner i to corner i + 1. */
struct side {
	vec3 p[3];
	vec3 edge[3];
	double length2[3];
	double inverse[3];	/* of length2; 0 for a point, which makes every parameter 0 */
};

/* The best pair of points so far. */
struct closest {
	vec3 on_a, on_b;
	double distance2;
};

/*
 * The longest edge and the height over it: they are perpendicular to within rounding even for a needle-shaped triangle.
 */
struct face {
	vec3 origin, base, side, rise;
	double foot;	/* side = foot base + rise */
	double base_inverse, rise_inverse;	/* of the squared lengths */
};

/* Clamped before the division by `whole`, not after it: then gcc generates no branches, which cost half the time. */
static inline double clamped(double part, double whole)
{
	part = part > 0 ? part : 0;
	return part < whole ? part : whole;
}

static void side_init(struct side *side, const tri *t, vec3 origin)
{
	for (int i = 0; i < 3; i++)
		side->p[i] = vec3_sub(t->p[i], origin);
	for (int i = 0; i < 3; i++) {
		side->edge[i] = vec3_sub(side->p[(i + 1) % 3], side->p[i]);
		side->length2[i] = vec3_norm2(side->edge[i]);
		side->inverse[i] = side->length2[i] > POINT_LENGTH2 ? 1 / side->length2[i] : 0;
	}
}

static inline void closest_offer(struct closest *best, vec3 x, vec3 y)
{
	double distance2 = vec3_norm2(vec3_sub(y, x));

	if (distance2 < best->distance2)
		*best = (struct closest){x, y, distance2};
}

/*
 * The point of the line p + s d nearest the line q + t e, as s. If the lines are nearly parallel the Gram determinant
 * cancels. The cross product keeps the resulting error of the distance at the size of the rounding of r, however small
 * the angle.
 */
static inline double line_parameter(vec3 d, vec3 e, vec3 r, const double gram[5])
{
	double dd = gram[0], ee = gram[1], de = gram[2], dr = gram[3], er = gram[4];
	double det = dd * ee - de * de, num = dr * ee - er * de;

	if (det < dd * ee * (1 / 16.0)) {
		vec3 n = vec3_cross(d, e);

		det = vec3_norm2(n);
		num = vec3_dot(vec3_cross(r, e), n);
	}
	return clamped(num, det) / (det > 0 ? det : 1);
}

/* The closest points of edge i of a and edge j of b, as their parameters; returns their squared distance. */
static inline double edge_edge(const struct side *a, int i, const struct side *b, int j, double *on_d, double *on_e)
{
	vec3 d = a->edge[i], e = b->edge[j], r = vec3_sub(b->p[j], a->p[i]);
	double de = vec3_dot(d, e), dr = vec3_dot(d, r), er = vec3_dot(e, r);
	const double gram[5] = {a->length2[i], b->length2[j], de, dr, er};
	double s = line_parameter(d, e, r, gram);
	double t = clamped(s * de - er, b->length2[j]) * b->inverse[j];

	s = clamped(t * de + dr, a->length2[i]) * a->inverse[i];
	*on_d = s;
	*on_e = t;
	return vec3_norm2(vec3_mad(vec3_mad(r, t, e), -s, d));
}

/* All nine are computed before any is compared: branches that cannot be predicted cost more than the pairs. */
static struct closest edges_closest(const struct side *a, const struct side *b)
{
	double s[9], t[9], distance2[9];
	int best = 0;
	vec3 x, y;

	for (int k = 0; k < 9; k++)
		distance2[k] = edge_edge(a, k / 3, b, k % 3, &s[k], &t[k]);
	for (int k = 1; k < 9; k++)
		best = distance2[k] < distance2[best] ? k : best;
	x = vec3_mad(a->p[best / 3], s[best], a->edge[best / 3]);
	y = vec3_mad(b->p[best % 3], t[best], b->edge[best % 3]);
	return (struct closest){x, y, vec3_norm2(vec3_sub(y, x))};
}

/* False if the triangle has no proper face. */
static bool face_init(struct face *face, const struct side *t)
{
	int i = t->length2[1] > t->length2[0] ? 1 : 0;
	double again, height2;

	i = t->length2[2] > t->length2[i] ? 2 : i;
	face->origin = t->p[i];
	face->base = t->edge[i];
	face->base_inverse = t->inverse[i];
	face->side = vec3_scale(-1, t->edge[(i + 2) % 3]);
	face->foot = vec3_dot(face->side, face->base) * face->base_inverse;
	face->rise = vec3_mad(face->side, -face->foot, face->base);
	again = vec3_dot(face->rise, face->base) * face->base_inverse;
	face->foot += again;
	face->rise = vec3_mad(face->rise, -again, face->base);
	height2 = vec3_norm2(face->rise);
	if (height2 <= FACE_FLAT * FACE_FLAT * t->length2[i] || height2 <= POINT_LENGTH2)
		return false;
	face->rise_inverse = 1 / height2;
	return true;
}

/* The projection of q onto the face; false if it is outside the face. */
static inline bool face_project(const struct face *face, vec3 q, vec3 *below)
{
	vec3 r = vec3_sub(q, face->origin);
	double v = vec3_dot(r, face->rise) * face->rise_inverse;
	double u = vec3_dot(r, face->base) * face->base_inverse - v * face->foot;

	if (!(v >= 0 && u >= 0 && u + v <= 1))
		return false;
	*below = vec3_mad(vec3_mad(face->origin, v, face->side), u, face->base);
	return true;
}

/* The point where an edge of t passes through the face. */
static bool face_pierced(const struct face *face, const struct side *t, vec3 *at)
{
	vec3 normal = vec3_cross(face->base, face->rise), ignored;
	double height[3];

	for (int k = 0; k < 3; k++)
		height[k] = vec3_dot(normal, vec3_sub(t->p[k], face->origin));
	for (int k = 0; k < 3; k++) {
		double h0 = height[k], h1 = height[(k + 1) % 3];

		if ((h0 > 0) == (h1 > 0))
			continue;
		*at = vec3_mad(t->p[k], h0 / (h0 - h1), t->edge[k]);
		if (face_project(face, *at, &ignored))
			return true;
	}
	return false;
}

/*
 * Tries the corners of t over the face of another triangle, which is a if face_on_a. True if an edge passes through the
 * face.
 */
static bool face_offer(struct closest *best, const struct side *of, const struct side *t, bool face_on_a)
{
	struct face face;
	vec3 below, at;

	if (!face_init(&face, of))
		return false;
	for (int k = 0; k < 3; k++) {
		if (!face_project(&face, t->p[k], &below))
			continue;
		if (face_on_a)
			closest_offer(best, below, t->p[k]);
		else
			closest_offer(best, t->p[k], below);
	}
	if (!face_pierced(&face, t, &at))
		return false;
	*best = (struct closest){at, at, 0};
	return true;
}

static double side_size(const struct side *t)
{
	double size = 0;

	for (int k = 0; k < 3; k++) {
		double x = fabs(t->p[k].x), y = fabs(t->p[k].y), z = fabs(t->p[k].z);

		x = x > y ? x : y;
		z = z > size ? z : size;
		size = x > z ? x : z;
	}
	return size;
}

/*
 * Is this pair of points a closest pair? Yes if the slab between the points contains no corner: then no other pair is
 * closer, to within the slab's rounding.
 */
static bool closest_certified(const struct closest *c, double distance, const struct side *a, const struct side *b,
			      double tolerance)
{
	vec3 v = vec3_sub(c->on_b, c->on_a);
	double above = vec3_dot(v, c->on_a), below = vec3_dot(v, c->on_b), rounding = tolerance * distance;

	for (int k = 0; k < 3; k++) {
		if (vec3_dot(v, a->p[k]) > above + rounding || vec3_dot(v, b->p[k]) < below - rounding)
			return false;
	}
	return distance > tolerance;
}

double tri_distance(const tri *a, const tri *b, vec3 *on_a, vec3 *on_b)
{
	vec3 origin = a->p[0];
	struct side p, q;
	struct closest best;
	double size, distance, tolerance;

	side_init(&p, a, origin);
	side_init(&q, b, origin);
	size = fmax(side_size(&p), side_size(&q));
	tolerance = 4 * DBL_EPSILON * size;
	best = edges_closest(&p, &q);
	distance = sqrt(best.distance2);
	if (!closest_certified(&best, distance, &p, &q, tolerance)) {
		if (!face_offer(&best, &q, &p, false))
			face_offer(&best, &p, &q, true);
		distance = sqrt(best.distance2);
	}
	*on_a = vec3_add(origin, best.on_a);
	*on_b = vec3_add(origin, best.on_b);
	/* At this distance, triangles that touch may be apart by rounding only. */
	return distance > 2 * tolerance ? distance : 0;
}

/* Appends the cross product of e and f unless it nearly vanishes. */
static void axis_add(vec3 *axes, int *count, vec3 e, vec3 f)
{
	vec3 n = vec3_cross(e, f);

	if (vec3_norm2(n) > CROSS_VANISHING * CROSS_VANISHING * vec3_norm2(e) * vec3_norm2(f))
		axes[(*count)++] = n;
}

/* The edges, and the normal from the two shorter edges, which determine it best; false if it nearly vanishes. */
static bool edges_and_normal(const tri *t, vec3 edge[3], vec3 *normal)
{
	double length2[3];
	int longest, found = 0;

	for (int k = 0; k < 3; k++) {
		edge[k] = vec3_sub(t->p[(k + 1) % 3], t->p[k]);
		length2[k] = vec3_norm2(edge[k]);
	}
	longest = length2[1] > length2[0] ? 1 : 0;
	longest = length2[2] > length2[longest] ? 2 : longest;
	axis_add(normal, &found, edge[(longest + 1) % 3], edge[(longest + 2) % 3]);
	return found > 0;
}

/* Do all corners of t lie in the plane through `point` with the normal n, to within rounding? */
static bool in_plane(const tri *t, vec3 point, vec3 n, double size)
{
	for (int k = 0; k < 3; k++) {
		if (fabs(vec3_dot(n, vec3_sub(t->p[k], point))) > tri_gap_error(size, n))
			return false;
	}
	return true;
}

/* As tri_axes; tells whether both triangles have a normal. */
static int find_axes(const tri *a, const tri *b, double size, vec3 *axes, bool *proper)
{
	vec3 e[3], f[3], na, nb;
	bool has_a = edges_and_normal(a, e, &na), has_b = edges_and_normal(b, f, &nb);
	bool coplanar = (has_a || has_b) && (!has_a || in_plane(b, a->p[0], na, size)) &&
			(!has_b || in_plane(a, b->p[0], nb, size));
	int count = 0;

	*proper = has_a && has_b;
	if (!coplanar) {
		if (has_a)
			axes[count++] = na;
		if (has_b)
			axes[count++] = nb;
		for (int k = 0; k < 9; k++)
			axis_add(axes, &count, e[k / 3], f[k % 3]);
		return count;
	}
	for (int k = 0; k < 3; k++) {
		if (has_a)
			axis_add(axes, &count, na, e[k]);
		if (has_b)
			axis_add(axes, &count, nb, f[k]);
	}
	return count;
}

int tri_axes(const tri *a, const tri *b, vec3 axes[TRI_AXES_MAX])
{
	bool proper;

	return find_axes(a, b, tri_pair_size(a, b), axes, &proper);
}

bool tri_meet(const tri *a, const tri *b)
{
	double size = tri_pair_size(a, b);
	vec3 axes[TRI_AXES_MAX], on_a, on_b;
	bool proper;
	int count = find_axes(a, b, size, axes, &proper);

	for (int k = 0; k < count; k++) {
		double error = tri_gap_error(size, axes[k]);

		if (tri_gap(a, b, axes[k]) > error || tri_gap(b, a, axes[k]) > error)
			return false;
	}
	return proper || tri_distance(a, b, &on_a, &on_b) <= TRI_DISTANCE_ERROR * size;
}
