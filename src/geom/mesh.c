#include "geom/mesh.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

void mesh_release(struct mesh *mesh)
{
	free(mesh->triangles);
	*mesh = (struct mesh){0};
}

void mesh_bounds(const struct mesh *mesh, vec3 *least, vec3 *greatest)
{
	const float *first = mesh->triangles[0].v[0];
	float low[3] = {first[0], first[1], first[2]}, high[3] = {first[0], first[1], first[2]};

	for (size_t i = 0; i < mesh->count; i++) {
		for (int k = 0; k < 3; k++) {
			for (int axis = 0; axis < 3; axis++) {
				float value = mesh->triangles[i].v[k][axis];

				low[axis] = value < low[axis] ? value : low[axis];
				high[axis] = value > high[axis] ? value : high[axis];
			}
		}
	}
	*least = (vec3){low[0], low[1], low[2]};
	*greatest = (vec3){high[0], high[1], high[2]};
}

void mesh_scale(struct mesh *mesh, double factor)
{
	double largest = 0;

	for (size_t i = 0; i < mesh->count; i++) {
		float *v = &mesh->triangles[i].v[0][0];

		for (int k = 0; k < 9; k++) {
			double scaled = v[k] * factor;

			v[k] = (float)scaled;
			largest = fmax(largest, fabs(scaled));
		}
	}
	/* The error of each coordinate is half a unit in its last place, that of a point sqrt(3) times as large. */
	mesh->rounding = mesh->rounding * fabs(factor) + 1.8 * 0.5 * (double)FLT_EPSILON * largest;
}
