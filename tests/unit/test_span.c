/* test_span.c - halving and walking: the pieces meet, cover the path in order, and are flat. */

#include "motion/span.h"
#include "motion_rig.h"
#include "suite.h"

static struct path random_straight(uint64_t *random)
{
	struct path path = {.kind = PATH_STRAIGHT};

	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		path.start.v[slot] = rig_random(random, -500, 500);
		path.end.v[slot] = rig_random(random, -500, 500);
	}
	return path;
}

static struct path circle(double radius, double turns)
{
	return (struct path){.kind = PATH_ARC, .circular = true, .start = {{radius, 0, 0}}, .end = {{radius, 0, 0}},
			     .arc = {{0, 0, 0}, {0, 0, 1}, 2 * PI * turns}};
}

START_TEST(halves_of_a_straight_path)
{
	uint64_t random = 3;

	for (int i = 0; i < 1000; i++) {
		struct path path = random_straight(&random);
		struct span whole, first, second;

		span_init(&whole, &path);
		ck_assert_mem_eq(&whole.q0, &path.start, sizeof(path.start));
		ck_assert_mem_eq(&whole.q1, &path.end, sizeof(path.end));
		span_halve(&whole, &first, &second);
		ck_assert_mem_eq(&first.q1, &second.q0, sizeof(first.q1));
		ck_assert_mem_eq(&first.q0, &whole.q0, sizeof(first.q0));
		ck_assert_mem_eq(&second.q1, &whole.q1, sizeof(first.q1));
		for (int slot = 0; slot < SLOT_COUNT; slot++) {
			ck_assert_double_eq_tol(first.q1.v[slot], 0.5 * (path.start.v[slot] + path.end.v[slot]), 1e-12);
			ck_assert(!(first.chord_error.v[slot] > 0) && !(second.chord_error.v[slot] > 0));
		}
		ck_assert(span_is_flat(&whole, 0));
		ck_assert(first.path == &path && second.path == &path);
		ck_assert_double_eq(first.u1, 0.5);
		ck_assert_double_eq(second.u0, 0.5);
	}
}
END_TEST

/* The middle of a half circle is on the circle; each halving divides the deviation by four. */
START_TEST(halves_of_an_arc)
{
	struct path path = circle(100, 0.5);
	struct span whole, first, second, quarter;

	path.end.v[SLOT_X] = -100;
	span_init(&whole, &path);
	ck_assert(!span_is_flat(&whole, 1));
	span_halve(&whole, &first, &second);
	ck_assert_double_eq_tol(first.q1.v[SLOT_X], 0, 1e-12);
	ck_assert_double_eq_tol(first.q1.v[SLOT_Y], 100, 1e-12);
	ck_assert_mem_eq(&first.q1, &second.q0, sizeof(first.q1));
	/* The piece may be the struct that is halved. */
	quarter = first;
	span_halve(&quarter, &quarter, &second);
	ck_assert_double_eq_tol(quarter.chord_error.v[SLOT_Y], first.chord_error.v[SLOT_Y] / 4, 1e-9);
	ck_assert_double_eq(quarter.u1, 0.25);
	ck_assert_double_eq(second.u0, 0.25);
}
END_TEST

/* Walks over the path and checks that the pieces meet. The value is their number. */
static long walk(const struct path *path, double linear)
{
	struct span whole, piece, last;
	struct span_walk pieces;
	long count = 0;

	span_init(&whole, path);
	span_walk_init(&pieces, &whole, linear);
	last = whole;
	last.u1 = 0;
	last.q1 = whole.q0;
	while (span_walk_next(&pieces, &piece)) {
		/* libcheck records every assertion: one for each piece would take most of the time. */
		if (piece.u0 < last.u1 || piece.u0 > last.u1 || !(piece.u1 > piece.u0) ||
		    memcmp(&piece.q0, &last.q1, sizeof(last.q1)) != 0)
			ck_abort_msg("the piece at %.17g does not join the one that ends at %.17g", piece.u0, last.u1);
		if (!span_is_flat(&piece, linear * 1.001) && !span_is_shortest(&piece))
			ck_abort_msg("the piece at %.17g is not flat", piece.u0);
		last = piece;
		count++;
	}
	ck_assert_double_eq(last.u1, 1);
	ck_assert_mem_eq(&last.q1, &whole.q1, sizeof(last.q1));
	ck_assert_int_eq(span_count(&whole, linear), count);
	return count;
}

START_TEST(walk_makes_no_more_pieces_than_it_must)
{
	uint64_t random = 4;
	struct path straight = random_straight(&random), one = circle(100, 1), many = circle(50, 1000);
	struct path missed = circle(10, 0.25);

	ck_assert_int_eq(walk(&straight, 1e-6), 1);
	/* sweep sqrt(r / 8 flatness) pieces are needed; by halving it is the next power of two. */
	ck_assert_int_eq(walk(&one, 0.001), 1024);
	ck_assert_int_eq(walk(&many, 0.001), 524288);
	/*
	 * If the end is not on the arc, no halving makes the last piece flat: after a few short pieces the walk stops
	 * halving.
	 */
	missed.end = (axis_values){{0, 10.5, 0}};
	ck_assert_int_lt(walk(&missed, 0.001), 500);
}
END_TEST

START_TEST(walk_of_guided_paths)
{
	uint64_t random = 17;
	long pieces = 0;

	for (int i = 0; i < 900; i++) {
		struct machine machine = rig_random_machine(&random, (enum rig_family)(i % RIG_FAMILIES));
		struct kinematics_tcp state = {.on = true, .length = 100};
		struct path path = {.kind = PATH_TCP};
		struct rig_messages messages;
		struct tcp tcp;

		rig_listen(&messages);
		ck_assert(tcp_init(&tcp, &machine, &state, (struct srcloc){NULL, 0, 0}, &messages.diag));
		path.tcp = &tcp;
		for (size_t k = 0; k < machine.axis_count; k++) {
			double size = machine.axes[k].rotary ? 2 : 200;

			path.start.v[machine.axes[k].slot] = rig_random(&random, -size, size);
			path.end.v[machine.axes[k].slot] = rig_random(&random, -size, size);
		}
		pieces += walk(&path, 0.01);
		/* If no rotary axis turns, the line of the tip is a line of the axes. */
		path.end = path.start;
		path.end.v[SLOT_X] += 1;
		ck_assert_int_eq(walk(&path, 1e-6), 1);
	}
	ck_assert_int_gt(pieces, 10000);
}
END_TEST

/* With a flatness of 0 the walk stops at the rounding. */
START_TEST(walk_ends_without_flatness)
{
	struct path path = circle(1e-6, 0.01);
	struct span whole, piece;
	struct span_walk pieces;
	long count = 0;

	span_init(&whole, &path);
	span_walk_init(&pieces, &whole, 0);
	while (span_walk_next(&pieces, &piece))
		count++;
	ck_assert_int_gt(count, 1000);
	ck_assert_int_lt(count, 10000000);
}
END_TEST

int main(void)
{
	TCase *tests = tcase_create("span");

	tcase_add_test(tests, halves_of_a_straight_path);
	tcase_add_test(tests, halves_of_an_arc);
	tcase_add_test(tests, walk_makes_no_more_pieces_than_it_must);
	tcase_add_test(tests, walk_of_guided_paths);
	tcase_add_test(tests, walk_ends_without_flatness);
	return run_suite("span", tests);
}
