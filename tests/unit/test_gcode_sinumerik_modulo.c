/* test_gcode_sinumerik_modulo.c - the sinumerik dialect: which way a rotary axis that counts modulo 360 turns. */
#include <stdio.h>
#include <string.h>

#include "gcode_refusal.h"
#include "sinumerik_case.h"

#define HEAD "G500 G90 G0\n"

static void modulo_case(struct gcode_case *c, enum rotary_way way)
{
	sinumerik_case_init(c);
	c->config.wrap[SLOT_C] = WRAP_SHORTEST;
	c->config.controller.rotary_way = way;
}

/* Function manual R2: with AC and G90 forward to a larger position of the display, back to a smaller one. */
START_TEST(plain)
{
	struct gcode_case c;

	modulo_case(&c, ROTARY_WAY_PLAIN);
	ck_assert_msg(case_run(&c, HEAD "C350\nC10\nC=AC(190)\nC=DC(350)\nC=DC(10)\nC0\nC=ACN(350)\nC20\nG91 C-30\nG90 C5\n"
				   "SUPA C355\n"),
		      "%s", strbuf_text(&c.messages));
	/* The display shows 10 at 370 and 20 at -340 + 360. */
	ck_assert_str_eq(strbuf_text(&c.moves),
			 "rapid 0 0 0 0 350\nrapid 0 0 0 0 10\nrapid 0 0 0 0 190\nrapid 0 0 0 0 350\nrapid 0 0 0 0 370\n"
			 "rapid 0 0 0 0 360\nrapid 0 0 0 0 350\nrapid 0 0 0 0 20\nrapid 0 0 0 0 -10\nrapid 0 0 0 0 -355\n"
			 "rapid 0 0 0 0 -5\n");
	case_release(&c);
}
END_TEST

START_TEST(shorter)
{
	struct gcode_case c;

	modulo_case(&c, ROTARY_WAY_SHORTER);
	ck_assert_msg(case_run(&c, HEAD "C350\nC10\nC-20\nC370\nSUPA C355\n"), "%s", strbuf_text(&c.messages));
	ck_assert_str_eq(strbuf_text(&c.moves), "rapid 0 0 0 0 -10\nrapid 0 0 0 0 10\nrapid 0 0 0 0 -20\nrapid 0 0 0 0 10\n"
						"rapid 0 0 0 0 -5\n");
	case_release(&c);
}
END_TEST

static size_t common_length(const char *a, const char *b)
{
	size_t length = 0;

	while (a[length] && a[length] == b[length])
		length++;
	return length;
}

/* Random moves on the display: the axis position follows only from the display and from the sum of all moves. */
START_TEST(walk)
{
	struct strbuf program = {0}, wanted = {0};
	double axis = 0, display = 0;
	unsigned state = 7;
	struct gcode_case c;

	strbuf_addf(&program, HEAD);
	for (int i = 0; i < 200; i++) {
		int next;

		state = state * 1103515245U + 12345U;
		next = (int)(state >> 16) % 360;
		strbuf_addf(&program, "C%d\n", next);
		strbuf_addf(&wanted, "rapid 0 0 0 0 %.9g\n", axis + next - display);
		axis += next - display;
		display = next;
		if (i % 5)
			continue;
		/* One step over 0, which the axis does by ACP alone. */
		strbuf_addf(&program, "C359\nC=ACP(1)\n");
		strbuf_addf(&wanted, "rapid 0 0 0 0 %.9g\nrapid 0 0 0 0 %.9g\n", axis + 359 - display,
			    axis + 361 - display);
		axis += 361 - display;
		display = 1;
	}
	modulo_case(&c, ROTARY_WAY_PLAIN);
	ck_assert_msg(case_run(&c, strbuf_text(&program)), "%s", strbuf_text(&c.messages));
	/* The whole walk is too long for a message of libcheck. */
	ck_assert_uint_eq(common_length(strbuf_text(&c.moves), strbuf_text(&wanted)), wanted.length);
	ck_assert_uint_eq(c.moves.length, wanted.length);
	case_release(&c);
	strbuf_release(&program);
	strbuf_release(&wanted);
}
END_TEST

/*
 * Without an answer the axis takes the shorter way, with one caution if the plain way is another one; half a turn has
 * no shorter way.
 */
START_TEST(unanswered)
{
	static const char *const text = "C turns the shorter way here, because its wrap=\"shortest\" says so";
	struct gcode_case c;

	modulo_case(&c, ROTARY_WAY_UNKNOWN);
	ck_assert_msg(case_run(&c, HEAD "C10\nC179\nC=DC(350)\nC300\n"), "%s", strbuf_text(&c.messages));
	ck_assert_str_eq(strbuf_text(&c.messages), "");
	case_release(&c);
	modulo_case(&c, ROTARY_WAY_UNKNOWN);
	ck_assert_msg(case_run(&c, HEAD "C350\nC10\nC-20\nC370\nSUPA C355\n"), "%s", strbuf_text(&c.messages));
	ck_assert_str_eq(strbuf_text(&c.moves), "rapid 0 0 0 0 -10\nrapid 0 0 0 0 10\nrapid 0 0 0 0 -20\nrapid 0 0 0 0 10\n"
						"rapid 0 0 0 0 -5\n");
	ck_assert_ptr_nonnull(strstr(strbuf_text(&c.messages), text));
	ck_assert_ptr_null(strstr(strstr(strbuf_text(&c.messages), text) + 1, text));
	case_release(&c);
}
END_TEST

START_TEST(uncertain)
{
	static const char *const programs[] = {"C-10\n", "C370\n"};
	struct gcode_case c;

	for (size_t i = 0; i < COUNT(programs); i++) {
		modulo_case(&c, ROTARY_WAY_PLAIN);
		case_refuses(&c, "which way C turns to this absolute position is not certain: it lies outside of 0 to 360 "
				 "degrees, or an offset shifts it; write DC, ACP or ACN", HEAD "%s", programs[i]);
	}
	modulo_case(&c, ROTARY_WAY_PLAIN);
	case_refuses(&c, "which way C turns to this absolute position is not certain", HEAD "C10\nTRANS C20\nC5\n");
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("programs");

	tcase_add_test(tcase, plain);
	tcase_add_test(tcase, shorter);
	tcase_add_test(tcase, walk);
	tcase_add_test(tcase, unanswered);
	tcase_add_test(tcase, uncertain);
	return run_suite("gcode_sinumerik_modulo", tcase);
}
