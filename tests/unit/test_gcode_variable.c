/*
 * test_gcode_variable.c - variables that a control keeps from one program to the next and whose values the machine file
 * gives: common variables of Fanuc and Haas; GUD, R parameters and system variables of Sinumerik; parameters and tables
 * of Heidenhain. The expected positions are computed by hand from the values.
 */
#include "gcode_case.h"

#include "control/control_variable.h"

#define VARIABLES 4
#define REAL_OF(given, its) {.name = given, .typed = true, .type = its}
#define VALUE(given, value) {.name = given, .text = #value, .number = value}
#define TEXT(given, value) {.name = given, .text = value, .number = NAN}

static const struct tool tools[] = {{.number = 3, .name = "MILL", .length = 50, .length_offset = 50, .diameter = 8}};
static const struct work_offset presets[] = {{.name = "G54.1 P1"}};

struct kept {
	const struct dialect *dialect;
	struct control_variable variables[VARIABLES];
	const char *program;
	const char *outcome;	/* the end of the last rapid, or the message */
};

#define KLARTEXT(blocks) "BEGIN PGM T MM\n" blocks "END PGM T MM\n"

static const struct kept accepted[] = {
	/* Fanuc, Haas: 5 + 2 */
	{&dialect_fanuc, {VALUE("#500", 5), VALUE("#100", 2)}, "G90 G21 G17\nG0 X[#500+#100]\n", "7 0 0"},
	{&dialect_haas, {VALUE("#500", 5), VALUE("#100", 2)}, "G90 G21 G17\nG0 X[#10500+#100]\n", "7 0 0"},
	/* #0 is vacant, and so is #500 by the file: the jump is taken */
	{&dialect_fanuc, {TEXT("#500", "vacant")}, "G90 G21 G17\nIF [#500 EQ #0] GOTO 10\nG0 X1.\nN10 G0 Y2.\n", "0 2 0"},
	{&dialect_fanuc, {VALUE("#500", 0)}, "G90 G21 G17\nIF [#500 EQ #0] GOTO 10\nG0 X1.\nN10 G0 Y2.\n", "1 2 0"},
	/* a value that the program assigns is valid from the assignment on */
	{&dialect_fanuc, {VALUE("#500", 5)}, "G90 G21 G17\n#1=#500\n#500=9\nG0 X#1 Y#500\n", "5 9 0"},
	{&dialect_fanuc, {VALUE("#1005", 1), VALUE("#8000", 3)}, "G90 G21 G17\nG0 X#1005 Y#8000\n", "1 3 0"},
	/* the radius of tool 3 in the control's table of offsets */
	{&dialect_fanuc, {VALUE("#2403", 4), VALUE("#13003", 4.5)}, "G90 G21 G17\n#1=3\nG0 X[10-#[2400+#1]] Y#13003\n",
	 "6 4.5 0"},
	{&dialect_haas, {VALUE("#2403", 4)}, "G90 G21 G17\n#1=3\nG0 X[10-#[2400+#1]]\n", "6 0 0"},
	/* Sinumerik */
	{&dialect_sinumerik, {VALUE("R5", 3), VALUE("R12", 4)}, "G500\nG0 X=R5 Y=R[R5*4]\n", "3 4 0"},
	{&dialect_sinumerik, {{.name = "_POS", .typed = true, .dimensions = 2, .size = {3, 2}}, VALUE("_POS[2,1]", 6)},
	 "G500\n_POS[0,0]=_POS[2,1]+1\nG0 X=_POS[2,1] Y=_POS[0,0]\n", "6 7 0"},
	/* the value of an array is the value of each of its elements */
	{&dialect_sinumerik, {{.name = "_POS", .typed = true, .dimensions = 1, .size = {4}, .text = "2", .number = 2},
			      VALUE("_POS[3]", 9)},
	 "G500\nG0 X=_POS[0] Y=_POS[3] Z=_POS[2]\n", "2 9 2"},
	/* an element without a value in the file gets one from the program, even if the array has none */
	{&dialect_sinumerik, {{.name = "_POS", .typed = true, .dimensions = 1, .size = {4}, .text = "2", .number = 2},
			      {.name = "_POS[3]"}},
	 "G500\n_POS[3]=1\nG0 X=_POS[0] Y=_POS[3]\n", "2 1 0"},
	/* INT rounds an assigned value, REAL does not */
	{&dialect_sinumerik, {{.name = "WHOLE", .typed = true, .type = CONTROL_INT}, REAL_OF("PART", CONTROL_REAL)},
	 "G500\nWHOLE=2.5\nPART=2.5\nG0 X=WHOLE Y=PART\n", "3 2.5 0"},
	{&dialect_sinumerik, {{.name = "DOOR", .typed = true, .type = CONTROL_BOOL, .text = "TRUE", .number = 1}},
	 "G500\nIF DOOR\nG0 X5\nENDIF\nIF NOT DOOR\nG0 Y5\nENDIF\n", "5 0 0"},
	{&dialect_sinumerik, {{.name = "NAME", .typed = true, .type = CONTROL_STRING, .text = "AB", .number = NAN}},
	 "G500\nIF NAME<<\"C\"==\"ABC\"\nG0 X5\nENDIF\n", "5 0 0"},
	/* a variable that FOR counts needs no value before */
	{&dialect_sinumerik, {REAL_OF("COUNT_", CONTROL_INT)}, "G500\nFOR COUNT_=1 TO 3\nG0 X=COUNT_\nENDFOR\n", "3 0 0"},
	/* DEF defines another variable of this name, which belongs to the program */
	{&dialect_sinumerik, {{.name = "SAME", .typed = true, .text = "8", .number = 8}},
	 "G500\nG0 Y=SAME\nDEF REAL SAME\nSAME=1\nG0 X=SAME\n", "1 8 0"},
	{&dialect_sinumerik, {{.name = "MOVED", .typed = true, .type = CONTROL_AXIS, .text = "Y", .number = NAN}},
	 "G500\n$P_PFRAME=CTRANS(MOVED,3)\nG0 X1 Y1\n", "1 4 0"},
	{&dialect_sinumerik, {VALUE("$MN_DATA", 4), VALUE("$A_DBB[2]", 5), VALUE("$MA_POS[1,Y]", 6)},
	 "G500\nR1=1\nG0 X=$MN_DATA Y=$A_DBB[R1+1] Z=$MA_POS[R1, Y]\n", "4 5 6"},
	/* Heidenhain: a Q parameter of the file, and the tool table for the tool of TOOL CALL */
	{&dialect_klartext, {VALUE("Q1600", 4), VALUE("QR3", 5)}, KLARTEXT("L X+Q1600 Y+QR3 FMAX\n"), "4 5 0"},
	{&dialect_klartext, {VALUE("Q5", 4)}, KLARTEXT("Q6 = Q5 + 1\nQ5 = 9\nL X+Q6 Y+Q5 FMAX\n"), "5 9 0"},
	{&dialect_klartext, {VALUE("ID50NR3IDX3", 1.5)},
	 KLARTEXT("TOOL CALL 3 Z S100\nFN 18: SYSREAD Q1 = ID50 NR3\nFN 18: SYSREAD Q2 = ID50 NR3 IDX3\n"
		  "L X+Q1 Y+Q2 FMAX\n"), "1.5 1.5 0"},
	/* TOOL CALL gives the value, so the file need not */
	{&dialect_klartext, {{0}},
	 KLARTEXT("TOOL CALL 3 Z S100 DL+0.5 DR-0.25\nFN 18: SYSREAD Q1 = ID60 NR1\nFN 18: SYSREAD Q2 = ID60 NR4\n"
		  "FN 18: SYSREAD Q3 = ID60 NR5\nL X+Q1 Y+Q2 FMAX\nL X+Q3 FMAX\n"), "-0.25 0.5 0"},
};

