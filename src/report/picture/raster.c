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

static int clamp(double value, int most)
{
	return value < 0 ? 0 : value > most ? most : (int)value;
}

/* Twice the area of the triangle a b c, positive if it turns from x to y. */
static double area_of(vec3 a, vec3 b, vec3 c)
{
	return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

static void draw_pixel(struct raster *raster, int x, int y, float depth, uint8_t paint)
{
	const size_t i = (size_t)y * (size_t)raster->width + (size_t)x;

	if (depth <= raster->depths[i])
		return;
	raster->depths[i] = depth;
	raster->paints[i] = paint;
}

void raster_triangle(struct raster *raster, const vec3 p[3], uint8_t paint)
{
	const double area = area_of(p[0], p[1], p[2]);
	const int x0 = clamp(floor(fmin(p[0].x, fmin(p[1].x, p[2].x))), raster->width);
	const int x1 = clamp(ceil(fmax(p[0].x, fmax(p[1].x, p[2].x))), raster->width);
	const int y0 = clamp(floor(fmin(p[0].y, fmin(p[1].y, p[2].y))), raster->height);
	const int y1 = clamp(ceil(fmax(p[0].y, fmax(p[1].y, p[2].y))), raster->height);

	double a_step, b_step;

	if (!(fabs(area) > 0))
		return;
	/* How a and b, the shares of the first two corners, change from pixel to pixel. */
	a_step = (p[1].y - p[2].y) / area;
	b_step = (p[2].y - p[0].y) / area;
	for (int y = y0; y < y1; y++) {
		const vec3 at = {x0 + 0.5, y + 0.5, 0};
		const double a0 = area_of(p[1], p[2], at) / area, b0 = area_of(p[2], p[0], at) / area;

		for (int x = x0; x < x1; x++) {
			const double a = a0 + (x - x0) * a_step, b = b0 + (x - x0) * b_step;

			if (a >= 0 && b >= 0 && a + b <= 1)
				draw_pixel(raster, x, y, (float)(a * p[0].z + b * p[1].z + (1 - a - b) * p[2].z), paint);
		}
	}
}
