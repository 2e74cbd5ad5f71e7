/* test_gcode_sinumerik_expr.c - expressions of the sinumerik dialect. */
#include "sinumerik_case.h"

struct value {
	const char *expression;
	double value;
};

/* 840D sl, job planning: operators, their ranks, functions. R1 is 5 and R2 is 1. */
static const struct value values[] = {
	{"1+1-1+-1", 0},
	{"2*3+4*5", 26},
	{"(2+3)*4", 20},
	{"7 DIV 2", 3},
	{"-7 DIV 2", -3},
	{"7 DIV 0.4", 17},
	{"7 MOD 4", 3},
	{"7 MOD 4.1", 2.9},
	{"-7 MOD 4", -3},
	{"7/2", 3.5},
	{"5-3-1", 1},
	{"-(-3)", 3},
	{"--3", 3},
	{"2-(-3)", 5},
	{"SIN(30)", 0.5},
	{"COS(60)", 0.5},
	{"TAN(45)", 1},
	{"ASIN(1)", 90},
	{"ACOS(0)", 90},
	{"ATAN2(1,1)", 45},
	{"ATAN2(30.5,80.1)", 20.8455339},
	{"SQRT(16)", 4},
	{"POT(3)", 9},
	{"ABS(-2.5)", 2.5},
	{"TRUNC(-2.7)", -2},
	{"ROUND(2.5)", 3},
	{"ROUND(-2.5)", -3},
	{"ROUNDUP(1.1)", 2},
	{"LN(1)", 0},
	{"EXP(0)", 1},
	{"MINVAL(1,2)", 1},
	{"MAXVAL(1,2)", 2},
	{"BOUND(0,5,9)", 5},
	{"BOUND(0,5,-1)", 0},
	{"NOT 0", 1},
	{"NOT(1==1)", 0},
	{"NOT 2==2", 0},
	{"B_NOT 5", -6},
	{"6 B_AND 3", 2},
	{"6 B_OR 3", 7},
	{"6 B_XOR 3", 5},
	{"1 AND 0", 0},
	{"1 OR 0", 1},
	{"1 XOR 1", 0},
	{"1 XOR 0", 1},
	{"1+1==2", 1},
	{"2>=2", 1},
	{"2<=1", 0},
	{"1<>2", 1},
	{"1==1+0.0000000000001", 1},
	{"(1<2) AND 3", 1},
	{"1<(2 AND 3)", 0},
	{"1==1 AND 1==1", 1},
	{"1 AND (2>1) AND 3", 1},
	{"TRUE+TRUE", 2},
	{"FALSE", 0},
	{"PI", 3.14159265},
	{"R1+R[2]", 6},
	{"R[R[2]]", 5},
	{"R1*R2-1", 4},
	{"5 div 2", 2},
	{"sin(90)", 1},
	{"+4", 4},
	{"STRLEN(\"\")", 0},
	{"STRLEN(\"AB\"<<12)", 4},
	/* Arithmetic comes before <<, and << before comparisons. */
	{"STRLEN(\"A\"<<R1+7<<\"B\")", 4},
	{"\"A\"<<2*R1+R2<<\"B\"==\"A11B\"", 1},
	{"\"A\"<<(R1-7)<<\"B\"<>\"A-2B\"", 0},
	{"GETT(\"drill\",1)", 2},
	{"10*GETT(\"MILL\"<<10)+1", 11},
	{"INDEX(\"workpiece\",\"e\")", 6},
	{"RINDEX(\"workpiece\",\"e\")", 8},
	{"MINDEX(\"workpiece\",\"kp\")", 3},
	{"INDEX(\"workpiece\",\"x\")", -1},
	{"NUMBER(\"-12.5\")+1", -11.5},
	{"NUMBER(SUBSTR(\"T15.7\",1))", 15.7},
	{"ISNUMBER(\"12\")", 1},
	{"ISNUMBER(\"A\")", 0},
	{"TOUPPER(\"aB1\")==\"AB1\"", 1},
	{"TOLOWER(\"aB1\")==\"ab1\"", 1},
	{"SUBSTR(\"QUERY\",1,3)==\"UER\"", 1},
	{"SUBSTR(\"QUERY\",4,3)==\"Y\"", 1},
	{"\"UER\"==TOUPPER(SUBSTR(\"query\",R2,3))", 1},
	{".5+1.", 1.5},
	{"1.5EX2+2ex-1+'H1f'+'b101'", 186.2},
	{"$P_TOOLNO", 0},
	{"$P_TOOLR+$P_TOOLL[1]", 0},
	{"$P_UIFR[1,Y,TR]+$P_UIFR[5,X,TR]+$P_UIFR[1,Z,SC]+$P_UIFR[1,Z,RT]", 22},
	{"$P_SEARCH", 0},
	{"$AA_IW[X]", 7},
	{"$AA_IM[Z]", 3},
	{"$P_EP[Y]", 2},
};

START_TEST(expressions)
{
	struct strbuf program = {0};
	struct gcode_case c;
	double x = NAN;

	sinumerik_case_init(&c);
	strbuf_addf(&program, "G500 F1 R1=5 R2=1\nX7 Y2 Z3\nX=%s Y8\n", values[_i].expression);
	ck_assert_msg(case_run(&c, strbuf_text(&program)), "%s", strbuf_text(&c.messages));
	ck_assert_int_eq(sscanf(strrchr(strbuf_text(&c.moves), 'f'), "feed %lf", &x), 1);
	ck_assert_double_eq_tol(x, values[_i].value, 1e-8);
	strbuf_release(&program);
	case_release(&c);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("programs");

	tcase_add_loop_test(tcase, expressions, 0, COUNT(values));
	return run_suite("gcode_sinumerik_expr", tcase);
}
