/* test_tool_solid.c - tessellated tools against the solids of revolution that they approximate. */
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "base/units.h"
#include "machine/tool_solid.h"
#include "suite.h"

#define SECTIONS_MAX 8

struct tool_case {
	struct tool_section sections[SECTIONS_MAX];
	size_t count;
	double top;
	enum tool_tip tip;
	double angle, corner;	/* degrees, mm */
};

static const struct tool_case cases[] = {
	{{{40, 10, 10}}, 1, 0, TIP_FLAT, 0, 0},
	{{{30, 63, 63}, {35, 40, 32}}, 2, 0, TIP_FLAT, 0, 0},
	{{{40, 10, 10}}, 1, -90, TIP_BALL, 0, 0},
	{{{5, 10, 10}}, 1, -125, TIP_BALL, 0, 0},
	{{{60, 12, 12}}, 1, -70, TIP_CONE, 118, 0},
	{{{20, 6, 6}}, 1, -30, TIP_CONE, 20, 0},
	{{{20, 6, 6}}, 1, -30, TIP_CONE, 178, 0},
	{{{25, 50, 50}}, 1, -100, TIP_BULL, 0, 6},
	{{{25, 50, 50}}, 1, -100, TIP_BULL, 0, 25},
	{{{25, 16, 16}}, 1, -100, TIP_BULL, 0, 0.01},
	/* a point with a long taper; a disc with a sharp rim; grooves of every kind */
	{{{100, 10, 0}}, 1, -50, TIP_FLAT, 0, 0},
	{{{0.5, 10, 80}, {0.5, 80, 10}}, 2, -50, TIP_FLAT, 0, 0},
	{{{5, 40, 20}, {5, 20, 40}}, 2, 0, TIP_FLAT, 0, 0},
	{{{5, 40, 40}, {0.01, 20, 20}, {5, 40, 40}}, 3, 0, TIP_FLAT, 0, 0},
	{{{5, 40, 20}, {5, 30, 35}, {5, 10, 30}, {15, 28, 28}}, 4, 0, TIP_BALL, 0, 0},
	{{{0.01, 40, 0}, {0.01, 0.001, 40}, {0.01, 39.999, 60}}, 3, 0, TIP_FLAT, 0, 0},
	/* the extremes that the reader accepts */
	{{{0.01, 0.001, 0.001}}, 1, 0, TIP_FLAT, 0, 0},
	{{{5000, 5000, 5000}}, 1, 0, TIP_BULL, 0, 20},
	{{{2500, 5000, 0}, {2500, 0.001, 5000}}, 2, 0, TIP_FLAT, 0, 0},
	{{{0.01, 5000, 0.001}, {4999.99, 0.001, 0.001}}, 2, 0, TIP_FLAT, 0, 0},
};

static uint64_t next_random(uint64_t *state)
{
	/* Steele, Lea and Flood, "Fast splittable pseudorandom number generators", 2014. */
	uint64_t z = *state += 0x9e3779b97f4a7c15u;

	z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
	z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
	return z ^ (z >> 31);
}

static double uniform(uint64_t *state)
{
	return (double)(next_random(state) >> 11) * 0x1p-53;
}

/* A convex piece of the half plane of radius and height: a trapezoid, or the lower half of a disc about (r, z). */
struct shape {
	bool disc;
	double r_top, z_top, r_end, z_end;
	double r, z, radius;
};

struct truth {
	struct shape shapes[SECTIONS_MAX + 3];
	size_t count;
};

static struct shape trapezoid(double r_top, double z_top, double r_end, double z_end)
{
	return (struct shape){.r_top = r_top, .z_top = z_top, .r_end = r_end, .z_end = z_end};
}