#define ASKS(name) "set <variable name=\"" name "\" value=\"\"/> in the machine file's <controller>"

static const struct kept refused[] = {
	{&dialect_fanuc, {VALUE("#2403", 4)}, "G90 G21 G17\nG10 L10 P3 R5.\nG0 X#2403\n",
	 "#2403, a tool offset of the control's table, cannot be read here after G10 L10 to L13 has changed the table"},
	/* a position that the program changes: the file must not give it */
	{&dialect_fanuc, {VALUE("#5021", 1)}, "G90 G21 G17\nG0 X#5021\n",
	 "#5021 (the position of the machine during read-ahead (#5001 has the programmed position)) is not known "
	 "before the program runs"},
	{&dialect_fanuc, {TEXT("#500", "five")}, "G90 G21 G17\nG0 X#500\n",
	 "#500: the value=\"five\" of its <variable> must be a number or \"vacant\""},
	{&dialect_haas, {VALUE("#501", 1)}, "G90 G21 G17\nG0 X#500\n",
	 "#500 keeps its value from earlier programs, and this program has not set it: "
	 "set <variable name=\"#500\" value=\"\"/> in the machine file's <controller>"},
	{&dialect_sinumerik, {{.name = "_POS", .typed = true, .dimensions = 2, .size = {3, 2}}}, "G500\nG0 X=_POS[2,1]\n",
	 "_POS[2,1] keeps its value from one program to the next, and this program has not set it: "
	 ASKS("_POS[2,1]")},
	{&dialect_sinumerik, {REAL_OF("NAME", CONTROL_STRING)}, "G500\nMSG(NAME)\nIF NAME==\"A\"\nENDIF\n",
	 "NAME keeps its value from one program to the next, and this program has not set it: "
	 ASKS("NAME")},
	{&dialect_sinumerik, {{.name = "_POS", .typed = true, .dimensions = 1, .size = {3}}, VALUE("_POS[3]", 1)}, "G500\n",
	 "<variable name=\"_POS[3]\"> is no element of that array"},
	/* two spellings of one name would give it two values */
	{&dialect_sinumerik, {{.name = "_POS", .typed = true, .dimensions = 1, .size = {3}}, VALUE("_POS[01]", 1)}, "G500\n",
	 "<variable name=\"_POS[01]\"> is no element of that array"},
	{&dialect_sinumerik, {{.name = "_POS", .typed = true, .dimensions = 1, .size = {3}}, VALUE("_POS[+1]", 1)}, "G500\n",
	 "<variable name=\"_POS[+1]\"> is no element of that array"},
	{&dialect_sinumerik, {VALUE("R05", 1)}, "G500\n",
	 "<variable name=\"R05\">: write it without leading zeros"},
	{&dialect_sinumerik, {TEXT("R5", "1,5")}, "G500\n", "R5: the value of its <variable> is no number"},
	{&dialect_klartext, {VALUE("Q1", 1), VALUE("Q01", 2)}, KLARTEXT("L X+1 FMAX\n"),
	 "<variable name=\"Q01\"> is no parameter that is kept: Q, QR or QS and its number, or data "
	 "of FN 18, such as ID50 NR3 IDX1"},
	{&dialect_klartext, {VALUE("ID50NR3IDX01", 1)}, KLARTEXT("L X+1 FMAX\n"),
	 "<variable name=\"ID50NR3IDX01\"> is no data of a table that FN 18 reads (ID 50, 51, 52, "
	 "230, 350), such as ID50 NR3 IDX1"},
	{&dialect_fanuc, {VALUE("#5001", 1)}, "G90 G21 G17\nG0 X#5001\n",
	 "<variable name=\"#5001\"> is not allowed: the program and the setup determine this variable"},
	{&dialect_fanuc, {VALUE("#5221", 1)}, "G90 G21 G17\nG0 X#5221\n",
	 "<variable name=\"#5221\"> is not allowed: the program and the setup determine this variable"},
	{&dialect_fanuc, {VALUE("#4001", 1)}, "G90 G21 G17\nG0 X#4001\n",
	 "<variable name=\"#4001\"> is not allowed: the program and the setup determine this variable"},
	{&dialect_sinumerik, {VALUE("_POS[3]", 1)}, "G500\n",
	 "<variable name=\"_POS[3]\">: its type is missing, type=\"REAL\" and the like"},
	{&dialect_sinumerik, {REAL_OF("SIN", CONTROL_REAL)}, "G500\n",
	 "<variable name=\"SIN\" type=\"\">: a variable has a name of two letters or more, _ and "
	 "digits, at most 32, which means nothing else; size=\"\" says how many elements it has"},
	{&dialect_sinumerik, {{.name = "AX_", .typed = true, .type = CONTROL_AXIS, .text = "Y", .number = NAN}},
	 "G500\nG0 X=AX_\n", "AX_ is the name of an axis and no number"},
	{&dialect_sinumerik, {{.name = "AX_", .typed = true, .type = CONTROL_AXIS, .text = "W", .number = NAN}}, "G500\n",
	 "AX_: the value of its <variable> is no axis of the machine"},
	{&dialect_sinumerik, {VALUE("$P_GG[1]", 1)}, "G500\nG0 X=$P_GG[1]\n",
	 "<variable name=\"$P_GG[1]\">: the offsets and tools of the setup, or the program, determine its value"},
	{&dialect_sinumerik, {VALUE("$P_UIFR[1,X,TR]", 10)}, "G500\n",
	 "<variable name=\"$P_UIFR[1,X,TR]\">: the offsets and tools of the setup, or the program, determine its value"},
	{&dialect_sinumerik, {VALUE("$TC_DP3[1,1]", 10)}, "G500\n",
	 "<variable name=\"$TC_DP3[1,1]\">: the offsets and tools of the setup, or the program, determine its value"},
	/* the program itself may have written this variable */
	{&dialect_sinumerik, {VALUE("$AC_MARKER[1]", 1)}, "G500\n$AC_MARKER[1]=2\nG0 X=$AC_MARKER[1]\n",
	 "<variable name=\"$AC_MARKER[1]\">: the offsets and tools of the setup, or the program, determine its value"},
	{&dialect_klartext, {VALUE("ID270NR1IDX1", 1)}, KLARTEXT("L X+1 FMAX\n"),
	 "<variable name=\"ID270NR1IDX1\"> is no data of a table that FN 18 reads (ID 50, 51, 52, "
	 "230, 350), such as ID50 NR3 IDX1"},
	{&dialect_klartext, {{0}}, KLARTEXT("FN 18: SYSREAD Q1 = ID270 NR1 IDX1\nL X+Q1 FMAX\n"),
	 "Q1 was read from the control (FN 18, ID270 NR1 IDX1), and that value is not known here: to check the program, "
	 "assign the value by FN 0 behind it, or write FN 20: WAIT FOR SYNC before it"},
	{&dialect_klartext, {VALUE("Q5", 1)}, KLARTEXT("L X+QL5 FMAX\n"),
	 "QL5 has no value: the program has not assigned one"},
	{&dialect_klartext, {VALUE("QL5", 1)}, KLARTEXT("L X+1 FMAX\n"),
	 "<variable name=\"QL5\"> is no parameter that is kept: Q, QR or QS and its number, or data "
	 "of FN 18, such as ID50 NR3 IDX1"},
	{&dialect_klartext, {TEXT("Q5", "five")}, KLARTEXT("L X+1 FMAX\n"),
	 "Q5: the value of its <variable> is no number"},
	/* the control itself changes this parameter */
	{&dialect_klartext, {VALUE("Q111", 1)}, KLARTEXT("L X+1 FMAX\n"),
	 "<variable name=\"Q111\">: the control itself changes this parameter while the program runs"},
};

