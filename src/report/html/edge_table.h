/* edge_table.h - the directed edges of a mesh: their triangles, and the boundary of the part that is coded already. */
#ifndef FIVECHECK_REPORT_HTML_EDGE_TABLE_H
#define FIVECHECK_REPORT_HTML_EDGE_TABLE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct edge {
	uint32_t from, to;
	/* the first corner, and 1, of the triangles that run along this edge from there; 0: none is left */
	uint32_t corners;
	bool open;	/* a coded triangle has it in the other direction, and there is none on this side yet */
	bool used;	/* this place of the table is in use */
};

struct edge_table {
	struct edge *edges;	/* a hash table; owned */
	size_t capacity;	/* a power of two */
	uint32_t *next;	/* by corner: the next one with the same edge, plus 1; owned */
};

/* Each triangle has three vertices. */
void edge_table_init(struct edge_table *table, const uint32_t *corners, size_t triangles);
void edge_table_release(struct edge_table *table);

/* The edge from one vertex to another, of a triangle that has it in either direction. NULL: there is none. */
struct edge *edge_table_find(const struct edge_table *table, uint32_t from, uint32_t to);

bool edge_table_open(const struct edge_table *table, uint32_t from, uint32_t to);

#endif
