/*
 * test_gcode_sinumerik_table.c - the sinumerik dialect: every word of its tables does what its row says. What is ignored
 * leaves the moves around it as they are, and what is refused names itself.
 */
#include "sinumerik_case.h"

#include "gcode/dialect/sinumerik/words/sinumerik_codes.h"

/* How a word stands in a block: alone, with a value, with parentheses, ...; NULL: it is not ignored and not refused. */
static const char *form_of(enum sinumerik_word_kind kind)
{
	switch (kind) {
	case SINUMERIK_WORD_IGNORED:
	case SINUMERIK_WORD_STOPS_READING:
		return "%s";
	case SINUMERIK_WORD_IGNORED_VALUE:
	case SINUMERIK_WORD_SPINDLE_STANDS:
		return "%s=1";
	case SINUMERIK_WORD_IGNORED_CALL:
		return "%s(1,\"a,b\",(2))";
	case SINUMERIK_WORD_IGNORED_LINE:
		return "%s X100 \"";
	case SINUMERIK_WORD_ZERO:
	case SINUMERIK_WORD_REFUSED:
		return "%s=1";
	default:
		return NULL;
	}
}

static void ignores(const char *block)
{
	struct strbuf program = {0};
	struct gcode_case c;

	sinumerik_case_init(&c);
	strbuf_addf(&program, "F6 G500 G1 X1\n%s\nX2 Y3\nX=IC(1)\nG2 X5 CR=5\n", block);
	ck_assert_msg(case_run(&c, strbuf_text(&program)), "%s", strbuf_text(&c.messages));
	ck_assert_msg(!strcmp(strbuf_text(&c.moves), "feed 1 0 0 0 0\nfeed 2 3 0 0 0\nfeed 3 3 0 0 0\n"
						     "arc 5 3 0 0 0 centre 4 -1.89897949 0 normal 0 0 1 sweep -23.0739181\n"),
		      "%s: %s", block, strbuf_text(&c.moves));
	strbuf_release(&program);
	case_release(&c);
}

static void refuses(const char *block, const char *word, const char *what)
{
	struct strbuf expected = {0};
	struct gcode_case c;

	sinumerik_case_init(&c);
	strbuf_addf(&expected, "p.nc:1:1: error: %s: %s is not supported", word, what);
	ck_assert_msg(!case_run(&c, block), "%s", block);
	ck_assert_msg(!strncmp(strbuf_text(&c.messages), strbuf_text(&expected), strlen(strbuf_text(&expected))), "%s: %s",
		      strbuf_text(&expected), strbuf_text(&c.messages));
	strbuf_release(&expected);
	case_release(&c);
}

START_TEST(words)
{
	size_t tried = 0;

	for (size_t i = 0; i < sinumerik_word_set.count; i++) {
		const struct code_word *row = &sinumerik_word_set.rows[i];
		struct sinumerik_word word;
		char block[64];
		const char *form;

		ck_assert(sinumerik_codes_word(row->word, &word));
		form = form_of(word.kind);
		ck_assert_msg((form != NULL) == (row->state == CODE_IGNORED || row->state == CODE_REFUSED), "%s", row->word);
		if (!form)
			continue;
		snprintf(block, sizeof(block), form, row->word);
		if (row->state == CODE_IGNORED)
			ignores(block);
		else
			refuses(block, row->word, row->what);
		tried++;
	}
	ck_assert_uint_gt(tried, 250);
}
END_TEST

START_TEST(g_codes)
{
	for (size_t i = 0; i < sinumerik_g_codes.count; i++) {
		const struct code *code = &sinumerik_g_codes.rows[i];
		char word[16], block[32];

		snprintf(word, sizeof(word), "G%d", code->number / 10);
		/* The limits of the working area have axes beside them. */
		snprintf(block, sizeof(block), "%s%s", word, code->number / 10 == 25 || code->number / 10 == 26 ? " X9" : "");
		if (code->state == CODE_IGNORED)
			ignores(block);
		if (code->state == CODE_REFUSED)
			refuses(block, word, code->what);
	}
}
END_TEST

START_TEST(m_codes)
{
	for (size_t i = 0; i < sinumerik_m_codes.count; i++) {
		char block[16];

		snprintf(block, sizeof(block), "M%d", sinumerik_m_codes.rows[i].number);
		if (sinumerik_m_codes.rows[i].state == CODE_IGNORED)
			ignores(block);
	}
}
END_TEST

