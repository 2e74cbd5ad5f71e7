/* test_report_turned.c - tools in a report are recognised as bodies of revolution, and no other body is. */
#include <math.h>
#include <stdlib.h>

#include "base/arena.h"
#include "base/mem.h"
#include "base/units.h"
#include "geom/mesh.h"
#include "machine/tool_solid.h"
#include "report/html/turned.h"

#include "random.h"
#include "suite.h"

static void make_tool(struct arena *arena, enum tool_tip tip, struct mesh *mesh)
{
	static const struct tool_section sections[] = {{30, 63, 63}, {35, 40, 32}, {0.5, 32, 50}, {20, 16, 16}};
	const struct tool_solid solid = {sections, 4, -50, tip, 2.0, 3};

	tool_solid_mesh(&solid, arena, mesh);
}

/* The distance of the point from the nearest vertex of a ring, or centre of a cap. */
static double from_rings(const struct turned *turned, const vec3 *circle, const float p[3])
{
	const double x = (double)p[0], y = (double)p[1], z = (double)p[2];
	const double bottom = z - turned->corners[0].z, top = z - turned->corners[turned->count - 1].z;
	double best = x * x + y * y + fmin(bottom * bottom, top * top);

	for (size_t i = 0; i < turned->count; i++) {
		const double r = turned->corners[i].r, dz = z - turned->corners[i].z;

		for (size_t k = 0; k < turned->facets; k++) {
			const double dx = x - r * circle[k].x, dy = y - r * circle[k].y;

			best = fmin(best, dx * dx + dy * dy + dz * dz);
		}
	}
	return sqrt(best);
}

START_TEST(tools_are_told_by_their_outline)
{
	struct arena arena = {0};
	struct turned turned;
	struct mesh mesh;
	vec3 *circle;

	make_tool(&arena, (enum tool_tip)_i, &mesh);
	ck_assert(turned_init(&turned, &mesh));
	circle = mem_alloc(turned.facets * sizeof(*circle));
	for (size_t k = 0; k < turned.facets; k++) {
		const double a = 2 * PI * (double)k / (double)turned.facets;

		circle[k] = (vec3){cos(a), sin(a), 0};
	}
	for (size_t i = 0; i < 3 * mesh.count; i++)
		ck_assert_double_le(from_rings(&turned, circle, mesh.triangles[i / 3].v[i % 3]), TURNED_ERROR);
	free(circle);
	turned_release(&turned);
	/* A body that lacks a triangle, or has a corner at another place, is no body of revolution. */
	mesh.count--;
	ck_assert(!turned_init(&turned, &mesh));
	mesh.count++;
	mesh.triangles[mesh.count / 2].v[0][0] += 0.01F;
	ck_assert(!turned_init(&turned, &mesh));
	arena_release(&arena);
}
END_TEST

START_TEST(other_meshes_are_no_turned_bodies)
{
	struct random random = random_case(7, 0);
	struct mesh mesh = {.triangles = mem_zalloc(288, sizeof(mesh_triangle)), .count = 288};
	struct turned turned;

	for (size_t i = 0; i < 9 * mesh.count; i++)
		mesh.triangles[i / 9].v[i % 9 / 3][i % 3] = (float)random_in(&random, -50, 50);
	ck_assert(!turned_init(&turned, &mesh));
	mesh.count = 0;
	ck_assert(!turned_init(&turned, &mesh));
	mesh_release(&mesh);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("report_turned");

	tcase_add_loop_test(tcase, tools_are_told_by_their_outline, TIP_FLAT, TIP_BULL + 1);
	tcase_add_test(tcase, other_meshes_are_no_turned_bodies);
	return run_suite("report_turned", tcase);
}