static void init(struct gcode_case *c, const struct kept *kept)
{
	case_init(c);
	c->config.dialect = kept->dialect;
	c->config.has_setup = true;
	c->config.tools = tools;
	c->config.tool_count = COUNT(tools);
	c->config.work_offsets = presets;
	c->config.work_offset_count = kept->dialect == &dialect_klartext;
	c->config.controller.tool_change.given = true;
	c->config.controller.variables = kept->variables;
	while (c->config.controller.variable_count < VARIABLES &&
	       kept->variables[c->config.controller.variable_count].name)
		c->config.controller.variable_count++;
}

/* The position of X, Y and Z after the program, without the tool length. */
START_TEST(values)
{
	const struct kept *kept = &accepted[_i];
	double x = 0, y = 0, z = 0;
	struct strbuf place = {0};
	const char *last = NULL;
	struct gcode_case c;
	bool good;

	init(&c, kept);
	good = case_run(&c, kept->program);
	ck_assert_msg(good, "%s%s", kept->program, strbuf_text(&c.messages));
	for (const char *at = strstr(strbuf_text(&c.moves), "rapid"); at; at = strstr(at + 1, "rapid"))
		last = at;
	ck_assert_ptr_nonnull(last);
	ck_assert_int_eq(sscanf(last, "rapid %lf %lf %lf", &x, &y, &z), 3);
	strbuf_addf(&place, "%.9g %.9g %.9g", x, y, strstr(kept->program, "TOOL CALL") ? 0 : z);
	ck_assert_str_eq(strbuf_text(&place), kept->outcome);
	strbuf_release(&place);
	case_release(&c);
}
END_TEST

