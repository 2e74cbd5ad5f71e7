/* test_gcode_box_cover.c - lines that cover the sweep of a box: they miss no position and add little. */
#include <math.h>
#include <stdlib.h>

#include "gcode/execute/box_cover.h"
#include "suite.h"

#define LINES 20000
#define BESIDE 0.7
#define ROUNDING 1e-6

struct lines {
	struct cover_line line[LINES];
	int count;
};

static double uniform(unsigned *seed, double low, double high)
{
	*seed = *seed * 1664525U + 1013904223U;
	return low + (high - low) * (double)(*seed >> 8) / (double)(1U << 24);
}

static bool keep(void *context, const struct cover_line *line)
{
	struct lines *lines = (struct lines *)context;

	ck_assert_int_lt(lines->count, LINES);
	lines->line[lines->count++] = *line;
	return true;
}

/* Reduces the shares of a line to those within `spread` of a coordinate. */
static void clip(double from, double to, double spread, double place, double share[2])
{
	const double low = place - spread - ROUNDING - from, high = place + spread + ROUNDING - from, way = to - from;

	if (fabs(way) < ROUNDING) {
		if (low > 0 || high < 0)
			share[1] = -1;
		return;
	}
	share[0] = fmax(share[0], fmin(low / way, high / way));
	share[1] = fmin(share[1], fmax(low / way, high / way));
}

static bool is_covered(const struct lines *lines, vec3 place)
{
	for (int i = 0; i < lines->count; i++) {
		const struct cover_line *line = &lines->line[i];
		double share[2] = {0, 1};

		clip(line->from.x, line->to.x, line->spread.x, place.x, share);
		clip(line->from.y, line->to.y, line->spread.y, place.y, share);
		clip(line->from.z, line->to.z, line->spread.z, place.z, share);
		if (share[0] <= share[1])
			return true;
	}
	return false;
}

static vec3 any_place(unsigned *seed, const struct box_way *box)
{
	vec3 place = vec3_mad(box->start, uniform(seed, 0, 1), box->way);

	for (int i = 0; i < 3; i++) {
		/* One in three positions lies in a face. */
		const double share = uniform(seed, -1.5, 1.5);

		place = vec3_mad(place, fmax(-1, fmin(share, 1)), box->half[i]);
	}
	return place;
}

/*
 * A box along the axes or turned in XY, some sides of length 0. The move is none, along a side, in the plane, or in any
 * direction.
 */
static struct box_way any_box(unsigned *seed, int kind)
{
	const double angle = kind % 2 ? uniform(seed, 0, 6) : 0, c = cos(angle), s = sin(angle);
	const double a = uniform(seed, 0, 60), b = uniform(seed, 0, 40);
	const double h = kind % 4 < 2 ? 0 : uniform(seed, 0, 4), way = uniform(seed, -50, 50);
	struct box_way box = {.start = {uniform(seed, -9, 9), uniform(seed, -9, 9), uniform(seed, -9, 9)},
			      .half = {{a * c, a * s, 0}, {-b * s, b * c, 0}, {0, 0, h}}};

	switch (kind / 4) {
	case 0:
		break;
	case 1:
		box.way = (vec3){0, 0, way};
		break;
	case 2:
		box.way = (vec3){way * c, way * s, 0};
		break;
	case 3:
		box.way = (vec3){way, uniform(seed, -50, 50), 0};
		break;
	default:
		box.way = (vec3){way, uniform(seed, -50, 50), uniform(seed, -50, 50)};
		break;
	}
	return box;
}

START_TEST(every_place)
{
	struct lines *lines = calloc(1, sizeof(*lines));
	unsigned seed = (unsigned)_i + 1;

	ck_assert_ptr_nonnull(lines);
	for (int run = 0; run < 4; run++) {
		const struct box_way box = any_box(&seed, _i);

		lines->count = 0;
		ck_assert(box_cover(&box, BESIDE, keep, lines));
		for (int i = 0; i < 300; i++) {
			const vec3 place = any_place(&seed, &box);

			ck_assert_msg(is_covered(lines, place), "kind %d run %d: %g %g %g", _i, run, place.x, place.y,
				      place.z);
		}
	}
	free(lines);
}
END_TEST

/* How far the ball about a place of a line reaches out of an upright box. */
static double reach_out(vec3 place, vec3 spread, vec3 half)
{
	const double out = fmax(fmax(fabs(place.x) - half.x, fabs(place.y) - half.y), fabs(place.z) - half.z);

	return out + vec3_norm(spread);
}

/* Faces and pockets that go down: sizes of half the sides, mm. */
START_TEST(tight)
{
	static const struct {
		vec3 half;
		int most;
	} faces[] = {
		{{150, 100, 25}, 2500}, {{150, 100, 1}, 1500}, {{150, 100, 0}, 150}, {{1000, 300, 20}, 4500},
		{{20, 15, 5}, 400},	{{0.2, 20, 30}, 60},
	};
	struct lines *lines = calloc(1, sizeof(*lines));
	const vec3 half = faces[_i].half;
	const struct box_way box = {.start = {0, 0, half.z},
				    .way = {0, 0, -2 * half.z},
				    .half = {{half.x, 0, 0}, {0, half.y, 0}, {0, 0, 0}}};

	ck_assert_ptr_nonnull(lines);
	ck_assert(box_cover(&box, BESIDE, keep, lines));
	ck_assert_int_le(lines->count, faces[_i].most);
	for (int i = 0; i < lines->count; i++) {
		const struct cover_line *line = &lines->line[i];

		ck_assert_double_le(reach_out(line->from, line->spread, half), BESIDE + ROUNDING);
		ck_assert_double_le(reach_out(line->to, line->spread, half), BESIDE + ROUNDING);
	}
	free(lines);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("gcode_box_cover");

	tcase_add_loop_test(tcase, every_place, 0, 20);
	tcase_add_loop_test(tcase, tight, 0, 6);
	return run_suite("gcode_box_cover", tcase);
}
