/* plane_point.h - points and vectors of the plane of G17, G18 or G19. */
#ifndef FIVECHECK_GCODE_EXECUTE_PLANE_POINT_H
#define FIVECHECK_GCODE_EXECUTE_PLANE_POINT_H

/* Along the first and the second axis of the plane (G17 X Y, G18 Z X, G19 Y Z), mm. */
struct plane_point {
	double a, b;
};

/* from + s direction */
static inline struct plane_point plane_along(struct plane_point from, double s, struct plane_point direction)
{
	return (struct plane_point){from.a + s * direction.a, from.b + s * direction.b};
}

static inline double plane_dot(struct plane_point p, struct plane_point q)
{
	return p.a * q.a + p.b * q.b;
}

/* Positive if q is counter-clockwise from p. */
static inline double plane_cross(struct plane_point p, struct plane_point q)
{
	return p.a * q.b - p.b * q.a;
}

#endif
