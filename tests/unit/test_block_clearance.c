#include "check/measure/block_clearance.h"

#include "first_contact.h"
#include "step_program.h"
#include "suite.h"

/* Does the oracle find a position in the steps where the bodies are as near as this? */
static bool comes_within(const struct program *p, int first, int last, double distance)
{
	for (int i = first; i < last; i++) {
		if (oracle_first(&p->duo, &p->corners[i], &p->corners[i + 1], distance, p->tolerance) < INFINITY)
			return true;
	}
	return false;
}

/* The least share of the true distance that a sharp bound must reach. */
#define SHARE 0.85

/* mm: the largest true distance that this accuracy allows for a bound. */
static double could_be(enum clearance_accuracy accuracy, double bound)
{
	double low = bound, high = 10 * bound + 1;

	for (int i = 0; i < 100; i++) {
		double middle = 0.5 * (low + high);

		if (clearance_accuracy_promised(accuracy, middle) > bound)
			high = middle;
		else
			low = middle;
	}
	return high;
}

/* Measures a block of a few steps and compares the bound with the truth; true if the bound is neither 0 nor `most`. */
static bool measure_block(const struct program *p, struct block_clearance *block, struct sweep *sweep, int first,
			  int last, double most, enum clearance_accuracy accuracy, long number)
{
	double bound;

	block_clearance_start(block, most);
	for (int i = first; i < last; i++) {
		struct path path = path_between(&p->corners[i], &p->corners[i + 1], PATH_STRAIGHT);
		struct motion_step step = step_on(&path);

		block_clearance_step(block, sweep, &step, p->tolerance, accuracy);
	}
	bound = block->pair.bound;
	require(bound >= 0 && bound <= most, "case %ld, step %d: a bound of %g", number, first, bound);
	require(bound <= 0 || !comes_within(p, first, last, bound * (1 - 1e-9)),
		"case %ld, step %d: %.9g mm proven, it is less", number, first, bound);
	require(bound >= clearance_accuracy_promised(accuracy, most) - p->tolerance ||
			comes_within(p, first, last, could_be(accuracy, bound) + 3 * p->tolerance),
		"case %ld, step %d: only %.9g mm proven, it is much more", number, first, bound);
	return bound > 0 && bound < most;
}

START_TEST(between_the_truth_and_a_share_of_it)
{
	struct sweep sweep = {0};
	long told = 0, capped = 0, cases = random_cases(60);

	for (long n = 0; n < cases; n++) {
		const enum clearance_accuracy accuracy = (enum clearance_accuracy)(n / 2 % 3);
		struct program p;
		struct block_clearance block;
		double cap;

		program_init(&p, 1, n);
		cap = random_size(&p.random, 1, 50);
		block_clearance_init(&block, &p.duo.pair);
		/* Half of the cases look for travelling planes wherever they can. */
		block.pair.account.credit = n % 2 ? 1e12 : 0;
		for (int first = 0, last; first < STEPS; first = last) {
			/*
			 * Other pairs may already have lowered the largest distance that a coarse measurement looks
			 * for.
			 */
			const double most = accuracy ? cap * random_size(&p.random, 0.1, 1) : cap;

			last = first + 1 + random_below(&p.random, 6);
			last = last < STEPS ? last : STEPS;
			told += measure_block(&p, &block, &sweep, first, last, most, accuracy, n);
			capped += !(block.pair.bound < most);
		}
		block_clearance_release(&block);
		duo_release(&p.duo);
	}
	sweep_release(&sweep);
	require(told > 2 * cases && capped > cases, "%ld told, %ld capped", told, capped);
}
END_TEST

