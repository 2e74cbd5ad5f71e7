#include "import/mesh_build.h"

#include <math.h>

#include "base/math/math_functions.h"
#include "base/mem.h"

/* mm: meshes farther away than this are drawn in another unit than given. The same limit holds for XML files. */
#define COORDINATE_MAX 1e7
/* mm: the largest deviation of facets from the round solid that they enclose. */
#define FACET_DEVIATION 0.01
enum { FACETS_MIN = 24, FACETS_MAX = 4096 };

bool mesh_build_add(struct mesh_build *build, const vec3 corners[3])
{
	struct mesh *mesh = &build->mesh;
	mesh_triangle t;

	for (int i = 0; i < 3; i++) {
		const double p[3] = {build->scale * corners[i].x, build->scale * corners[i].y,
				     build->scale * corners[i].z};

		for (int k = 0; k < 3; k++) {
			if (!(fabs(p[k]) <= COORDINATE_MAX))
				return false;
			t.v[i][k] = (float)p[k];
		}
	}
	mesh->triangles = mem_grow(mesh->triangles, &build->capacity, mesh->count + 1, sizeof(*mesh->triangles));
	mesh->triangles[mesh->count++] = t;
	return true;
}

void mesh_build_finish(struct mesh_build *build, struct mesh *out)
{
	*out = build->mesh;
	*build = (struct mesh_build){.scale = build->scale};
}

void mesh_build_discard(struct mesh_build *build)
{
	mesh_release(&build->mesh);
	build->capacity = 0;
}

static void add_quad(struct mesh_build *build, vec3 a, vec3 b, vec3 c, vec3 d)
{
	const vec3 first[3] = {a, b, c}, second[3] = {a, c, d};

	mesh_build_add(build, first);
	mesh_build_add(build, second);
}

/* Is the size of the solid within the limit? A triangle that is left out would be a hole in it. */
static bool is_within(const struct mesh_build *build, double size)
{
	return build->scale * size <= COORDINATE_MAX / 2;
}

bool mesh_build_block(struct mesh_build *build, vec3 size)
{
	vec3 p[8];

	if (!is_within(build, size.x) || !is_within(build, size.y) || !is_within(build, size.z))
		return false;
	for (int i = 0; i < 8; i++)
		p[i] = (vec3){i & 1 ? size.x : 0, i & 2 ? size.y : 0, i & 4 ? size.z : 0};
	add_quad(build, p[0], p[2], p[3], p[1]);
	add_quad(build, p[4], p[5], p[7], p[6]);
	add_quad(build, p[0], p[1], p[5], p[4]);
	add_quad(build, p[2], p[6], p[7], p[3]);
	add_quad(build, p[0], p[4], p[6], p[2]);
	add_quad(build, p[1], p[3], p[7], p[5]);
	return true;
}

/*
 * The number of facets for which a circle's circumscribed polygon deviates by at most the deviation: r (1 / cos(pi / n)
 * - 1).
 */
static int facets_of(double radius)
{
	const double pi = math_acos(-1);

	for (int n = FACETS_MIN; n < FACETS_MAX; n *= 2)
		if (radius * (1 / math_cos(pi / n) - 1) <= FACET_DEVIATION)
			return n;
	return FACETS_MAX;
}

bool mesh_build_frustum(struct mesh_build *build, double radius, double radius_end, double height)
{
	const bool good = is_within(build, radius) && is_within(build, radius_end) && is_within(build, height);
	const int n = good ? facets_of(fmax(radius, radius_end)) : FACETS_MIN;
	const double step = 2 * math_acos(-1) / n, outer = 1 / math_cos(step / 2);

	for (int i = 0; good && i < n; i++) {
		/*
		 * The last facet ends exactly at the corner where the first one begins: otherwise the mesh would be
		 * open there.
		 */
		const double a = step * i, b = step * ((i + 1) % n);
		const vec3 from = {outer * math_cos(a), outer * math_sin(a), 0},
			   to = {outer * math_cos(b), outer * math_sin(b), 0};
		const vec3 top = {0, 0, height}, middle = {0, 0, 0};
		const vec3 low[3] = {middle, vec3_scale(radius, to), vec3_scale(radius, from)};
		const vec3 high[3] = {top, vec3_mad(top, radius_end, from), vec3_mad(top, radius_end, to)};

		const vec3 side[3] = {low[2], low[1], high[2]}, other[3] = {low[2], high[2], high[1]};

		/* An end of radius 0 is a point: a triangle with this point twice is left out. */
		if (radius > 0) {
			mesh_build_add(build, low);
			mesh_build_add(build, side);
		}
		if (radius_end > 0) {
			mesh_build_add(build, high);
			mesh_build_add(build, other);
		}
	}
	return good;
}
