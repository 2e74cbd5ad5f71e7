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
	*least = *greatest = mesh_corner(&mesh->triangles[0], 0);
	for (size_t i = 0; i < mesh->count; i++) {
		for (int k = 0; k < 3; k++) {
			vec3 p = mesh_corner(&mesh->triangles[i], k);

			*least = vec3_min(*least, p);
			*greatest = vec3_max(*greatest, p);
		}
	}
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
	/* Each coordinate is off by half a unit in its last place, a point by sqrt(3) of it. */
	mesh->rounding = mesh->rounding * fabs(factor) + 1.8 * 0.5 * (double)FLT_EPSILON * largest;
}
