/*
 * test_gcode_klartext_table.c - Klartext: every M-function of the table does what its row says. An ignored function
 * leaves the moves around it as they are; the message of a refused function names it. The same holds for cycles whose
 * moves are not modelled.
 */
#include "klartext_case.h"

#include "gcode/dialect/klartext/klartext_codes.h"

static void ignores(const char *block)
{
	struct strbuf program = {0};
	struct gcode_case c;

	klartext_case(&c);
	strbuf_addf(&program, "L X+1 F100\n%s\nL X+2 Y+3\nL IX+1\n", block);
	ck_assert_msg(klartext_run(&c, strbuf_text(&program)), "%s: %s", block, strbuf_text(&c.messages));
	ck_assert_str_eq(strbuf_text(&c.messages), "");
	ck_assert_msg(!strcmp(strbuf_text(&c.moves), "feed 1 0 0 0 0\nfeed 2 3 0 0 0\nfeed 3 3 0 0 0\n"), "%s: %s", block,
		      strbuf_text(&c.moves));
	strbuf_release(&program);
	case_release(&c);
}

static void refuses(const char *block, const char *expected)
{
	struct gcode_case c;

	klartext_case(&c);
	ck_assert_msg(!klartext_run(&c, block), "%s", block);
	ck_assert_msg(strstr(strbuf_text(&c.messages), expected) != NULL, "%s and not %s", strbuf_text(&c.messages),
		      expected);
	case_release(&c);
}

/* Each function alone, and after the words of a block. */
START_TEST(functions)
{
	size_t tried = 0;

	for (size_t i = 0; i < klartext_m_codes.count; i++) {
		const struct code *code = &klartext_m_codes.rows[i];
		char block[64], expected[128];

		if (code->state != CODE_IGNORED && code->state != CODE_REFUSED)
			continue;
		tried++;
		snprintf(block, sizeof(block), "L M%d\n", code->number);
		snprintf(expected, sizeof(expected), "p.nc:2:3: error: M%d: %s is not supported", code->number, code->what);
		if (code->state == CODE_IGNORED)
			ignores(block);
		else
			refuses(block, expected);
	}
	ck_assert_uint_gt(tried, 20);
}
END_TEST

/* Statements without geometry. */
START_TEST(statements)
{
	static const char *const blocks[] = {
	    "FUNCTION DCM OFF",
	    "FUNCTION AFC CUT END",
	    "FUNCTION COUNT INC",
	    "FUNCTION LIFTOFF RESET",
	    "FUNCTION S-PULSE RESET",
	    "FN 29: PLC = +5",
	    "FN 38: SEND /\"TEXT\"",
	    "BLK FORM CYLINDER Z R50 L100",
	    "STOP M8",
	};

	for (int i = 0; i < COUNT(blocks); i++)
		ignores(blocks[i]);
}
END_TEST

/* The message about a called cycle whose moves are not modelled names the cycle and what to do. */
START_TEST(cycles)
{
	static const int numbers[] = {25, 27, 28, 29, 39, 225, 231, 272, 273, 274, 275, 276, 277};

	for (int i = 0; i < COUNT(numbers); i++) {
		char block[64], expected[64];

		snprintf(block, sizeof(block), "CYCL DEF %d NAME Q1=+1\n", numbers[i]);
		snprintf(expected, sizeof(expected), "<macro program=\"%d\" action=\"around\"", numbers[i]);
		refuses(block, expected);
	}
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("gcode_klartext_table");

	tcase_add_test(tcase, functions);
	tcase_add_test(tcase, statements);
	tcase_add_test(tcase, cycles);
	return run_suite("gcode_klartext_table", tcase);
}
