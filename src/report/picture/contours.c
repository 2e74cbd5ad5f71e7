#include "report/picture/contours.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "base/math/math_functions.h"
#include "base/mem.h"

struct corner {
	int x, y;
};

struct tracer {
	const struct raster *raster;
	uint8_t paint;
	bool *seen;	/* by pixel: its upper side is part of an outline that was traced */
	struct corner *corners;
	size_t count, capacity;
	bool *kept;	/* by corner */
};

static bool is_inside(const struct tracer *tracer, int x, int y)
{
	const struct raster *raster = tracer->raster;

	return x >= 0 && y >= 0 && x < raster->width && y < raster->height &&
	       raster->paints[y * raster->width + x] == tracer->paint;
}

/* East, south, west, north. */
static const int dx[4] = {1, 0, -1, 0}, dy[4] = {0, 1, 0, -1};

/* The pixel ahead of a corner, to the left or to the right of the direction. */
static bool ahead(const struct tracer *tracer, struct corner at, int direction, bool left)
{
	static const int left_x[4] = {0, 0, -1, -1}, left_y[4] = {-1, 0, 0, -1};
	static const int right_x[4] = {0, -1, -1, 0}, right_y[4] = {0, 0, -1, -1};

	return is_inside(tracer, at.x + (left ? left_x : right_x)[direction],
			 at.y + (left ? left_y : right_y)[direction]);
}

static void push(struct tracer *tracer, struct corner at)
{
	tracer->corners = mem_grow(tracer->corners, &tracer->capacity, tracer->count + 1, sizeof(*tracer->corners));
	tracer->corners[tracer->count++] = at;
}

/* Follows an outline with the inside on the right, from the upper side of a pixel. Returns twice its area, signed. */
static long trace(struct tracer *tracer, int x, int y)
{
	const struct corner start = {x, y};
	struct corner at = start;
	int direction = 0;
	long area = 0;

	tracer->count = 0;
	do {
		if (direction == 0)
			tracer->seen[at.y * tracer->raster->width + at.x] = true;
		area += (long)at.x * (at.y + dy[direction]) - (long)(at.x + dx[direction]) * at.y;
		at.x += dx[direction];
		at.y += dy[direction];
		if (ahead(tracer, at, direction, true)) {
			push(tracer, at);
			direction = (direction + 3) % 4;
		} else if (!ahead(tracer, at, direction, false)) {
			push(tracer, at);
			direction = (direction + 1) % 4;
		}
	} while (at.x != start.x || at.y != start.y || direction != 0);
	return area;
}

static double distance_of(struct corner p, struct corner a, struct corner b)
{
	const double x = b.x - a.x, y = b.y - a.y, length = math_hypot(x, y);

	if (!(length > 0))
		return math_hypot(p.x - a.x, p.y - a.y);
	return fabs(x * (p.y - a.y) - y * (p.x - a.x)) / length;
}

/* Keeps the corners between `from` and `to` that are needed (Douglas and Peucker). */
static void simplify(struct tracer *tracer, size_t from, size_t to, double tolerance)
{
	const struct corner *c = tracer->corners;
	double most = tolerance;
	size_t farthest = from;

	for (size_t i = from + 1; i < to; i++) {
		const double distance = distance_of(c[i], c[from], c[to]);

		if (distance > most) {
			most = distance;
			farthest = i;
		}
	}
	if (farthest == from)
		return;
	tracer->kept[farthest] = true;
	simplify(tracer, from, farthest, tolerance);
	simplify(tracer, farthest, to, tolerance);
}

/* The corner farthest from the first one. */
static size_t farthest_corner(const struct tracer *tracer)
{
	const struct corner *c = tracer->corners;
	size_t best = 0;

	for (size_t i = 1; i < tracer->count; i++) {
		if (math_hypot(c[i].x - c[0].x, c[i].y - c[0].y) > math_hypot(c[best].x - c[0].x, c[best].y - c[0].y))
			best = i;
	}
	return best;
}

static void add_number(struct strbuf *out, int number, bool first)
{
	strbuf_addf(out, first || number < 0 ? "%d" : " %d", number);
}

static void add_loop(struct strbuf *out, struct tracer *tracer, double tolerance)
{
	const size_t half = farthest_corner(tracer), count = tracer->count;
	struct corner last;

	push(tracer, tracer->corners[0]);
	tracer->kept = mem_zalloc(tracer->count, sizeof(bool));
	tracer->kept[0] = tracer->kept[half] = true;
	simplify(tracer, 0, half, tolerance);
	simplify(tracer, half, count, tolerance);
	last = tracer->corners[0];
	strbuf_addf(out, "M%d %dl", last.x, last.y);
	for (size_t i = 1, written = 0; i < count; i++) {
		const struct corner at = tracer->corners[i];

		if (!tracer->kept[i])
			continue;
		add_number(out, at.x - last.x, !written++);
		add_number(out, at.y - last.y, false);
		last = at;
	}
	strbuf_addf(out, "z");
	free(tracer->kept);
}

/* The outlines that begin in this row. */
static void add_row(struct strbuf *out, struct tracer *tracer, int y, double tolerance, int least)
{
	const uint8_t *row = tracer->raster->paints + (size_t)y * (size_t)tracer->raster->width;
	const uint8_t *end = row + tracer->raster->width, *at = row;

	for (; at < end && (at = memchr(at, tracer->paint, (size_t)(end - at))); at++) {
		const int x = (int)(at - row);

		if (is_inside(tracer, x, y - 1) || tracer->seen[y * tracer->raster->width + x])
			continue;
		if (labs(trace(tracer, x, y)) >= 2L * least)
			add_loop(out, tracer, tolerance);
	}
}

void contours_add(struct strbuf *out, const struct raster *raster, uint8_t paint, double tolerance, int least)
{
	const size_t count = (size_t)raster->width * (size_t)raster->height;
	struct tracer tracer = {.raster = raster, .paint = paint};

	if (!memchr(raster->paints, paint, count))
		return;
	tracer.seen = mem_zalloc(count, sizeof(bool));
	for (int y = 0; y < raster->height; y++)
		add_row(out, &tracer, y, tolerance, least);
	free(tracer.seen);
	free(tracer.corners);
}
