/*
 * test_gcode_dialect.c - the tables of the dialects, and a control without answers: a question that its table leaves
 * open is refused at its place and never answered in the way of another control.
 */
#include "gcode/dialect/fanuc/fanuc_family.h"
#include "gcode/dialect/standard_codes.h"
#include "gcode/state.h"
#include "gcode_case.h"

static bool read_words(struct interp *interp)
{
	static const struct lexer_rules lexer = {0};
	static const struct block_rules rules = {.lexer = &lexer};

	return block_read(&interp->block, &interp->at, interp->config, &rules, interp, &interp->cautions);
}

static const struct code bare_codes[] = {
    {G0, G_MOTION, CODE_READ, "a code"},
    {G1, G_MOTION, CODE_READ, "a code"},
};
static const struct code_set bare_set = CODE_SET(bare_codes);

/* Only G0 and G1, no answers. */
static const struct dialect bare = {.name = "bare", .g_codes = {&bare_set}, .read_block = read_words};

static const struct code more_codes[] = {
    {G41, G_CUTTER, CODE_READ, "a code"},
    {G53_1, G_NONMODAL, CODE_READ, "a code"},
    {G54_1, G_SYSTEM, CODE_READ, "a code"},
    {G61_1, G_PATH, CODE_READ, "a code"},
    {G92_1, G_NONMODAL, CODE_READ, "a code"},
    {1234, G_NONMODAL, CODE_READ, "a code"},
    {1235, G_MOTION, CODE_READ, "a code"},
};
static const struct code_set more_set = CODE_SET(more_codes);

/* All codes that several controls share, no answers. */
static const struct dialect silent = {
    .name = "silent",
    .g_codes = {&standard_g_codes, &more_set, &fanuc_family_g_codes},
    .m_codes = {&basic_m_codes, &standard_m_codes, &fanuc_family_m_codes},
    .read_block = read_words,
};

/* Answers the questions that nearly every program raises, so that the test reaches the question behind them. */
static const struct dialect_traits usual = {
    .power_on = {.units = G21, .distance = G90, .plane = G17, .feed_mode = G94},
    .whole_numbers = WHOLE_NUMBERS_UNITS,
    .t_word = T_WORD_SELECTS,
};

struct refusal {
	const char *program;	/* its last line is refused */
	int column;
	const char *message;
};

static void expect_refusal(const struct refusal *refusal, const struct dialect *dialect)
{
	const char *line = refusal->program, *next;
	struct strbuf expected = {0};
	const struct tool tool = {.number = 1, .length_offset = 5, .diameter = 2};
	const struct length_offset length = {.number = 1, .length = 5};
	const struct mcode mcode = {428, MCODE_TCP_ON};
	struct gcode_case c;
	int number = 1;

	case_init(&c);
	c.config.dialect = dialect;
	c.config.controller = (struct controller){0};
	c.config.has_setup = true;
	c.config.tools = &tool;
	c.config.lengths = &length;
	c.config.tool_count = c.config.length_count = 1;
	c.config.controller.mcodes = &mcode;
	c.config.controller.mcode_count = 1;
	c.config.controller.tool_change.given = true;
	c.config.wrap[SLOT_C] = WRAP_SIGN;
	ck_assert_msg(!case_run(&c, refusal->program), "accepted: %s", refusal->program);
	for (; (next = strchr(line, '\n')) && next[1]; line = next + 1)
		number++;
	strbuf_addf(&expected, "p.nc:%d:%d: error: %s\n    %.*s\n    %*s\n", number, refusal->column, refusal->message,
		    (int)strcspn(line, "\n"), line, refusal->column, "^");
	ck_assert_msg(strstr(strbuf_text(&c.messages), expected.text), "of\n%s\nsaid:\n%sinstead of:\n%s",
		      refusal->program, strbuf_text(&c.messages), expected.text);
	strbuf_release(&expected);
	case_release(&c);
}

#define UNKNOWN(question) "it is not known " question " in the bare dialect"
#define PARAMETER(question, answer) \
	"a parameter of the control decides " question ": set " answer " in the machine file's <controller>"
#define UNITS "power_on_units=\"mm\" or \"inch\""

static const struct refusal bare_refusals[] = {
    {"G0 X1.\n", 1, PARAMETER("whether lengths are mm or inches before any G20 or G21", UNITS)},
    {"G1 F9.\n", 4, PARAMETER("whether F is in mm or inches before any G20 or G21", UNITS)},
    {"G0\nC90.\n", 1, PARAMETER("whether lengths are mm or inches before any G20 or G21", UNITS)},
    {"G21\n", 1, "G21 is not a G-code of the bare dialect"},
    {"G2 X1. I1.\n", 1, "G2 is not a G-code of the bare dialect"},
    {"G4 P1.\n", 1, "G4 is not a G-code of the bare dialect"},
    {"M30\n", 1,
     "M30 is not known; if it moves no axis, set <mcode number=\"30\" action=\"ignore\"/> in the machine file's "
     "<controller>"},
    {"T1\n", 1, UNKNOWN("whether T changes the tool or selects it for M6")},
    {"X1.\n", 1, "axis words without an active motion code (G0, G1, G2, G3)"},
    {"#1=5\n", 1, "unexpected '#'"},
    {"IF [1 EQ 1] GOTO 5\n", 1, "I without a number"},
    {"O1234\n", 1, "O is allowed only at the start of a block"},
    {"G0 ; end\n", 4, "it is not known whether ';' starts a comment or ends the block on this control"},
};

