/*
 * test_gcode_sinumerik_contour.c - CYCLE62 and CYCLE72: the moves and what lies beside them hold the path that the
 * control may take, by closed forms: beside the contour, on its leads, up to the retraction plane; and little more.
 */
#include "sinumerik_refused.h"

#include <math.h>

#include "base/math/math_functions.h"
#include "base/units.h"

/* T1 D1 has a radius of 5 and is 100 long. The contour runs up, round a corner, and on an arc; G41 keeps the tool outside of it. */
#define HEAD "G500 G17 T1 D1 M6 F6 G450\nG0 X-30 Y-40 Z60\n"
#define CONTOUR "G0 X0 Y0\nG1 Y40 RND=6\nX50\nY20\nG3 X30 Y0 I0 J-20\nG1 X0\n"
#define CYCLE(name, variant, lead, radius) \
	"CYCLE72(\"" name "\",50,0,2,-10,3,0.2,0.1,300,100," variant ",41," lead "," radius ",200," lead "," radius ",0,0,0,1,0,101)\n"

struct covered {
	vec3 from, to;
	double beside;
};

static struct covered moves[40000];
static size_t move_count;

/* "feed 1 2 3 0 0 spread 4 5 6" */
static void read_moves(const char *text)
{
	vec3 at = {0, 0, 0};

	move_count = 0;
	for (const char *line = text; *line; line = strchr(line, '\n') + 1) {
		double a, c, x = 0, y = 0, z = 0;
		char kind[16];
		vec3 to;

		if (sscanf(line, "%15s %lf %lf %lf %lf %lf spread %lf %lf %lf", kind, &to.x, &to.y, &to.z, &a, &c, &x, &y,
			   &z) < 6)
			continue;
		ck_assert_uint_lt(move_count, COUNT(moves));
		moves[move_count++] = (struct covered){at, to, sqrt(x * x + y * y + z * z)};
		at = to;
	}
}

/* The distance of a point of the workpiece from everything that is covered. */
static double outside(vec3 place)
{
	const vec3 p = {place.x, place.y, place.z + 100};
	double least = INFINITY;

	for (size_t i = 0; i < move_count; i++) {
		const vec3 way = vec3_sub(moves[i].to, moves[i].from), there = vec3_sub(p, moves[i].from);
		const double whole = vec3_norm2(way);
		const double share = whole > 0 ? fmin(1, fmax(0, vec3_dot(there, way) / whole)) : 0;

		least = fmin(least, vec3_norm(vec3_mad(there, -share, way)) - moves[i].beside);
	}
	return least;
}

static void holds(double x, double y)
{
	for (double z = -10; z <= 2; z += 4)
		ck_assert_msg(outside((vec3){x, y, z}) <= 1e-9, "%g %g %g is outside by %g", x, y, z,
			      outside((vec3){x, y, z}));
}

/* The tool's centre beside the contour, by the allowance farther than its radius. */
static void holds_path(double off)
{
	for (int i = 0; i <= 34; i += 2)
		holds(-off, i);
	for (int i = 0; i <= 10; i++) {
		const double angle = PI - i * PI / 20;

		holds(6 + (6 + off) * math_cos(angle), 34 + (6 + off) * math_sin(angle));
	}
	for (int i = 6; i <= 50; i += 4)
		holds(i, 40 + off);
	for (int i = 0; i <= 10; i++)
		holds(50 + off * math_cos(PI / 2 - i * PI / 20), 40 + off * math_sin(PI / 2 - i * PI / 20));
	for (int i = 20; i <= 40; i += 2)
		holds(50 + off, i);
	for (int i = 0; i <= 10; i++)
		holds(50 + (20 - off) * math_cos(PI / 2 + i * PI / 20), (20 - off) * math_sin(PI / 2 + i * PI / 20));
	for (int i = 0; i <= 30; i += 3)
		holds(i, -off);
}

/* On a half circle to the first point, from where the tool comes straight down. */
static void holds_lead(double off, double radius)
{
	for (int i = 0; i <= 10; i++)
		holds(-off - radius + radius * math_cos(i * PI / 10), -radius * math_sin(i * PI / 10));
	for (double z = 2; z <= 50; z += 8)
		ck_assert(outside((vec3){-off - 2 * radius, 0, z}) <= 1e-9);
}

static void mill(struct gcode_case *c, const char *program)
{
	sinumerik_case_init(c);
	c->show_spread = true;
	ck_assert_msg(case_run(c, program), "%s", strbuf_text(&c->messages));
	read_moves(strbuf_text(&c->moves));
}