static void expect(const char *program, const char *moves)
{
	struct gcode_case c;

	sinumerik_case_init(&c);
	ck_assert_msg(case_run(&c, program), "%s", strbuf_text(&c.messages));
	ck_assert_str_eq(strbuf_text(&c.moves), moves);
	case_release(&c);
}

START_TEST(scales_added)
{
	expect("F6 G500 TRANS X10\nASCALE X2 Y3 Z4\nX1 Y1 Z1\n", "feed 12 3 4 0 0\n");
	expect("F6 G500 SCALE X2 Y2 Z2\nATRANS X10\nASCALE X2\nX1\n", "feed 24 0 0 0 0\n");
}
END_TEST

/* A word beside another one that means the same here, in a program in place of its %s. */
START_TEST(words_alike)
{
	static const struct {
		const char *program, *word, *other;
	} alike[] = {
		{"F6 G500 G0 Z100\nTRAORI\nG1 A30 C20\n%s\nZ5\n", "TOROTZ", "TOROT"},
		{"F6 G500 G0 Z100\nTRAORI\nG1 A30 C20\n%s\nZ5\n", "TOFRAMEZ", "TOFRAME"},
		{"F6 G500 G0 Z100\nTRAORI\nG1 A30 C20\nTOROT\nZ5\n%s\nX2 Z7\n", "TOFRAMEOF", "TOROTOF"},
		{"F6 G500 G0 Z100\nTRAORI\nORIWKS %s\nG1 A3=1 B3=0 C3=2\nX9 A3=0 B3=1 C3=2\n", "ORIPLANE", "ORIVECT"},
		{"F6 G500 CTOL=0.1 %s\nX1\nX2\n", "COMPON", "COMPCAD"},
		{"F6 G500 CTOL=0.1 %s\nX1\nX2\n", "COMPCURV", "COMPCAD"},
		{"F6 G500 CTOL=0.1 %s\nX1\nX2\n", "COMPSURF", "COMPCAD"},
		{"F6 G500 CTOL=0.1 %s\nX1\nY2\n", "G643", "G642"},
		{"F6 G500 CTOL=0.1 %s\nX1\nY2\n", "G645", "G642"},
		{"F6 G500 CTOL=0.1 %s\nX1\nY2\n", "G646", "G642"},
	};

	for (size_t i = 0; i < COUNT(alike); i++) {
		struct strbuf first = {0}, second = {0};
		struct gcode_case one, two;

		sinumerik_case_init(&one);
		sinumerik_case_init(&two);
		one.show_blend = two.show_blend = one.show_spread = two.show_spread = true;
		strbuf_addf(&first, alike[i].program, alike[i].word);
		strbuf_addf(&second, alike[i].program, alike[i].other);
		ck_assert_msg(case_run(&one, strbuf_text(&first)), "%s", strbuf_text(&one.messages));
		ck_assert_msg(case_run(&two, strbuf_text(&second)), "%s", strbuf_text(&two.messages));
		ck_assert_str_eq(strbuf_text(&one.moves), strbuf_text(&two.moves));
		strbuf_release(&first);
		strbuf_release(&second);
		case_release(&one);
		case_release(&two);
	}
}
END_TEST

/* MD21104=0: the coordinates of the orientation decide. On a great circle, the turn is cut into pieces. */
START_TEST(orientation_by_coordinates)
{
	static const char circle[] = "tcp on length 0 zero A0 C0\nfeed 0.5 0 0 5 0 tcp\nfeed 1 0 0 10 0 tcp\n"
				     "feed 1.5 0 0 15 0 tcp\nfeed 2 0 0 20 0 tcp\n",
			  even[] = "tcp on length 0 zero A0 C0\nfeed 2 0 0 20 0 tcp\n";
	static const struct {
		const char *program, *moves;
	} cases[] = {
		{"G500 F6 TRAORI\nX2 A20\n", circle},
		{"G500 F6 TRAORI ORIWKS ORIAXES\nX2 A20\n", circle},
		{"G500 F6 TRAORI ORIMKS ORIVECT\nX2 A20\n", even},
	};

	for (size_t i = 0; i < COUNT(cases); i++) {
		struct gcode_case c;

		sinumerik_case_init(&c);
		c.config.controller.orientation_interpolation = ORIENTATION_INTERPOLATION_ORIWKS;
		ck_assert_msg(case_run(&c, cases[i].program), "%s", strbuf_text(&c.messages));
		ck_assert_str_eq(strbuf_text(&c.moves), cases[i].moves);
		case_release(&c);
	}
}
END_TEST

