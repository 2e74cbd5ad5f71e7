/*
 * test_topology.c - components, edges and winding numbers against known solids, comparison of all pairs, and crossed
 * rays.
 */
#include "geom/inside.h"

#include <math.h>

#include "base/mem.h"
#include "geom/edge_balance.h"
#include "suite.h"

static uint64_t random_bits(uint64_t *state)
{
	*state ^= *state << 13;
	*state ^= *state >> 7;
	*state ^= *state << 17;
	return *state;
}

/* In [0, 1). */
static double random_unit(uint64_t *state)
{
	return (double)(random_bits(state) >> 11) * 0x1p-53;
}

static void add_triangle(struct mesh *mesh, vec3 a, vec3 b, vec3 c)
{
	const vec3 corners[3] = {a, b, c};
	mesh_triangle *t;

	mesh->triangles = mem_realloc(mesh->triangles, mesh->count + 1, sizeof(*t));
	t = &mesh->triangles[mesh->count++];
	for (int k = 0; k < 3; k++) {
		t->v[k][0] = (float)corners[k].x;
		t->v[k][1] = (float)corners[k].y;
		t->v[k][2] = (float)corners[k].z;
	}
}

/* Counter-clockwise as seen from outside; size < 0 turns the cube inside out. */
static void add_cube(struct mesh *mesh, vec3 least, double size)
{
	static const int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
					{2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
	vec3 p[8];

	for (int k = 0; k < 8; k++)
		p[k] = vec3_add(least, vec3_scale(size, (vec3){k & 1, k >> 1 & 1, k >> 2}));
	for (int f = 0; f < 6; f++) {
		add_triangle(mesh, p[faces[f][0]], p[faces[f][1]], p[faces[f][2]]);
		add_triangle(mesh, p[faces[f][0]], p[faces[f][2]], p[faces[f][3]]);
	}
}

static void flip(mesh_triangle *t)
{
	for (int k = 0; k < 3; k++) {
		float swap = t->v[1][k];

		t->v[1][k] = t->v[2][k];
		t->v[2][k] = swap;
	}
}

static void expect(const struct mesh *mesh, size_t components, size_t open, size_t flipped, size_t degenerate)
{
	struct topology t;

	topology_init(&t, mesh);
	ck_assert_uint_eq(t.component_count, components);
	ck_assert_uint_eq(t.open_edges, open);
	ck_assert_uint_eq(t.flipped_edges, flipped);
	ck_assert_uint_eq(t.degenerate, degenerate);
	ck_assert_int_eq(t.closed, open == 0);
	topology_release(&t);
	ck_assert_ptr_null(t.component_point);
}

START_TEST(cubes)
{
	struct mesh mesh = {0};
	struct topology t;

	add_cube(&mesh, (vec3){-1, -1, -1}, 2);
	expect(&mesh, 1, 0, 0, 0);
	ck_assert_int_eq(mesh_winding_number(&mesh, (vec3){0.5, 0.9, -0.99}), 1);
	ck_assert_int_eq(mesh_winding_number(&mesh, (vec3){0.5, 0.9, -1.01}), 0);

	/* A cavity: its cube is inside out. */
	add_cube(&mesh, (vec3){0.5, 0.5, 0.5}, -1);
	expect(&mesh, 2, 0, 0, 0);
	ck_assert_int_eq(mesh_winding_number(&mesh, (vec3){0, 0.1, 0.2}), 0);
	ck_assert_int_eq(mesh_winding_number(&mesh, (vec3){0, 0.1, 0.7}), 1);

	/* A second solid overlaps the first one: both count. */
	add_cube(&mesh, (vec3){0.75, -4, -4}, 8);
	expect(&mesh, 3, 0, 0, 0);
	ck_assert_int_eq(mesh_winding_number(&mesh, (vec3){0.9, 0.1, 0.2}), 2);
	ck_assert_int_eq(mesh_winding_number(&mesh, (vec3){3, 3, 3}), 1);
	ck_assert_int_eq(mesh_winding_number(&mesh, (vec3){-3, 3, 3}), 0);

	topology_init(&t, &mesh);
	for (int c = 0; c < 3; c++) {
		vec3 first = mesh_corner(&mesh.triangles[12 * c], 0);

		ck_assert_double_le(vec3_norm(vec3_sub(t.component_point[c], first)), 0);
	}
	topology_release(&t);
	mesh_release(&mesh);
}
END_TEST

START_TEST(cubes_that_share)
{
	struct mesh mesh = {0};

	/* A common edge: four triangles meet there, two in each direction, so the mesh is closed. */
	add_cube(&mesh, (vec3){0, 0, 0}, 1);
	add_cube(&mesh, (vec3){1, 1, 0}, 1);
	expect(&mesh, 1, 0, 0, 0);
	mesh.count = 12;
	/* Only one common corner. */
	add_cube(&mesh, (vec3){1, 1, 1}, 1);
	expect(&mesh, 1, 0, 0, 0);
	mesh.count = 12;
	/* Every triangle twice: closed, and the inside counts twice. */
	add_cube(&mesh, (vec3){0, 0, 0}, 1);
	expect(&mesh, 1, 0, 0, 0);
	ck_assert_int_eq(mesh_winding_number(&mesh, (vec3){0.5, 0.4, 0.3}), 2);
	/* One triangle twice: the sides of its second copy have no partners. */
	mesh.count = 13;
	expect(&mesh, 1, 3, 3, 0);
	mesh_release(&mesh);
}
END_TEST

START_TEST(minus_zero_is_zero)
{
	struct mesh mesh = {0};

	add_cube(&mesh, (vec3){0, 0, 0}, 1);
	for (size_t i = 0; i < mesh.count; i += 2) {
		for (int k = 0; k < 9; k++) {
			float *c = &mesh.triangles[i].v[k / 3][k % 3];

			*c = *c > 0 ? *c : -0.0f;
		}
	}
	expect(&mesh, 1, 0, 0, 0);
	mesh_release(&mesh);
}
END_TEST

START_TEST(broken_cubes)
{
	struct mesh mesh = {0};

	add_cube(&mesh, (vec3){0, 0, 0}, 1);
	/* The open box: two triangles less, four sides without a partner. */
	mesh.count = 10;
	expect(&mesh, 1, 4, 0, 0);
	mesh.count = 11;
	expect(&mesh, 1, 3, 0, 0);
	/* A flipped triangle runs in the direction of each of its three neighbours: six sides without a partner. */
	mesh.count = 12;
	flip(&mesh.triangles[5]);
	expect(&mesh, 1, 6, 6, 0);
	flip(&mesh.triangles[5]);
	/* Degenerate triangles are counted and change nothing else. */
	add_triangle(&mesh, (vec3){0, 0, 0}, (vec3){1, 0, 0}, (vec3){0, 0, 0});
	add_triangle(&mesh, (vec3){1, 1, 1}, (vec3){1, 1, 1}, (vec3){1, 1, 1});
	expect(&mesh, 1, 0, 0, 2);
	/* They can join components, and can be a component. */
	add_triangle(&mesh, (vec3){5, 5, 5}, (vec3){5, 5, 5}, (vec3){5, 5, 5});
	expect(&mesh, 2, 0, 0, 3);
	add_triangle(&mesh, (vec3){5, 5, 5}, (vec3){1, 1, 1}, (vec3){5, 5, 5});
	expect(&mesh, 1, 0, 0, 4);
	mesh_release(&mesh);
}
END_TEST

START_TEST(moebius_strip)
{
	enum { STEPS = 24 };
	vec3 p[STEPS + 1][2];
	struct mesh mesh = {0};

	for (int i = 0; i < STEPS; i++) {
		for (int side = 0; side < 2; side++) {
			double turn = 6.283185307179586 * i / STEPS, width = side ? 0.3 : -0.3;
			double r = 1 + width * cos(turn / 2);

			p[i][side] = (vec3){r * cos(turn), r * sin(turn), width * sin(turn / 2)};
		}
	}
	p[STEPS][0] = p[0][1];
	p[STEPS][1] = p[0][0];
	for (int i = 0; i < STEPS; i++) {
		add_triangle(&mesh, p[i][0], p[i + 1][0], p[i + 1][1]);
		add_triangle(&mesh, p[i][0], p[i + 1][1], p[i][1]);
	}
	/* The one boundary, and the seam, where both sides have the same direction. */
	expect(&mesh, 1, 2 * STEPS + 2, 2, 0);
	mesh_release(&mesh);
}
END_TEST

static bool same_corner(const struct mesh *mesh, size_t i, size_t j)
{
	vec3 d = vec3_sub(mesh_corner(&mesh->triangles[i / 3], (int)(i % 3)),
			  mesh_corner(&mesh->triangles[j / 3], (int)(j % 3)));

	return !(vec3_norm2(d) > 0);
}

static bool is_degenerate(const struct mesh *mesh, size_t t)
{
	return same_corner(mesh, 3 * t, 3 * t + 1) || same_corner(mesh, 3 * t + 1, 3 * t + 2) ||
	       same_corner(mesh, 3 * t + 2, 3 * t);
}

/* The number of sides from corner i's vertex to the next one minus those back; `along` is the number of the former. */
static int surplus(const struct mesh *mesh, size_t i, int *along)
{
	size_t next = i - i % 3 + (i + 1) % 3;
	int back = 0;

	*along = 0;
	for (size_t j = 0; j < 3 * mesh->count; j++) {
		size_t after = j - j % 3 + (j + 1) % 3;

		if (is_degenerate(mesh, j / 3))
			continue;
		*along += same_corner(mesh, i, j) && same_corner(mesh, next, after);
		back += same_corner(mesh, i, after) && same_corner(mesh, next, j);
	}
	return *along - back;
}

static void mark_component(const struct mesh *mesh, size_t t, bool *seen)
{
	seen[t] = true;
	for (size_t u = 0; u < mesh->count; u++) {
		bool touch = false;

		for (int k = 0; k < 9; k++)
			touch |= same_corner(mesh, 3 * t + (size_t)k / 3, 3 * u + (size_t)k % 3);
		if (touch && !seen[u])
			mark_component(mesh, u, seen);
	}
}

/* Random triangles on a small grid, so that everything can coincide, against the comparison of all pairs. */
START_TEST(random_soups)
{
	uint64_t state = 42;

	for (int turn = 0; turn < 1500; turn++) {
		int grid = 2 + turn % 4;
		struct mesh mesh = {0};
		bool seen[64] = {false};
		size_t components = 0, degenerate = 0;
		double open = 0, flipped = 0;

		for (int t = 1 + turn % 40; t > 0; t--) {
			vec3 p[3];

			for (int k = 0; k < 3; k++) {
				uint64_t bits = random_bits(&state) >> 8;

				p[k] = (vec3){(double)(bits % (uint64_t)grid), (double)(bits / 64 % (uint64_t)grid),
					      (double)(bits / 4096 % (uint64_t)grid)};
				p[k].x = bits >> 20 & 1 ? -p[k].x : p[k].x;
			}
			add_triangle(&mesh, p[0], p[1], p[2]);
		}
		for (size_t t = 0; t < mesh.count; t++) {
			degenerate += is_degenerate(&mesh, t);
			if (!seen[t]) {
				components++;
				mark_component(&mesh, t, seen);
			}
		}
		/* A directed edge with the surplus s is counted from `along` sides: each of them counts s / along. */
		for (size_t i = 0; i < 3 * mesh.count; i++) {
			int along, s = is_degenerate(&mesh, i / 3) ? 0 : surplus(&mesh, i, &along);

			if (s > 0) {
				open += (double)s / along;
				flipped += along > 1 ? (double)s / along : 0;
			}
		}
		expect(&mesh, components, (size_t)lround(open), (size_t)lround(flipped), degenerate);
		mesh_release(&mesh);
	}
}
END_TEST

/*
 * The quick test for cubes, for cubes without a triangle or with a reversed one, and for cubes drawn from both sides.
 */
START_TEST(balanced_edges)
{
	struct mesh mesh = {0}, both = {0};

	add_cube(&mesh, (vec3){100, -0.0, 0}, 3);
	add_cube(&mesh, (vec3){103, 0, 0}, -2);
	ck_assert(edge_balance_is_closed(&mesh));
	for (size_t i = 0; i < mesh.count; i++) {
		const mesh_triangle last = mesh.triangles[mesh.count - 1], kept = mesh.triangles[i];

		flip(&mesh.triangles[i]);
		ck_assert(!edge_balance_is_closed(&mesh));
		mesh.triangles[i] = last;
		mesh.count--;
		ck_assert(!edge_balance_is_closed(&mesh));
		mesh.triangles[mesh.count++] = last;
		mesh.triangles[i] = kept;
	}
	ck_assert(edge_balance_is_closed(&mesh));
	for (int side = 0; side < 2; side++) {
		for (int i = 0; i < 11; i++) {
			add_triangle(&both, mesh_corner(&mesh.triangles[i], 0), mesh_corner(&mesh.triangles[i], 1),
				     mesh_corner(&mesh.triangles[i], 2));
			if (side)
				flip(&both.triangles[both.count - 1]);
		}
	}
	ck_assert(!edge_balance_is_closed(&both));
	mesh_release(&mesh);
	mesh_release(&both);
}
END_TEST

/* Many more vertices than 32-bit hashes can distinguish: no two may be merged. */
START_TEST(many_vertices)
{
	struct mesh mesh = {.triangles = mem_alloc(300000 * sizeof(mesh_triangle)), .count = 300000};
	uint64_t state = 6;
	struct topology t;

	for (size_t i = 0; i < 9 * mesh.count; i++)
		mesh.triangles[i / 9].v[i % 9 / 3][i % 3] = (float)(random_bits(&state) >> 40);
	topology_init(&t, &mesh);
	ck_assert_uint_eq(t.component_count, mesh.count);
	ck_assert_uint_eq(t.open_edges, 3 * mesh.count);
	ck_assert_uint_eq(t.flipped_edges, 0);
	for (size_t i = 0; i < mesh.count; i++)
		ck_assert(vec3_norm(vec3_sub(t.component_point[i], mesh_corner(&mesh.triangles[i], 0))) <= 0);
	topology_release(&t);
	mesh_release(&mesh);
}
END_TEST

/* A torus whose tube is twisted about the axis; radii 3 and 1. */
static void add_torus(struct mesh *mesh, int n)
{
	for (int i = 0; i < n * n; i++) {
		vec3 p[4];

		for (int k = 0; k < 4; k++) {
			double u = 6.283185307179586 * ((i / n + (k & 1)) % n) / n;
			double v = 6.283185307179586 * ((i % n + (k >> 1)) % n) / n;

			p[k] = (vec3){(3 + cos(v)) * cos(u), (3 + cos(v)) * sin(u), sin(v)};
		}
		add_triangle(mesh, p[0], p[1], p[3]);
		add_triangle(mesh, p[0], p[3], p[2]);
	}
}

/* Signed crossings of the ray from the point along z: outward ones count 1. */
static int crossings(const struct mesh *mesh, vec3 point)
{
	int sum = 0;

	for (size_t i = 0; i < mesh->count; i++) {
		vec3 a = vec3_sub(mesh_corner(&mesh->triangles[i], 0), point);
		vec3 b = vec3_sub(mesh_corner(&mesh->triangles[i], 1), point);
		vec3 c = vec3_sub(mesh_corner(&mesh->triangles[i], 2), point);
		double ab = a.x * b.y - a.y * b.x, bc = b.x * c.y - b.y * c.x, ca = c.x * a.y - c.y * a.x;
		bool up = ab > 0 && bc > 0 && ca > 0, down = ab < 0 && bc < 0 && ca < 0;

		if ((up || down) && (ab * c.z + bc * a.z + ca * b.z) / (ab + bc + ca) > 0)
			sum += up ? 1 : -1;
	}
	return sum;
}

START_TEST(winding_matches_rays)
{
	struct mesh mesh = {0};
	uint64_t state = 21;
	int inside = 0;

	add_torus(&mesh, 40);
	add_cube(&mesh, (vec3){2.5, -0.25, -0.25}, 3);
	add_cube(&mesh, (vec3){-2.8, 0.2, 0.2}, -0.4);
	expect(&mesh, 3, 0, 0, 0);
	for (int turn = 0; turn < 2000; turn++) {
		vec3 point = {10 * random_unit(&state) - 5, 10 * random_unit(&state) - 5,
			      3 * random_unit(&state) - 1.5};
		int winding = mesh_winding_number(&mesh, point);

		ck_assert_int_eq(winding, crossings(&mesh, point));
		inside += winding != 0;
	}
	ck_assert_int_gt(inside, 300);
	mesh_release(&mesh);
}
END_TEST

/* Near a face, an edge and a corner, and for a mesh that is small compared with its distance. */
START_TEST(winding_near_and_far)
{
	struct mesh mesh = {0};
	static const vec3 outward[] = {{1, 0, 0}, {1, 1, 0}, {-1, 1, 1}, {1, 0.999, 0.998}};

	add_cube(&mesh, (vec3){-1, -1, -1}, 2);
	for (int k = 0; k < 4; k++) {
		vec3 surface = {outward[k].x, outward[k].y, outward[k].z};

		for (double off = 0.5; off > 1e-8; off /= 8) {
			ck_assert_int_eq(mesh_winding_number(&mesh, vec3_scale(1 + off, surface)), 0);
			ck_assert_int_eq(mesh_winding_number(&mesh, vec3_scale(1 - off, surface)), 1);
		}
	}
	ck_assert_int_eq(mesh_winding_number(&mesh, (vec3){1e6, -1e6, 1e5}), 0);
	ck_assert_int_eq(mesh_winding_number(&mesh, (vec3){1e30, 0, 0}), 0);
	mesh_release(&mesh);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("core");

	tcase_add_test(tcase, cubes);
	tcase_add_test(tcase, cubes_that_share);
	tcase_add_test(tcase, minus_zero_is_zero);
	tcase_add_test(tcase, broken_cubes);
	tcase_add_test(tcase, moebius_strip);
	tcase_add_test(tcase, random_soups);
	tcase_add_test(tcase, balanced_edges);
	tcase_add_test(tcase, many_vertices);
	tcase_add_test(tcase, winding_matches_rays);
	tcase_add_test(tcase, winding_near_and_far);
	return run_suite("topology", tcase);
}