static void truth_init(struct truth *truth, const struct tool_case *c)
{
	double z = c->top;

	truth->count = 0;
	for (size_t i = 0; i < c->count; i++) {
		double r = c->sections[i].diameter / 2, end = c->sections[i].diameter_end / 2;
		double below = z - c->sections[i].length, corner = c->tip == TIP_BALL ? end : c->corner;

		if (i + 1 < c->count || c->tip == TIP_FLAT) {
			truth->shapes[truth->count++] = trapezoid(r, z, end, below);
		} else if (c->tip == TIP_CONE) {
			double shoulder = below + end / tan(radians(c->angle) / 2);

			truth->shapes[truth->count++] = trapezoid(r, z, r, shoulder);
			truth->shapes[truth->count++] = trapezoid(r, shoulder, 0, below);
		} else {
			truth->shapes[truth->count++] = trapezoid(r, z, r, below + corner);
			truth->shapes[truth->count++] = trapezoid(r - corner, z, r - corner, below);
			truth->shapes[truth->count++] =
				(struct shape){.disc = true, .r = r - corner, .z = below + corner, .radius = corner};
		}
		z = below;
	}
}

static double to_segment(double r, double z, double r0, double z0, double r1, double z1)
{
	double dr = r1 - r0, dz = z1 - z0, length2 = dr * dr + dz * dz;
	double t = length2 > 0 ? ((r - r0) * dr + (z - z0) * dz) / length2 : 0;

	t = fmin(1, fmax(0, t));
	return hypot(r - r0 - t * dr, z - z0 - t * dz);
}

/* The distance from the solid; -1 strictly inside. */
static double distance_to(const struct truth *truth, double r, double z)
{
	double least = INFINITY;

	for (size_t i = 0; i < truth->count; i++) {
		const struct shape *s = &truth->shapes[i];
		double edge;

		if (s->disc) {
			double d = hypot(r - s->r, z - s->z) - s->radius;

			if (z >= s->z)
				continue;
			if (d < 0)
				return -1;
			least = fmin(least, d);
			continue;
		}
		edge = s->z_top > s->z_end
			       ? s->r_end + (s->r_top - s->r_end) * ((z - s->z_end) / (s->z_top - s->z_end))
			       : 0;
		if (z < s->z_top && z > s->z_end && r < edge)
			return -1;
		least = fmin(least, to_segment(r, z, s->r_top, s->z_top, s->r_end, s->z_end));
		least = fmin(least, to_segment(r, z, 0, s->z_top, s->r_top, s->z_top));
		least = fmin(least, to_segment(r, z, 0, s->z_end, s->r_end, s->z_end));
	}
	return least;
}

static struct tool_solid solid_of(const struct tool_case *c)
{
	return (struct tool_solid){.sections = c->sections,
				   .count = c->count,
				   .top = c->top,
				   .tip = c->tip,
				   .angle = radians(c->angle),
				   .corner = c->corner};
}

struct edge {
	float from[3], to[3];
};

static int compare_edges(const void *a, const void *b)
{
	return memcmp(a, b, sizeof(struct edge));
}

/* Each directed edge has exactly one opposite edge; no triangle has two equal corners. */
static void assert_closed(const struct mesh *mesh)
{
	size_t count = 3 * mesh->count, degenerate = 0, twice = 0;
	struct edge *edges = mem_zalloc(count, sizeof(*edges)), *back = mem_zalloc(count, sizeof(*back));

	for (size_t i = 0; i < count; i++) {
		const float *from = mesh->triangles[i / 3].v[i % 3], *to = mesh->triangles[i / 3].v[(i + 1) % 3];

		for (int k = 0; k < 3; k++) {
			/* -0 and 0 are the same coordinate. */
			edges[i].from[k] = back[i].to[k] = from[k] + 0.0f;
			edges[i].to[k] = back[i].from[k] = to[k] + 0.0f;
		}
		degenerate += memcmp(edges[i].from, edges[i].to, sizeof(edges[i].from)) == 0;
	}
	ck_assert_uint_eq(degenerate, 0);
	qsort(edges, count, sizeof(*edges), compare_edges);
	qsort(back, count, sizeof(*back), compare_edges);
	ck_assert_int_eq(memcmp(edges, back, count * sizeof(*edges)), 0);
	for (size_t i = 1; i < count; i++)
		twice += compare_edges(&edges[i - 1], &edges[i]) == 0;
	ck_assert_uint_eq(twice, 0);
	free(edges);
	free(back);
}

