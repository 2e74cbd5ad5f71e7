/* test_gcode_expr.c - values of LinuxCNC's programs: expressions, parameters, what is read from the modes. */
#include "gcode_refusal.h"

/* The expression as X of a rapid. */
static double value_of(const char *setting, const char *expression)
{
	struct strbuf program = {0};
	struct gcode_case c;
	double value;

	case_init(&c);
	strbuf_addf(&program, "%s\nG0 X[[%s]+1000]\n", setting, expression);
	ck_assert_msg(case_run(&c, program.text), "%s: %s", expression, strbuf_text(&c.messages));
	ck_assert_int_eq(sscanf(strrchr(c.moves.text, 'r'), "rapid %lf", &value), 1);
	strbuf_release(&program);
	case_release(&c);
	return value - 1000;
}

static const struct {
	const char *expression;
	double value;
} values[] = {
	/* precedence, left to right */
	{"1 + 2 * 3", 7}, {"2 * 3 ** 2", 18}, {"2 ** 3 ** 2", 64}, {"10 - 4 - 3", 3}, {"100 / 10 / 2", 5},
	{"7 MOD 4 * 2", 6}, {"1 + 2 EQ 3", 1}, {"1 LT 2 AND 3 LT 2", 0}, {"0 AND 0 OR 1", 1}, {"1 OR 0 AND 0", 0},
	{"2 GT 1 EQ 1", 1}, {"1 XOR 1 XOR 1", 1}, {"-2 ** 2", 4}, {"- [2 ** 2]", -4}, {"8 - 2 * 3 LT 2 + 1", 1},
	/* MOD is never negative, whatever the signs */
	{"-7 MOD 3", 2}, {"7 MOD -3", 1}, {"-7 MOD -3", 2}, {"5.5 MOD 2", 1.5},
	/* rounding */
	{"FIX[2.8]", 2}, {"FIX[-2.8]", -3}, {"FUP[2.2]", 3}, {"FUP[-2.8]", -2}, {"ROUND[2.5]", 3}, {"ROUND[-2.5]", -3},
	{"SIN[0] MOD 5", 0}, {"ROUND[SIN[180]] MOD 5", 0}, {"[1 + COS[90]] MOD 5", 1}, {"COS[90] EQ 0", 1},
	{"ROUND[2.49]", 2}, {"FIX[10 * SIN[30]]", 5}, {"FUP[10 * COS[60]]", 5}, {"FIX[TAN[45]]", 1},
	/* functions, angles in degrees */
	{"SIN[90]", 1}, {"ACOS[0]", 90}, {"ASIN[-1]", -90}, {"ATAN[1]/[-1]", 135}, {"ATAN[-1]/[-1]", -135},
	{"ATAN[0]/[-1]", 180}, {"ABS[-4]", 4}, {"SQRT[16]", 4}, {"LN[EXP[2]]", 2}, {"EXP[0]", 1},
	/* comparisons */
	{"1 EQ 1.0000005", 1}, {"1 NE 1.0000005", 0}, {"1 EQ 1.0002", 0}, {"1 NE 1.0002", 1}, {"1 LE 1", 1},
	{"2 GE 3", 0}, {"3 GT 2", 1}, {"2 LT 2", 0},
	/* logic: whatever is not 0 is true */
	{"2 AND -1", 1}, {"0 OR 0.1", 1}, {"3 XOR 2", 0}, {"0 XOR 5", 1},
	/* signs, blanks, letter case */
	{"3 - -2", 5}, {"3---2", 1}, {"+[2]", 2}, {"- SIN[90]", -1}, {"s I n [ 9 0 ]", 1}, {"1 0 + 2 . 5", 12.5},
	/* parameters */
	{"#1", 2}, {"##1", 3}, {"#[#1 + 1]", 7.5}, {"###1", 7.5}, {"-#1", -2}, {"#1.99995", 3}, {"#100", 0},
	{"#<depth>", 4}, {"# < DE pth >", 4}, {"#<_all>", 5}, {"EXISTS[#<depth>]", 1}, {"EXISTS[#<width>]", 0},
	{"EXISTS[#<_x>]", 1}, {"EXISTS[#5601]", 1}, {"EXISTS[#5602]", 0}, {"#5599", 1},
};

START_TEST(expressions)
{
	for (size_t i = 0; i < COUNT(values); i++) {
		double value = value_of("#1=2 #2=3 #3=7.5 #<depth>=4 #<_all>=5", values[i].expression);

		ck_assert_msg(fabs(value - values[i].value) < 1e-9, "%s is %.12g", values[i].expression, value);
	}
}
END_TEST

