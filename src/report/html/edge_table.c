#include "report/html/edge_table.h"

#include <stdlib.h>

#include "base/mem.h"

/* The place of an edge, or the free place for it. */
static struct edge *place_of(const struct edge_table *table, uint32_t from, uint32_t to)
{
	/* Fibonacci hashing (Knuth, The Art of Computer Programming 3, 6.4). */
	const uint64_t key = ((uint64_t)from << 32 | to) * UINT64_C(0x9e3779b97f4a7c15);
	size_t i = (size_t)(key >> 20) & (table->capacity - 1);

	while (table->edges[i].used && (table->edges[i].from != from || table->edges[i].to != to))
		i = (i + 1) & (table->capacity - 1);
	return &table->edges[i];
}

static struct edge *add(struct edge_table *table, uint32_t from, uint32_t to)
{
	struct edge *edge = place_of(table, from, to);

	edge->from = from;
	edge->to = to;
	edge->used = true;
	return edge;
}

void edge_table_init(struct edge_table *table, const uint32_t *corners, size_t triangles)
{
	*table = (struct edge_table){.capacity = 16, .next = mem_zalloc(3 * triangles + 1, sizeof(*table->next))};
	/* Both directions of three edges, and some free places. */
	while (table->capacity < 9 * triangles)
		table->capacity *= 2;
	table->edges = mem_zalloc(table->capacity, sizeof(*table->edges));
	for (size_t i = 3 * triangles; i-- > 0;) {
		const uint32_t from = corners[i], to = corners[i % 3 == 2 ? i - 2 : i + 1];
		struct edge *edge = add(table, from, to);

		table->next[i] = edge->corners;
		edge->corners = (uint32_t)i + 1;
		add(table, to, from);
	}
}

void edge_table_release(struct edge_table *table)
{
	free(table->edges);
	free(table->next);
}

struct edge *edge_table_find(const struct edge_table *table, uint32_t from, uint32_t to)
{
	struct edge *edge = place_of(table, from, to);

	return edge->used ? edge : NULL;
}

bool edge_table_open(const struct edge_table *table, uint32_t from, uint32_t to)
{
	const struct edge *edge = edge_table_find(table, from, to);

	return edge && edge->open;
}
