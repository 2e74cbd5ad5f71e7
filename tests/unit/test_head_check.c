/* test_head_check.c - a tool that points into its head is doubted, for every position and rotation of the machine. */
#include "scene/head_check.h"

#include "model_case.h"
#include "suite.h"

/* The gauge point is at 0 0 300, and the tool points down. */
static int head(struct model *model, double from, double to)
{
	return model_box(model, ROLE_MACHINE, LINK_Z, (vec3){-60, -70, from}, (vec3){60, 70, to});
}

static bool in_head(const struct model *model, int body, double ahead)
{
	struct doubts doubts = {0};
	const struct doubt *doubt;
	bool found;

	head_check(model->scene, &doubts);
	doubt = model_doubt(&doubts, DOUBT_SPINDLE_IN_HEAD);
	found = doubt != NULL;
	ck_assert_uint_eq(doubts.count, found);
	if (doubt) {
		ck_assert_int_eq(doubt->body, body);
		require(fabs(doubt->value - ahead) < 1e-3, "%g mm ahead, not %g", doubt->value, ahead);
	}
	doubts_release(&doubts);
	return found;
}

/* Expects a doubt, or none, for a head from `up` mm above the gauge point to `ahead` mm in front of it. */
static void expect(double up, double ahead, bool doubted)
{
	struct random random = random_case(1, (long)(ahead * 100));

	for (int i = 0; i < 20; i++) {
		const xform by = random_place(&random, 2000);
		struct model model;
		int body;

		model_init(&model);
		body = head(&model, 300 - ahead, 300 + up);
		if (i)
			model_move(&model, &by);
		require(in_head(&model, body, ahead) == doubted, "place %d: %g mm ahead", i, ahead);
		model_release(&model);
	}
}

START_TEST(both_sides_of_the_nose)
{
	expect(200, 0, false);
	expect(200, 39.9, false);
	expect(200, 40.1, true);
	expect(0, 200, true);
}
END_TEST

/* A body that begins at the gauge point counts as an arbor in the spindle if there is a head behind it. */
START_TEST(an_arbor)
{
	for (int gap = 0; gap < 3; gap++) {
		for (int with_head = 0; with_head < 2; with_head++) {
			struct model model;
			int arbor;

			model_init(&model);
			if (with_head)
				head(&model, 300, 500);
			/* The arbor begins 0, 0.9 or 1.1 mm behind the gauge point. */
			arbor = head(&model, 200, 300 + (gap ? 0.7 + 0.2 * gap : 0));
			require(in_head(&model, arbor, 100) == (!with_head || gap == 2), "gap %d, head %d", gap,
				with_head);
			model_release(&model);
		}
	}
}
END_TEST

/* Bodies of other links and of the setup do not belong to the head. */
START_TEST(other_bodies)
{
	struct model model;

	model_init(&model);
	model_box(&model, ROLE_MACHINE, LINK_X, (vec3){-60, -70, 100}, (vec3){60, 70, 200});
	model_box(&model, ROLE_FIXTURE, LINK_Z, (vec3){-60, -70, 100}, (vec3){60, 70, 200});
	/*
	 * The body is so far beside the spindle's line that none of the examined lines, 15 mm from it, meets the body.
	 */
	model_box(&model, ROLE_MACHINE, LINK_Z, (vec3){16, -70, 100}, (vec3){60, 70, 400});
	ck_assert(!in_head(&model, -1, 0));
	model_release(&model);
}
END_TEST

/* A head behind the gauge point confirms a spindle across Z; a head around the gauge point does not. */
START_TEST(a_spindle_across)
{
	static const enum doubt_kind kinds[] = {DOUBT_SPINDLE_ACROSS, DOUBT_SPINDLE_AWAY, DOUBT_WORKHOLDING_BESIDE,
						DOUBT_SPINDLE_FAR};

	for (int ahead = 0; ahead < 2; ahead++) {
		for (int across = 0; across < 2; across++) {
			struct doubts doubts = {0};
			struct model model;

			model_init(&model);
			head(&model, ahead ? 250 : 300, 500);
			for (int i = !across; i < COUNT(kinds); i++)
				doubts_add(&doubts, &(struct doubt){.kind = kinds[i]});
			head_check(model.scene, &doubts);
			ck_assert_int_eq(model_doubt(&doubts, DOUBT_SPINDLE_ACROSS) != NULL, ahead && across);
			/* The other doubts go only together with the first one. */
			ck_assert_int_eq(model_doubt(&doubts, DOUBT_SPINDLE_AWAY) != NULL, ahead || !across);
			ck_assert_int_eq(model_doubt(&doubts, DOUBT_WORKHOLDING_BESIDE) != NULL, ahead || !across);
			ck_assert_ptr_nonnull(model_doubt(&doubts, DOUBT_SPINDLE_FAR));
			doubts_release(&doubts);
			model_release(&model);
		}
	}
}
END_TEST

int main(void)
{
	const TTest *const tests[] = {both_sides_of_the_nose, an_arbor, other_bodies, a_spindle_across};

	return RUN_TESTS("head_check", tests);
}
