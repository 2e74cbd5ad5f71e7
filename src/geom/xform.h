/* xform.h - rigid motions: rotation matrices and poses. */
#ifndef FIVECHECK_GEOM_XFORM_H
#define FIVECHECK_GEOM_XFORM_H

#include <stdbool.h>

#include "base/math/math_functions.h"
#include "base/same_double.h"
#include "geom/vec3.h"

/* By columns: the images of the unit vectors. */
typedef struct mat3 {
	vec3 x, y, z;
} mat3;

/* p -> rotation p + translation */
typedef struct xform {
	mat3 rotation;
	vec3 translation;
} xform;

static inline mat3 mat3_identity(void)
{
	return (mat3){{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
}

static inline bool mat3_is_identity(const mat3 *m)
{
	const double off[6] = {m->x.y, m->x.z, m->y.x, m->y.z, m->z.x, m->z.y};

	for (int i = 0; i < 6; i++)
		if (!same_double(off[i], 0))
			return false;
	return same_double(m->x.x, 1) && same_double(m->y.y, 1) && same_double(m->z.z, 1);
}

static inline vec3 mat3_apply(const mat3 *m, vec3 p)
{
	return (vec3){m->x.x * p.x + m->y.x * p.y + m->z.x * p.z,
		      m->x.y * p.x + m->y.y * p.y + m->z.y * p.z,
		      m->x.z * p.x + m->y.z * p.y + m->z.z * p.z};
}

/* The transpose applied: for a rotation, its inverse. */
static inline vec3 mat3_apply_transposed(const mat3 *m, vec3 p)
{
	return (vec3){vec3_dot(m->x, p), vec3_dot(m->y, p), vec3_dot(m->z, p)};
}

static inline mat3 mat3_mul(const mat3 *a, const mat3 *b)
{
	return (mat3){mat3_apply(a, b->x), mat3_apply(a, b->y), mat3_apply(a, b->z)};
}

static inline xform xform_identity(void)
{
	return (xform){mat3_identity(), {0, 0, 0}};
}

static inline vec3 xform_apply(const xform *t, vec3 p)
{
	return vec3_add(mat3_apply(&t->rotation, p), t->translation);
}

/* a after b */
static inline xform xform_mul(const xform *a, const xform *b)
{
	return (xform){mat3_mul(&a->rotation, &b->rotation), xform_apply(a, b->translation)};
}

/* The same for an `a` that may be known to have no rotation: then its rotation is not read. */
static inline xform xform_mul_turned(const xform *a, bool turned, const xform *b)
{
	return turned ? xform_mul(a, b) : (xform){b->rotation, vec3_add(b->translation, a->translation)};
}

static inline xform xform_inverse(const xform *t)
{
	const mat3 *r = &t->rotation;
	mat3 transposed = {{r->x.x, r->y.x, r->z.x}, {r->x.y, r->y.y, r->z.y}, {r->x.z, r->y.z, r->z.z}};

	return (xform){transposed, vec3_scale(-1, mat3_apply(&transposed, t->translation))};
}

/* Right-handed rotation by `angle` radians about the unit vector `axis` (Rodrigues' formula). */
static inline mat3 mat3_turn(vec3 axis, double angle)
{
	double x = axis.x, y = axis.y, z = axis.z, c, s, k;

	math_sin_cos(angle, &s, &c);
	k = 1 - c;
	return (mat3){{c + k * x * x, k * x * y + s * z, k * x * z - s * y},
		      {k * x * y - s * z, c + k * y * y, k * y * z + s * x},
		      {k * x * z + s * y, k * y * z - s * x, c + k * z * z}};
}

/* The same about the line through `point` along the unit vector `axis`. */
static inline xform xform_turn(vec3 point, vec3 axis, double angle)
{
	mat3 turn = mat3_turn(axis, angle);

	return (xform){turn, vec3_sub(point, mat3_apply(&turn, point))};
}

#endif
