#include "report/html/mesh_coder.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "report/format/range_coder.h"
#include "report/html/edge_table.h"

enum { NOBODY = UINT32_MAX };

/* The triangle or vertex on the other side of an edge of the walk. */
enum beyond { BEYOND_NONE, BEYOND_NEW, BEYOND_BEFORE, BEYOND_AFTER, BEYOND_OLD, BEYOND_COUNT };
enum { HISTORY = BEYOND_COUNT * BEYOND_COUNT * BEYOND_COUNT };

/* Remembers the step that followed two steps: equal parts of a body repeat such steps. */
enum { MEMORY_BITS = 14, RUN_MAX = 6 };
struct remembered {
	int32_t step[3];
	int run;	/* how often in a row it was repeated, plus 1; 0: nothing is remembered here */
};

/* An edge whose other side the walk must still visit, and the third vertex on this side. */
struct gate {
	uint32_t from, to, opposite;
};

struct coder {
	struct range_coder bits;
	struct edge_table edges;
	const uint16_t (*points)[3];
	const uint32_t *corners;
	bool *taken;	/* by triangle */
	uint32_t *numbers;	/* by point: its number in the code; NOBODY: not coded yet */
	uint32_t *before, *after;	/* by point: the last neighbours before and after it along open edges */
	uint32_t seen, newest;	/* points that are coded; the last of them, NOBODY: none */
	struct gate *gates;
	size_t depth;
	/* The predictions. */
	struct bit_model begins_new[3];
	struct bit_model beyond[BEYOND_COUNT][2][2][HISTORY];
	struct number_model back, back_at_start;
	struct bit_model again[RUN_MAX + 2];
	struct bit_model equal[3][3][4][3]; /* by corner, coordinate, which coordinates before were equal, candidate */
	struct bit_model known[3][4];
	struct number_model rank[3], residual[3];
	int history;
	struct remembered memory[1 << MEMORY_BITS];
	uint32_t hashes[2];	/* of the last two steps */
	uint16_t *values[3];	/* by coordinate: those that were coded in full, in order */
	size_t value_counts[3];
};

/* ---------------------------------------------------------------- vertices */

static uint32_t zigzag(int32_t value)
{
	return value < 0 ? 2 * (uint32_t)(-(value + 1)) + 1 : 2 * (uint32_t)value;
}

/* How many of the values are smaller. */
static size_t rank_of(const uint16_t *values, size_t count, int32_t value)
{
	size_t low = 0, high = count;

	while (low < high) {
		const size_t middle = (low + high) / 2;

		if (values[middle] < value)
			low = middle + 1;
		else
			high = middle;
	}
	return low;
}

/* A coordinate that no neighbour has: one of the earlier values of the mesh, or a difference. */
static void code_value(struct coder *coder, int corner, int k, int equal, uint16_t value, int32_t guess)
{
	uint16_t *values = coder->values[k];
	const size_t count = coder->value_counts[k], rank = rank_of(values, count, value);
	const bool known = rank < count && values[rank] == value;

	range_coder_bit(&coder->bits, &coder->known[k][equal], known);
	if (known) {
		range_coder_number(&coder->bits, &coder->rank[corner],
				   zigzag((int32_t)rank - (int32_t)rank_of(values, count, guess)));
		return;
	}
	range_coder_number(&coder->bits, &coder->residual[corner], zigzag(value - guess));
	memmove(values + rank + 1, values + rank, (count - rank) * sizeof(*values));
	values[rank] = value;
	coder->value_counts[k]++;
}

/* Is the step from the last vertex the one that is remembered here? */
static bool code_again(struct coder *coder, const int32_t step[3])
{
	const uint32_t slot = (31 * coder->hashes[0] + coder->hashes[1]) * UINT32_C(0x9e3779b1) >> (32 - MEMORY_BITS);
	struct remembered *it = &coder->memory[slot];
	const bool again = it->run && !memcmp(it->step, step, sizeof(it->step));

	range_coder_bit(&coder->bits, &coder->again[it->run], again);
	it->run = !again ? 1 : it->run <= RUN_MAX ? it->run + 1 : it->run;
	memcpy(it->step, step, sizeof(it->step));
	coder->hashes[1] = coder->hashes[0];
	/* Three primes, as in Teschner et al., Optimized spatial hashing, 2003. */
	coder->hashes[0] =
	    (uint32_t)step[0] * 73856093U ^ (uint32_t)step[1] * 19349663U ^ (uint32_t)step[2] * 83492791U;
	return again;
}

