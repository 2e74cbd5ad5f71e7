#include "geom/nesting.h"

#include <stdlib.h>

#include "base/mem.h"
#include "geom/inside.h"

/* Solid angles that are computed within a second. */
static const double AFFORDABLE = 3e7;

/* Six times the volume under the triangle, as seen from `from`. */
static double volume_below(const mesh_triangle *t, vec3 from)
{
	return vec3_dot(vec3_sub(mesh_corner(t, 0), from),
			vec3_cross(vec3_sub(mesh_corner(t, 1), from), vec3_sub(mesh_corner(t, 2), from)));
}

static void judge(struct nesting *nesting, double volume, int winding)
{
	if (winding == 0)
		nesting->inverted += volume < 0;
	else
		nesting->nested += volume > 0 ? winding > 0 : winding < 0;
}

void nesting_find(struct nesting *nesting, const struct mesh *mesh, const struct topology *topology)
{
	double *volume = mem_zalloc(topology->component_count, sizeof(*volume));
	bool affordable = (double)mesh->count * (double)topology->component_count < AFFORDABLE;

	*nesting = (struct nesting){0};
	for (size_t t = 0; t < mesh->count; t++) {
		uint32_t shell = topology->shell_of ? topology->shell_of[t] : 0;

		if (shell != NO_SHELL)
			volume[shell / 2] += volume_below(&mesh->triangles[t], topology->witness[shell / 2]);
	}
	for (uint32_t c = 0; c < topology->component_count; c++) {
		if (topology->shells && topology->shells[2 * c].kind != SHELL_ORIENTED)
			continue;
		judge(nesting, volume[c],
		      topology->shells && affordable ? mesh_winding_around(mesh, topology, 2 * c) : 0);
	}
	free(volume);
}