/* Derived by hand from LinuxCNC's manual, "Predefined Named Parameters" and "Numbered Parameters". */
static const struct {
	const char *setting, *expression;
	double value;
} modes[] = {
	{"G20\nG0 Y2\n#1=#<_imperial> #2=#5421\nG21", "#1 * 10 + #2 + #5421", 62.8},
	{"G90", "#<_absolute> * 10 + #<_metric>", 11},
	{"G19", "#<_plane>", 190},
	{"G1 F120 Y1", "#<_motion_mode> + #<_feed>", 130},
	{"S500", "#<_rpm>", 500},
	{"G80", "#<_motion_mode>", 800},
	{"G57", "#<_coord_system> + #5220", 574},
	{"G59.3", "#<_coord_system> + #5220", 602},
	{"G90.1", "#<_ijk_absolute_mode>", 1},
	{"G95", "#<_units_per_rev> * 2 + #<_units_per_minute>", 2},
	{"M3", "#<_spindle_on> + #<_spindle_cw>", 2},
	{"M4", "#<_spindle_on> + #<_spindle_cw>", 1},
	{"", "#<_line>", 2},
	{"", "#<_ccomp> + #<_call_level>", 400},
	{"G10 L2 P1 Y5\nG0 X3 Y4 A30", "#5420 * 100 + #5421 * 10 + #5423", 370},
	{"G10 L2 P1 Y5\nG0 X3 Y4", "#<_abs_y> * 10 + #<_y>", 94},
	{"G10 L2 P2 X5 Y6", "#5241 * 10 + #5242", 56},
	{"#5242=7", "#5242", 7},
	{"G0 X8\nG28.1\nG0 X0", "#5161", 8},
	{"G92 Y-7\n#1=#5210", "#5212 + #1", 8},
	{"G92 Y-7\nG92.2\n#1=#5210", "#5212 + #1", 7},
	{"T3 M6\nT4", "#5400 * 10 + #<_selected_tool>", 34},
};

START_TEST(predefined)
{
	for (size_t i = 0; i < COUNT(modes); i++) {
		double value = value_of(modes[i].setting, modes[i].expression);

		ck_assert_msg(fabs(value - modes[i].value) < 1e-6, "%s: %s is %.12g", modes[i].setting,
			      modes[i].expression, value);
	}
}
END_TEST

/* The same on a machine in inches ("[TRAJ] LINEAR_UNITS"); tests/rs274 has them compared with rs274. */
START_TEST(parameters_of_an_inch_machine)
{
	struct gcode_case c;

	case_init(&c);
	c.config.controller.unit = 25.4;
	case_expect(&c, "G21 G10 L2 P2 X25.4 C30\nG0 X#5241 C#5246\n#5242=2 G55 G0 X0 Y0\nG28.1 G0 X0\nG0 Y#5162\nM2\n",
		    "rapid 1 0 0 0 30\nrapid 25.4 50.8 0 0 30\nrapid 25.4 50.8 0 0 30\nrapid 25.4 52.8 0 0 30\n");
	/* Before any G20 or G21, coordinates are in the unit of the control, too. */
	case_init(&c);
	c.config.controller.unit = 25.4;
	case_expect(&c, "G0 X1 C30\nG21 Y1\nM2\n", "rapid 25.4 0 0 0 30\nrapid 25.4 1 0 0 30\n");
}
END_TEST

START_TEST(assignments_wait)
{
	expect_moves("#3=15\n#3=6 G0 X#3\nY#3\n", "rapid 15 0 0 0 0\nrapid 15 6 0 0 0\n");
	expect_moves("#1=10 #2=#1\n#1=20 #2=#1 G0 X#2\nY#2\n", "rapid 0 0 0 0 0\nrapid 0 10 0 0 0\n");
	expect_moves("#1=2 #1=5\nG0 X#1\n", "rapid 5 0 0 0 0\n");
	/* A name exists from its assignment on. */
	expect_moves("#<n>=[#<n>+1]\nG0 X#<n>\n", "rapid 1 0 0 0 0\n");
	/* Offsets that are written take effect at the next selection. */
	expect_moves("#5241=3 G55 G0 X0\n", "rapid 3 0 0 0 0\n");
	expect_moves("#5181=4\nG30\n#5211=2\nG92.3\nG0 X1\n", "rapid 4 0 0 0 0\nrapid 3 0 0 0 0\n");
}
END_TEST

