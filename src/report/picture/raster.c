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

	/* Casts instead of ceil and floor, which are function calls: this is done for each triangle. */
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

/*
 * The crossing of a side of a triangle with the middle of row y, in pixels from the centre of the first one: at + y
 * slope.
 */
struct side {
	double at, slope;
};

/* The sides that cross rows, at most three: those at the left end of a row, and those at its right end. */
struct sides {
	struct side left[3], right[3];
	int left_count, right_count;
};

/*
 * Each side begins at its upper end, so that two triangles with a common side get the same numbers and leave no gap. A
 * horizontal side limits the rows, not the pixels in them.
 */
static struct sides sides_of(const vec3 p[3], double area)
{
	struct sides sides = {.left_count = 0};

	for (int k = 0; k < 3; k++) {
		const vec3 from = p[k], to = p[(k + 1) % 3];
		const bool down = from.y < to.y;
		const vec3 upper = down ? from : to, lower = down ? to : from;
		const double slope = (lower.x - upper.x) / (lower.y - upper.y);
		const struct side side = {upper.x + (0.5 - upper.y) * slope - 0.5, slope};

		if (!(upper.y < lower.y))
			continue;
		if (down == (area > 0))
			sides.right[sides.right_count++] = side;
		else
			sides.left[sides.left_count++] = side;
	}
	return sides;
}

/* Narrows the pixels *low to *high of row y to those whose centres are between the sides. */
static void narrow(const struct sides *sides, int y, double *low, double *high)
{
	for (int k = 0; k < sides->left_count; k++) {
		const double x = sides->left[k].at + y * sides->left[k].slope;

		*low = x > *low ? x : *low;
	}
	for (int k = 0; k < sides->right_count; k++) {
		const double x = sides->right[k].at + y * sides->right[k].slope;

		*high = x < *high ? x : *high;
	}
}

/*
 * Paints `count` adjacent pixels where nothing is nearer; depths change by `step` from one to the next. It has no
 * branches and uses floats, like the depth buffer, so that compilers vectorise it: most of a picture's time is spent
 * here.
 */
static void draw_pixels(float *restrict depths, uint8_t *restrict paints, int count, float first, float step,
			uint8_t paint)
{
	for (int i = 0; i < count; i++) {
		const float depth = first + (float)i * step, before = depths[i];
		const uint8_t old = paints[i];

		paints[i] = before >= depth ? old : paint;
		depths[i] = before < depth ? depth : before;
	}
}

void raster_triangle(struct raster *raster, const vec3 p[3], uint8_t paint)
{
	const double area = area_of(p[0], p[1], p[2]);
	const vec3 b = vec3_sub(p[1], p[0]), c = vec3_sub(p[2], p[0]);
	double depth, right, down;	/* of the first pixel; the changes to the next pixel and to the next row */
	struct sides sides;
	int columns[2], rows[2];

	if (!(fabs(area) > 0))
		return;
	right = (b.z * c.y - c.z * b.y) / area;
	down = (c.z * b.x - b.z * c.x) / area;
	depth = p[0].z + (0.5 - p[0].x) * right + (0.5 - p[0].y) * down;
	bounds_of(raster, p, columns, rows);
	sides = sides_of(p, area);
	for (int y = rows[0]; y < rows[1]; y++) {
		double low = columns[0], high = columns[1] - 1;
		size_t first;
		int from;

		narrow(&sides, y, &low, &high);
		if (low > high)
			continue;
		from = (int)low + (low > (int)low);
		first = (size_t)y * (size_t)raster->width + (size_t)from;
		draw_pixels(raster->depths + first, raster->paints + first, (int)high + 1 - from,
			    (float)(depth + from * right + y * down), (float)right, paint);
	}
}
