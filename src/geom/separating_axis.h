/* separating_axis.h - separating axes as proofs that two moving triangles stay apart over an interval. */
#ifndef FIVECHECK_GEOM_SEPARATING_AXIS_H
#define FIVECHECK_GEOM_SEPARATING_AXIS_H

#include <stdbool.h>

#include "geom/tri.h"

/*
 * Triangle a is fixed; b's corners go from b0 to b1, each on its chord to within a displacement that the caller adds to
 * `apart`. fivecheck(7), "Certificates".
 */

/*
 * One axis: if the gap along a fixed unit direction exceeds `apart` at both ends, it does so during the whole interval.
 */
bool separating_axis_fixed(const tri *a, const tri *b0, const tri *b1, vec3 n, double apart);

/*
 * Interpolated axis: n(s) = (1-s) n0 + s n1 with unit ends. For any two corners
 * n(s).(q(s) - p) is a quadratic in s whose Bernstein coefficients are
 *     n0.(q0 - p),  (n0.(q1 - p) + n1.(q0 - p)) / 2,  n1.(q1 - p);
 * if the least of each over all corners exceeds `apart` then so does the
 * distance, since |n(s)| <= 1.
 */
bool separating_axis_interpolated(const tri *a, const tri *b0, const tri *b1, vec3 n0, vec3 n1, double apart);

#endif
