#include "geom/topology.h"

#include <assert.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "base/units.h"

/*
 * Everything is brought together by sorting 64-bit keys, one a corner or one a
 * side, never by probing a hash table: no file can make that slow.
 */

#define DIGIT_BITS 11
#define DIGITS (1 << DIGIT_BITS)

/* The working storage: three entries a triangle. */
struct soup {
	const struct mesh *mesh;
	size_t corner_count;
	uint32_t *vertex;	/* of each corner, which vertex it is */
	uint32_t vertex_count;
	uint64_t *keys, *scratch;
};

/* Sorts the keys by their bits from `low` up to and without `high`; equal ones stay in order. */
static void sort_keys(struct soup *soup, int low, int high)
{
	for (int shift = low; shift < high; shift += DIGIT_BITS) {
		size_t start[DIGITS + 1] = {0};
		uint64_t *swap = soup->keys;
		int bits = high - shift < DIGIT_BITS ? high - shift : DIGIT_BITS;
		uint64_t mask = ((uint64_t)1 << bits) - 1;

		for (size_t i = 0; i < soup->corner_count; i++)
			start[(soup->keys[i] >> shift & mask) + 1]++;
		for (int d = 0; d < DIGITS; d++)
			start[d + 1] += start[d];
		for (size_t i = 0; i < soup->corner_count; i++)
			soup->scratch[start[soup->keys[i] >> shift & mask]++] = soup->keys[i];
		soup->keys = soup->scratch;
		soup->scratch = swap;
	}
}

static const float *corner_at(const struct soup *soup, size_t corner)
{
	return soup->mesh->triangles[corner / 3].v[corner % 3];
}

/* The bits of a coordinate, the same for -0 as for 0. */
static uint32_t coordinate_bits(float value)
{
	uint32_t bits;

	value += 0.0f;
	memcpy(&bits, &value, sizeof(bits));
	return bits;
}

static uint32_t corner_hash(const float *v)
{
	uint64_t h = coordinate_bits(v[0]) * UINT64_C(0x9e3779b97f4a7c15);

	h = (h ^ h >> 32 ^ coordinate_bits(v[1])) * UINT64_C(0xbf58476d1ce4e5b9);
	h = (h ^ h >> 29 ^ coordinate_bits(v[2])) * UINT64_C(0x94d049bb133111eb);
	return (uint32_t)(h >> 32);
}

static int compare_coordinates(const float *a, const float *b)
{
	for (int k = 0; k < 3; k++) {
		if (a[k] < b[k] || a[k] > b[k])
			return a[k] < b[k] ? -1 : 1;
	}
	return 0;
}

struct corner {
	float v[3];
	uint32_t index;
};

static int compare_corners(const void *a, const void *b)
{
	const struct corner *p = a, *q = b;

	return compare_coordinates(p->v, q->v);
}

/* Numbers the vertices among keys[first..last), corners with one hash but of different places. */
static void weld_mixed(struct soup *soup, size_t first, size_t last)
{
	struct corner *corners = mem_alloc((last - first) * sizeof(*corners));

	for (size_t i = first; i < last; i++) {
		corners[i - first].index = (uint32_t)soup->keys[i];
		memcpy(corners[i - first].v, corner_at(soup, (uint32_t)soup->keys[i]), sizeof(corners->v));
	}
	qsort(corners, last - first, sizeof(*corners), compare_corners);
	for (size_t i = 0; i < last - first; i++) {
		if (i == 0 || compare_corners(&corners[i - 1], &corners[i]) != 0)
			soup->vertex_count++;
		soup->vertex[corners[i].index] = soup->vertex_count - 1;
	}
	free(corners);
}

static void weld(struct soup *soup)
{
	for (size_t i = 0; i < soup->corner_count; i++)
		soup->keys[i] = (uint64_t)corner_hash(corner_at(soup, i)) << 32 | i;
	sort_keys(soup, 32, 64);
	for (size_t first = 0, last; first < soup->corner_count; first = last) {
		const float *place = corner_at(soup, (uint32_t)soup->keys[first]);
		uint64_t hash = soup->keys[first] >> 32;
		bool mixed = false;

		for (last = first; last < soup->corner_count && soup->keys[last] >> 32 == hash; last++) {
			mixed |= compare_coordinates(place, corner_at(soup, (uint32_t)soup->keys[last])) != 0;
			soup->vertex[(uint32_t)soup->keys[last]] = soup->vertex_count;
		}
		if (mixed)
			weld_mixed(soup, first, last);
		else
			soup->vertex_count++;
	}
}

/* The root of a vertex' tree; halves the path to it. */
static uint32_t find_root(uint32_t *parent, uint32_t vertex)
{
	while (parent[vertex] != vertex) {
		parent[vertex] = parent[parent[vertex]];
		vertex = parent[vertex];
	}
	return vertex;
}

