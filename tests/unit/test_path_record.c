#include "check/measure/path_record.h"

#include "motion/span.h"
#include "suite.h"

/* Adds three blocks of one step each to x, the second one with C at `turn`; the number of blocks is `blocks`. */
static void travel(struct path_record *path, double x, double turn, int tool, long blocks)
{
	for (long i = 0; i < blocks; i++) {
		struct motion_step step = {.line = i + 1};

		step.span.q1.v[SLOT_X] = x + 10 * (double)i;
		step.span.q1.v[SLOT_C] = i == 1 ? turn : 0;
		path_record_step(path, &step);
		path_record_block(path, i + 1, tool, &step.span.q1);
	}
}

static bool is_same(struct path_record *path, double x, double turn, int tool, long blocks, double way)
{
	path_record_compare(path);
	travel(path, x, turn, tool, blocks);
	path_record_end(path);
	ck_assert(!path->failed);
	ck_assert_double_eq_tol(path->farthest, way, 1e-12);
	return path->same;
}

START_TEST(runs_are_compared)
{
	struct path_record path;
	uint64_t x, y;

	ck_assert(path_record_init(&path));
	path_record_start(&path);
	travel(&path, 5, 1, 2, 3);
	x = path.digests[SLOT_X];
	y = path.digests[SLOT_Y];
	ck_assert(is_same(&path, 5, 1, 2, 3, 0));
	ck_assert(path.digests[SLOT_X] == x && path.digests[SLOT_Y] == y);
	/* Farther along X it is still the same path. */
	ck_assert(is_same(&path, 5.25, 1, 2, 3, 0.25));
	ck_assert(path.digests[SLOT_X] != x && path.digests[SLOT_Y] == y);
	/* Another turn, another tool, fewer blocks, more blocks. */
	ck_assert(!is_same(&path, 5, 1 + 1e-6, 2, 3, 0));
	ck_assert(!is_same(&path, 5, 1, 3, 3, 0));
	ck_assert(!is_same(&path, 5, 1, 2, 2, 0));
	ck_assert(!is_same(&path, 5, 1, 2, 4, 0));
	/* These questions have not changed the record. */
	ck_assert(is_same(&path, 4, 1, 2, 3, 1));
	path_record_release(&path);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("runs");

	tcase_add_test(tcase, runs_are_compared);
	return run_suite("path_record", tcase);
}
