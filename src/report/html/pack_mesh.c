#include "report/html/pack_mesh.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

#include "base/mem.h"
#include "base/minmax.h"
#include "report/html/mesh_coder.h"

enum { GRID_MAX = 65535 };

/* Points of the grid and the triangles between them. */
struct grid {
	uint16_t (*points)[3];
	size_t point_count;
	uint32_t *corners;
	size_t triangle_count;
	uint32_t *slots;	/* hash table: a point's number and 1; 0 is free */
	size_t slot_count;	/* a power of two */
};

static void choose_grid(struct packed_mesh *packed, const struct mesh *mesh, const xform *place)
{
	vec3 least = {INFINITY, INFINITY, INFINITY}, greatest = {-INFINITY, -INFINITY, -INFINITY};
	double extent;

	for (size_t i = 0; i < 3 * mesh->count; i++) {
		vec3 p = xform_apply(place, mesh_corner(&mesh->triangles[i / 3], (int)(i % 3)));

		least = (vec3){smaller(least.x, p.x), smaller(least.y, p.y), smaller(least.z, p.z)};
		greatest = (vec3){larger(greatest.x, p.x), larger(greatest.y, p.y), larger(greatest.z, p.z)};
	}
	extent = fmax(greatest.x - least.x, fmax(greatest.y - least.y, greatest.z - least.z));
	packed->origin = least;
	packed->step = fmax(PACK_MESH_STEP, extent / (GRID_MAX - 1));
}

/* Without calls, because this is done three times for each corner of a mesh. */
static uint16_t quantise(double value, double origin, double step)
{
	return (uint16_t)(smaller(larger((value - origin) / step, 0), GRID_MAX) + 0.5);
}

/* The number of the grid point, which may be new. */
static uint32_t number_of(struct grid *grid, const uint16_t point[3])
{
	const uint64_t key = (uint64_t)point[0] << 32 | (uint64_t)point[1] << 16 | point[2];
	/* Fibonacci hashing (Knuth, The Art of Computer Programming 3, 6.4). */
	size_t slot = (size_t)(key * UINT64_C(0x9e3779b97f4a7c15) >> 20) & (grid->slot_count - 1);

	for (; grid->slots[slot]; slot = (slot + 1) & (grid->slot_count - 1)) {
		const uint16_t *p = grid->points[grid->slots[slot] - 1];

		if (p[0] == point[0] && p[1] == point[1] && p[2] == point[2])
			return grid->slots[slot] - 1;
	}
	for (int k = 0; k < 3; k++)
		grid->points[grid->point_count][k] = point[k];
	grid->slots[slot] = (uint32_t)++grid->point_count;
	return (uint32_t)grid->point_count - 1;
}

static void grid_init(struct grid *grid, const struct mesh *mesh, const xform *place, const struct packed_mesh *packed)
{
	*grid = (struct grid){
		.points = mem_alloc(3 * mesh->count * sizeof(*grid->points)),
		.corners = mem_alloc(3 * mesh->count * sizeof(*grid->corners)),
		.slot_count = 8,
	};
	while (grid->slot_count < 6 * mesh->count)
		grid->slot_count *= 2;
	grid->slots = mem_zalloc(grid->slot_count, sizeof(*grid->slots));
	for (size_t i = 0; i < mesh->count; i++) {
		uint32_t *v = &grid->corners[3 * grid->triangle_count];

		for (int k = 0; k < 3; k++) {
			vec3 p = xform_apply(place, mesh_corner(&mesh->triangles[i], k));
			const uint16_t point[3] = {quantise(p.x, packed->origin.x, packed->step),
						   quantise(p.y, packed->origin.y, packed->step),
						   quantise(p.z, packed->origin.z, packed->step)};

			v[k] = number_of(grid, point);
		}
		grid->triangle_count += v[0] != v[1] && v[1] != v[2] && v[2] != v[0];
	}
}

/* A triangle, rotated so that its smallest corner is the first, and the grid points of its corners. */
struct placed_triangle {
	uint64_t keys[3];
	uint32_t corners[3];
};

static int compare(const void *a, const void *b)
{
	const struct placed_triangle *x = a, *y = b;

	for (int k = 0; k < 3; k++) {
		if (x->keys[k] != y->keys[k])
			return x->keys[k] < y->keys[k] ? -1 : 1;
	}
	return 0;
}

static uint64_t key_of(const uint16_t point[3])
{
	return (uint64_t)point[2] << 32 | (uint64_t)point[1] << 16 | point[0];
}

/*
 * Sorts the triangles by the grid points of their corners. Then equal parts of a body, such as its screws, begin with
 * the same triangle, are walked in the same order, and have the same steps between vertices, which need almost no
 * bytes.
 */
static void sort_triangles(struct grid *grid)
{
	struct placed_triangle *sorted = mem_alloc((grid->triangle_count + 1) * sizeof(*sorted));

	for (size_t i = 0; i < grid->triangle_count; i++) {
		const uint32_t *v = &grid->corners[3 * i];
		int least = 0;

		for (int k = 1; k < 3; k++) {
			if (key_of(grid->points[v[k]]) < key_of(grid->points[v[least]]))
				least = k;
		}
		for (int k = 0; k < 3; k++) {
			sorted[i].corners[k] = v[(least + k) % 3];
			sorted[i].keys[k] = key_of(grid->points[sorted[i].corners[k]]);
		}
	}
	qsort(sorted, grid->triangle_count, sizeof(*sorted), compare);
	for (size_t i = 0; i < grid->triangle_count; i++) {
		for (size_t k = 0; k < 3; k++)
			grid->corners[3 * i + k] = sorted[i].corners[k];
	}
	free(sorted);
}

static void grid_release(struct grid *grid)
{
	free(grid->points);
	free(grid->corners);
	free(grid->slots);
}

void pack_mesh_add(struct strbuf *out, const struct mesh *mesh, const xform *place, struct packed_mesh *packed)
{
	struct packed_mesh result = {0};
	struct grid grid;

	choose_grid(&result, mesh, place);
	grid_init(&grid, mesh, place, &result);
	sort_triangles(&grid);
	result.triangles = grid.triangle_count;
	result.vertices = mesh_coder_add(out, grid.points, grid.point_count, grid.corners, grid.triangle_count);
	grid_release(&grid);
	*packed = result;
}
