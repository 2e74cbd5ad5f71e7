#include "check/open_boxes.h"

#include "suite.h"

static int after(struct open_boxes *boxes, long share, enum query_answer answer, bool exhausted, enum path_kind kind)
{
	const struct path path = {.kind = kind};
	const struct batch_step step = {.motion.span.path = &path, .share = share};
	const struct pair_result result = {.answer = answer, .exhausted = exhausted};

	open_boxes_count(boxes, share);
	open_boxes_add(boxes, &result, &step);
	return open_boxes_count(boxes, share);
}

START_TEST(counts_undecided_rapids_of_a_share)
{
	struct open_boxes boxes = {0};

	/* Only a rapid whose path is not known, and that used up its effort, counts. */
	ck_assert_int_eq(after(&boxes, 0, QUERY_UNDECIDED, true, PATH_STRAIGHT), 0);
	ck_assert_int_eq(after(&boxes, 0, QUERY_UNDECIDED, false, PATH_BOX), 0);
	ck_assert_int_eq(after(&boxes, 0, QUERY_CONTACT, true, PATH_BOX), 0);
	ck_assert_int_eq(after(&boxes, 0, QUERY_UNDECIDED, true, PATH_BOX), 1);
	ck_assert_int_eq(after(&boxes, 0, QUERY_UNDECIDED, true, PATH_BOX), 2);
	ck_assert_int_eq(after(&boxes, 0, QUERY_CONTACT, false, PATH_BOX), 2);
	/* It must not matter which shard checks which share. */
	ck_assert_int_eq(open_boxes_count(&boxes, 5), 0);
	for (int i = 1; i <= 2 * BOX_HALVINGS_MAX; i++)
		ck_assert_int_eq(after(&boxes, 5, QUERY_UNDECIDED, true, PATH_BOX),
				 i < BOX_HALVINGS_MAX ? i : BOX_HALVINGS_MAX);
	ck_assert_int_eq(open_boxes_count(&boxes, 6), 0);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("shares");

	tcase_add_test(tcase, counts_undecided_rapids_of_a_share);
	return run_suite("open_boxes", tcase);
}
