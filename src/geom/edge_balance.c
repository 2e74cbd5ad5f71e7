#include "geom/edge_balance.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

/*
 * The volume of a sheet that is drawn from both sides, as a share of its area times its size, is at most this, by
 * rounding.
 */
static const double FLAT = 1e-6;

/* Mixes the bits of a word: the finaliser of MurmurHash3 (A. Appleby, public domain). */
static uint64_t mix(uint64_t x)
{
	x ^= x >> 33;
	x *= 0xff51afd7ed558ccdULL;
	x ^= x >> 33;
	x *= 0xc4ceb9fe1a85ec53ULL;
	return x ^ x >> 33;
}

/* Corners with equal coordinates have equal hashes: -0 is 0. */
static uint64_t hash_of(const float corner[3])
{
	uint32_t bits[3];

	for (int k = 0; k < 3; k++) {
		const float coordinate = corner[k] + 0.0F;

		memcpy(&bits[k], &coordinate, sizeof(bits[k]));
	}
	return mix(mix((uint64_t)bits[0] << 32 | bits[1]) + bits[2]);
}

/* The term of an edge in the sum; the edge in the opposite direction has the negative term, modulo 2^64. */
static uint64_t edge_term(uint64_t from, uint64_t to)
{
	return mix(from + 3 * to) - mix(to + 3 * from);
}

static bool is_near_zero(const float corner[3], float near)
{
	return fabsf(corner[0]) <= near || fabsf(corner[1]) <= near || fabsf(corner[2]) <= near;
}

bool edge_balance_near_zero(const struct mesh *mesh, float near)
{
	uint64_t sum = 0;

	for (size_t i = 0; i < mesh->count; i++) {
		const mesh_triangle *t = &mesh->triangles[i];
		const bool is_near[3] = {is_near_zero(t->v[0], near), is_near_zero(t->v[1], near),
					 is_near_zero(t->v[2], near)};

		for (int k = 0; k < 3; k++)
			if (is_near[k] || is_near[(k + 1) % 3])
				sum += edge_term(hash_of(t->v[k]), hash_of(t->v[(k + 1) % 3]));
	}
	return sum == 0;
}

bool edge_balance_is_closed(const struct mesh *mesh)
{
	uint64_t sum = 0;
	double volume = 0, area = 0;
	vec3 least, greatest, middle;

	if (!mesh->count)
		return false;
	mesh_bounds(mesh, &least, &greatest);
	middle = vec3_scale(0.5, vec3_add(least, greatest));
	for (size_t i = 0; i < mesh->count; i++) {
		const mesh_triangle *t = &mesh->triangles[i];
		const uint64_t a = hash_of(t->v[0]), b = hash_of(t->v[1]), c = hash_of(t->v[2]);
		const vec3 p = vec3_sub(mesh_corner(t, 0), middle);
		const vec3 normal = vec3_cross(vec3_sub(mesh_corner(t, 1), mesh_corner(t, 0)),
					       vec3_sub(mesh_corner(t, 2), mesh_corner(t, 0)));

		sum += edge_term(a, b) + edge_term(b, c) + edge_term(c, a);
		volume += vec3_dot(p, normal);
		area += vec3_norm(normal);
	}
	return sum == 0 && fabs(volume) > FLAT * area * vec3_norm(vec3_sub(greatest, least));
}
