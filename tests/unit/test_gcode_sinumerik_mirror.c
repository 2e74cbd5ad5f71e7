/* test_gcode_sinumerik_mirror.c - the sinumerik dialect: what the values of MIRROR mean (MD10612). */
#include <string.h>

#include "sinumerik_case.h"

#define CAUTION "with MD10612=0 a value of 0 means no mirroring"

static const struct mirrored {
	enum answer toggle;
	const char *words;
	double x, y;	/* of X2 Y3 */
	bool cautioned;
} rows[] = {
	{ANSWER_YES, "MIRROR X0", -2, 3, false},
	{ANSWER_YES, "MIRROR X1 Y0", -2, -3, false},
	{ANSWER_YES, "MIRROR X1\nAMIRROR X1", 2, 3, false},
	{ANSWER_NO, "MIRROR X0", 2, 3, false},
	{ANSWER_NO, "MIRROR X1 Y0", -2, 3, false},
	{ANSWER_NO, "MIRROR X1\nMIRROR Y-1", 2, -3, false},
	{ANSWER_NO, "MIRROR X1\nMIRROR", 2, 3, false},
	/* The default of the control, with a caution where the other value would differ. */
	{ANSWER_UNKNOWN, "MIRROR X1", -2, 3, false},
	{ANSWER_UNKNOWN, "MIRROR X1\nMIRROR", 2, 3, false},
	{ANSWER_UNKNOWN, "MIRROR X0", -2, 3, true},
	{ANSWER_UNKNOWN, "MIRROR X1\nAMIRROR X1", 2, 3, true},
};

START_TEST(values)
{
	const struct mirrored *row = &rows[_i];
	struct strbuf program = {0}, moves = {0};
	struct gcode_case c;

	sinumerik_case_init(&c);
	c.config.controller.mirror_toggle = row->toggle;
	strbuf_addf(&program, "G500\n%s\nG0 X2 Y3\nM30\n", row->words);
	strbuf_addf(&moves, "rapid %g %g 0 0 0\n", row->x, row->y);
	ck_assert_msg(case_run(&c, strbuf_text(&program)), "%s", strbuf_text(&c.messages));
	ck_assert_str_eq(strbuf_text(&c.moves), strbuf_text(&moves));
	ck_assert_int_eq(strstr(strbuf_text(&c.messages), CAUTION) != NULL, row->cautioned);
	strbuf_release(&program);
	strbuf_release(&moves);
	case_release(&c);
}
END_TEST

START_TEST(added)
{
	struct gcode_case c;

	sinumerik_case_init(&c);
	c.config.controller.mirror_toggle = ANSWER_NO;
	ck_assert(!case_run(&c, "G500\nAMIRROR X1\nG0 X2\n"));
	ck_assert_ptr_nonnull(strstr(strbuf_text(&c.messages), "AMIRROR with mirror_toggle=\"no\" (MD10612=0)"));
	case_release(&c);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("programs");

	tcase_add_loop_test(tcase, values, 0, COUNT(rows));
	tcase_add_test(tcase, added);
	return run_suite("gcode_sinumerik_mirror", tcase);
}