START_TEST(faults)
{
	const struct kept *kept = &refused[_i];
	struct strbuf words = {0};
	struct gcode_case c;

	init(&c, kept);
	strbuf_addf(&words, ": error: %s\n", kept->outcome);
	ck_assert_msg(!case_run(&c, kept->program), "%s passes", kept->program);
	ck_assert_msg(strstr(strbuf_text(&c.messages), strbuf_text(&words)), "%s%s", kept->program,
		      strbuf_text(&c.messages));
	ck_assert_uint_eq(c.diag.errors, 1);
	strbuf_release(&words);
	case_release(&c);
}
END_TEST

START_TEST(names)
{
	char name[CONTROL_VARIABLE_NAME], longest[CONTROL_VARIABLE_NAME + 1];

	ck_assert(control_variable_name_normalise(" id220\tnr2 IDX3 ", name));
	ck_assert_str_eq(name, "ID220NR2IDX3");
	ck_assert(!control_variable_name_normalise(" \t", name));
	memset(longest, 'a', sizeof(longest));
	longest[CONTROL_VARIABLE_NAME] = '\0';
	ck_assert(!control_variable_name_normalise(longest, name));
	ck_assert_str_eq(name, "ID220NR2IDX3");
	longest[CONTROL_VARIABLE_NAME - 1] = '\0';
	ck_assert(control_variable_name_normalise(longest, name));
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("gcode_variable");

	tcase_add_loop_test(tcase, values, 0, COUNT(accepted));
	tcase_add_loop_test(tcase, faults, 0, COUNT(refused));
	tcase_add_test(tcase, names);
	return run_suite("gcode_variable", tcase);
}
