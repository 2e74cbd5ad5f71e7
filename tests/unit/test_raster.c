#include "report/picture/raster.h"

#include <math.h>
#include <string.h>

#include "random.h"
#include "suite.h"

enum { WIDTH = 50, HEIGHT = 40, PAINT = 7 };

static double area_of(vec3 a, vec3 b, double x, double y)
{
	return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

/* Is the point in the triangle? -1: it is on a side, or so near to a side that rounding decides. */
static int is_inside(const vec3 p[3], double x, double y)
{
	double side[3];

	for (int k = 0; k < 3; k++) {
		side[k] = area_of(p[k], p[(k + 1) % 3], x, y);
		if (fabs(side[k]) < 1e-9)
			return -1;
	}
	return (side[0] > 0) == (side[1] > 0) && (side[1] > 0) == (side[2] > 0);
}

/* The depth of the triangle's plane at the point, from the areas of the three triangles around the point. */
static double depth_at(const vec3 p[3], double x, double y)
{
	double sum = 0, area = 0;

	for (int k = 0; k < 3; k++) {
		const double share = area_of(p[(k + 1) % 3], p[(k + 2) % 3], x, y);

		sum += share * p[k].z;
		area += share;
	}
	return sum / area;
}

/* A random point in the raster or around it. */
static vec3 random_corner(struct random *random)
{
	return vec3_add((vec3){WIDTH / 2, HEIGHT / 2, 0}, random_point(random, 2 * WIDTH));
}

START_TEST(pixels_are_those_whose_centres_are_inside)
{
	struct random random = {5};
	struct raster raster;
	long painted = 0;

	for (int round = 0; round < 500; round++) {
		const vec3 p[3] = {random_corner(&random), random_corner(&random), random_corner(&random)};

		raster_init(&raster, WIDTH, HEIGHT);
		raster_triangle(&raster, p, PAINT);
		for (int i = 0; i < WIDTH * HEIGHT; i++) {
			const double x = i % WIDTH + 0.5, y = i / WIDTH + 0.5;
			const int inside = is_inside(p, x, y);

			if (inside >= 0)
				ck_assert_int_eq(raster.paints[i], inside ? PAINT : 0);
			if (inside == 1 && fabs(area_of(p[0], p[1], p[2].x, p[2].y)) > 10)
				ck_assert_double_eq_tol((double)raster.depths[i], depth_at(p, x, y), 1e-3);
			painted += inside == 1;
		}
		ck_assert(raster_may_show(&raster, p) || !memchr(raster.paints, PAINT, WIDTH * HEIGHT));
		raster_release(&raster);
	}
	ck_assert_int_gt(painted, 10000);
}
END_TEST

/* Triangles around a point fill the square around it, for every position of the point. */
START_TEST(neighbours_leave_no_gap)
{
	const vec3 corners[4] = {{3, 3, 0}, {40, 3, 1}, {40, 30, 2}, {3, 30, 3}};
	struct random random = {11};

	for (int round = 0; round < 300; round++) {
		const vec3 middle = {random_in(&random, 3, 40), 3 + 0.09 * round, 4};
		struct raster raster;

		raster_init(&raster, WIDTH, HEIGHT);
		for (int k = 0; k < 4; k++)
			raster_triangle(&raster, (vec3[]){corners[k], corners[(k + 1) % 4], middle}, PAINT);
		for (int y = 3; y < 30; y++) {
			for (int x = 3; x < 40; x++)
				ck_assert_int_eq(raster.paints[y * WIDTH + x], PAINT);
		}
		raster_release(&raster);
	}
}
END_TEST

/* The nearer of two triangles is visible in either order of drawing, also if it covers only a few pixels of a row. */
START_TEST(the_nearer_is_seen)
{
	for (int order = 0; order < 2; order++) {
		const vec3 flat[3] = {{-5, -5, 5}, {3 * WIDTH, -5, 5}, {-5, 3 * HEIGHT, 5}};
		const vec3 steep[3] = {{-5, 4, -5}, {3 * WIDTH, 4, 3 * WIDTH}, {-5, 3 * HEIGHT, -5}};
		struct raster raster;

		raster_init(&raster, WIDTH, HEIGHT);
		raster_triangle(&raster, order ? flat : steep, order ? 1 : 2);
		raster_triangle(&raster, order ? steep : flat, order ? 2 : 1);
		for (int x = 0; x < WIDTH; x++)
			ck_assert_int_eq(raster.paints[10 * WIDTH + x], x + 0.5 < 5 ? 1 : 2);
		raster_release(&raster);
	}
}
END_TEST

int main(void)
{
	const TTest *const tests[] = {
	    pixels_are_those_whose_centres_are_inside, neighbours_leave_no_gap, the_nearer_is_seen,
	};

	return RUN_TESTS("raster", tests);
}
