/* test_cylinder_box.c - the distance of a cylinder from a box, in closed forms and against all triangles of both. */
#include "geom/cylinder_box.h"

#include "solids.h"
#include "suite.h"

/* Around the Z axis, from z up. */
static struct cylinder upright(double x, double y, double z, double length, double radius)
{
	return (struct cylinder){{x, y, z}, {0, 0, 1}, length, radius};
}

static const struct solid_box CUBE = {{0, 0, 0}, {10, 10, 10}};

static void expect(struct cylinder cylinder, double distance)
{
	const struct cylinder upside_down = {vec3_mad(cylinder.base, cylinder.length, cylinder.along),
					     vec3_scale(-1, cylinder.along), cylinder.length, cylinder.radius};
	double found = cylinder_box_distance(&cylinder, &CUBE, 0);

	require(found >= distance - 1e-9 && found <= 1.0102 * distance + 1e-9, "%.12g mm, not %.12g", found, distance);
	found = cylinder_box_distance(&upside_down, &CUBE, 0);
	require(found >= distance - 1e-9 && found <= 1.0102 * distance + 1e-9, "upside down %.12g mm, not %.12g", found,
		distance);
}

START_TEST(closed_forms)
{
	const double diagonal = sqrt(0.5);

	/* Above a face, inside of its edges and farther out than the cylinder is thick. */
	expect(upright(0, 0, 15, 40, 3), 5);
	expect(upright(9, -9, 15, 40, 3), 5);
	expect(upright(12, 0, 15, 40, 3), 5);
	expect(upright(0, 0, 15, 40, 300), 5);
	/* Beside a face, an edge; below a corner; a rim off an edge. */
	expect(upright(17, 0, -2, 40, 3), 4);
	expect(upright(13, 14, -2, 40, 1), 4);
	expect(upright(14, 14, -100, 40, 1), sqrt(50 * 50 + pow(sqrt(32) - 1, 2)));
	expect(upright(16, 0, 14, 40, 3), 5);
	/* Points, lines and discs. */
	expect(upright(13, 14, 10, 0, 0), 5);
	expect(upright(13, 14, 0, 5, 0), 5);
	expect(upright(13, 0, 14, 0, 3), 4);
	/* Lying on a side: an edge of the box across it. */
	expect((struct cylinder){{0, -50, 20}, {0, 1, 0}, 100, 4}, 6);
	expect((struct cylinder){{30, -50, 30}, {0, 1, 0}, 100, 4}, sqrt(800) - 4);
	/* Tilted over a face: the lower rim is nearest. */
	expect((struct cylinder){{0, 0, 30}, {diagonal, 0, diagonal}, 100, 5}, 20 - 5 * diagonal);
	/* They meet, or one is within the other. */
	expect(upright(0, 0, 10, 40, 3), 0);
	expect(upright(0, 0, -2, 4, 3), 0);
	expect(upright(0, 0, -200, 400, 300), 0);
	expect(upright(12, 0, 9, 40, 3), 0);
}
END_TEST

START_TEST(ends_once_it_is_near_enough)
{
	const struct cylinder corner = upright(30, 31, 32, 40, 3);
	const double exact = cylinder_box_distance(&corner, &CUBE, 0);

	ck_assert_double_ge(cylinder_box_distance(&corner, &CUBE, 1e6), exact - 1e-9);
	ck_assert_double_lt(cylinder_box_distance(&corner, &CUBE, 1.01 * exact), 1.0101 * exact);
}
END_TEST

enum { SIDES = 48 };
/* mm, of cylinder_box_distance */
static const double GRAZING = 0.05;

/* The cylinder as a prism, and the box, in the box's coordinates. */
static double true_distance_of(const struct cylinder *cylinder, const struct solid_box *box, const xform *place)
{
	struct mesh prism = {0}, cuboid = {0};
	const xform here = xform_identity();
	struct bvh *a, *b;
	double distance;

	solid_prism(&prism, SIDES, cylinder->radius, 0.5 * cylinder->length, 1);
	solid_place(&prism, place);
	solid_box(&cuboid, box->half);
	a = bvh_new(&prism);
	b = bvh_new(&cuboid);
	distance = brute_distance(a, b, &here, 1e9);
	bvh_free(a);
	bvh_free(b);
	return distance;
}

/* Is the middle of one inside the other? */
static bool holds_the_other(const struct cylinder *cylinder, const struct solid_box *box, const xform *place)
{
	const vec3 m = place->translation, to = vec3_scale(-1, m);
	const double height = vec3_dot(to, cylinder->along);

	return (fabs(m.x) < box->half.x && fabs(m.y) < box->half.y && fabs(m.z) < box->half.z) ||
	       (fabs(height) < 0.5 * cylinder->length &&
		vec3_norm(vec3_mad(to, -height, cylinder->along)) < cylinder->radius);
}

START_TEST(random_places)
{
	const long cases = random_cases(150);
	long apart = 0;

	for (long n = 0; n < cases; n++) {
		struct random random = random_case(1, n);
		const double x = random_size(&random, 1, 100), y = random_size(&random, 1, 100);
		const struct solid_box box = {{0, 0, 0}, {x, y, random_size(&random, 1, 100)}};
		const xform place = random_place(&random, 70);
		struct cylinder cylinder = {.along = place.rotation.z, .length = random_size(&random, 1, 200)};
		double found, truth;

		cylinder.radius = random_size(&random, 0.1, 50);
		cylinder.base = vec3_mad(place.translation, -0.5 * cylinder.length, cylinder.along);
		found = cylinder_box_distance(&cylinder, &box, 0);
		truth = true_distance_of(&cylinder, &box, &place);
		if (found < 0.01) {
			require(truth < 0.02 || holds_the_other(&cylinder, &box, &place), "case %ld: 0, not %g mm", n,
				truth);
			continue;
		}
		apart++;
		/* The prism is within the cylinder; the search is slow along edges that graze. */
		require(found <= 1.0102 * truth + GRAZING &&
			    found >= truth - cylinder.radius * (1 - cos(PI / SIDES)) - 1e-3,
			"case %ld: %.9g mm, not %.9g", n, found, truth);
	}
	/* In a small number of cases all may be apart. */
	require(apart > cases / 2 && (apart < cases || cases < 50), "%ld of %ld apart", apart, cases);
}
END_TEST

int main(void)
{
	const TTest *const tests[] = {closed_forms, ends_once_it_is_near_enough, random_places};

	return RUN_TESTS("cylinder_box", tests);
}
