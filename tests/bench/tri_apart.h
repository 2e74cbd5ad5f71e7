/* tri_apart.h - the distance of two triangles: crossings, then all edges against edges and corners against faces. */
#ifndef BENCH_TRI_APART_H
#define BENCH_TRI_APART_H

#include "plain_scene.h"

static inline double clamp01(double x)
{
	return x < 0 ? 0 : x > 1 ? 1 : x;
}

/* Squared distance of p from the segment a b, by projection. */
static inline double point_segment2(vec p, vec a, vec b)
{
	vec d = sub(b, a), way;
	double l2 = dot(d, d), s = l2 > 0 ? clamp01(dot(sub(p, a), d) / l2) : 0;

	way = sub(p, add(a, times(s, d)));
	return dot(way, way);
}

/* Squared distance of two segments: an end of one to the other, or the feet of their common normal. */
static inline double segments2(vec a, vec b, vec c, vec d)
{
	vec u = sub(b, a), v = sub(d, c), w = sub(a, c), n = cross(u, v), way;
	double n2 = dot(n, n), best, s, t;

	best = fmin(fmin(point_segment2(a, c, d), point_segment2(b, c, d)),
		    fmin(point_segment2(c, a, b), point_segment2(d, a, b)));
	if (!(n2 > 0))
		return best;
	s = dot(cross(v, w), n) / n2;
	t = dot(cross(u, w), n) / n2;
	if (!(s > 0 && s < 1 && t > 0 && t < 1))
		return best;
	way = sub(add(a, times(s, u)), add(c, times(t, v)));
	return fmin(best, dot(way, way));
}

/* Does the foot of p on the triangle's plane lie in it? Then *height2 is the squared height. */
static inline int over_face(vec p, const struct triangle *t, double *height2)
{
	vec e = sub(t->p[1], t->p[0]), f = sub(t->p[2], t->p[0]), n = cross(e, f), w = sub(p, t->p[0]);
	double n2 = dot(n, n), u, v, h;

	if (!(n2 > 0))
		return 0;
	u = dot(cross(w, f), n) / n2;
	v = dot(cross(e, w), n) / n2;
	if (u < 0 || v < 0 || u + v > 1)
		return 0;
	h = dot(w, n);
	*height2 = h * h / n2;
	return 1;
}

static inline int pierces(vec a, vec b, const struct triangle *t)
{
	vec n = cross(sub(t->p[1], t->p[0]), sub(t->p[2], t->p[0]));
	double ha = dot(n, sub(a, t->p[0])), hb = dot(n, sub(b, t->p[0])), height2;

	if ((ha > 0) == (hb > 0) || !(fabs(ha - hb) > 0))
		return 0;
	return over_face(add(a, times(ha / (ha - hb), sub(b, a))), t, &height2);
}

static inline double tri_apart2(const struct triangle *a, const struct triangle *b)
{
	double best = INFINITY, h2;

	for (int i = 0; i < 3; i++) {
		if (pierces(a->p[i], a->p[(i + 1) % 3], b) || pierces(b->p[i], b->p[(i + 1) % 3], a))
			return 0;
		if (over_face(a->p[i], b, &h2))
			best = fmin(best, h2);
		if (over_face(b->p[i], a, &h2))
			best = fmin(best, h2);
		for (int j = 0; j < 3; j++)
			best = fmin(best, segments2(a->p[i], a->p[(i + 1) % 3], b->p[j], b->p[(j + 1) % 3]));
	}
	return best;
}

#endif
