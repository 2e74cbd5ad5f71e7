/* vec3.h - a point or a direction in space. */
#ifndef FIVECHECK_GEOM_VEC3_H
#define FIVECHECK_GEOM_VEC3_H

#include <math.h>
#include <stdbool.h>

#include "base/same_double.h"

typedef struct vec3 {
	double x, y, z;
} vec3;

/* See same_double: exactly equal. */
static inline bool same_vec3(vec3 a, vec3 b)
{
	return same_double(a.x, b.x) && same_double(a.y, b.y) && same_double(a.z, b.z);
}

static inline bool vec3_is_zero(vec3 a)
{
	return same_vec3(a, (vec3){0, 0, 0});
}

static inline vec3 vec3_add(vec3 a, vec3 b)
{
	return (vec3){a.x + b.x, a.y + b.y, a.z + b.z};
}

static inline vec3 vec3_sub(vec3 a, vec3 b)
{
	return (vec3){a.x - b.x, a.y - b.y, a.z - b.z};
}

static inline vec3 vec3_scale(double s, vec3 a)
{
	return (vec3){s * a.x, s * a.y, s * a.z};
}

/* a + s b */
static inline vec3 vec3_mad(vec3 a, double s, vec3 b)
{
	return (vec3){a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
}

static inline double vec3_dot(vec3 a, vec3 b)
{
	return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline vec3 vec3_cross(vec3 a, vec3 b)
{
	return (vec3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static inline double vec3_norm2(vec3 a)
{
	return vec3_dot(a, a);
}

static inline double vec3_norm(vec3 a)
{
	return sqrt(vec3_norm2(a));
}

/* The unit vector of a's direction; 0 if a is so short that its square loses digits. */
static inline vec3 vec3_unit(vec3 a)
{
	double norm2 = vec3_norm2(a);

	return norm2 > 0x1p-900 ? vec3_scale(1 / sqrt(norm2), a) : (vec3){0, 0, 0};
}

/* (1-s) a + s b */
static inline vec3 vec3_lerp(vec3 a, vec3 b, double s)
{
	return vec3_mad(a, s, vec3_sub(b, a));
}

/* For each coordinate; the numbers are finite, so a comparison is enough. */
static inline vec3 vec3_min(vec3 a, vec3 b)
{
	return (vec3){a.x < b.x ? a.x : b.x, a.y < b.y ? a.y : b.y, a.z < b.z ? a.z : b.z};
}

static inline vec3 vec3_max(vec3 a, vec3 b)
{
	return (vec3){a.x > b.x ? a.x : b.x, a.y > b.y ? a.y : b.y, a.z > b.z ? a.z : b.z};
}

#endif
