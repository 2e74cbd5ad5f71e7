#include "geom/separating_axis.h"

#include "random.h"
#include "suite.h"
#include "truth.h"

enum { INSTANTS = 65 };

static tri random_tri(struct random *random, vec3 centre, double size)
{
	tri t;

	for (int i = 0; i < 3; i++)
		t.p[i] = vec3_add(centre, random_point(random, size));
	return t;
}

static tri on_chords(const tri *b0, const tri *b1, double s)
{
	tri t;

	for (int i = 0; i < 3; i++)
		t.p[i] = vec3_lerp(b0->p[i], b1->p[i], s);
	return t;
}

static double least_on_chords(const tri *a, const tri *b0, const tri *b1)
{
	double least = INFINITY;
	vec3 x, y;

	for (int i = 0; i < INSTANTS; i++) {
		tri b = on_chords(b0, b1, (double)i / (INSTANTS - 1));

		least = fmin(least, tri_distance(a, &b, &x, &y));
	}
	return least;
}

/* A random unit vector, or the direction between the closest points, slightly turned. */
static vec3 some_axis(struct random *random, const tri *a, const tri *b)
{
	vec3 x, y, n = random_unit(random);

	if (random_below(random, 5) == 0 || tri_distance(a, b, &x, &y) <= 0)
		return n;
	n = vec3_mad(vec3_scale(1 / vec3_norm(vec3_sub(y, x)), vec3_sub(y, x)), random_size(random, 1e-6, 0.5), n);
	return vec3_scale(1 / vec3_norm(n), n);
}

struct chord_case {
	tri a, b0, b1;
	vec3 n0, n1;
	double least, apart;
};

static struct chord_case random_chords(uint64_t test, long number)
{
	struct random random = random_case(test, number);
	struct chord_case c;
	double size = random_size(&random, 0.1, 100), way = random_size(&random, 0.01, 300);
	vec3 to = vec3_scale(random_size(&random, 0.01, 300), random_unit(&random));

	c.a = random_tri(&random, (vec3){0, 0, 0}, size);
	c.b0 = random_tri(&random, to, random_size(&random, 0.1, 100));
	for (int i = 0; i < 3; i++)
		c.b1.p[i] = vec3_add(c.b0.p[i], random_point(&random, way));
	if (random_below(&random, 2)) {
		vec3 shift = random_point(&random, way);

		for (int i = 0; i < 3; i++)
			c.b1.p[i] = vec3_add(c.b0.p[i], shift);
	}
	c.n0 = some_axis(&random, &c.a, &c.b0);
	c.n1 = some_axis(&random, &c.a, &c.b1);
	c.least = least_on_chords(&c.a, &c.b0, &c.b1);
	/* As much as can be proved, or a little more. */
	c.apart =
	    c.least * (random_below(&random, 3) ? random_in(&random, 0, 1.02) : 1 - random_size(&random, 1e-9, 1));
	return c;
}

START_TEST(what_is_witnessed_is_apart)
{
	long fixed = 0, interpolated = 0, more = 0, cases = random_cases(50000);
	double closest = 0;

	for (long n = 0; n < cases; n++) {
		struct chord_case c = random_chords(1, n);
		bool by_n0 = separating_axis_fixed(&c.a, &c.b0, &c.b1, c.n0, c.apart);
		bool by_n1 = separating_axis_fixed(&c.a, &c.b0, &c.b1, c.n1, c.apart);
		bool by_both = separating_axis_interpolated(&c.a, &c.b0, &c.b1, c.n0, c.n1, c.apart);

		fixed += by_n0 || by_n1;
		interpolated += by_both;
		more += by_both && !by_n0 && !by_n1;
		if (!by_n0 && !by_n1 && !by_both)
			continue;
		require(c.least > c.apart * (1 - 1e-12), "case %ld: %g apart was witnessed, %g is", n, c.apart,
			c.least);
		if (c.least > 0)
			closest = fmax(closest, c.apart / c.least);
	}
	require(fixed > cases / 5 && interpolated > cases / 5 && more > cases / 1000,
		"fixed %ld, interpolated %ld, more %ld", fixed, interpolated, more);
	require(closest > 0.999, "the proofs are slack: %g", closest);
}
END_TEST

/* Without the middle Bernstein coefficient, the ends alone would prove false statements. */
START_TEST(ends_alone_do_not_witness)
{
	long wrong = 0, cases = random_cases(30000);

	for (long n = 0; n < cases; n++) {
		struct chord_case c = random_chords(2, n);

		wrong +=
		    tri_gap(&c.a, &c.b0, c.n0) > c.apart && tri_gap(&c.a, &c.b1, c.n1) > c.apart && c.least < c.apart;
	}
	require(wrong > cases / 10000, "%ld", wrong);
}
END_TEST

/* An arm from the x axis to a tip at `radius`, turned about x from upright by `angle`. */
static tri on_circle(double radius, double angle)
{
	const vec3 corners[3] = {{-1, 0, 0}, {1, 0, 0}, {0, 0, radius}};
	xform turn = xform_turn((vec3){0, 0, 0}, (vec3){1, 0, 0}, angle);
	tri t;

	for (int i = 0; i < 3; i++)
		t.p[i] = xform_apply(&turn, corners[i]);
	return t;
}

/* The tip passes a ceiling at the top of its circle; at both ends of the motion it is below the ceiling. */
START_TEST(rotary_dip)
{
	for (long n = 0; n < random_cases(2000); n++) {
		struct random random = random_case(3, n);
		double radius = random_size(&random, 2, 1000), angle = random_size(&random, 1e-3, 1);
		double sagitta = radius * (1 - cos(angle / 2)), bend = angle * angle * radius / 8;
		double ceiling = radius - sagitta * random_in(&random, 0.02, 0.98);
		tri b0 = on_circle(radius, -angle / 2), b1 = on_circle(radius, angle / 2), top = on_circle(radius, 0);
		const tri a = {{{-2000, -2000, ceiling}, {2000, -2000, ceiling}, {0, 3000, ceiling}}};
		const vec3 down = {0, 0, -1};
		vec3 x, y;

		require(tri_distance(&a, &top, &x, &y) <= 0, "case %ld: the tip does not reach the ceiling", n);
		require(separating_axis_fixed(&a, &b0, &b1, down, 0) && separating_axis_interpolated(&a, &b0, &b1, down, down, 0),
			"case %ld: the ends are to be free", n);
		require(!separating_axis_fixed(&a, &b0, &b1, down, bend), "case %ld: fixed", n);
		require(!separating_axis_interpolated(&a, &b0, &b1, down, down, bend), "case %ld: interpolated", n);
	}
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("axes");

	tcase_add_test(tcase, what_is_witnessed_is_apart);
	tcase_add_test(tcase, ends_alone_do_not_witness);
	tcase_add_test(tcase, rotary_dip);
	return run_suite("separating_axis", tcase);
}
