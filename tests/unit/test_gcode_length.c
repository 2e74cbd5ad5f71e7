/* test_gcode_length.c - which axes a change of the length compensation moves on Fanuc and Haas controls. */
#include "gcode_refusal.h"

static const struct length_offset lengths[] = {{1, 100}, {2, 40}};

static void length_case(struct gcode_case *c, const struct dialect *dialect, enum answer answer)
{
	case_init(c);
	c->config.dialect = dialect;
	c->config.lengths = lengths;
	c->config.length_count = 2;
	c->config.controller.length_moves = answer;
}

static void run(const struct dialect *dialect, enum answer answer, const char *program, const char *moves)
{
	struct gcode_case c;

	length_case(&c, dialect, answer);
	case_expect(&c, program, moves);
}

/* Whatever the control does, the programs reach the same places. */
START_TEST(either_way)
{
	static const enum answer answers[] = {ANSWER_UNKNOWN, ANSWER_YES, ANSWER_NO};
	static const struct dialect *const dialects[] = {&dialect_fanuc, &dialect_haas};

	for (int i = 0; i < 3; i++) {
		for (int k = 0; k < 2; k++) {
			enum answer answer = answers[i];
			const struct dialect *dialect = dialects[k];

			/* Safe starts; the usual first approach; the same length again. */
			run(dialect, answer, "G40 G49 G80\nG43 H1 G0 X1. Y0 Z5.\nG43 H1\nG49 G53 Z0.\nG49\nM30\n",
			    "rapid 1 0 105 0 0\nrapid 1 0 0 0 0\n");
			/* A motion in force, helices. */
			run(dialect, answer, "G1 F9. X1.\nG43 H2 Z1.\nG17 G49 G2 I5. Z7.\nM30\n",
			    "feed 1 0 0 0 0\nfeed 1 0 41 0 0\n"
			    "arc 1 0 7 0 0 centre 6 0 41 normal 0 0 1 sweep -360\n");
			/* Under TCP, a change along Z leaves X and Y. */
			run(dialect, answer,
			    dialect == &dialect_haas ? "G0 X2. C90.\nG234 H1 Z5.\nM30\n" : "G0 X2. C90.\nG43.4 H1 "
			        "Z5.\nM30\n",
			    "rapid 2 0 0 0 90\ntcp on length 0 zero A0 C0\ntcp on length 100 zero A0 C0\n"
			    "rapid 0 -2 5 0 90 tcp\n");
		}
	}
	/* B-63844EN, "G53, G28, and G30 commands in tool length offset mode": G28 cancels the length. */
	run(&dialect_fanuc, ANSWER_UNKNOWN, "G43 H1 G0 Z5.\nG91 G28 Z0.\nG49\nG90 Z1.\nM30\n",
	    "rapid 0 0 105 0 0\nrapid 0 0 105 0 0\nrapid 0 0 0 0 0\nrapid 0 0 1 0 0\n");
}
END_TEST

/* C Executer manual B-62443EN-3, reading modal data: H stays; the Mori post-processor counts on it after G49. */
START_TEST(number_stays)
{
	run(&dialect_fanuc, ANSWER_NO, "G43 H1 G0 Z5.\nG49\nG43 Z6.\nG49\nG43 H2 Z7.\nG49 Z0.\nG43 Z8.\nM30\n",
	    "rapid 0 0 105 0 0\nrapid 0 0 106 0 0\nrapid 0 0 47 0 0\nrapid 0 0 0 0 0\nrapid 0 0 48 0 0\n");
	run(&dialect_fanuc, ANSWER_NO, "G43 H1 G0 Z5.\nG49\nG43.4 Z6.\nM30\n",
	    "rapid 0 0 105 0 0\ntcp on length 0 zero A0 C0\ntcp on length 100 zero A0 C0\n"
	    "rapid 0 0 6 0 0 tcp\n");
}
END_TEST

