/*
 * test_stress_table.c - encounters with a known first contact, swept as meshes and run as programs, each in every
 * disguise.
 */
#include <stdlib.h>

#include "stress_encounters.h"
#include "suite.h"

START_TEST(as_they_are)
{
	struct stress_case c = rows[_i].make();

	stress_sweep(&c, rows[_i].name, "swept");
	stress_program(&c, rows[_i].name, "run");
	stress_release(&c);
}
END_TEST

START_TEST(disguised)
{
	static const double scales[] = {0x1p-17, 0x1p-3, 0x1p20};
	struct random random = random_case(1, _i);
	const char *name = rows[_i].name;
	struct stress_case c = rows[_i].make();

	stress_swap(&c);
	stress_sweep(&c, name, "bodies swapped");
	stress_program(&c, name, "bodies swapped, run");
	for (long k = 0; k < random_cases(2); k++) {
		stress_shuffle(&c.a, &random);
		stress_shuffle(&c.b, &random);
		stress_sweep(&c, name, "shuffled");
	}
	stress_triple(&c.a);
	stress_triple(&c.b);
	stress_sweep(&c, name, "triangles three times");
	stress_program(&c, name, "triangles three times, run");
	stress_release(&c);
	for (int k = 0; k < 3; k++) {
		c = rows[_i].make();
		stress_scale(&c, scales[k]);
		stress_sweep(&c, name, k ? k > 1 ? "2^20 times" : "2^-3 times" : "2^-17 times");
		stress_release(&c);
	}
	c = rows[_i].make();
	if (!rows[_i].fine) {
		stress_move(&c, (vec3){0x1p20, -0x1p20, 0x1p20});
		stress_sweep(&c, name, "moved by 2^20 mm");
		stress_program(&c, name, "moved by 2^20 mm, run");
	}
	stress_release(&c);
}
END_TEST

/* With time reversed, bodies that never meet still do not meet; brute force judges the other cases. */
START_TEST(backwards)
{
	struct stress_case c = rows[_i].make();
	axis_values start = c.chord.q0;

	c.chord.q0 = c.chord.q1;
	c.chord.q1 = start;
	if (c.first < 0) {
		stress_sweep(&c, rows[_i].name, "backwards");
	} else if (fabs(c.chord.q1.v[SLOT_C] - c.chord.q0.v[SLOT_C]) < 10) {
		struct mesh a = stress_copy(&c.a), b = stress_copy(&c.b);
		struct sweep sweep = {0};
		struct contact contact;
		enum sweep_answer answer;
		struct duo duo;

		duo_init(&duo, &c.chain, &a, &b, &c.place_a, &c.place_b);
		answer = sweep_chord(&sweep, &duo.pair, &c.chord, c.clearance, c.tolerance, &contact);
		require(answer == SWEEP_CONTACT, "%s, backwards: missed", rows[_i].name);
		oracle_judge(&duo, &c.chord.q0, &c.chord.q1, c.clearance, c.tolerance, answer, &contact, rows[_i].name,
			     0);
		sweep_release(&sweep);
		duo_release(&duo);
	}
	stress_release(&c);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("closed forms");

	tcase_add_checked_fixture(tcase, stress_enter, stress_leave);
	tcase_add_loop_test(tcase, as_they_are, 0, ROWS);
	tcase_add_loop_test(tcase, disguised, 0, ROWS);
	tcase_add_loop_test(tcase, backwards, 0, ROWS);
	return run_suite("stress_table", tcase);
}
