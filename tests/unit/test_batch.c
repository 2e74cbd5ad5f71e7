/* test_batch.c - the boxes of a batch contain exactly what its steps reach; steps past a limit are marked. */
#include "check/batch.h"

#include "geom/tolerance.h"
#include "random.h"
#include "suite.h"

enum { STEPS_MOST = 3 * CHUNK_STEPS };

struct steps {
	struct motion_step of[STEPS_MOST];
	int count;
};

static axis_values random_position(struct random *random)
{
	axis_values q;

	for (int i = 0; i < SLOT_COUNT; i++)
		q.v[i] = random_in(random, -500, 500);
	return q;
}

/* Errors of some axes in some steps; a few are larger than the reach over which pairs out of reach are proved apart. */
static axis_values random_errors(struct random *random)
{
	axis_values errors = {{0}};

	for (int i = 0; i < SLOT_COUNT && !random_below(random, 4); i++)
		if (!random_below(random, 3))
			errors.v[i] = REACH_PATH_TOLERANCE *
				      (random_below(random, 20) ? random_in(random, 0, 1) : random_in(random, 1, 2));
	return errors;
}

static void make_steps(struct random *random, struct steps *steps)
{
	axis_values at = random_position(random);

	steps->count = 1 + random_below(random, STEPS_MOST);
	for (int i = 0; i < steps->count; i++) {
		static const struct path straight = {.kind = PATH_STRAIGHT};
		struct motion_step *step = &steps->of[i];

		*step = (struct motion_step){.span = {.q0 = at, .q1 = random_position(random), .path = &straight},
					     .tolerance = random_errors(random),
					     .outside = random_below(random, 50) == 0,
					     .step_class = (enum step_class)(1 << random_below(random, 3))};
		step->span.chord_error = random_errors(random);
		at = step->span.q1;
	}
}

static bool is_beyond(const struct motion_step *step)
{
	bool beyond = step->outside;

	for (int i = 0; i < SLOT_COUNT; i++)
		beyond = beyond || step->tolerance.v[i] > REACH_PATH_TOLERANCE;
	return beyond;
}

/* Compares the box with the steps from `first` to before `end`. */
static void compare(const struct steps *steps, const struct batch_chunk *box, int first, int end, long n)
{
	bool any = false, beyond = false;
	unsigned classes = 0;

	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		double low = INFINITY, high = -INFINITY, path = 0;

		for (int i = first; i < end; i++) {
			const struct span *span = &steps->of[i].span;
			const double ends[] = {span->q0.v[slot], span->q1.v[slot]}, off = span->chord_error.v[slot];

			low = fmin(low, fmin(ends[0], ends[1]) - off);
			high = fmax(high, fmax(ends[0], ends[1]) + off);
			path = fmax(path, steps->of[i].tolerance.v[slot]);
		}
		require(!(box->low.v[slot] < low || box->low.v[slot] > low), "case %ld: low, step %d", n, first);
		require(!(box->high.v[slot] < high || box->high.v[slot] > high), "case %ld: high, step %d", n, first);
		require(!(box->errors.path.v[slot] < path || box->errors.path.v[slot] > path),
			"case %ld: path tolerance, step %d", n, first);
		require(!(box->errors.chord.v[slot] > 0), "case %ld: chord error, step %d", n, first);
		any = any || path > 0;
	}
	for (int i = first; i < end; i++) {
		beyond = beyond || is_beyond(&steps->of[i]);
		classes |= steps->of[i].step_class;
	}
	require(box->errors.any == any && box->beyond == beyond && box->classes == classes,
		"case %ld: what the box of step %d says of its steps", n, first);
}

START_TEST(boxes_contain_their_steps)
{
	static struct steps steps;
	struct batch batch = {0};

	for (long n = 0; n < random_cases(2000); n++) {
		struct random random = random_case(1, n);

		make_steps(&random, &steps);
		batch_clear(&batch);
		for (int i = 0; i < steps.count; i++)
			batch_add(&batch, &steps.of[i], i, i, 0);
		batch_close(&batch);
		for (int i = 0; i < steps.count; i++)
			require(batch.steps[i].beyond == is_beyond(&steps.of[i]), "case %ld: step %d", n, i);
		for (int first = 0, end; first < steps.count; first = end) {
			end = first + PIECE_STEPS < steps.count ? first + PIECE_STEPS : steps.count;
			compare(&steps, &batch.pieces[first / PIECE_STEPS], first, end, n);
		}
		for (int first = 0, end; first < steps.count; first = end) {
			end = first + CHUNK_STEPS < steps.count ? first + CHUNK_STEPS : steps.count;
			compare(&steps, &batch.chunks[first / CHUNK_STEPS], first, end, n);
		}
	}
	batch_release(&batch);
}
END_TEST

int main(void)
{
	const TTest *const tests[] = {boxes_contain_their_steps};

	return RUN_TESTS("batch", tests);
}