START_TEST(words_can_be_computed)
{
	expect_moves("#1=1\nG[#1-1] X5\nG#1 Y5 F[10*10]\nG[90+1] X1\n",
		     "rapid 5 0 0 0 0\nfeed 5 5 0 0 0\nfeed 6 5 0 0 0\n");
	expect_moves("G0 X-[1+2] Y--3 Z-#5421\n", "rapid -3 3 0 0 0\n");
	expect_moves("g 0 x s q r t [ 1 6 ] y a b s [ - 2 ]\n", "rapid 4 2 0 0 0\n");
}
END_TEST

struct bad {
	const char *program;
	int line, column;
	const char *message;
};

static const struct bad bad[] = {
	{"G0 X[1/0]\n", 1, 7, "division by zero"},
	{"G0 X[1 MOD 0]\n", 1, 8, "division by zero"},
	{"G0 X SQRT[-1]\n", 1, 6, "SQRT of -1: the value must not be negative"},
	{"G0 X LN[0]\n", 1, 6, "LN of 0: the value must be greater than 0"},
	{"G0 X ACOS[1.1]\n", 1, 6, "ACOS of 1.1: the value must be from -1 to 1"},
	{"G0 X ASIN[-2]\n", 1, 6, "ASIN of -2: the value must be from -1 to 1"},
	{"G0 X ROUND[3000000000]\n", 1, 6, "ROUND of 3000000000: LinuxCNC rounds only numbers below 2^31"},
	{"G0 X[[-2]**0.5]\n", 1, 10, "a negative number has only whole powers"},
	{"G0 X EXP[1000]\n", 1, 6, "the result is infinite"},
	{"G0 X[1+2\n", 1, 9, "this expression is not closed: ']' is missing"},
	{"G0 X[1 ? 2]\n", 1, 8, "an operator or ']' is missing here"},
	{"G0 X[1 (one) + 2]\n", 1, 8, "an operator or ']' is missing here"},
	{"G0 X[]\n", 1, 6, "a value is needed here"},
	{"G0 X[1+]\n", 1, 8, "a value is needed here"},
	{"G0 X ATAN[1]\n", 1, 13, "'/' is missing after ATAN[...]"},
	{"G0 X ATAN[1]/2\n", 1, 14, "ATAN[...]/ needs a value in brackets, [...]"},
	{"G0 X SIN 30\n", 1, 10, "the function needs a value in brackets, [...]"},
	{"G0 X[COS[90] MOD 50]\n", 1, 14,
	 "the rounding error of a sine, cosine or tangent decides whether this number is 0; round it, or compare with "
	 "a margin"},
	{"G0 X[SIN[180] LT 0]\n", 1, 15,
	 "the rounding error of a sine, cosine or tangent decides whether this number is 0; round it, or compare with "
	 "a margin"},
	{"G0 X[0 GE SIN[180]]\n", 1, 8,
	 "the rounding error of a sine, cosine or tangent decides whether this number is 0; round it, or compare with "
	 "a margin"},
	{"G0 X[TAN[180] OR 0]\n", 1, 15,
	 "the rounding error of a sine, cosine or tangent decides whether this number is 0; round it, or compare with "
	 "a margin"},
	{"G0 X FIX[SIN[360]]\n", 1, 6,
	 "the rounding error of a sine, cosine or tangent decides whether this number is 0; round it, or compare with "
	 "a margin"},
	{"G0 X FUP[2*COS[270]]\n", 1, 6,
	 "the rounding error of a sine, cosine or tangent decides whether this number is 0; round it, or compare with "
	 "a margin"},
	{"G0 X[1/COS[90]]\n", 1, 7,
	 "the rounding error of a sine, cosine or tangent decides whether this number is 0; round it, or compare with "
	 "a margin"},
	{"G0 X ATAN[SIN[180]]/[-1]\n", 1, 6,
	 "the rounding error of a sine, cosine or tangent decides whether this number is 0; round it, or compare with "
	 "a margin"},
	{"G0 X SQRT[COS[90]]\n", 1, 6,
	 "the rounding error of a sine, cosine or tangent decides whether this number is 0; round it, or compare with "
	 "a margin"},
	{"#1=COS[90]\no1 if [#1]\no1 endif\n", 2, 1,
	 "the rounding error of a sine, cosine or tangent decides whether this number is 0; round it, or compare with "
	 "a margin"},
	{"G0 X[1 LE 0.9999995]\n", 1, 8,
	 "LE of numbers that differ by only 5e-07: versions of LinuxCNC disagree; compare with a margin"},
	{"G0 X[1 EQ 1.000002]\n", 1, 8,
	 "EQ of numbers that differ by only 2e-06: versions of LinuxCNC disagree; compare with a margin"},
	{"G0 X#5602\n", 1, 6, "#5602: parameters are numbered from 1 to 5601"},
	{"G0 X#0\n", 1, 6, "#0: parameters are numbered from 1 to 5601"},
	{"G0 X#1.5\n", 1, 6, "a whole number is needed, not 1.5"},
	{"G0 X#[10**300]\n", 1, 6, "1e+300 is too large here"},
	{"G0 X#<nothing>\n", 1, 5, "there is no parameter #<nothing>"},
	{"G0 X#<open\n", 1, 6, "this parameter name is not closed: '>' is missing"},
	{"#1 5\n", 1, 5, "'=' is missing after the parameter"},
	{"#1=\n", 1, 4, "a value is needed here"},
	{"#5400=1\n", 1, 1, "#5400 is read-only"},
	{"#5420=1\n", 1, 1, "#5420 is read-only"},
	{"#<_x>=1\n", 1, 1, "#<_x> is read-only"},
	{"G0 X#5063\n", 1, 5, "#5063 (a probed position) is not known before the program runs"},
	{"#1=#5399\n", 1, 4, "#5399 (an input that M66 has read) is not known before the program runs"},
	{"#1=#5601\n", 1, 4, "#5601 (a report of the tool changer) is not known before the program runs"},
	{"#1=#5021\n", 1, 4, "the value of #5021 depends on the version of LinuxCNC"},
	{"#1=#<_task>\n", 1, 4,
	 "#<_task> depends on the state of the machine, which is not known before the program runs"},
	{"#1=#<_ini[axis_x]home>\n", 1, 4,
	 "#<_ini[axis_x]home> is set in the machine's INI file, which fivecheck does not read"},
	{"#1=#<_hal[a.b]>\n", 1, 4,
	 "#<_hal[a.b]> depends on the state of the machine, which is not known before the program runs"},
	{"G93 G1 X1 F1\n#1=#<_feed>\n", 2, 4, "#<_feed> is undefined in inverse time mode (G93)"},
	{"#5221=1\n", 1, 1,
	 "#5221 belongs to G54, which is active: LinuxCNC uses the new value only when G54 is selected again; use G10 "
	 "L2 P1"},
	{"#5250=1\n", 1, 1, "#5250: rotation of a coordinate system is not supported"},
	{"#5220=2\n", 1, 1, "#5220 does not select a coordinate system; use G54 to G59.3"},
	{"#5210=1\n", 1, 1, "#5210 does not apply the shift; use G92.2 and G92.3"},
	{"T5 M6\nG0 X#5403\n", 2, 5, "#5403: the setup does not define the tool in the spindle, T5"},
};

