#include "report/picture/raster.h"

#include <math.h>
#include <stdlib.h>

#include "base/mem.h"

void raster_init(struct raster *raster, int width, int height)
{
	const size_t count = (size_t)width * (size_t)height;

	*raster = (struct raster){width, height, mem_zalloc(count, 1), mem_alloc(count * sizeof(float))};
	for (size_t i = 0; i < count; i++)
		raster->depths[i] = -INFINITY;
}

void raster_release(struct raster *raster)
{
	free(raster->paints);
	free(raster->depths);
	*raster = (struct raster){0};
}

/* Twice the area of the triangle a b c, positive if it turns from x to y. */
static double area_of(vec3 a, vec3 b, vec3 c)
{
	return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

static double least_of(double a, double b, double c)
{
	const double ab = a < b ? a : b;

	return ab < c ? ab : c;
}

static double most_of(double a, double b, double c)
{
	const double ab = a > b ? a : b;

	return ab > c ? ab : c;
}

/* The pixels of a row, or of a column, whose centres are between low and high: from *first to the one before *end. */
static void pixels_between(double low, double high, int most, int *first, int *end)
{
	const double from = low - 0.5, to = high - 0.5;

	/* Casts instead of ceil and floor, which are calls: this is done for each triangle. */
	*first = !(from > 0) ? 0 : from > most ? most : (int)from + (from > (int)from);
	*end = !(to >= 0) ? 0 : to + 1 > most ? most : (int)to + 1;
}

static void bounds_of(const struct raster *raster, const vec3 p[3], int x[2], int y[2])
{
	pixels_between(least_of(p[0].x, p[1].x, p[2].x), most_of(p[0].x, p[1].x, p[2].x), raster->width, &x[0], &x[1]);
	pixels_between(least_of(p[0].y, p[1].y, p[2].y), most_of(p[0].y, p[1].y, p[2].y), raster->height, &y[0], &y[1]);
}

bool raster_may_show(const struct raster *raster, const vec3 p[3])
{
	int x[2], y[2];

	bounds_of(raster, p, x, y);
	return x[0] < x[1] && y[0] < y[1];
}

/* A share of a corner along a row: `at` in the first pixel, `step` more in each later one. */
struct share {
	double at, step;
	double pixels;	/* -1 / step */
};

/* Narrows the pixels *from to *to - 1 of a row to those where the share may be 0 or more. */
static void narrow(const struct share *share, int *from, int *to)
{
	/* One pixel to spare: the share itself is tested later. */
	const double zero = share->at * share->pixels;

	if (share->step > 0 && zero - 1 > *from)
		*from = zero - 1 < *to ? (int)(zero - 1) : *to;
	else if (share->step < 0 && zero + 2 < *to)
		*to = zero + 2 > *from ? (int)(zero + 2) : *from;
}

/*
 * How the share of the corner opposite the side from p to q changes; `at` is that in the first pixel of the first row.
 */
static struct share share_of(vec3 p, vec3 q, double inverse_area, int x, int y, double *down)
{
	const double step = (p.y - q.y) * inverse_area;

	*down = (q.x - p.x) * inverse_area;
	return (struct share){area_of(p, q, (vec3){x + 0.5, y + 0.5, 0}) * inverse_area, step, -1 / step};
}

static bool is_inside(const struct share *a, const struct share *b, int x)
{
	const double of_a = a->at + x * a->step, of_b = b->at + x * b->step;

	return of_a >= 0 && of_b >= 0 && 1 - of_a - of_b >= 0;
}

/* Paints the pixels *from to *to - 1 of a row where nothing nearer is; depths change by `step` from one to the next. */
static void draw_row(struct raster *raster, int y, int from, int to, double at, double step, uint8_t paint)
{
	float *depths = raster->depths + (size_t)y * (size_t)raster->width;
	uint8_t *paints = raster->paints + (size_t)y * (size_t)raster->width;

	for (int x = from; x < to; x++) {
		const float depth = (float)(at + x * step);

		if (depth > depths[x]) {
			depths[x] = depth;
			paints[x] = paint;
		}
	}
}

void raster_triangle(struct raster *raster, const vec3 p[3], uint8_t paint)
{
	const double area = area_of(p[0], p[1], p[2]);
	const double a_depth = p[0].z - p[2].z, b_depth = p[1].z - p[2].z;
	int columns[2], rows[2];
	double a_down, b_down;
	struct share a, b, c;

	if (!(fabs(area) > 0))
		return;
	bounds_of(raster, p, columns, rows);
	/* Shares of the first two corners; of the third there is what is left. */
	a = share_of(p[1], p[2], 1 / area, 0, rows[0], &a_down);
	b = share_of(p[2], p[0], 1 / area, 0, rows[0], &b_down);
	c = (struct share){1 - a.at - b.at, -a.step - b.step, 1 / (a.step + b.step)};
	for (int y = rows[0]; y < rows[1]; y++) {
		int from = columns[0], to = columns[1];

		narrow(&a, &from, &to);
		narrow(&b, &from, &to);
		narrow(&c, &from, &to);
		while (from < to && !is_inside(&a, &b, from))
			from++;
		while (from < to && !is_inside(&a, &b, to - 1))
			to--;
		draw_row(raster, y, from, to, p[2].z + a.at * a_depth + b.at * b_depth,
			 a.step * a_depth + b.step * b_depth, paint);
		a.at += a_down;
		b.at += b_down;
		c.at -= a_down + b_down;
	}
}
