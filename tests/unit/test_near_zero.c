/* test_near_zero.c - cylinders drawn with the sines of two pi, closed and with a triangle missing. */
#include "geom/near_zero.h"

#include <math.h>
#include <string.h>

#include "base/mem.h"
#include "base/units.h"
#include "geom/edge_balance.h"
#include "solids.h"
#include "suite.h"

typedef vec3 rim_fn(double radius, double angle, double height);

static vec3 in_double(double radius, double angle, double height)
{
	return (vec3){radius * cos(angle), radius * sin(angle), height};
}

static vec3 in_float(double radius, double angle, double height)
{
	return (vec3){(float)radius * cosf((float)angle), (float)radius * sinf((float)angle), height};
}

/* Each side computes its own corners: the last one ends at 2 pi, where the first one begins at 0. */
static struct mesh cylinder(rim_fn *rim, double radius, int sides, bool whole)
{
	struct mesh mesh = {0};

	for (int i = 0; i < sides; i++) {
		const double from = 2 * PI * i / sides, to = 2 * PI * (i + 1) / sides;
		const vec3 a = rim(radius, from, 0), b = rim(radius, to, 0), c = rim(radius, to, 10), d = rim(radius, from, 10);

		solid_quad(&mesh, a, b, c, d);
		solid_add(&mesh, (vec3){0, 0, 10}, d, c);
		if (whole || i)
			solid_add(&mesh, (vec3){0, 0, 0}, b, a);
	}
	return mesh;
}

static struct mesh copy_of(const struct mesh *mesh)
{
	struct mesh copy = *mesh;

	copy.triangles = mem_alloc(mesh->count * sizeof(*copy.triangles));
	memcpy(copy.triangles, mesh->triangles, mesh->count * sizeof(*copy.triangles));
	return copy;
}

/* mm: the largest distance of a corner from the same one in the other mesh. */
static double moved(const struct mesh *mesh, const struct mesh *other)
{
	double most = 0;

	for (size_t i = 0; i < mesh->count; i++)
		for (int k = 0; k < 3; k++)
			most = fmax(most, vec3_norm(vec3_sub(mesh_corner(&mesh->triangles[i], k),
							     mesh_corner(&other->triangles[i], k))));
	return most;
}

static rim_fn *const rims[] = {in_double, in_float};

START_TEST(a_cylinder_closes_at_two_pi)
{
	for (int i = 0; i < 2; i++) {
		for (double radius = 1e-3; radius < 1e5; radius *= 10) {
			for (int sides = 3; sides < 40; sides += 4) {
				struct mesh mesh = cylinder(rims[i], radius, sides, true), drawn = copy_of(&mesh);

				ck_assert(!edge_balance_is_closed(&drawn));
				near_zero_close(&mesh);
				ck_assert(edge_balance_is_closed(&mesh));
				ck_assert(mesh.rounding >= moved(&mesh, &drawn) && mesh.rounding < 1e-6 * (radius + 10));
				mesh_release(&mesh);
				mesh_release(&drawn);
			}
		}
	}
}
END_TEST

START_TEST(an_open_mesh_stays_as_it_is)
{
	for (int i = 0; i < 2; i++) {
		struct mesh mesh = cylinder(rims[i], 50, 12, false), drawn = copy_of(&mesh);

		near_zero_close(&mesh);
		ck_assert(!memcmp(mesh.triangles, drawn.triangles, mesh.count * sizeof(*mesh.triangles)));
		ck_assert(!(mesh.rounding > 0));
		mesh_release(&mesh);
		mesh_release(&drawn);
	}
}
END_TEST

START_TEST(a_closed_mesh_stays_as_it_is)
{
	struct mesh mesh = {0}, drawn;

	solid_box(&mesh, (vec3){50, 50, 50});
	for (size_t i = 0; i < mesh.count; i++)
		for (int k = 0; k < 3; k++)
			mesh.triangles[i].v[k][2] = mesh.triangles[i].v[k][2] > 0 ? 50 : 1e-7F;
	drawn = copy_of(&mesh);
	near_zero_close(&mesh);
	ck_assert(!memcmp(mesh.triangles, drawn.triangles, mesh.count * sizeof(*mesh.triangles)));
	ck_assert(!(mesh.rounding > 0));
	mesh_release(&mesh);
	mesh_release(&drawn);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("near zero");

	tcase_add_test(tcase, a_cylinder_closes_at_two_pi);
	tcase_add_test(tcase, an_open_mesh_stays_as_it_is);
	tcase_add_test(tcase, a_closed_mesh_stays_as_it_is);
	return run_suite("near_zero", tcase);
}
