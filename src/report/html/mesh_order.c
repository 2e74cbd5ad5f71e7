#include "report/html/mesh_order.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"

enum { NONE = UINT32_MAX };

struct order {
	const uint32_t *corners;
	size_t triangles;
	uint32_t *first;	/* by vertex: where its triangles begin in `around`; one more entry than vertices */
	uint32_t *around;	/* triangles by vertex */
	bool *taken;
	uint32_t *stack;	/* edges that may have a triangle beyond: two vertices each */
	size_t depth;
	uint32_t *out;
	size_t written;
};

static void collect(struct order *order, size_t vertices)
{
	const size_t count = 3 * order->triangles;

	for (size_t i = 0; i < count; i++)
		order->first[order->corners[i] + 1]++;
	for (size_t v = 0; v < vertices; v++)
		order->first[v + 1] += order->first[v];
	for (size_t i = count; i-- > 0;)
		order->around[--order->first[order->corners[i] + 1]] = (uint32_t)(i / 3);
	/* Counting down has moved every start to the entry of the vertex after it. */
	memmove(order->first, order->first + 1, vertices * sizeof(*order->first));
	order->first[vertices] = (uint32_t)count;
}

/* A triangle with the edge from `a` to `b` that is not taken; *third is its other vertex. */
static uint32_t find(const struct order *order, uint32_t a, uint32_t b, uint32_t *third)
{
	for (uint32_t i = order->first[a]; i < order->first[a + 1]; i++) {
		const uint32_t t = order->around[i];
		const uint32_t *v = &order->corners[3 * (size_t)t];

		for (int k = 0; k < 3 && !order->taken[t]; k++) {
			if (v[k] == a && v[(k + 1) % 3] == b) {
				*third = v[(k + 2) % 3];
				return t;
			}
		}
	}
	return NONE;
}

static void take(struct order *order, uint32_t triangle, uint32_t a, uint32_t b, uint32_t c)
{
	const uint32_t edges[3][2] = {{b, a}, {a, c}, {c, b}};

	order->taken[triangle] = true;
	order->out[order->written++] = a;
	order->out[order->written++] = b;
	order->out[order->written++] = c;
	/* The edge that is pushed last is looked at first: beyond the newest vertex. */
	memcpy(order->stack + order->depth, edges, sizeof(edges));
	order->depth += 6;
}

static void walk(struct order *order)
{
	while (order->depth) {
		const uint32_t *edge = &order->stack[order->depth -= 2];
		const uint32_t a = edge[0], b = edge[1];
		uint32_t c, t = find(order, a, b, &c);

		if (t != NONE)
			take(order, t, a, b, c);
	}
}

void mesh_order(uint32_t *corners, size_t triangles, size_t vertices)
{
	struct order order = {
		.corners = corners,
		.triangles = triangles,
		.first = mem_zalloc(vertices + 2, sizeof(uint32_t)),
		.around = mem_alloc((3 * triangles + 1) * sizeof(uint32_t)),
		.taken = mem_zalloc(triangles + 1, sizeof(bool)),
		.stack = mem_alloc((6 * triangles + 6) * sizeof(uint32_t)),
		.out = mem_alloc((3 * triangles + 1) * sizeof(uint32_t)),
	};

	collect(&order, vertices);
	for (size_t t = 0; t < triangles; t++) {
		if (order.taken[t])
			continue;
		take(&order, (uint32_t)t, corners[3 * t], corners[3 * t + 1], corners[3 * t + 2]);
		walk(&order);
	}
	memcpy(corners, order.out, 3 * triangles * sizeof(*corners));
	free(order.first);
	free(order.around);
	free(order.taken);
	free(order.stack);
	free(order.out);
}
