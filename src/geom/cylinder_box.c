#include "geom/cylinder_box.h"

#include <math.h>

/* The distance may be too large by this share of it. */
static const double SHARE = 0.01;
/*
 * The largest number of projections; then the current distance is returned. Random cases need about 10; edges that
 * graze need most.
 */
enum { PROJECTIONS = 1000 };

static double clamp(double value, double least, double most)
{
	return value < least ? least : value > most ? most : value;
}

static vec3 nearest_of_box(const struct solid_box *box, vec3 p)
{
	return vec3_max(vec3_sub(box->middle, box->half), vec3_min(p, vec3_add(box->middle, box->half)));
}

static vec3 nearest_of_cylinder(const struct cylinder *cylinder, vec3 p)
{
	const vec3 to = vec3_sub(p, cylinder->base);
	const double height = vec3_dot(to, cylinder->along);
	vec3 out = vec3_mad(to, -height, cylinder->along);
	const double off = vec3_norm(out);

	if (off > cylinder->radius)
		out = vec3_scale(cylinder->radius / off, out);
	return vec3_add(cylinder->base, vec3_mad(out, clamp(height, 0, cylinder->length), cylinder->along));
}

/*
 * The gap between both along the unit vector n, which points from the box to the cylinder. It is a lower bound of the
 * distance.
 */
static double gap_along(const struct cylinder *cylinder, const struct solid_box *box, vec3 n)
{
	const double height = vec3_dot(cylinder->along, n);
	const double across = sqrt(clamp(1 - height * height, 0, 1));
	const double least = vec3_dot(vec3_sub(cylinder->base, box->middle), n) +
			     (height < 0 ? height * cylinder->length : 0) - across * cylinder->radius;

	return least - (fabs(n.x) * box->half.x + fabs(n.y) * box->half.y + fabs(n.z) * box->half.z);
}

double cylinder_box_distance(const struct cylinder *cylinder, const struct solid_box *box, double enough)
{
	vec3 p = nearest_of_cylinder(cylinder, box->middle), to = {0, 0, 0};

	for (int i = 0; i < PROJECTIONS; i++) {
		const vec3 b = nearest_of_box(box, p);
		double distance;

		to = vec3_sub(p, b);
		distance = vec3_norm(to);
		if (distance <= enough || !(distance > 0) ||
		    gap_along(cylinder, box, vec3_scale(1 / distance, to)) >= (1 - SHARE) * distance)
			break;
		p = nearest_of_cylinder(cylinder, b);
	}
	return vec3_norm(to);
}
