/* test_gcode_modal.c - modal groups and modal words as Fanuc and Haas controls have them. */
#include "gcode_case.h"

static const struct dialect *const dialects[] = {&dialect_fanuc, &dialect_haas};

static void modal_case(struct gcode_case *c, const struct dialect *dialect)
{
	static const struct length_offset lengths[] = {{1, 100}, {2, 40}};

	case_init(c);
	c->config.dialect = dialect;
	c->config.lengths = lengths;
	c->config.length_count = 2;
	c->config.controller.length_moves = ANSWER_NO;
}

static void run(const struct dialect *dialect, const char *program, const char *moves)
{
	struct gcode_case c;

	modal_case(&c, dialect);
	case_expect(&c, program, moves);
}

/* The last line of the program is at fault. */
static void refuse(const struct dialect *dialect, const char *program, int column, const char *message)
{
	struct gcode_case c;
	struct strbuf expected = {0};
	const char *last = program;
	int line = 1;

	for (const char *p = program; *p; p++) {
		if (*p == '\n' && p[1]) {
			line++;
			last = p + 1;
		}
	}
	modal_case(&c, dialect);
	ck_assert_msg(!case_run(&c, program), "accepted: %s", program);
	strbuf_addf(&expected, "p.nc:%d:%d: error: %s\n    %s    %*s^\n", line, column, message, last, column - 1, "");
	ck_assert_str_eq(strbuf_text(&c.messages), strbuf_text(&expected));
	strbuf_release(&expected);
	case_release(&c);
}

/*
 * Fanuc 30i-B operator's manual (B-64484EN), G code list: G28 and G30 are of group 00, G0 to G3 of group 01, so that
 * both stand in one block, and the motion holds from there on. Haas mill operator's manual, G-codes: the same groups.
 */
START_TEST(motion_beside_reference)
{
	static const char *const orders[] = {"G00 G91 G28 Z0.\n", "G91 G28 G00 Z0.\n", "G28 G91 Z0. G0\n",
					     "G80 G0 G91 G28 Z0.\n"};

	for (int i = 0; i < 2; i++) {
		for (size_t k = 0; k < sizeof(orders) / sizeof(orders[0]); k++) {
			struct strbuf program = {0};

			strbuf_addf(&program, "G1 F9. Z5.\n%sG90 X1.\nM30\n", orders[k]);
			run(dialects[i], program.text,
			    "feed 0 0 5 0 0\nrapid 0 0 5 0 0\nrapid 0 0 0 0 0\nrapid 1 0 0 0 0\n");
			strbuf_release(&program);
		}
		/* G28 itself goes at the rapid rate, whichever motion stands beside it. */
		run(dialects[i], "G0 Z5.\nF9. G1 G28 Z7.\nX1.\nM30\n",
		    "rapid 0 0 5 0 0\nrapid 0 0 7 0 0\nrapid 0 0 0 0 0\nfeed 1 0 0 0 0\n");
		run(dialects[i], "G10 L2 P1 X5.\nG0 G52 X1.\nX0.\nM30\n", "rapid 6 0 0 0 0\n");
		/* G0 ends a cycle there, too. */
		run(dialects[i], "F9. G0 Z5.\nG81 Z-1. R1.\nG0 G91 G28 Z0.\nG90 X1.\nM30\n",
		    "rapid 0 0 5 0 0\nrapid 0 0 5 0 0\nrapid 0 0 1 0 0\nfeed 0 0 -1 0 0\nrapid 0 0 5 0 0\n"
		    "rapid 0 0 5 0 0\nrapid 0 0 0 0 0\nrapid 1 0 0 0 0\n");
		refuse(dialects[i], "G28 G81 Z0. R1.\n", 5,
		       "G81 and G28 both need the axis words of the block; write two blocks");
	}
}
END_TEST

/*
 * The same lists: cycles and G80 are of group 09, so that G80 leaves G0 to G3; B-64484EN, canned cycles for drilling,
 * "Cancel": G80 or a code of group 01 cancels them.
 */
START_TEST(cycles_apart)
{
	for (int i = 0; i < 2; i++) {
		run(dialects[i], "F9. G0 Z5.\nG81 X1. Z-1. R1.\nG80\nX2.\nM30\n",
		    "rapid 0 0 5 0 0\nrapid 1 0 5 0 0\nrapid 1 0 1 0 0\nfeed 1 0 -1 0 0\nrapid 1 0 5 0 0\n"
		    "rapid 2 0 5 0 0\n");
		run(dialects[i], "F9. G1 Z5.\nG81 X1. Z-1. R1.\nG80 X2.\nX3.\nG40 G80 G90\nX4.\nM30\n",
		    "feed 0 0 5 0 0\nrapid 1 0 5 0 0\nrapid 1 0 1 0 0\nfeed 1 0 -1 0 0\nrapid 1 0 5 0 0\n"
		    "feed 2 0 5 0 0\nfeed 3 0 5 0 0\nfeed 4 0 5 0 0\n");
		run(dialects[i], "F9. G0 Z5.\nG81 X1. Z-1. R1.\nG1 X2.\nX3.\nG80 G0 X4.\nM30\n",
		    "rapid 0 0 5 0 0\nrapid 1 0 5 0 0\nrapid 1 0 1 0 0\nfeed 1 0 -1 0 0\nrapid 1 0 5 0 0\n"
		    "feed 2 0 5 0 0\nfeed 3 0 5 0 0\nrapid 4 0 5 0 0\n");
		/* Which motion is in force at power-on is the control's choice. */
		refuse(dialects[i], "G80\nX1.\n", 1, "axis words, but no motion code is in force (G0, G1, G2, G3)");
	}
	refuse(&dialect_linuxcnc, "G0 X1\nG80\nX2\n", 1, "axis words, but no motion code is in force (G0, G1, G2, G3)");
}
END_TEST

int main(void)
{
	const TTest *const tests[] = {motion_beside_reference, cycles_apart};

	return RUN_TESTS("gcode_modal", tests);
}
