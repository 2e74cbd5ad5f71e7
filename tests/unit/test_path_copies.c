/* test_path_copies.c - what copies of a path share, and how long the shared data stay. */

#include "check/path_copies.h"
#include "suite.h"

static struct span whole(const struct path *path)
{
	struct span span;

	span_init(&span, path);
	return span;
}

START_TEST(straight_paths_of_one_kind_share_a_copy)
{
	const struct path first = {.kind = PATH_STRAIGHT, .end = {{1}}}, second = {.kind = PATH_STRAIGHT, .end = {{2}}};
	const struct path box = {.kind = PATH_BOX, .end = {{3}}};
	const struct span spans[] = {whole(&first), whole(&second), whole(&box), whole(&first)};
	struct path_copies copies = {0};
	const struct path *copied[4];

	for (int i = 0; i < 4; i++) {
		copied[i] = path_copies_add(&copies, &spans[i]);
		ck_assert_int_eq(copied[i]->kind, spans[i].path->kind);
	}
	ck_assert_ptr_eq(copied[0], copied[1]);
	ck_assert_int_eq(copied[0]->kind, PATH_STRAIGHT);
	ck_assert_int_eq(copied[2]->kind, PATH_BOX);
	path_copies_release(&copies);
}
END_TEST

START_TEST(each_curved_move_has_its_own_copy)
{
	const struct canon_arc arc = {.normal = {0, 0, 1}, .sweep = 1};
	const struct path paths[] = {{.kind = PATH_ARC, .start = {{1}}, .end = {{0, 1}}, .circular = true, .arc = arc},
				     {.kind = PATH_ARC, .start = {{2}}, .end = {{0, 2}}, .circular = true, .arc = arc}};
	struct path_copies copies = {0};
	const struct path *copied[2];

	for (int i = 0; i < 2; i++) {
		const struct span span = whole(&paths[i]);
		struct span halves[2];

		span_halve(&span, &halves[0], &halves[1]);
		copied[i] = path_copies_add(&copies, &halves[0]);
		ck_assert_ptr_eq(path_copies_add(&copies, &halves[1]), copied[i]);
	}
	ck_assert_ptr_ne(copied[0], copied[1]);
	for (int i = 0; i < 2; i++) {
		ck_assert_double_eq(copied[i]->start.v[SLOT_X], paths[i].start.v[SLOT_X]);
		ck_assert_double_eq(copied[i]->end.v[SLOT_Y], paths[i].end.v[SLOT_Y]);
	}
	path_copies_release(&copies);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("copies");

	tcase_add_test(tcase, straight_paths_of_one_kind_share_a_copy);
	tcase_add_test(tcase, each_curved_move_has_its_own_copy);
	return run_suite("path_copies", tcase);
}