static void expect_bad(const struct bad *row)
{
	struct gcode_case c;

	case_init(&c);
	case_refuses_at(&c, row->program, row->line, row->column, row->message);
}

START_TEST(faults)
{
	for (size_t i = 0; i < COUNT(bad); i++)
		expect_bad(&bad[i]);
}
END_TEST

/* Deep nesting and long lines must do no harm. */
START_TEST(depth_is_bounded)
{
	static const char *const pieces[] = {"[", "-[", "#", "SIN[", "[1+"};

	for (size_t i = 0; i < COUNT(pieces); i++) {
		struct strbuf program = {0};
		struct gcode_case c;

		case_init(&c);
		strbuf_addf(&program, "G0 X");
		for (int k = 0; k < 10000; k++)
			strbuf_addf(&program, "%s", pieces[i]);
		ck_assert(!case_run(&c, program.text));
		ck_assert_msg(strstr(c.messages.text, "values are nested deeper than 256 levels"), "%.200s",
			      c.messages.text);
		strbuf_release(&program);
		case_release(&c);
	}
}
END_TEST

START_TEST(comments_say_nothing)
{
	expect_moves("#1=3\n(DEBUG, #1 #<nothing>)\n(PRINT,#9)\n(MSG, x)\n(LOG, y)\nG0 X#1\n", "rapid 3 0 0 0 0\n");
}
END_TEST

int main(void)
{
	const TTest *const tests[] = {expressions, predefined, parameters_of_an_inch_machine, assignments_wait,
				     words_can_be_computed, faults, depth_is_bounded, comments_say_nothing};

	return RUN_TESTS("gcode_expr", tests);
}