/* Fanuc 30i connection manual (B-63943EN-1), "Tool Length Compensation Shift Types": parameter TOS at 1. */
START_TEST(axes_stand)
{
	run(&dialect_fanuc, ANSWER_NO, "G43 H1 G0 X1. Y0\nX2.\nZ3.\nG49\nG91 G43 H2 Z1.\nX1.\nM30\n",
	    "rapid 1 0 0 0 0\nrapid 2 0 0 0 0\nrapid 2 0 103 0 0\nrapid 2 0 104 0 0\nrapid 3 0 104 0 0\n");
}
END_TEST

/*
 * TOS at 0. Fanuc 0i-MB operator's manual (B-63844EN), tool length offset: in
 * its example increments and the offset add up.
 */
START_TEST(axes_move)
{
	run(&dialect_fanuc, ANSWER_YES, "G0 Z1.\nG43 H1\nX1.\nG43 H2 X2. Y0\nG91 G43 H1 Z1.\nG49\nX1.\nG90 Z5.\nM30\n",
	    "rapid 0 0 1 0 0\nrapid 0 0 101 0 0\nrapid 1 0 101 0 0\nrapid 2 0 41 0 0\nrapid 2 0 102 0 0\n"
	    "rapid 2 0 2 0 0\nrapid 3 0 2 0 0\nrapid 3 0 5 0 0\n");
	run(&dialect_fanuc, ANSWER_YES, "G1 F9. G43 H1\nX1.\nG80 G49\nM30\n",
	    "rapid 0 0 100 0 0\nfeed 1 0 100 0 0\nrapid 1 0 0 0 0\n");
	/* The tool goes back along itself: the tip comes to where the spindle was. */
	run(&dialect_fanuc, ANSWER_YES, "G0 X2. Z9. C90.\nG43.4 H1\nY-3.\nM30\n",
	    "rapid 2 0 9 0 90\ntcp on length 0 zero A0 C0\ntcp on length 100 zero A0 C0\nrapid 0 -2 9 0 90 tcp\n"
	    "rapid 0 -3 9 0 90 tcp\n");
}
END_TEST

#define ASK \
	"controls differ in whether this change of the tool length moves Z at once: write Z in this block as an " \
	"absolute coordinate, or set length_offset_moves=\"yes\" or \"no\" in the machine file's <controller>"
#define NOT_PLAIN \
	"with length_offset_moves=\"yes\", this change of the tool length moves Z to an unknown position; write Z in " \
	"this block as an absolute coordinate of G0 or G1"

static const struct {
	const struct dialect *dialect;
	enum answer answer;
	const char *before, *block;
	int column;
	const char *message;
} bads[] = {
    {&dialect_fanuc, ANSWER_UNKNOWN, "G0", "G43 H1", 1, ASK},
    {&dialect_haas, ANSWER_UNKNOWN, "G0", "G43 H1 X5.", 1, ASK},
    {&dialect_fanuc, ANSWER_UNKNOWN, "G0", "G91 G43 H1 Z5.", 5, ASK},
    {&dialect_fanuc, ANSWER_UNKNOWN, "G91", "G43 H1 G0 Z5.", 1, ASK},
    {&dialect_fanuc, ANSWER_UNKNOWN, "G43 H1 G0 Z5.", "G49", 1, ASK},
    {&dialect_haas, ANSWER_UNKNOWN, "G43 H1 G0 Z5.\nG53 Z0.", "G40 G49 G80", 5, ASK},
    {&dialect_fanuc, ANSWER_UNKNOWN, "G43 H1 G0 Z5.", "G49 G53 X0.", 1, ASK},
    {&dialect_fanuc, ANSWER_UNKNOWN, "G43 H1 G0 Z5.", "G49 G28 Z9.", 1, ASK},
    {&dialect_fanuc, ANSWER_UNKNOWN, "G0 F9.", "G43 H1 G81 Z-5. R2.", 1, ASK},
    {&dialect_fanuc, ANSWER_UNKNOWN, "G0", "G43 H1 G92 Z5.", 1, ASK},
    {&dialect_fanuc, ANSWER_UNKNOWN, "G0", "G43.4 H1 X1. Y1.", 1, ASK},
    {&dialect_haas, ANSWER_UNKNOWN, "G0", "G234 H1", 1, ASK},
    {&dialect_fanuc, ANSWER_UNKNOWN, "G0 G43.4 H1 X1. Y1. Z1.", "G49", 1, ASK},
    /* The length that G28 has cancelled returns by itself, or it does not. */
    {&dialect_fanuc, ANSWER_UNKNOWN, "G0 G43 H1 Z1.\nG28 Z5.", "G43 H1", 1, ASK},
    {&dialect_fanuc, ANSWER_YES, "G0 G43 H1 Z1.\nG28 Z5.", "G43 H1", 1, NOT_PLAIN},
    {&dialect_fanuc, ANSWER_YES, "G0 G43 H1 Z1.", "G49 G28 Z5.", 1, NOT_PLAIN},
    {&dialect_fanuc, ANSWER_YES, "G0 G43 H1 Z1. F9.", "G49 G2 I5.", 1, NOT_PLAIN},
    {&dialect_fanuc, ANSWER_YES, "F9. G81 Z-5. R2.", "G43 H1", 1, NOT_PLAIN},
    {&dialect_fanuc, ANSWER_YES, "G0 G43.4 H1 X1. Y1. Z1.", "G49", 1, NOT_PLAIN},
    {&dialect_fanuc, ANSWER_YES, "G68.2 I180. J5.", "G43 H1", 1, NOT_PLAIN},
};

