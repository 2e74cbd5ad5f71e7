#include "report/picture/silhouettes.h"

#include "report/picture/stage.h"
#include "suite.h"

enum { SIZE = 40, BRIGHT = PAINT_A * PAINT_LEVELS + 5, DARK = PAINT_A * PAINT_LEVELS };

/* A square whose depth is 10 at its left edge and grows by `slope` per pixel to the right. */
static void draw_square(struct raster *raster, double slope)
{
	const vec3 low = {10, 10, 10}, right = {30, 10, 10 + 20 * slope}, far = {30, 30, 10 + 20 * slope},
		   down = {10, 30, 10};

	raster_triangle(raster, (vec3[]){low, right, far}, BRIGHT);
	raster_triangle(raster, (vec3[]){low, far, down}, BRIGHT);
}

static uint8_t at(const struct raster *raster, int x, int y)
{
	return raster->paints[y * raster->width + x];
}

START_TEST(a_square_has_a_dark_rim)
{
	struct raster raster;

	raster_init(&raster, SIZE, SIZE);
	draw_square(&raster, 0);
	silhouettes_add(&raster, 2, 1);
	for (int y = 0; y < SIZE; y++) {
		for (int x = 0; x < SIZE; x++) {
			const bool within = x >= 10 && x < 30 && y >= 10 && y < 30;
			const bool inner = x >= 12 && x < 28 && y >= 12 && y < 28;

			ck_assert_int_eq(at(&raster, x, y), inner ? BRIGHT : within ? DARK : 0);
		}
	}
	raster_release(&raster);
}
END_TEST

/* A steep surface has no edges inside, and none where it lies on a wall. */
START_TEST(a_slope_has_no_edge)
{
	const vec3 wall[2][3] = {{{0, 0, 9.5}, {SIZE, 0, 9.5}, {SIZE, SIZE, 9.5}},
				 {{0, 0, 9.5}, {SIZE, SIZE, 9.5}, {0, SIZE, 9.5}}};
	struct raster raster;

	raster_init(&raster, SIZE, SIZE);
	raster_triangle(&raster, wall[0], PAINT_BASE * PAINT_LEVELS + 4);
	raster_triangle(&raster, wall[1], PAINT_BASE * PAINT_LEVELS + 4);
	draw_square(&raster, 3);
	silhouettes_add(&raster, 2, 1);
	ck_assert_int_eq(at(&raster, 20, 20), BRIGHT);
	ck_assert_int_eq(at(&raster, 10, 20), BRIGHT);
	ck_assert_int_eq(at(&raster, 29, 20), DARK);
	ck_assert_int_eq(at(&raster, 5, 20), PAINT_BASE * PAINT_LEVELS + 4);
	raster_release(&raster);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("edges");

	tcase_add_test(tcase, a_square_has_a_dark_rim);
	tcase_add_test(tcase, a_slope_has_no_edge);
	return run_suite("silhouettes", tcase);
}