START_TEST(covers)
{
	static const char *const programs[] = {
		HEAD CYCLE("KON", "1", "3", "7") "M30\n%_N_KON_SPF\n" CONTOUR "M17\n",
		HEAD "CYCLE62(\"KON\",0,,)\n" CYCLE("", "1", "3", "7") "M30\n%_N_KON_SPF\n" CONTOUR "M17\n",
		HEAD CYCLE("A1:A2", "1", "3", "7") "M30\nA1:\n" CONTOUR "A2:\n",
		HEAD "CYCLE62(,2,\"A1\",\"A2\")\n" CYCLE("", "1", "3", "7") "M30\nA1:\n" CONTOUR "A2:\n",
		HEAD "CYCLE62(\"K1\",1,,)\n" CYCLE("", "1", "3", "7") "M30\nE_LAB_A_K1: ;#SM Z:2\nG17 G90 DIAMOF\n" CONTOUR
		     "E_LAB_E_K1:\n",
	};
	struct strbuf first = {0};

	for (size_t i = 0; i < COUNT(programs); i++) {
		struct gcode_case c;

		mill(&c, programs[i]);
		if (i == 0) {
			holds_path(5.2);
			holds_lead(5.2, 7);
			/* Whether the cycle draws corners out is not said: where the lines beside both sides cross. */
			holds(55.2, 45.2);
			/* No more is covered: nothing below the depth, and nothing far in the middle. */
			ck_assert(outside((vec3){75, 30, -5}) > 0.5);
			ck_assert(outside((vec3){25, 40, -14}) > 1);
			ck_assert(outside((vec3){90, 20, -5}) > 1);
			strbuf_addf(&first, "%s", strbuf_text(&c.moves));
		}
		/* The moves do not depend on how the contour is named. */
		ck_assert_str_eq(strbuf_text(&c.moves), strbuf_text(&first));
		case_release(&c);
	}
	strbuf_release(&first);
}
END_TEST

/* After the cycle the tool is somewhere near the ends of the contour, until an absolute position is programmed. */
START_TEST(goes_on)
{
	struct gcode_case c;

	mill(&c, HEAD CYCLE("KON", "1", "1", "4") "G0 X100 Y100\nZ60\nM30\n%_N_KON_SPF\n" CONTOUR "M17\n");
	ck_assert(strstr(strbuf_text(&c.moves), "rapid 100 100 150 0 0"));
	ck_assert(strstr(strbuf_text(&c.moves), "\nrapid 100 100 160 0 0\n"));
	/* The end of the contour is (0, 0); between it and (100, 100) at the retraction plane. */
	ck_assert(outside((vec3){50, 50, 50}) <= 1e-9);
	case_release(&c);
}
END_TEST

/*
 * With a backward contour the tool comes to the last point first, on any path from its old position; with a forward one
 * no path leads there.
 */
START_TEST(comes_to_the_end)
{
	static const char *const far = "M30\n%_N_KON_SPF\nG0 X0 Y0\nG1 X60\nY50\nM17\n";
	static const struct {
		const char *cycle;
		bool comes;
	} variants[] = {{CYCLE("KON", "1", "1", "4"), false}, {CYCLE("KON", "10001", "1", "4"), true}};

	for (size_t i = 0; i < 2; i++) {
		struct strbuf program = {0};
		struct gcode_case c;

		strbuf_addf(&program, HEAD "%s%s", variants[i].cycle, far);
		mill(&c, strbuf_text(&program));
		for (int j = 0; j <= 10; j++) {
			const double share = j / 10.0;
			const vec3 way = {-30 + 90 * share, -40 + 90 * share, 60 - 10 * share};

			ck_assert(!variants[i].comes || outside(way) <= 1e-9);
		}
		ck_assert_int_eq(outside((vec3){-30, 50, 60}) <= 1e-9, variants[i].comes);
		ck_assert_int_eq(outside((vec3){60, -40, 60}) <= 1e-9, variants[i].comes);
		strbuf_release(&program);
		case_release(&c);
	}
}
END_TEST

/* The cycle in a loop, and the contour at the end of the file, outside the loop. */
START_TEST(repeats)
{
	struct gcode_case c;

	mill(&c, HEAD "FOR R1=1 TO 2\n" CYCLE("A1:A2", "1", "1", "4") "G0 X=100*R1 Y100\nENDFOR\nM30\nA1:\n" CONTOUR "A2:\n");
	ck_assert(strstr(strbuf_text(&c.moves), "rapid 100 100 150 0 0"));
	ck_assert(strstr(strbuf_text(&c.moves), "rapid 200 100 150 0 0"));
	case_release(&c);
	sinumerik_case_init(&c);
	ck_assert(!case_run(&c, "G500 F6\nREPEAT A B\nM30\nA: X1\nFOR R1=1 TO 2\nB: X2"));
	ck_assert(strstr(strbuf_text(&c.messages), "error: the loop of line 5 is not closed at the end of the file\n"));
	case_release(&c);
}
END_TEST