/* The machine's builder decides what a tool change does on its way, or the manual does not say it. */
START_TEST(tool_change_leaves_doubt)
{
	static const struct dialect *const dialects[] = {&dialect_fanuc, &dialect_haas};
	const struct control_place home = {.given = true, .has[SLOT_Z] = true, .order = {SLOT_Z}, .order_count = 1};

	for (int i = 0; i < 2; i++) {
		struct gcode_case c;

		length_case(&c, dialects[i], ANSWER_NO);
		c.config.controller.tool_change = home;
		case_expect(&c, "G0 G43 H1 Z5.\nT2 M6\nX1.\nG43 H2 Z5.\nT1 M6\nG49\nZ3.\nT2 M6\nZ4.\nM30\n",
			    "rapid 0 0 105 0 0\nrapid 0 0 0 0 0\ntool 2\nrapid 1 0 0 0 0\nrapid 1 0 45 0 0\n"
			    "rapid 1 0 0 0 0\ntool 1\nrapid 1 0 3 0 0\nrapid 1 0 0 0 0\ntool 2\nrapid 1 0 4 0 0\n");
		length_case(&c, dialects[i], ANSWER_NO);
		c.config.controller.tool_change = home;
		ck_assert(!case_run(&c, "G0 G43 H1 Z5.\nT2 M6\nZ5.\nM30\n"));
		ck_assert_str_eq(strbuf_text(&c.messages),
				 "p.nc:3:1: error: M6 may have cancelled the tool length compensation, so the position "
				 "of Z depends on the control; write G43, G43.4 or G49 again first, or set "
				 "length_after_reference=\"keeps\" or \"cancels\" in the machine file's <controller>\n"
				 "    Z5.\n    ^\n");
		case_release(&c);
		length_case(&c, dialects[i], ANSWER_NO);
		c.config.controller.tool_change = home;
		ck_assert(!case_run(&c, i ? "G0 G234 H1 Z5.\nT2 M6\nX5.\n" : "G0 G43.4 H1 Z5.\nT2 M6\nX5.\n"));
		ck_assert_ptr_nonnull(strstr(strbuf_text(&c.messages), "p.nc:3:1: error: M6 may have cancelled"));
		case_release(&c);
	}
}
END_TEST

/*
 * A program cannot read a position that depends on an uncertain length or on an unknown unit; X does not depend on the
 * length.
 */
