#include "geom/topology.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

#include "base/mem.h"
#include "geom/twins.h"
#include "geom/weld.h"

/* The root of a vertex's tree; halves the path to the root. */
static uint32_t find_root(uint32_t *parent, uint32_t vertex)
{
	while (parent[vertex] != vertex) {
		parent[vertex] = parent[parent[vertex]];
		vertex = parent[vertex];
	}
	return vertex;
}

/*
 * Trees are joined under the smaller root: with path halving the depth stays low, and the result does not depend on the
 * order.
 */
static void join(uint32_t *parent, uint32_t a, uint32_t b)
{
	a = find_root(parent, a);
	b = find_root(parent, b);
	if (a < b)
		parent[b] = a;
	else
		parent[a] = b;
}

/*
 * The component of each vertex; the caller owns the memory. Components and component points are in the order of the
 * file.
 */
static uint32_t *find_components(struct topology *topology, const struct soup *soup)
{
	uint32_t *parent = mem_alloc(soup->vertex_count * sizeof(*parent));
	uint32_t *component = mem_alloc(soup->vertex_count * sizeof(*component));
	size_t capacity = 0;

	for (uint32_t v = 0; v < soup->vertex_count; v++) {
		parent[v] = v;
		component[v] = UINT32_MAX;
	}
	for (size_t i = 0; i < soup->corner_count; i += 3) {
		join(parent, soup->vertex[i], soup->vertex[i + 1]);
		join(parent, soup->vertex[i], soup->vertex[i + 2]);
	}
	for (size_t i = 0; i < soup->corner_count; i += 3) {
		uint32_t root = find_root(parent, soup->vertex[i]);
		size_t n = topology->component_count;

		if (component[root] != UINT32_MAX)
			continue;
		component[root] = (uint32_t)n;
		topology->component_point =
		    mem_grow(topology->component_point, &capacity, n + 1, sizeof(*topology->component_point));
		topology->component_point[n] = mesh_corner(&soup->mesh->triangles[i / 3], 0);
		topology->component_count++;
	}
	for (uint32_t v = 0; v < soup->vertex_count; v++)
		component[v] = component[find_root(parent, v)];
	free(parent);
	return component;
}

/* The properties of a component that its edges show. */
enum {
	EDGES_UNBALANCED = 1,	/* one is run through more often in one direction */
	EDGES_ODD = 2,	/* an odd number of triangles meets in one */
	EDGES_FLIPPED = 4,	/* neighbouring triangles face opposite ways */
	EDGES_CROWDED = 8	/* more than two triangles meet in one */
};

/* One key for each side: the smaller vertex, the larger one, and in the last bit the direction. */
static uint64_t side_key(uint32_t from, uint32_t to)
{
	return from < to ? (uint64_t)from << 32 | (uint64_t)to << 1 : (uint64_t)to << 32 | (uint64_t)from << 1 | 1;
}

/*
 * Writes the sides of the triangles that are not degenerate to soup->keys, sorted; if `twins`, only the sides of kept
 * twins.
 */
static size_t list_sides(struct soup *soup, const uint8_t *twins)
{
	size_t count = 0;
	int bits = 0;

	for (size_t i = 0; i < soup->corner_count; i += 3) {
		if (soup_is_degenerate(soup, i / 3) || (twins && twins[i / 3] != TWIN_KEPT))
			continue;
		for (size_t k = 0; k < 3; k++)
			soup->keys[count++] = side_key(soup->vertex[i + k], soup->vertex[i + (k + 1) % 3]);
	}
	while (soup->vertex_count >> bits)
		bits++;
	soup_sort_keys(soup, count, 32 + bits);
	return count;
}

static void judge_edge(struct topology *topology, const size_t ways[2], uint8_t *edges)
{
	size_t most = ways[0] > ways[1] ? ways[0] : ways[1];
	size_t all = ways[0] + ways[1], alone = 2 * most - all;

	topology->open_edges += alone;
	topology->flipped_edges += most > 1 ? alone : 0;
	*edges |= (uint8_t)((alone ? EDGES_UNBALANCED : 0) | (all % 2 ? EDGES_ODD : 0) |
			    (alone && most > 1 ? EDGES_FLIPPED : 0) | (all > 2 ? EDGES_CROWDED : 0));
}