START_TEST(bare_table)
{
	expect_refusal(&bare_refusals[_i], &bare);
}
END_TEST

START_TEST(no_table_at_all)
{
	static const struct dialect empty = {.name = "empty"};
	static const struct refusal refusal = {"G0\n", 1,
					       "it is not known how a block is written in the empty dialect"};

	expect_refusal(&refusal, &empty);
}
END_TEST

/* If the program gives all modes, the codes that need no answer are carried out, and no others. */
START_TEST(given_modes)
{
	struct gcode_case c;

	case_init(&c);
	c.config.dialect = &silent;
	case_expect(&c, "G20 G90 G94\nG0 X1. C90.\nG1 Z-1. F2.\nG91 X1.\nM2\n",
		    "rapid 25.4 0 0 0 90\nfeed 25.4 0 -25.4 0 90\nfeed 50.8 0 -25.4 0 90\n");
}
END_TEST

#undef UNKNOWN
#define UNKNOWN(question) "it is not known " question " in the silent dialect"

static const struct refusal silent_refusals[] = {
    {"G21\nG0 X1.\n", 1,
     PARAMETER("whether coordinates are absolute before any G90 or G91", "power_on_distance=\"absolute\" or \"incremental\"")},
    {"G21 G90\nG1 X1. F9.\n", 8, UNKNOWN("what F means before any G93, G94 or G95")},
    {"G21 G90 G94\nG2 X1. I1. F9.\n", 1, 
     PARAMETER("which plane is active before any G17, G18 or G19", "power_on_plane=\"xy\", \"zx\" or \"yz\"")},
    {"G21 G90 G94 G17\nG2 X1. I1. F9.\n", 1, UNKNOWN("whether I, J and K are relative to the start of an arc")},
    {"G21 G90\nG0 X5\n", 4, UNKNOWN("what a number without a decimal point means")},
    {"G21 G94\nF9.\nG95\n", 1, UNKNOWN("whether the feed rate remains valid after G93, G94 or G95")},
    {"T1\n", 1, UNKNOWN("whether T changes the tool or selects it for M6")},
};

START_TEST(silent_modes)
{
	struct refusal refusal = silent_refusals[_i];

	expect_refusal(&refusal, &silent);
}
END_TEST

static const struct refusal usual_refusals[] = {
    {"G4 P1.\n", 1, UNKNOWN("which word of G4 is its time")},
    {"G94 F9\nG95\n", 1, UNKNOWN("whether the feed rate remains valid after G93, G94 or G95")},
    {"G1 F9\n", 1, UNKNOWN("whether G1 without an axis word needs a feed rate")},
    {"G64 P1\n", 5, UNKNOWN("whether P of G64 is a path tolerance")},
    {"G61.1\n", 1, UNKNOWN("whether G61.1 keeps to the programmed path")},
    {"G92.1\n", 1, UNKNOWN("whether G92.1 cancels the shift or presets coordinates")},
    {"G20 G0 X1\n", 1, UNKNOWN("whether a unit applies to all words of its block")},
    {"F9\nG2 X1 R1 P2\n", 10, UNKNOWN("whether P of G2 and G3 is the number of turns")},
    {"F9\nG2 X2 I1\n", 1, UNKNOWN("whether I, J and K are relative to the start of an arc")},
    {"G0 C400\n", 4, UNKNOWN("where an absolute position of a turn or more moves a wrapped axis")},
    {"F9\nG81 X1 Z-5 R1\n", 1, UNKNOWN("how canned cycles drill")},
    {"F9\nG83 X1 Z-5 R1 Q1 K2\n", 1, UNKNOWN("how canned cycles drill")},
    {"G53 G1 X1\n", 1, UNKNOWN("whether G53 with G1 moves at the feed rate")},
    {"G53\n", 1, UNKNOWN("what G53 without axis words does")},
    {"G28\n", 1, UNKNOWN("which axes G28 and G30 without an axis word move")},
    {"G30 X1 P3\n", 8, UNKNOWN("whether P of G30 is the number of a reference position")},
    {"G30 X1\n", 1,
     "the machine file has no reference position 2: set <reference number=\"2\" X=\"\" .../> in its <controller>"},
    {"M428\nG53 G0 X1\n", 1, UNKNOWN("what machine coordinates mean while an M-code has TCP on")},
    {"G68 R5 X0 Y0\nG0 X1 Y1\nG28 Z1\n", 1, UNKNOWN("where G28, G30 and G53 move while G68 is active")},
    {"T1 M6 G0 X1\n", 4,
     "M6 in a block with motion: the machine builder decides whether it comes before or after the move: set "
     "m6_with_move=\"after\" or \"before\" in the machine file's <controller>, or write two blocks"},
    {"G54.1 P1\n", 1, UNKNOWN("how many additional work offsets there are")},
    {"G54 P1\n", 5, UNKNOWN("whether G54 with P selects an additional work offset")},
    {"G10 L2 P1 X5\n", 5, UNKNOWN("which work offsets G10 writes")},
    {"G10 L20 P1 X5\n", 5, UNKNOWN("what G10 L20 writes")},
    {"G10 L1 P1 Z5\n", 5, "G10 L1 is not supported"},
    {"G91 G92 X5\n", 5, "G92 in incremental mode (G91) is not supported"},
    {"G52 X5\nG92 X9\n", 1, "G92 while G52 is active is not supported"},
    {"G43\n", 1, UNKNOWN("which length G43 without H uses")},
    {"G43 H0\n", 5, UNKNOWN("which length H0 means")},
    {"G43 H1\n", 1,
     "controls differ in whether this change of the tool length moves Z at once: write Z in this block as an absolute "
     "coordinate, or set length_offset_moves=\"yes\" or \"no\" in the machine file's <controller>"},
    {"G43 H1 G0 Z9\nG28 X1\nG0 Z5\n", 4,
     "G28 may have cancelled the tool length compensation, so the position of Z depends on the control; write G43, "
     "G43.4 or G49 again first, or set length_after_reference=\"keeps\" or \"cancels\" in the machine file's "
     "<controller>"},
    {"M98 P1\n", 5, "no code in the block uses the word P"},
    {"M99\n", 1, UNKNOWN("what the calls of subprograms (M97 to M99) do")},
    {"G65 P1\n", 1, "G65 must be the first word of its block after N"},
    {"G123.4\n", 1, "G123.4 is not supported; post the program without it"},
    {"G123.5 X1\n", 1, "G123.5: this motion is not supported; write it as lines and circles (G1, G2, G3)"},
};

