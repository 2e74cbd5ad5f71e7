#include "geom/nesting.h"

#include <math.h>
#include <stdlib.h>

#include "base/mem.h"
#include "geom/inside.h"

/*
 * A shell inside another one is reported if its volume is more than this share of the other's. Drawings have many bolts
 * and bosses inside the parts to which they are fixed, but cavities are larger.
 */
static const double VOLUME_SHARE = 0.4;

/* The largest number of shells that are compared in pairs: this takes a few milliseconds. */
enum { SHELLS_MOST = 2000 };

/* Six times the volume under the triangle, as seen from `from`. */
static double volume_below(const mesh_triangle *t, vec3 from)
{
	return vec3_dot(vec3_sub(mesh_corner(t, 0), from),
			vec3_cross(vec3_sub(mesh_corner(t, 1), from), vec3_sub(mesh_corner(t, 2), from)));
}

static bool is_within(const struct shell *inner, const struct shell *outer)
{
	return inner->least.x > outer->least.x && inner->least.y > outer->least.y && inner->least.z > outer->least.z &&
	       inner->greatest.x < outer->greatest.x && inner->greatest.y < outer->greatest.y &&
	       inner->greatest.z < outer->greatest.z;
}

/* The winding number of large shells around component c. */
static int winding_around(const struct mesh *mesh, const struct topology *topology, const double *volume, size_t c)
{
	int winding = 0;

	for (size_t o = 0; o < topology->component_count; o++) {
		const struct shell *outer = &topology->shells[2 * o];

		if (o != c && outer->kind == SHELL_ORIENTED && fabs(volume[c]) > VOLUME_SHARE * fabs(volume[o]) &&
		    is_within(&topology->shells[2 * c], outer))
			winding +=
			    shell_winding_number(mesh, topology, (uint32_t)(2 * o), topology->component_point[c]);
	}
	return winding;
}

void nesting_find(struct nesting *nesting, const struct mesh *mesh, const struct topology *topology)
{
	double *volume = mem_zalloc(topology->component_count, sizeof(*volume));
	bool compare = topology->shells && topology->component_count <= SHELLS_MOST;

	*nesting = (struct nesting){0};
	for (size_t t = 0; t < mesh->count; t++) {
		uint32_t shell = topology->shell_of ? topology->shell_of[t] : 0;

		if (shell != NO_SHELL && shell % 2 == 0)
			volume[shell / 2] += volume_below(&mesh->triangles[t], topology->component_point[shell / 2]);
	}
	for (size_t c = 0; c < topology->component_count; c++) {
		bool oriented = topology->shells ? topology->shells[2 * c].kind == SHELL_ORIENTED : topology->closed;
		int winding = oriented && compare ? winding_around(mesh, topology, volume, c) : 0;

		if (oriented && winding == 0)
			nesting->inverted += volume[c] < 0;
		else if (oriented)
			nesting->nested += (volume[c] > 0) == (winding > 0);
	}
	free(volume);
}