/* The contour needs no F, and its G-codes are in force only in it. */
START_TEST(modes_come_back)
{
	struct gcode_case c;

	mill(&c, "G500 G17 T1 D1 M6\nG0 X-30 Y-40 Z60\nG91\n" CYCLE("KON", "1", "1", "4") "G90 X100 Y100\nG91\nX5\nM30\n"
		 "%_N_KON_SPF\nG90\n" CONTOUR "M17\n");
	ck_assert(strstr(strbuf_text(&c.moves), "\nrapid 105 100 150 0 0\n"));
	case_release(&c);
	sinumerik_case_init(&c);
	ck_assert(case_run(&c, "G500 G17 T1 D1 M6\nG0 X-30 Y-40 Z60\n" CYCLE("KON", "1", "1", "4")
			       "G1 X100 Y100\nM30\n%_N_KON_SPF\n" CONTOUR "M17\n"));
	ck_assert(strstr(strbuf_text(&c.messages), "p.nc:4:1: warning: G1 without a feed rate (F)"));
	case_release(&c);
}
END_TEST

static const struct refused_program refused[] = {
	{"G500 F6 T1 D1 M6\nCYCLE72(\"\",50,0,1,-5,,,,100,,1,41,1,2)\n", 2, 1,
	 "CYCLE72 without the name of a contour, and without CYCLE62 before it"},
	{"G500 F6 T1 D1 M6\nCYCLE62(\"A\")\nCYCLE62(\"B\")\nCYCLE72(\"\",50,0,1,-5,,,,100,,1,41,1,2)\n", 4, 1,
	 "CYCLE72 behind several CYCLE62: a contour made of several is not supported"},
	{"G500 F6 T1 D1 M6\nCYCLE72(\"A:B\",50,0,1,-5,,,,100,,1,41,1,2)\n", 2, 1,
	 "no line of this program has the label A of the contour"},
	{"G500 F6 T1 D1 M6\nCYCLE72(\"A:B\",50,0,1,-5,,,,100,,5,41,1,2)\n", 2, 1,
	 "CYCLE72 that makes a chamfer (units of _VARI 5) is not supported: how far beside the contour the tool goes is not "
	 "known"},
	{"G500 F6 T1 D1 M6\nCYCLE72(\"A:B\",50,0,1,-5,,,,100,,1,41,4,2)\n", 2, 1,
	 "CYCLE72 whose approach or retraction (units of _AS1 and _AS2) is not 1, 2 or 3: a way that the control chooses is "
	 "not known"},
	{"G500 F6\nCYCLE72(\"A:B\",50,0,1,-5,,,,100,,1,41,1,2)\n", 2, 1,
	 "CYCLE72 needs the radius of the tool: give the tool of the setup a <cutter>, or diameter=\"\""},
	{"G500 F6 T1 D1 M6\nMCALL CYCLE81(10,0,1,-5)\nCYCLE72(\"A:B\",50,0,1,-5,,,,100,,1,41,1,2)\n", 3, 1,
	 "CYCLE72 while CYCLE81 is called behind each motion; MCALL first"},
	{"G500 F6 T1 D1 M6\nCYCLE72(\"A:B\",50,0,1,-5,,,,100,,1,41,1,2)\nM30\nA:\nG0 X0 Y0\nG1 X5 Z1\nB:\n", 6, 1,
	 "the contour of CYCLE72 moves Z, which is not in its plane"},
	{"G500 F6 T1 D1 M6\nCYCLE72(\"A:B\",50,0,1,-5,,,,100,,1,41,1,2)\nM30\nA:\nG0 X0 Y0\nG41 X5\nB:\n", 6, 1,
	 "the contour of CYCLE72 has moves of G0, G1, G2 and G3 in its plane, and nothing else that acts on them"},
	{"G500 F6 T1 D1 M6\nCYCLE72(\"A:B\",50,0,1,-5,,,,100,,1,41,1,2)\nM30\nA:\nTRANS X5\nX0 Y0\nB:\n", 5, 1,
	 "the contour of CYCLE72 has moves of G0, G1, G2 and G3 in its plane, and nothing else that acts on them"},
	{"G500 F6 T1 D1 M6\nCYCLE72(\"A:B\",50,0,1,-5,,,,100,,1,41,1,2)\nM30\nA:\nG2 X10 CR=5\nB:\n", 5, 1,
	 "the contour of CYCLE72 begins with a circle: its first point is not known"},
	{"G500 F6 T1 D1 M6\nCYCLE72(\"A:B\",50,0,1,-5,,,,100,,1,41,1,2)\nM30\nA:\nB:\n", 2, 1,
	 "the contour A:B has no moves"},
	{"G500 F6 T1 D1 M6\nCYCLE72(\"A:B\",50,0,1,-5,,,,100,,1,41,1,2)\nM30\nA:\nX0 Y0\nGOTOF C\nX9\nB:\nC: X5\nM30\n", 9, 1,
	 "a jump or RET leaves the contour of the CYCLE72 in line 2"},
	{"G500 F6 T1 D1 M6\nCYCLE72(\"A:B\",50,0,1,-5,,,,100,,1,41,1,2)\nM30\nA:\nX0 Y0\nGOTOF C\nB:\nC: M30\n", 8, 1,
	 "a jump or RET leaves the contour of the CYCLE72 in line 2"},
	{"G500 F6 T1 D1 M6\nCYCLE72(\"A:B\",50,0,1,-5,,,,100,,1,41,1,2)\nM30\nA:\nX0 Y0\nX5 M30\nB:\n", 6, 4,
	 "the program ends in the contour of CYCLE72"},
	{"G500 F6 T1 D1 M6\nCYCLE72(\"A:B\",50,0,1,-5,,,,100,,1,41,1,2)\nM30\nA:\nX0 Y0\nRET\nB:\n", 6, 1,
	 "the program ends in the contour of CYCLE72"},
	{"G500 F6 T1 D1 M6\nCYCLE72(\"A:B\",50,0,1,-5,,,,100,,1,41,1,2)\nM30\nA:\nG91 X0 Y0\nB:\n", 5, 5,
	 "the contour of CYCLE72 begins with a point whose coordinates in the plane are not both given, absolutely: write "
	 "G90 and both of them"},
	{"G500 F6 T1 D1 M6\nCYCLE72(\"A:B\",50,0,1,-5,,,,100,,1,41,1,2)\nM30\nA:\nY0\nB:\n", 5, 1,
	 "the contour of CYCLE72 begins with a point whose coordinates in the plane are not both given, absolutely: write "
	 "G90 and both of them"},
	{"G500 F6 T1 D1 M6\nCYCLE72(\"A:B\",50,0,1,-5,,,,100,,1,41,1,2)\nM30\nA:\nX0 Y=IC(0)\nB:\n", 5, 1,
	 "the contour of CYCLE72 begins with a point whose coordinates in the plane are not both given, absolutely: write "
	 "G90 and both of them"},
	{"CYCLE62(\"A\",0.6,,)\n", 1, 1,
	 "CYCLE62 with a contour of type 0.6 is not supported, only 0 (a subprogram), 1 (a contour's name) and 2 (two labels)"},
	{"G500 F6 T1 D1 M6\nCYCLE62(,2,\"A\",\"B\")\nL1\nA:\nX0 Y0\nB:\nM30\n%_N_L1_SPF\n"
	 "CYCLE72(\"\",50,0,1,-5,,,,100,,1,41,1,2)\nM17\n", 9, 1,
	 "no line of this program has the label A of the contour"},
	{"G500 F6 T1 D1 M6\nSCALE Y0.5\nCYCLE72(\"A:B\",50,0,1,-5,,,,100,,1,41,1,2)\nM30\nA:\nX0 Y0\nB:\n", 3, 1,
	 "CYCLE72 while SCALE is in force is not supported"},
	{"G500 F6 T1 D1 M6\nSCALE X2 Y2 Z2\nPOCKET4(50,0,2,-10,20,30,30,5,0,0,300,100,0,11,1)\n", 3, 1,
	 "POCKET4 while SCALE is in force is not supported"},
	{"G500 F6 T1 D1 M6\nSCALE Y2\nG1 G41 X0 Y0\n", 3, 4,
	 "tool radius compensation while SCALE is in force is not supported"},
	{"MCALL CYCLE72(\"A:B\",50,0,1,-5)\n", 1, 7,
	 "CYCLE72: milling of a contour is not supported; lines and circles (G1, G2, G3) can say "
	 "its moves"},
};

START_TEST(refuses)
{
	for (size_t i = 0; i < COUNT(refused); i++) {
		struct strbuf message = {0};
		struct gcode_case c;

		sinumerik_case_init(&c);
		strbuf_addf(&message, "p.nc:%d:%d: error: %s\n", refused[i].line, refused[i].column, refused[i].message);
		case_refuses(&c, strbuf_text(&message), "%s", refused[i].program);
		strbuf_release(&message);
	}
}
END_TEST

int main(void)
{
	const TTest *const tests[] = {covers, goes_on, comes_to_the_end, repeats, modes_come_back, refuses};

	return RUN_TESTS("gcode_sinumerik_contour", tests);
}