/* Every triangle, at sample points given by weights of its corners, is outside the solid and near it. */
static void assert_near(const struct mesh *mesh, const struct truth *truth, int grid)
{
	double nearest = INFINITY, farthest = 0;

	for (size_t i = 0; i < mesh->count; i++) {
		vec3 a = mesh_corner(&mesh->triangles[i], 0), b = mesh_corner(&mesh->triangles[i], 1);
		vec3 c = mesh_corner(&mesh->triangles[i], 2);

		for (int j = 0; j <= grid; j++) {
			for (int k = 0; j + k <= grid; k++) {
				vec3 p = vec3_mad(a, (double)j / grid, vec3_sub(b, a));
				double d;

				p = vec3_mad(p, (double)k / grid, vec3_sub(c, a));
				d = distance_to(truth, hypot(p.x, p.y), p.z);
				nearest = fmin(nearest, d);
				farthest = fmax(farthest, d);
			}
		}
	}
	ck_assert_double_ge(nearest, 0);
	ck_assert_double_le(farthest, TOOL_SOLID_DEVIATION);
}

/* Does the horizontal ray from p along (x, y) cross the triangle? */
static bool crosses(const mesh_triangle *t, vec3 p, vec3 ray)
{
	vec3 a = mesh_corner(t, 0), e = vec3_sub(mesh_corner(t, 1), a), f = vec3_sub(mesh_corner(t, 2), a);
	vec3 h = vec3_cross(ray, f), s = vec3_sub(p, a), q = vec3_cross(s, e);
	double det = vec3_dot(e, h), u, v;

	if (det == 0)
		return false;
	u = vec3_dot(s, h) / det;
	v = vec3_dot(ray, q) / det;
	return u >= 0 && v >= 0 && u + v <= 1 && vec3_dot(f, q) / det > 0;
}

static bool encloses(const struct mesh *mesh, vec3 p, vec3 ray)
{
	size_t count = 0;

	for (size_t i = 0; i < mesh->count; i++) {
		const mesh_triangle *t = &mesh->triangles[i];
		float z0 = t->v[0][2], z1 = t->v[1][2], z2 = t->v[2][2];

		if ((z0 < p.z && z1 < p.z && z2 < p.z) || (z0 > p.z && z1 > p.z && z2 > p.z))
			continue;
		count += crosses(t, p, ray);
	}
	return count % 2 == 1;
}

/* A random point on the outline of a random piece: its side, top or end. */
static void random_point(const struct truth *truth, uint64_t *state, double *r, double *z)
{
	const struct shape *s = &truth->shapes[next_random(state) % truth->count];
	double t = uniform(state), where = uniform(state);

	if (s->disc) {
		*r = s->r + s->radius * sin(t * PI / 2);
		*z = s->z - s->radius * cos(t * PI / 2);
	} else if (where < 0.6) {
		*r = s->r_top + t * (s->r_end - s->r_top);
		*z = s->z_top + t * (s->z_end - s->z_top);
	} else {
		*r = t * (where < 0.8 ? s->r_top : s->r_end);
		*z = where < 0.8 ? s->z_top : s->z_end;
	}
}

static void assert_encloses(const struct mesh *mesh, const struct truth *truth, size_t samples, uint64_t *state)
{
	size_t outside = 0;

	for (size_t i = 0; i < samples; i++) {
		double angle = 2 * PI * uniform(state), r, z;
		vec3 ray = {cos(angle), sin(angle), 0};

		random_point(truth, state, &r, &z);
		outside += !encloses(mesh, (vec3){r * ray.x, r * ray.y, z}, ray);
	}
	ck_assert_uint_eq(outside, 0);
}

static double mesh_volume(const struct mesh *mesh)
{
	double sum = 0;

	for (size_t i = 0; i < mesh->count; i++) {
		const mesh_triangle *t = &mesh->triangles[i];

		sum += vec3_dot(mesh_corner(t, 0), vec3_cross(mesh_corner(t, 1), mesh_corner(t, 2)));
	}
	return sum / 6;
}