/* If MD21104 is not known, the program is followed, with a caution where the two values differ. */
START_TEST(orientation_unknown)
{
	static const char even[] = ":2:1: warning: the rotary axes turn evenly here, because the program says so; on a "
				   "control with MD21104=%d";
	static const struct {
		const char *modes;
		bool good;
		int other;	/* the value of MD21104 that the caution names; -1: no caution */
	} cases[] = {
		{"ORIWKS ORIVECT", true, -1}, {"ORIVECT", true, -1}, {"ORIMKS ORIAXES", true, -1},
		{"ORIWKS ORIAXES", true, 0},  {"ORIAXES", true, 0},  {"ORIMKS", true, 1},
		{"", false, -1},
	};

	for (size_t i = 0; i < COUNT(cases); i++) {
		struct strbuf text = {0}, expected = {0};
		struct gcode_case c;

		sinumerik_case_init(&c);
		c.config.controller.orientation_interpolation = ORIENTATION_INTERPOLATION_UNKNOWN;
		strbuf_addf(&text, "G500 F6 TRAORI %s\nX3 A20\nX4 A10\n", cases[i].modes);
		ck_assert_msg(case_run(&c, strbuf_text(&text)) == cases[i].good, "%s: %s", cases[i].modes,
			      strbuf_text(&c.messages));
		if (!cases[i].good)
			strbuf_addf(&expected, "%s", ": error: a parameter of the control (MD21104) decides how TRAORI turns");
		else if (cases[i].other >= 0)
			strbuf_addf(&expected, even, cases[i].other);
		ck_assert_msg(!strbuf_text(&expected)[0] == !strbuf_text(&c.messages)[0] &&
				      strstr(strbuf_text(&c.messages), strbuf_text(&expected)),
			      "%s: %s", cases[i].modes, strbuf_text(&c.messages));
		ck_assert_msg(!strstr(strbuf_text(&c.messages), ":3:"), "%s", strbuf_text(&c.messages));
		strbuf_release(&text);
		strbuf_release(&expected);
		case_release(&c);
	}
}
END_TEST

/* SD42110: a default feed of the control. The path is the same. */
START_TEST(feed_missing)
{
	struct gcode_case c;

	sinumerik_case_init(&c);
	ck_assert_msg(case_run(&c, "G500 X5\nG2 X6 I0.5\n"), "%s", strbuf_text(&c.messages));
	ck_assert_str_eq(strbuf_text(&c.moves),
			 "feed 5 0 0 0 0\narc 6 0 0 0 0 centre 5.5 0 0 normal 0 0 1 sweep -180\n");
	ck_assert_ptr_nonnull(strstr(strbuf_text(&c.messages), "p.nc:1:6: warning: G1 without a feed rate (F)"));
	case_release(&c);
}
END_TEST

/* Taps without a speed or a pitch, as posts write them that have no data of the tool, and feeds per revolution. */
START_TEST(speed_missing)
{
	static const char *const blocks[] = {
		"G500 G0\nMCALL CYCLE84(9,0,2,-5,,,,,,,)\nX1 Y2\n",
		"G500 G0 S0\nMCALL CYCLE840(9,0,2,-5,,0,4,3,1,,1)\nX1 Y2\n",
		"G500 G0 X1 Y2 Z2\nG331 Z-5 K1\nG332 Z2 K1\n",
		"G500 G0 X1 Y2 Z2\nG95 F1 G1 Z-5\nZ2\n",
	};

	for (size_t i = 0; i < COUNT(blocks); i++) {
		struct gcode_case c;

		sinumerik_case_init(&c);
		ck_assert_msg(case_run(&c, blocks[i]), "%s: %s", blocks[i], strbuf_text(&c.messages));
		ck_assert_ptr_nonnull(strstr(strbuf_text(&c.moves), "feed 1 2 -5 0 0\nfeed 1 2 2 0 0\n"));
		ck_assert_ptr_nonnull(strstr(strbuf_text(&c.messages),
					     "warning: a thread or a feed per revolution without a spindle speed (S)"));
		ck_assert_uint_eq(c.diag.warnings, 1);
		case_release(&c);
	}
}
END_TEST

int main(void)
{
	const TTest *const tests[] = {words, g_codes, m_codes, scales_added, words_alike, orientation_by_coordinates,
				      orientation_unknown, feed_missing, speed_missing};

	return RUN_TESTS("gcode_sinumerik_table", tests);
}