/* Trees are joined under the lesser root: the depth stays low with halved paths, and the result has no other order. */
static void join(uint32_t *parent, uint32_t a, uint32_t b)
{
	a = find_root(parent, a);
	b = find_root(parent, b);
	if (a < b)
		parent[b] = a;
	else
		parent[a] = b;
}

/* The witnesses come in the order of the file. */
static void find_components(struct topology *topology, const struct soup *soup)
{
	uint32_t *parent = mem_alloc(soup->vertex_count * sizeof(*parent));
	bool *seen = mem_zalloc(soup->vertex_count, sizeof(*seen));
	size_t capacity = 0;

	for (uint32_t v = 0; v < soup->vertex_count; v++)
		parent[v] = v;
	for (size_t i = 0; i < soup->corner_count; i += 3) {
		join(parent, soup->vertex[i], soup->vertex[i + 1]);
		join(parent, soup->vertex[i], soup->vertex[i + 2]);
	}
	for (size_t i = 0; i < soup->corner_count; i += 3) {
		uint32_t root = find_root(parent, soup->vertex[i]);
		size_t n = topology->component_count;

		if (seen[root])
			continue;
		seen[root] = true;
		topology->witness = mem_grow(topology->witness, &capacity, n + 1, sizeof(*topology->witness));
		topology->witness[n] = mesh_corner(&soup->mesh->triangles[i / 3], 0);
		topology->component_count++;
	}
	free(seen);
	free(parent);
}

/* One key a side: the lesser vertex, the greater one, and in the last bit which way it is run through. */
static uint64_t side_key(uint32_t from, uint32_t to)
{
	return from < to ? (uint64_t)from << 32 | (uint64_t)to << 1 : (uint64_t)to << 32 | (uint64_t)from << 1 | 1;
}

/* Leaves the sides of all but the degenerate triangles in soup->keys, as its first corner_count entries. */
static void list_sides(struct topology *topology, struct soup *soup)
{
	size_t count = 0;

	for (size_t i = 0; i < soup->corner_count; i += 3) {
		const uint32_t *v = &soup->vertex[i];

		if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) {
			topology->degenerate++;
			continue;
		}
		for (int k = 0; k < 3; k++)
			soup->keys[count++] = side_key(v[k], v[(k + 1) % 3]);
	}
	soup->corner_count = count;
}

static void count_open_sides(struct topology *topology, const struct soup *soup)
{
	for (size_t first = 0, last; first < soup->corner_count; first = last) {
		size_t ways[2] = {0, 0}, most, alone;

		for (last = first; last < soup->corner_count && soup->keys[last] >> 1 == soup->keys[first] >> 1; last++)
			ways[soup->keys[last] & 1]++;
		most = ways[0] > ways[1] ? ways[0] : ways[1];
		alone = most - (ways[0] + ways[1] - most);
		topology->open_edges += alone;
		topology->flipped_edges += most > 1 ? alone : 0;
	}
	topology->closed = topology->open_edges == 0;
}

void topology_init(struct topology *topology, const struct mesh *mesh)
{
	struct soup soup = {.mesh = mesh, .corner_count = 3 * mesh->count};
	int bits = 0;

	assert(mesh->count <= TOPOLOGY_TRIANGLES_MAX);
	*topology = (struct topology){0};
	soup.vertex = mem_alloc(soup.corner_count * sizeof(*soup.vertex));
	soup.keys = mem_alloc(soup.corner_count * sizeof(*soup.keys));
	soup.scratch = mem_alloc(soup.corner_count * sizeof(*soup.scratch));
	weld(&soup);
	find_components(topology, &soup);
	list_sides(topology, &soup);
	while (soup.vertex_count >> bits)
		bits++;
	sort_keys(&soup, 1, 1 + bits);
	sort_keys(&soup, 32, 32 + bits);
	count_open_sides(topology, &soup);
	free(soup.vertex);
	free(soup.keys);
	free(soup.scratch);
}

void topology_release(struct topology *topology)
{
	free(topology->witness);
	*topology = (struct topology){0};
}

/*
 * A solid angle's error is a few roundings times the ratio of the triangle's
 * size to the point's distance from its edges; even a million of them add up to
 * half a turn only for points within some 1e-9 of the mesh's size of it.
 */
int mesh_winding_number(const struct mesh *mesh, vec3 point)
{
	double half_sum = 0;

	for (size_t i = 0; i < mesh->count; i++) {
		vec3 a = vec3_sub(mesh_corner(&mesh->triangles[i], 0), point);
		vec3 b = vec3_sub(mesh_corner(&mesh->triangles[i], 1), point);
		vec3 c = vec3_sub(mesh_corner(&mesh->triangles[i], 2), point);
		double na = vec3_norm(a), nb = vec3_norm(b), nc = vec3_norm(c);
		double volume = vec3_dot(a, vec3_cross(b, c));
		double spread = na * nb * nc + vec3_dot(a, b) * nc + vec3_dot(b, c) * na + vec3_dot(c, a) * nb;

		half_sum += atan2(volume, spread);
	}
	return (int)lround(half_sum / (2 * PI));
}