/*
 * A new vertex, corner 0, 1 or 2 of its triangle. near[0] is the vertex before it; near[1] and near[2], if they exist,
 * are the other end of the edge and the vertex on the other side of the edge.
 */
static void code_vertex(struct coder *coder, int corner, uint32_t point, const uint16_t *const near[3], int near_count)
{
	const uint16_t *p = coder->points[point];
	const int32_t step[3] = {p[0] - near[0][0], p[1] - near[0][1], p[2] - near[0][2]};
	int equal = 0;

	coder->numbers[point] = coder->seen++;
	coder->newest = point;
	if (code_again(coder, step))
		return;
	for (int k = 0; k < 3; k++) {
		int i = 0;

		for (; i < near_count; i++) {
			const bool same = near[i][k] == p[k];

			if ((i > 0 && near[i][k] == near[0][k]) || (i > 1 && near[i][k] == near[1][k]))
				continue;
			range_coder_bit(&coder->bits, &coder->equal[corner][k][equal][i], same);
			if (same)
				break;
		}
		if (i == near_count)
			code_value(coder, corner, k, equal, p[k],
				   near_count < 3 ? near[0][k] : near[0][k] + near[1][k] - near[2][k]);
		equal = (2 * equal + (i < near_count)) & 3;
	}
}

/* --------------------------------------------------------------- triangles */

static void code_old(struct coder *coder, struct number_model *model, uint32_t point)
{
	range_coder_number(&coder->bits, model, coder->seen - 1 - coder->numbers[point]);
}

static void open_edge(struct coder *coder, uint32_t from, uint32_t to)
{
	struct edge *other = edge_table_find(&coder->edges, to, from);

	/* The triangle has the edge from `to` to `from`: it closes that edge, or opens this one. */
	if (other->open) {
		other->open = false;
		return;
	}
	edge_table_find(&coder->edges, from, to)->open = true;
	coder->after[from] = to;
	coder->before[to] = from;
}

static void take_triangle(struct coder *coder, size_t triangle, uint32_t a, uint32_t b, uint32_t c)
{
	coder->taken[triangle] = true;
	open_edge(coder, b, a);
	open_edge(coder, c, b);
	open_edge(coder, a, c);
	/* The last one is visited first: the edge beyond the newest vertex. */
	coder->gates[coder->depth++] = (struct gate){b, a, c};
	coder->gates[coder->depth++] = (struct gate){a, c, b};
	coder->gates[coder->depth++] = (struct gate){c, b, a};
}

/* A corner, plus 1, of a triangle that is not coded and has the edge from there. 0: there is none. */
static uint32_t corner_at(const struct coder *coder, struct edge *edge)
{
	while (edge->corners && coder->taken[(edge->corners - 1) / 3])
		edge->corners = coder->edges.next[edge->corners - 1];
	return edge->corners;
}

/* Codes the other side of the gate by at most three or four questions, the most probable first. */
static void code_beyond(struct coder *coder, enum beyond beyond, bool before, bool after)
{
	static const enum beyond order[] = {BEYOND_NEW, BEYOND_BEFORE, BEYOND_AFTER, BEYOND_NONE};

	for (size_t i = 0; i < sizeof(order) / sizeof(*order); i++) {
		if ((order[i] == BEYOND_BEFORE && !before) || (order[i] == BEYOND_AFTER && !after))
			continue;
		range_coder_bit(&coder->bits, &coder->beyond[order[i]][before][after][coder->history],
				order[i] == beyond);
		if (order[i] == beyond)
			break;
	}
	coder->history = (BEYOND_COUNT * coder->history + (int)beyond) % HISTORY;
}