START_TEST(position_in_doubt)
{
	struct gcode_case c;

	length_case(&c, &dialect_fanuc, ANSWER_NO);
	ck_assert(!case_run(&c, "G0 G43 H1 X7. Z5.\nG91 G28 Z0.\nG90 X[#5001+1.]\n#1=#5003\n"));
	ck_assert_str_eq(strbuf_text(&c.moves), "rapid 7 0 105 0 0\nrapid 7 0 105 0 0\nrapid 7 0 0 0 0\nrapid 8 0 0 0 0\n");
	ck_assert_msg(strstr(strbuf_text(&c.messages), "p.nc:4:4: error: G28 may have cancelled the tool length"), "%s",
		      strbuf_text(&c.messages));
	case_release(&c);
	/* G92 makes a coordinate of the place. */
	length_case(&c, &dialect_fanuc, ANSWER_NO);
	ck_assert(!case_run(&c, "G0 G43 H1 X7. Z5.\nG91 G28 Z0.\nG90 G92 X0.\nG92 Z0.\n"));
	ck_assert_msg(strstr(strbuf_text(&c.messages), "p.nc:4:5: error: G28 may have cancelled the tool length"), "%s",
		      strbuf_text(&c.messages));
	case_release(&c);
	/* After G69 X is at 0, and its last coordinate was 10. */
	length_case(&c, &dialect_haas, ANSWER_NO);
	ck_assert(!case_run(&c, "G0 X0. Y0. Z5.\nG68 X0. Y0. R90.\nX10. Y0.\nG69\n#1=#5003\nY[#1]\n#1=#5002\n#1=#5001\n"));
	ck_assert_msg(strstr(strbuf_text(&c.messages), "p.nc:8:4: error: the position of X after G69 depends on the control"),
		      "%s", strbuf_text(&c.messages));
	case_release(&c);
	length_case(&c, &dialect_haas, ANSWER_NO);
	c.config.controller.power_on_units = POWER_ON_UNITS_UNKNOWN;
	ck_assert(!case_run(&c, "#1=1\n#1=#5003\n"));
	ck_assert_msg(strstr(strbuf_text(&c.messages), "p.nc:2:4: error: a length is read before G20 or G21"), "%s",
		      strbuf_text(&c.messages));
	case_release(&c);
}
END_TEST

START_TEST(open)
{
	struct gcode_case c;

	length_case(&c, bads[_i].dialect, bads[_i].answer);
	case_refuses_last(&c, bads[_i].column, bads[_i].message, "%s\n%s\n", bads[_i].before, bads[_i].block);
}
END_TEST

/* B-64484EN-2, "Tool Length Offset": types B and C, of which type A differs in these blocks only. */
START_TEST(axis_of_the_length)
{
	static const char *const asked[] = {"G17 G43 X5. H2", "G17 G43 Y5. H2", "G18 G43 Z5. H2", "G19 G43 H2"};
	static const char *const same[] = {"G17 G43 X5. Y5. H2", "G17 G43 X5. Z5. H2", "G17 G43 H2", "G18 G43 X5. H0"};
	static const struct length_offset table[] = {{2, 7}};

	for (size_t i = 0; i < COUNT(asked) + COUNT(same); i++) {
		const bool is_open = i < COUNT(asked);
		struct strbuf program = {0};
		struct gcode_case c;

		strbuf_addf(&program, "G0\n%s\nM30\n", is_open ? asked[i] : same[i - COUNT(asked)]);
		for (int told = 0; told < 2; told++) {
			case_init(&c);
			c.config.dialect = &dialect_fanuc;
			c.config.has_setup = true;
			c.config.lengths = table;
			c.config.length_count = COUNT(table);
			c.config.controller.length_moves = ANSWER_NO;
			c.config.controller.length_along_z = told ? ANSWER_YES : ANSWER_UNKNOWN;
			ck_assert_msg(case_run(&c, strbuf_text(&program)) == (told || !is_open), "%s%s",
				      strbuf_text(&program), strbuf_text(&c.messages));
			ck_assert(told || !is_open || strstr(strbuf_text(&c.messages), "tool_length_axis=\"z\""));
			case_release(&c);
		}
		strbuf_release(&program);
	}
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("gcode_length");

	tcase_add_test(tcase, either_way);
	tcase_add_test(tcase, axes_stand);
	tcase_add_test(tcase, axis_of_the_length);
	tcase_add_test(tcase, number_stays);
	tcase_add_test(tcase, axes_move);
	tcase_add_test(tcase, tool_change_leaves_doubt);
	tcase_add_test(tcase, position_in_doubt);
	tcase_add_loop_test(tcase, open, 0, COUNT(bads));
	return run_suite("gcode_length", tcase);
}
