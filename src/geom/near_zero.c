#include "geom/near_zero.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "base/minmax.h"
#include "geom/edge_balance.h"

/* Coordinates up to this share of the largest one may be roundings of 0. */
#define SHARE (2 * FLT_EPSILON)

#define SIGN_BIT UINT32_C(0x80000000)

static inline uint32_t bits_of(float number)
{
	uint32_t bits;

	memcpy(&bits, &number, sizeof(bits));
	return bits;
}

static inline float float_of(uint32_t bits)
{
	float number;

	memcpy(&number, &bits, sizeof(number));
	return number;
}

/* The coordinates that may be roundings of 0 are at most this large, mm; 0: there are none but 0 itself. */
static float near_of(const struct mesh *mesh)
{
	/* The bits of floats without their signs are in the order of the floats. */
	uint32_t largest = 0, below_least = UINT32_MAX;
	float near;

	for (size_t i = 0; i < mesh->count; i++) {
		for (int k = 0; k < 9; k++) {
			const uint32_t size = bits_of(mesh->triangles[i].v[k / 3][k % 3]) & ~SIGN_BIT;

			largest = size > largest ? size : largest;
			/* 0 becomes the largest number. */
			below_least = size - 1 < below_least ? size - 1 : below_least;
		}
	}
	near = SHARE * float_of(largest);
	return below_least < bits_of(near) ? near : 0;
}

/* Returns the largest change of a coordinate, mm. */
static double set_to_zero(struct mesh *mesh, float near)
{
	double most = 0;

	for (size_t i = 0; i < mesh->count; i++) {
		float *v = &mesh->triangles[i].v[0][0];

		for (int k = 0; k < 9; k++) {
			if (!(fabsf(v[k]) <= near))
				continue;
			most = larger(most, fabs((double)v[k]));
			v[k] = 0;
		}
	}
	return most;
}

void near_zero_close(struct mesh *mesh)
{
	const float near = near_of(mesh);
	struct mesh closed = *mesh;
	double most;

	if (!(near > 0) || edge_balance_near_zero(mesh, near))
		return;
	closed.triangles = mem_alloc(mesh->count * sizeof(*closed.triangles));
	memcpy(closed.triangles, mesh->triangles, mesh->count * sizeof(*closed.triangles));
	most = set_to_zero(&closed, near);
	if (!edge_balance_is_closed(&closed)) {
		mesh_release(&closed);
		return;
	}
	free(mesh->triangles);
	*mesh = closed;
	/* A corner has moved by at most sqrt(3) times as much. */
	mesh->rounding += 1.8 * most;
}