static void look_beyond(struct coder *coder, const struct gate *gate)
{
	const uint32_t a = gate->from, b = gate->to, before = coder->before[a], after = coder->after[b];
	const bool has_before = before != NOBODY && before != b && edge_table_open(&coder->edges, before, a);
	const bool has_after = after != NOBODY && after != a && edge_table_open(&coder->edges, b, after);
	struct edge *edge = edge_table_find(&coder->edges, a, b);
	const uint32_t corner = corner_at(coder, edge);
	uint32_t triangle, c;

	if (!corner) {
		code_beyond(coder, BEYOND_NONE, has_before, has_after);
		edge->open = false;
		return;
	}
	triangle = (corner - 1) / 3;
	c = coder->corners[3 * triangle + (corner + 1) % 3];
	if (coder->numbers[c] == NOBODY) {
		const uint16_t *const near[3] = {coder->points[b], coder->points[a], coder->points[gate->opposite]};

		code_beyond(coder, BEYOND_NEW, has_before, has_after);
		code_vertex(coder, 2, c, near, 3);
	} else if (has_before && c == before) {
		code_beyond(coder, BEYOND_BEFORE, has_before, has_after);
	} else if (has_after && c == after) {
		code_beyond(coder, BEYOND_AFTER, has_before, has_after);
	} else {
		code_beyond(coder, BEYOND_OLD, has_before, has_after);
		code_old(coder, &coder->back, c);
	}
	take_triangle(coder, triangle, a, b, c);
}

/* Begins with a triangle that shares no open edge with earlier ones. */
static void begin_part(struct coder *coder, size_t triangle)
{
	static const uint16_t zero[3] = {0};
	const uint32_t *v = &coder->corners[3 * triangle];

	for (int k = 0; k < 3; k++) {
		const uint16_t *const near[3] = {
			k ? coder->points[v[k - 1]] : coder->newest == NOBODY ? zero : coder->points[coder->newest],
			coder->points[v[0]],
		};
		const bool new = coder->numbers[v[k]] == NOBODY;

		range_coder_bit(&coder->bits, &coder->begins_new[k], new);
		if (new)
			code_vertex(coder, k, v[k], near, k == 2 ? 2 : 1);
		else
			code_old(coder, &coder->back_at_start, v[k]);
	}
	take_triangle(coder, triangle, v[0], v[1], v[2]);
}

static void walk(struct coder *coder, size_t triangles)
{
	for (size_t t = 0; t < triangles; t++) {
		if (coder->taken[t])
			continue;
		begin_part(coder, t);
		while (coder->depth) {
			const struct gate gate = coder->gates[--coder->depth];

			if (edge_table_open(&coder->edges, gate.from, gate.to))
				look_beyond(coder, &gate);
		}
	}
}

/* -------------------------------------------------------------------- face */

static uint32_t *nobody_for(size_t count)
{
	uint32_t *array = mem_alloc((count + 1) * sizeof(*array));

	for (size_t i = 0; i <= count; i++)
		array[i] = NOBODY;
	return array;
}

size_t mesh_coder_add(struct strbuf *out, const uint16_t (*points)[3], size_t point_count, const uint32_t *corners,
		      size_t triangles)
{
	struct coder *coder = mem_zalloc(1, sizeof(*coder));
	size_t seen;

	coder->points = points;
	coder->corners = corners;
	coder->taken = mem_zalloc(triangles + 1, sizeof(*coder->taken));
	coder->numbers = nobody_for(point_count);
	coder->before = nobody_for(point_count);
	coder->after = nobody_for(point_count);
	coder->newest = NOBODY;
	coder->gates = mem_alloc((3 * triangles + 1) * sizeof(*coder->gates));
	for (int k = 0; k < 3; k++)
		coder->values[k] = mem_alloc((size_t)(UINT16_MAX + 1) * sizeof(*coder->values[k]));
	edge_table_init(&coder->edges, corners, triangles);
	range_coder_init(&coder->bits, out);
	walk(coder, triangles);
	range_coder_finish(&coder->bits);
	seen = coder->seen;
	edge_table_release(&coder->edges);
	for (int k = 0; k < 3; k++)
		free(coder->values[k]);
	free(coder->gates);
	free(coder->after);
	free(coder->before);
	free(coder->numbers);
	free(coder->taken);
	free(coder);
	return seen;
}