/* Many steps that are declared clear at once are clear. */
START_TEST(clear_without_a_look)
{
	struct sweep sweep = {0};
	long clear = 0, cases = random_cases(200);

	for (long n = 0; n < cases; n++) {
		struct program p;
		struct block_clearance block;
		struct batch_chunk box;
		double cap;
		int last;

		program_init(&p, 2, n);
		cap = random_size(&p.random, 0.01, 5);
		block_clearance_init(&block, &p.duo.pair);
		block.pair.account.credit = n % 2 ? 1e12 : 0;
		measure_block(&p, &block, &sweep, 0, 1, cap, CLEARANCE_SHARP, n);
		last = 2 + random_below(&p.random, 5);
		box = (struct batch_chunk){.low = p.corners[1], .high = p.corners[1]};
		for (int i = 1; i <= last; i++) {
			for (int k = 0; k < SLOT_COUNT; k++) {
				box.low.v[k] = fmin(box.low.v[k], p.corners[i].v[k]);
				box.high.v[k] = fmax(box.high.v[k], p.corners[i].v[k]);
			}
		}
		if (block_clearance_clears(&block, &box, cap, 1, n % 4 < 2)) {
			clear++;
			require(!comes_within(&p, 1, last, cap), "case %ld: not clear", n);
		}
		block_clearance_release(&block);
		duo_release(&p.duo);
	}
	sweep_release(&sweep);
	require(clear > cases / 20, "only %ld clear", clear);
}
END_TEST

/* A cube, and a wall 10 mm from it in x. */
static void stand_by_wall(struct duo *duo)
{
	const struct chain chain = {.count = 2, .joints = {{SLOT_X, false, {1, 0, 0}, {0, 0, 0}},
							   {SLOT_Y, false, {0, 1, 0}, {0, 0, 0}}}};
	struct mesh wall = {0}, cube = {0};
	xform identity = xform_identity(), beside = identity;

	beside.translation.x = 16;
	solid_box(&wall, (vec3){1, 500, 500});
	solid_place(&wall, &beside);
	solid_box(&cube, (vec3){5, 5, 5});
	duo_init(duo, &chain, &wall, &cube, &identity, &identity);
}

static double go(struct block_clearance *block, struct sweep *sweep, double x0, double y0, double x1, double y1,
		 enum path_kind kind, double tolerance)
{
	axis_values from = {{x0, y0}}, to = {{x1, y1}};
	struct path path = path_between(&from, &to, kind);
	struct motion_step step = step_on(&path);

	step.tolerance.v[SLOT_X] = tolerance;
	block_clearance_start(block, 8);
	block_clearance_step(block, sweep, &step, 1e-3, CLEARANCE_SHARP);
	return block->pair.bound;
}

static void between(double value, double least, double most)
{
	require(value >= least && value <= most, "%.9g is not between %.9g and %.9g", value, least, most);
}

START_TEST(known_distances)
{
	struct sweep sweep = {0};
	struct block_clearance block;
	struct duo duo;

	stand_by_wall(&duo);
	block_clearance_init(&block, &duo.pair);
	/*
	 * The bodies never come nearer than the cap; then they do at the end, at the start, all along, and on the way.
	 */
	between(go(&block, &sweep, 0, 0, 1, 0, PATH_STRAIGHT, 0), 8, 8);
	between(go(&block, &sweep, 1, 0, 6, 0, PATH_STRAIGHT, 0), SHARE * 4, 4);
	between(go(&block, &sweep, 6, 0, -100, 0, PATH_STRAIGHT, 0), SHARE * 4, 4);
	between(go(&block, &sweep, 9.5, -400, 9.5, 400, PATH_STRAIGHT, 0), SHARE * 0.5, 0.5);
	between(go(&block, &sweep, 7, -400, 9, 400, PATH_STRAIGHT, 0), SHARE * 1, 1);
	/* The control may come 0.25 mm nearer, or anywhere in the box. */
	between(go(&block, &sweep, 9.5, -40, 9.5, 40, PATH_STRAIGHT, 0.25), 0.1, 0.25);
	between(go(&block, &sweep, 0, 0, 8, 40, PATH_BOX, 0.25), 0.5, 1.75);
	/* Through the wall, and in it. */
	between(go(&block, &sweep, 0, 0, 40, 0, PATH_STRAIGHT, 0), 0, 0);
	between(go(&block, &sweep, 11, 0, 11, 0, PATH_STRAIGHT, 0), 0, 0);
	/* A block's result does not depend on the block before. */
	between(go(&block, &sweep, 0, 0, 0, 1, PATH_STRAIGHT, 0), 8, 8);
	sweep_release(&sweep);
	block_clearance_release(&block);
	duo_release(&duo);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("blocks");

	tcase_add_test(tcase, between_the_truth_and_a_share_of_it);
	tcase_add_test(tcase, clear_without_a_look);
	tcase_add_test(tcase, known_distances);
	return run_suite("block_clearance", tcase);
}
