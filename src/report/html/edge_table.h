/* edge_table.h - the directed edges of a mesh: which triangles have them, and where the part that is coded ends. */
#ifndef FIVECHECK_REPORT_HTML_EDGE_TABLE_H
#define FIVECHECK_REPORT_HTML_EDGE_TABLE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct edge {
	uint32_t from, to;
	/* the first corner, and 1, of the triangles that run along this edge from there; 0: none is left */
	uint32_t corners;
	bool open;	/* a coded triangle runs along it the other way, and none is on this side yet */
	bool used;	/* this place of the table */
};

struct edge_table {
	struct edge *edges;	/* a hash table; owned */
	size_t capacity;	/* a power of two */
	uint32_t *next;	/* by corner: the next one, and 1, with the same edge; owned */
};

/* Three vertices to a triangle. */
void edge_table_init(struct edge_table *table, const uint32_t *corners, size_t triangles);
void edge_table_release(struct edge_table *table);

/* The edge from one vertex to another, which a triangle has in this direction or the other. NULL: none has. */
struct edge *edge_table_find(const struct edge_table *table, uint32_t from, uint32_t to);

bool edge_table_open(const struct edge_table *table, uint32_t from, uint32_t to);

#endif
