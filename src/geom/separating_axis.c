#include "geom/separating_axis.h"

bool separating_axis_fixed(const tri *a, const tri *b0, const tri *b1, vec3 n, double apart)
{
	return tri_gap(a, b0, n) > apart && tri_gap(a, b1, n) > apart;
}

bool separating_axis_interpolated(const tri *a, const tri *b0, const tri *b1, vec3 n0, vec3 n1, double apart)
{
	vec3 sum = vec3_add(n0, n1);
	double most_p, least_q = INFINITY;

	if (!(tri_gap(a, b0, n0) > apart) || !(tri_gap(a, b1, n1) > apart))
		return false;
	most_p = fmax(vec3_dot(sum, a->p[0]), fmax(vec3_dot(sum, a->p[1]), vec3_dot(sum, a->p[2])));
	for (int i = 0; i < 3; i++)
		least_q = fmin(least_q, vec3_dot(n0, b1->p[i]) + vec3_dot(n1, b0->p[i]));
	return 0.5 * (least_q - most_p) > apart;
}