/* A point that tool_solid_contains calls inside by the margin is that deep inside the true solid. */
static void assert_contains(const struct tool_solid *solid, const struct truth *truth, size_t samples, uint64_t *state)
{
	const double margin = 0.05;

	for (size_t i = 0; i < samples; i++) {
		double angle = 2 * PI * uniform(state), r, z;

		random_point(truth, state, &r, &z);
		r = fmax(0, r + 4 * margin * (uniform(state) - 0.8));
		z += 4 * margin * (uniform(state) - 0.5);
		if (!tool_solid_contains(solid, (vec3){r * cos(angle), r * sin(angle), z}, margin))
			continue;
		ck_assert(distance_to(truth, r, z) < 0 && distance_to(truth, r + 0.9 * margin, z) < 0);
		ck_assert(distance_to(truth, r, z + 0.9 * margin) < 0 || distance_to(truth, r, z - 0.9 * margin) < 0);
	}
}

/* The coarse mesh is closed and contains the solid, and its rings are less than a tenth larger. */
static void assert_coarse(const struct tool_solid *solid, const struct truth *truth, size_t samples, uint64_t *state)
{
	struct arena arena = {0};
	struct mesh mesh;
	double largest = 0;

	tool_solid_coarse_mesh(solid, &arena, &mesh);
	assert_closed(&mesh);
	assert_encloses(&mesh, truth, samples, state);
	for (size_t i = 0; i < solid->count; i++)
		largest = fmax(largest, fmax(solid->sections[i].diameter, solid->sections[i].diameter_end) / 2);
	for (size_t i = 0; i < 3 * mesh.count; i++) {
		vec3 p = mesh_corner(&mesh.triangles[i / 3], (int)(i % 3));

		ck_assert(hypot(p.x, p.y) < 1.1 * largest + TOOL_SOLID_DEVIATION);
	}
	arena_release(&arena);
}

static void assert_all(const struct tool_case *c, int grid, size_t samples, uint64_t *state)
{
	struct tool_solid solid = solid_of(c);
	struct arena arena = {0};
	struct truth truth;
	struct mesh mesh;

	truth_init(&truth, c);
	tool_solid_mesh(&solid, &arena, &mesh);
	ck_assert_uint_eq(mesh.count, tool_solid_triangles(&solid));
	ck_assert_double_eq(mesh.rounding, 0);
	assert_closed(&mesh);
	assert_near(&mesh, &truth, grid);
	assert_encloses(&mesh, &truth, samples, state);
	assert_coarse(&solid, &truth, samples, state);
	assert_contains(&solid, &truth, samples, state);
	arena_release(&arena);
}

START_TEST(encloses_and_is_near)
{
	uint64_t state = (uint64_t)_i;

	assert_all(&cases[_i], 4, 300, &state);
}
END_TEST

static double log_uniform(uint64_t *state, double least, double most)
{
	return least * pow(most / least, uniform(state));
}

static struct tool_case random_case(uint64_t *state)
{
	struct tool_case c = {.count = 1 + next_random(state) % 5, .tip = next_random(state) % 4};
	double size = log_uniform(state, 0.1, 1000), r;
	struct tool_section *last = &c.sections[c.count - 1];

	for (size_t i = 0; i < c.count; i++) {
		struct tool_section *s = &c.sections[i];

		s->length = fmax(TOOL_SECTION_MIN, log_uniform(state, size / 1000, size / (double)c.count));
		s->diameter = fmax(TOOL_DIAMETER_MIN, log_uniform(state, size / 1000, size));
		s->diameter_end = s->diameter;
		if (next_random(state) % 2)
			s->diameter_end = next_random(state) % 4 ? log_uniform(state, size / 100, size) : 0;
		if (i > 0 && next_random(state) % 3 == 0 && c.sections[i - 1].diameter_end > 0)
			s->diameter = c.sections[i - 1].diameter_end;
	}
	if (c.tip == TIP_FLAT)
		return c;
	last->diameter_end = last->diameter;
	r = last->diameter / 2;
	c.corner = r * fmax(0.001, uniform(state));
	c.angle = 2 + 175 * uniform(state);
	last->length = fmax(TOOL_SECTION_MIN, uniform(state) * r) +
		       (c.tip == TIP_BALL ? r : c.tip == TIP_BULL ? c.corner : r / tan(radians(c.angle) / 2));
	if (last->length > TOOL_SIZE_MAX / 2)
		c.tip = TIP_FLAT;
	return c;
}