START_TEST(silent_table)
{
	struct dialect dialect = silent;

	dialect.traits = usual;
	expect_refusal(&usual_refusals[_i], &dialect);
}
END_TEST

/* A control without this answer may leave the path until the program has G61. */
START_TEST(silent_path)
{
	struct dialect dialect = silent;
	struct gcode_case c;

	dialect.traits = usual;
	case_init(&c);
	c.config.dialect = &dialect;
	c.show_blend = true;
	case_expect(&c, "G0 X1\nG61 X2\nM2\n", "rapid 1 0 0 0 0 blend 0\nrapid 2 0 0 0 0 exact\n");
}
END_TEST

/* Canned cycles need all of their answers. */
START_TEST(half_answered_cycles)
{
	static const struct refusal refusal = {
	    "F9\nG81 X1 Z-5 R1\n", 1, UNKNOWN("what a canned cycle without axis words does")};
	const struct cycle_traits cycles = {
	    .words_outlive_cycle = ANSWER_NO, .words_keep_place = ANSWER_NO, .repeat_letter = 'L'};
	struct dialect dialect = silent;

	dialect.traits = usual;
	dialect.traits.cycles = &cycles;
	expect_refusal(&refusal, &dialect);
}
END_TEST

/* The rows of a set are sorted for the search, and no code has two rows. */
START_TEST(rows)
{
	for (int row = 0; dialect_names[row]; row++) {
		const struct dialect *dialect = dialect_of_row(row);
		const struct code_set *const *kinds[] = {dialect->g_codes, dialect->m_codes};

		ck_assert_str_eq(dialect->name, dialect_names[row]);
		ck_assert(dialect->manual);
		ck_assert_int_eq(dialect_row_find(dialect->name), row);
		for (int kind = 0; kind < 2; kind++) {
			for (int i = 0; i < CODE_SETS_MAX && kinds[kind][i]; i++) {
				const struct code_set *set = kinds[kind][i];

				for (size_t k = 0; k < set->count; k++) {
					const struct code *code = &set->rows[k];

					ck_assert_msg(k == 0 || code[-1].number < code->number, "%s: %d", dialect->name,
						      code->number);
					ck_assert_msg(code_find(kinds[kind], code->number) == code, "%s: %d twice",
						      dialect->name, code->number);
					/* A refused code has no group, and one without a group is refused or ignored. */
					ck_assert(code->what && code->what[0] != '\0');
					ck_assert(code->state != CODE_REFUSED || code->group == GROUP_NONE);
					ck_assert(code->group != GROUP_NONE || code->state == CODE_REFUSED ||
						  code->state == CODE_IGNORED);
				}
			}
		}
	}
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("dialect");

	tcase_add_loop_test(tcase, bare_table, 0, COUNT(bare_refusals));
	tcase_add_test(tcase, no_table_at_all);
	tcase_add_test(tcase, given_modes);
	tcase_add_loop_test(tcase, silent_modes, 0, COUNT(silent_refusals));
	tcase_add_loop_test(tcase, silent_table, 0, COUNT(usual_refusals));
	tcase_add_test(tcase, silent_path);
	tcase_add_test(tcase, half_answered_cycles);
	tcase_add_test(tcase, rows);
	return run_suite("gcode_dialect", tcase);
}
