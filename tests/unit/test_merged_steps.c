#include "check/certified/merged_steps.h"

#include <math.h>

#include "random.h"
#include "suite.h"

enum { STEPS = MERGED_STEPS_MAX };

/* A path of straight steps and pieces of arcs, some of them long and some short. */
struct way {
	struct random random;
	struct path paths[STEPS];
	struct batch_step steps[STEPS];
};

static struct path random_path(struct random *random, const axis_values *from)
{
	struct path path = {.kind = PATH_STRAIGHT, .start = *from, .end = *from, .seconds = 1};
	double size = random_size(random, 1e-3, 10);

	for (int k = 0; k < SLOT_COUNT; k++)
		path.end.v[k] +=
		    random_below(random, 3) ? size * random_in(random, -1, 1) * (slot_is_rotary(k) ? 0.01 : 1) : 0;
	if (random_below(random, 3))
		return path;
	path.kind = PATH_ARC;
	path.circular = true;
	path.arc = (struct canon_arc){{from->v[SLOT_X] + size, from->v[SLOT_Y], from->v[SLOT_Z]}, {0, 0, 1},
				      random_in(random, -1, 1)};
	path.end.v[SLOT_X] = path.arc.centre.x - size * cos(path.arc.sweep);
	path.end.v[SLOT_Y] = path.arc.centre.y - size * sin(path.arc.sweep);
	path.end.v[SLOT_Z] = from->v[SLOT_Z];
	return path;
}

static void way_init(struct way *way, uint64_t test, long number)
{
	axis_values at = {{0}};

	way->random = random_case(test, number);
	for (int i = 0; i < STEPS; i++) {
		struct motion_step *step = &way->steps[i].motion;

		way->paths[i] = random_path(&way->random, &at);
		*step = (struct motion_step){.line = 1};
		span_init(&step->span, &way->paths[i]);
		step->span.q0 = at;
		at = step->span.q1;
	}
}

/* Is q, within its deviations, on the chord at *s or later? *s becomes the earliest such place. False: nowhere. */
static bool is_held(const struct chord *chord, const axis_values *q, double *s)
{
	double low = *s, high = 1;

	for (int k = 0; k < SLOT_COUNT; k++) {
		double d = chord->q1.v[k] - chord->q0.v[k], off = q->v[k] - chord->q0.v[k],
		       play = chord->chord_error.v[k] + 1e-9;

		if (fabs(d) < 1e-12) {
			if (fabs(off) > play)
				return false;
			continue;
		}
		low = fmax(low, (d > 0 ? off - play : off + play) / d);
		high = fmin(high, (d > 0 ? off + play : off - play) / d);
	}
	if (low > high)
		return false;
	*s = low;
	return true;
}

/* Every true position of the piece u0..u1 of the path is near the chord, in the same order. */
static void require_held(const struct way *way, const struct chord *chord, long number)
{
	double s = 0;

	for (int i = 0; i <= 64; i++) {
		double u = chord->u0 + (chord->u1 - chord->u0) * i / 64;
		size_t step = (size_t)u < STEPS ? (size_t)u : STEPS - 1;
		axis_values q = path_position(&way->paths[step], u - (double)step);

		require(is_held(chord, &q, &s), "case %ld: at %g of %g to %g the way is off the chord", number, u,
			chord->u0, chord->u1);
	}
}

START_TEST(the_way_is_near_its_chord_and_its_halves)
{
	long cases = random_cases(2000);

	for (long n = 0; n < cases; n++) {
		struct way way;
		size_t count;
		struct chord chord, halves[2];

		way_init(&way, 1, n);
		count = (size_t)1 << random_below(&way.random, 6);
		chord = merged_steps_chord(way.steps, count);
		for (int depth = 0; depth < 9; depth++) {
			int side = random_below(&way.random, 2);

			require_held(&way, &chord, n);
			chord.halve(&chord, &halves[0], &halves[1]);
			require_held(&way, &halves[1 - side], n);
			for (int k = 0; k < SLOT_COUNT; k++) {
				require(fabs(halves[0].q0.v[k] - chord.q0.v[k]) <= 0 &&
						fabs(halves[1].q1.v[k] - chord.q1.v[k]) <= 0 &&
						fabs(halves[0].q1.v[k] - halves[1].q0.v[k]) <= 0,
					"case %ld: the halves do not meet", n);
			}
			chord = halves[side];
		}
	}
}
END_TEST

/* Steps on one line at different speeds are one straight motion. */
START_TEST(a_line_in_pieces_deviates_by_nothing)
{
	const double ends[] = {0, 1, 1.001, 7, 8};
	struct path paths[4];
	struct batch_step steps[4];
	struct chord chord;

	for (int i = 0; i < 4; i++) {
		paths[i] = (struct path){.kind = PATH_STRAIGHT, .seconds = 1};
		for (int k = 0; k < SLOT_COUNT; k++) {
			paths[i].start.v[k] = ends[i] * (k + 1);
			paths[i].end.v[k] = ends[i + 1] * (k + 1);
		}
		span_init(&steps[i].motion.span, &paths[i]);
	}
	chord = merged_steps_chord(steps, 4);
	for (int k = 0; k < SLOT_COUNT; k++)
		ck_assert_double_le(chord.chord_error.v[k], 1e-12);
}
END_TEST

START_TEST(rapids_of_unknown_way_are_left_out)
{
	struct path path = {.kind = PATH_BOX};
	struct batch_step step = {.block = 0};

	step.motion.span.path = &path;
	ck_assert(!merged_steps_takes(&step));
	path.kind = PATH_ARC;
	ck_assert(merged_steps_takes(&step));
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("several steps as one");

	tcase_add_test(tcase, the_way_is_near_its_chord_and_its_halves);
	tcase_add_test(tcase, a_line_in_pieces_deviates_by_nothing);
	tcase_add_test(tcase, rapids_of_unknown_way_are_left_out);
	return run_suite("merged_steps", tcase);
}