/* Finds for each component what its edges show. */
static void judge_edges(struct topology *topology, const struct soup *soup, size_t count, const uint32_t *component,
			uint8_t *edges)
{
	for (size_t first = 0, last; first < count; first = last) {
		size_t ways[2] = {0, 0};

		for (last = first; last < count && soup->keys[last] >> 1 == soup->keys[first] >> 1; last++)
			ways[soup->keys[last] & 1]++;
		judge_edge(topology, ways, &edges[component[soup->keys[first] >> 32]]);
	}
	topology->closed = topology->open_edges == 0;
}

static void add_to_shell(struct topology *topology, uint32_t shell, const struct mesh *mesh, size_t triangle)
{
	struct shell *s = &topology->shells[shell];

	for (int k = 0; k < 3; k++) {
		vec3 corner = mesh_corner(&mesh->triangles[triangle], k);

		s->least = vec3_min(s->least, corner);
		s->greatest = vec3_max(s->greatest, corner);
	}
	s->kind = SHELL_ORIENTED;
	topology->shell_of[triangle] = shell;
}

/* It is unknown which of two twins faces outward, so their shells are never oriented. */
static void judge_shells(struct topology *topology, const uint8_t *edges, const uint8_t *twin_edges)
{
	for (size_t i = 0; i < topology->shell_count; i++) {
		struct shell *shell = &topology->shells[i];
		bool twins = i % 2;
		unsigned said = twins ? twin_edges[i / 2] : edges[i / 2];

		if (shell->kind == SHELL_EMPTY)
			continue;
		if (said & EDGES_ODD)
			shell->kind = SHELL_OPEN;
		else if (twins || said & EDGES_UNBALANCED)
			shell->kind = SHELL_UNORIENTED;
		shell->flipped = twins || said & EDGES_FLIPPED;
	}
}

static void find_shells(struct topology *topology, struct soup *soup, const uint32_t *component, const uint8_t *edges,
			bool crowded)
{
	uint8_t *twins = mem_zalloc(soup->mesh->count, sizeof(*twins));
	uint8_t *twin_edges = mem_zalloc(topology->component_count, sizeof(*twin_edges));
	struct topology unused = {0};

	if (crowded)
		topology->doubled = twins_find(soup, twins);
	topology->shell_count = 2 * topology->component_count;
	topology->shells = mem_alloc(topology->shell_count * sizeof(*topology->shells));
	topology->shell_of = mem_alloc(soup->mesh->count * sizeof(*topology->shell_of));
	for (size_t i = 0; i < topology->shell_count; i++)
		topology->shells[i] = (struct shell){.least = {INFINITY, INFINITY, INFINITY},
						     .greatest = {-INFINITY, -INFINITY, -INFINITY}};
	for (size_t t = 0; t < soup->mesh->count; t++) {
		uint32_t shell = 2 * component[soup->vertex[3 * t]] + (twins[t] == TWIN_KEPT);

		topology->shell_of[t] = NO_SHELL;
		if (twins[t] != TWIN_DROPPED && !soup_is_degenerate(soup, t))
			add_to_shell(topology, shell, soup->mesh, t);
	}
	if (topology->doubled)
		judge_edges(&unused, soup, list_sides(soup, twins), component, twin_edges);
	judge_shells(topology, edges, twin_edges);
	free(twins);
	free(twin_edges);
}

void topology_init(struct topology *topology, const struct mesh *mesh)
{
	struct soup soup;
	uint32_t *component;
	uint8_t *edges;
	bool crowded = false;

	assert(mesh->count <= TOPOLOGY_TRIANGLES_MAX);
	*topology = (struct topology){0};
	soup_init(&soup, mesh);
	component = find_components(topology, &soup);
	edges = mem_zalloc(topology->component_count, sizeof(*edges));
	for (size_t t = 0; t < mesh->count; t++)
		topology->degenerate += soup_is_degenerate(&soup, t);
	judge_edges(topology, &soup, list_sides(&soup, NULL), component, edges);
	for (size_t i = 0; i < topology->component_count; i++)
		crowded |= edges[i] & EDGES_CROWDED;
	if (!topology->closed || crowded || topology->component_count > 1)
		find_shells(topology, &soup, component, edges, crowded);
	topology->plain = topology->closed && !topology->doubled;
	free(edges);
	free(component);
	soup_release(&soup);
}

void topology_release(struct topology *topology)
{
	free(topology->component_point);
	free(topology->shells);
	free(topology->shell_of);
	*topology = (struct topology){0};
}

bool topology_is_open(const struct topology *topology)
{
	for (size_t i = 0; i < topology->shell_count; i++) {
		if (topology->shells[i].kind == SHELL_OPEN)
			return true;
	}
	return false;
}