START_TEST(random_tools)
{
	uint64_t state = 2026;

	for (int i = 0; i < 60; i++) {
		struct tool_case c = random_case(&state);

		assert_all(&c, 2, 50, &state);
	}
}
END_TEST

static double frustum_volume(double d0, double d1, double h)
{
	return PI * h / 12 * (d0 * d0 + d0 * d1 + d1 * d1);
}

/* The volume is between the closed form and the closed form plus a skin of the permitted thickness. */
static void assert_volume(const struct tool_case *c, double volume, double surface)
{
	struct tool_solid solid = solid_of(c);
	struct arena arena = {0};
	struct mesh mesh;
	double measured;

	tool_solid_mesh(&solid, &arena, &mesh);
	measured = mesh_volume(&mesh);
	ck_assert_double_gt(measured, volume);
	ck_assert_double_lt(measured, volume + 1.01 * TOOL_SOLID_DEVIATION * surface);
	arena_release(&arena);
}

START_TEST(volumes)
{
	const double cylinder = PI * 25 * 40, r = 25, k = 6;

	assert_volume(&cases[0], cylinder, 2 * PI * 25 + PI * 10 * 40);
	assert_volume(&cases[1], PI * 31.5 * 31.5 * 30 + frustum_volume(40, 32, 35),
		      2 * PI * 31.5 * 31.5 + PI * 63 * 30 + PI * 36 * hypot(35, 4));
	assert_volume(&cases[2], PI * 25 * 35 + 2.0 / 3 * PI * 125, PI * 25 + PI * 10 * 35 + 2 * PI * 25);
	assert_volume(&cases[4], PI * 36 * 60 - 2.0 / 3 * PI * 36 * 6 / tan(radians(59)),
		      PI * 36 + PI * 12 * 60 + PI * 36 / sin(radians(59)));
	/*
	 * A cylinder of the full radius; below it an inner cylinder, a quarter of a torus around that (Pappus), and the
	 * rest, as much as half a ball.
	 */
	assert_volume(&cases[7],
		      PI * r * r * (25 - k) + PI * (r - k) * (r - k) * k + PI * PI * k * k * (r - k) / 2 +
			      2.0 / 3 * PI * k * k * k,
		      2 * PI * r * r + 2 * PI * r * 25);
}
END_TEST

/* No facets are wasted: the permitted deviation is used. */
START_TEST(is_not_finer_than_needed)
{
	struct tool_solid flat = solid_of(&cases[0]), ball = solid_of(&cases[2]);
	struct arena arena = {0};
	struct mesh mesh;

	tool_solid_mesh(&flat, &arena, &mesh);
	ck_assert_uint_le(mesh.count, 4 * 54);
	tool_solid_mesh(&ball, &arena, &mesh);
	ck_assert_uint_le(mesh.count, 4000);
	arena_release(&arena);
}
END_TEST

START_TEST(contains_its_middle)
{
	const struct tool_section sections[] = {{10, 20, 20}, {20, 20, 8}};
	const struct tool_solid solid = {.sections = sections, .count = 2, .top = 5, .tip = TIP_FLAT};

	ck_assert(tool_solid_contains(&solid, (vec3){9.9, 0, 0}, 0.05));
	ck_assert(!tool_solid_contains(&solid, (vec3){9.96, 0, 0}, 0.05));
	ck_assert(!tool_solid_contains(&solid, (vec3){0, 0, 4.96}, 0.05));
	ck_assert(tool_solid_contains(&solid, (vec3){0, 6.9, -15}, 0.05));
	ck_assert(!tool_solid_contains(&solid, (vec3){0, 7.1, -15}, 0.05));
	ck_assert(!tool_solid_contains(&solid, (vec3){0, 0, -24.96}, 0.05));
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("tool_solid");

	tcase_add_loop_test(tcase, encloses_and_is_near, 0, COUNT(cases));
	tcase_add_test(tcase, random_tools);
	tcase_add_test(tcase, volumes);
	tcase_add_test(tcase, is_not_finer_than_needed);
	tcase_add_test(tcase, contains_its_middle);
	return run_suite("tool_solid", tcase);
}
