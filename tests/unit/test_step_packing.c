/* A step that was packed is the same again, bit for bit, whatever of it the last step or its path repeats. */
#include "check/step_packing.h"

#include <stdlib.h>
#include <string.h>

#include "random.h"
#include "suite.h"

static axis_values random_values(struct random *random)
{
	axis_values q;

	for (int i = 0; i < SLOT_COUNT; i++)
		q.v[i] = random_in(random, -500, 500);
	return q;
}

/* The next step and its path: each part repeats the last one, or what is usual, or is new. */
static void random_step(struct random *random, const struct motion_step *last, struct motion_step *step,
			struct path *path)
{
	*step = (struct motion_step){
		.file = "part.nc", .line = random_below(random, 1000), .move = random_below(random, 9),
		.tool = random_below(random, 3), .time = random_in(random, 0, 1e4),
		.block_time = random_in(random, 0, 10), .seconds = random_in(random, 0, 1),
		.outside = random_below(random, 2) == 0, .bounded = random_below(random, 2) == 0,
		.step_class = STEP_FEED_TURNING, .tolerance = last->tolerance};
	*path = (struct path){.kind = random_below(random, 3) ? PATH_STRAIGHT : PATH_BOX,
			      .seconds = random_in(random, 0, 1)};
	step->span = (struct span){.q0 = last->span.q1, .q1 = random_values(random), .u1 = 1};
	if (!random_below(random, 4))
		step->span.q0 = random_values(random);
	if (!random_below(random, 8))
		step->span.q0.v[SLOT_X] = -0.0;
	if (!random_below(random, 4))
		step->span.chord_error = random_values(random);
	if (!random_below(random, 4))
		step->tolerance = random_values(random);
	path->start = step->span.q0;
	path->end = step->span.q1;
	/* A part of a path, or one that does not lead where its chord does. */
	if (!random_below(random, 8))
		step->span.u1 = random_in(random, 0.1, 0.9);
	if (!random_below(random, 8))
		path->start = random_values(random);
	step->span.path = path;
}

/* By their bits: -0 is not 0. */
static void require_same_values(const axis_values *a, const axis_values *b, long n, int i, const char *what)
{
	require(memcmp(a, b, sizeof(*a)) == 0, "case %ld, step %d: %s differs", n, i, what);
}

static void require_same(const struct motion_step *a, const struct motion_step *b, long n, int i)
{
	require_same_values(&a->span.q0, &b->span.q0, n, i, "q0");
	require_same_values(&a->span.q1, &b->span.q1, n, i, "q1");
	require_same_values(&a->span.chord_error, &b->span.chord_error, n, i, "the chord error");
	require_same_values(&a->tolerance, &b->tolerance, n, i, "the tolerance");
	require_same_values(&a->span.path->start, &b->span.path->start, n, i, "the path's start");
	require_same_values(&a->span.path->end, &b->span.path->end, n, i, "the path's end");
	require(a->span.path->kind == b->span.path->kind &&
		memcmp(&a->span.path->seconds, &b->span.path->seconds, sizeof(double)) == 0 &&
		!b->span.path->tcp && !b->span.path->circular, "case %ld, step %d: the path differs", n, i);
	require(memcmp(&a->span.u1, &b->span.u1, sizeof(double)) == 0 && !(b->span.u0 > 0) && a->file == b->file &&
		a->line == b->line && a->move == b->move && a->tool == b->tool && a->outside == b->outside &&
		a->bounded == b->bounded && a->step_class == b->step_class &&
		memcmp(&a->time, &b->time, 3 * sizeof(double)) == 0, "case %ld, step %d: a number differs", n, i);
}

enum { STEPS = 50 };

START_TEST(steps_are_the_same_again)
{
	for (long n = 0; n < random_cases(200); n++) {
		struct random random = random_case(1, n);
		struct step_packing packs = {0}, unpacks = {0};
		struct path_copies paths = {0};
		struct motion_step steps[STEPS + 1] = {0}, got;
		struct path own[STEPS];
		double *packed = malloc(STEPS * step_packing_most());
		size_t used = 0;

		for (int i = 0; i < STEPS; i++) {
			random_step(&random, &steps[i], &steps[i + 1], &own[i]);
			used += step_packing_pack(&packs, &steps[i + 1], &paths, (char *)packed + used);
		}
		ck_assert_uint_le(used, STEPS * step_packing_most());
		used = 0;
		for (int i = 0; i < STEPS; i++) {
			used += step_packing_unpack(&unpacks, (char *)packed + used, &got);
			require_same(&steps[i + 1], &got, n, i);
		}
		free(packed);
		path_copies_release(&paths);
	}
}
END_TEST

/* Most steps of a program are like this one: of all their axis values only the new position is packed. */
START_TEST(a_plain_step_is_packed_without_its_path)
{
	struct path path = {.kind = PATH_STRAIGHT, .end = {{1, 2, 3}}};
	struct motion_step step = {.span = {.q1 = path.end, .u1 = 1, .path = &path}};
	struct step_packing packing = {0};
	struct path_copies paths = {0};
	double *packed = malloc(step_packing_most());

	ck_assert_uint_le(step_packing_pack(&packing, &step, &paths, packed),
			  step_packing_most() - 3 * sizeof(axis_values));
	ck_assert_ptr_null(paths.path);
	free(packed);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("steps");

	tcase_add_test(tcase, steps_are_the_same_again);
	tcase_add_test(tcase, a_plain_step_is_packed_without_its_path);
	return run_suite("step_packing", tcase);
}
