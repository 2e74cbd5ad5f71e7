/*
 * test_gcode_spline.c - splines of LinuxCNC and of Fanuc against the curve by its definition, and LinuxCNC's against
 * the arcs that join points of the curve: none of their points lies outside of the boxes.
 */
#include "gcode_refusal.h"
#include "random.h"

#define PIECES_MAX 64
#define SAMPLES 40
#define ROUNDING 1e-6

struct piece {
	double x0, y0, x1, y1, beside_x, beside_y;
};

static size_t run(const char *program, struct piece pieces[PIECES_MAX])
{
	struct gcode_case c;
	size_t count = 0;
	double x0 = 0, y0 = 0;
	bool good;

	case_init(&c);
	c.show_spread = true;
	good = case_run(&c, program);
	ck_assert_msg(good, "%s: %s", program, strbuf_text(&c.messages));
	for (const char *line = strbuf_text(&c.moves); line && *line; line = strchr(line, '\n') + 1) {
		struct piece *piece = &pieces[count];
		double z, a, b, beside;

		ck_assert(count < PIECES_MAX);
		*piece = (struct piece){.x0 = x0, .y0 = y0};
		ck_assert_int_ge(sscanf(line, "feed %lf %lf %lf %lf %lf spread %lf %lf %lf", &piece->x1, &piece->y1, &z, &a, &b,
					&piece->beside_x, &piece->beside_y, &beside), 5);
		x0 = piece->x1, y0 = piece->y1;
		count++;
	}
	case_release(&c);
	return count;
}

/* Some point of the line whose box has this one. */
static void expect_inside(const struct piece *piece, double x, double y)
{
	double low = 0, high = 1, wx = piece->x1 - piece->x0, wy = piece->y1 - piece->y0;
	const double way[2] = {wx, wy}, at[2] = {x - piece->x0, y - piece->y0};
	const double beside[2] = {piece->beside_x + ROUNDING, piece->beside_y + ROUNDING};

	for (int i = 0; i < 2; i++) {
		double a, b;

		if (fabs(way[i]) < 1e-12) {
			ck_assert_double_le(fabs(at[i]), beside[i]);
			continue;
		}
		a = (at[i] - beside[i]) / way[i];
		b = (at[i] + beside[i]) / way[i];
		low = fmax(low, fmin(a, b));
		high = fmin(high, fmax(a, b));
	}
	require(low <= high, "(%g, %g) is outside of the box from (%g, %g) to (%g, %g)", x, y, piece->x0, piece->y0,
		      piece->x1, piece->y1);
}

/* Basis functions of Cox and de Boor over the knots 0 (order times), 1, 2, ..., by their recursion. */
static double knot(int index, int order, int count)
{
	int value = index - order + 1, last = count - order + 1;

	return value < 0 ? 0 : value > last ? last : value;
}

static double basis(int i, int k, double u, int order, int count)
{
	double a = knot(i, order, count), b = knot(i + 1, order, count), c = knot(i + k - 1, order, count),
	       d = knot(i + k, order, count);

	if (k == 1)
		return a <= u && u < b ? 1 : 0;
	return (c > a ? (u - a) / (c - a) * basis(i, k - 1, u, order, count) : 0) +
	       (d > b ? (d - u) / (d - b) * basis(i + 1, k - 1, u, order, count) : 0);
}

struct control {
	double x, y, w;
};

static void evaluate(const struct control *points, int count, int order, double u, double *x, double *y)
{
	double sum = 0;

	*x = *y = 0;
	for (int i = 0; i < count; i++) {
		double part = basis(i, order, u, order, count) * points[i].w;

		*x += part * points[i].x;
		*y += part * points[i].y;
		sum += part;
	}
	*x /= sum;
	*y /= sum;
}

/* The joint of the two arcs: half way between the ends of tangents that are each half as long as what lies between them. */
static void expect_joint(const struct piece *piece, const struct control *points, int count, int order, double u0,
			 double u1)
{
	double ax, ay, bx, by, cx, cy, dx, dy, h = 1e-6 * (u1 - u0), low = 0, high = 1;

	evaluate(points, count, order, u0, &ax, &ay);
	evaluate(points, count, order, u0 + h, &bx, &by);
	evaluate(points, count, order, u1 - h, &cx, &cy);
	evaluate(points, count, order, u1 - 1e-12, &dx, &dy);
	bx -= ax, by -= ay, cx = dx - cx, cy = dy - cy;
	for (double *t[2] = {&bx, &cx}, *s[2] = {&by, &cy}, **p = t; p < t + 2; p++) {
		double *q = s[p - t], length = sqrt(**p * **p + *q * *q);

		**p /= length, *q /= length;
	}
	high = 2 * hypot(dx - ax, dy - ay);
	for (int i = 0; i < 100; i++) {
		double d = (low + high) / 2, gap = hypot(dx - d * cx - ax - d * bx, dy - d * cy - ay - d * by);

		*(gap > 2 * d ? &low : &high) = d;
	}
	expect_inside(piece, (ax + low * bx + dx - low * cx) / 2, (ay + low * by + dy - low * cy) / 2);
}

static void expect_curve(const char *program, const struct control *points, int count, int order)
{
	struct piece pieces[PIECES_MAX];
	const size_t found = run(program, pieces);
	const double last = count - order + 1;

	ck_assert_uint_eq(found, 4 * (size_t)count);
	for (size_t i = 0; i < found; i++) {
		double u0 = last * (double)i / (double)found, u1 = last * (double)(i + 1) / (double)found, x, y;

		for (int k = 0; k < SAMPLES; k++) {
			evaluate(points, count, order, u0 + (u1 - u0) * k / SAMPLES, &x, &y);
			expect_inside(&pieces[i], x, y);
		}
		expect_joint(&pieces[i], points, count, order, u0, u1);
	}
	ck_assert_double_eq_tol(pieces[found - 1].x1, points[count - 1].x, ROUNDING);
	ck_assert_double_eq_tol(pieces[found - 1].y1, points[count - 1].y, ROUNDING);
}

/* A sequence of points whose turns are less than a right angle, so that no tangent turns back. */
static void walk(struct random *random, struct control *points, int count, bool weights)
{
	double angle = random_in(random, -3, 3);

	points[0] = (struct control){0, 0, 1};
	for (int i = 1; i < count; i++) {
		double way = random_in(random, 5, 30);

		angle += random_in(random, -0.7, 0.7);
		points[i] = (struct control){points[i - 1].x + way * cos(angle), points[i - 1].y + way * sin(angle),
					     weights ? random_in(random, 0.5, 2) : 1};
	}
}

struct bad {
	const char *program, *message;
};

/* LinuxCNC's manual, "G5 Cubic Spline", "G5.1 Quadratic Spline", "G5.2 G5.3 NURBS Block". */
START_TEST(curves)
{
	const long cases = random_cases(60);

	for (long i = 0; i < cases; i++) {
		struct random random = random_case(5, i);
		struct strbuf text = {0};
		struct control p[8];
		int count = 4 + random_below(&random, 4), order = 3 + random_below(&random, 2);

		walk(&random, p, 4, false);
		strbuf_addf(&text, "F9\nG5 X%.12f Y%.12f I%.12f J%.12f P%.12f Q%.12f\nM2\n", p[3].x, p[3].y, p[1].x, p[1].y,
			    p[2].x - p[3].x, p[2].y - p[3].y);
		expect_curve(text.text, p, 4, 4);
		strbuf_release(&text);
		walk(&random, p, 3, false);
		strbuf_addf(&text, "F9\nG5.1 X%.12f Y%.12f I%.12f J%.12f\nM2\n", p[2].x, p[2].y, p[1].x, p[1].y);
		expect_curve(text.text, p, 3, 3);
		strbuf_release(&text);
		walk(&random, p, count, true);
		strbuf_addf(&text, "F9\nG5.2 L%d\n", order);
		for (int k = 1; k < count; k++)
			strbuf_addf(&text, "X%.12f Y%.12f P%.12f\n", p[k].x, p[k].y, p[k].w);
		strbuf_addf(&text, "G5.3\nM2\n");
		expect_curve(text.text, p, count, order);
		strbuf_release(&text);
	}
}
END_TEST

/* The manual's example: a second G5 without I and J goes on in the direction in which the first one ends. */
START_TEST(goes_on)
{
	struct piece once[PIECES_MAX], again[PIECES_MAX];
	const size_t count = run("G90 G17 F9\nG5 I0 J3 P0 Q-3 X1 Y1\nP0 Q3 X2 Y2\nM2\n", once);

	ck_assert_uint_eq(count, 32);
	ck_assert_uint_eq(run("G90 G17 F9\nG5 I0 J3 P0 Q-3 X1 Y1\nG5 I0 J3 P0 Q3 X2 Y2\nM2\n", again), 32);
	ck_assert_mem_eq(once, again, count * sizeof(*once));
}
END_TEST

#define NURBS_POINTS 7
#define NURBS_ORDER 4
#define NURBS_PIECES 4000

struct nurbs {
	int count, order;
	double point[NURBS_POINTS][3], weight[NURBS_POINTS], knot[NURBS_POINTS + NURBS_ORDER];
};

struct box {
	double from[3], to[3], beside[3];
};

/* Cox and de Boor, over the knots of the program. */
static double nurbs_basis(const struct nurbs *curve, int i, int k, double u)
{
	const double *t = &curve->knot[i];

	if (k == 1)
		return t[0] <= u && u < t[1] ? 1 : 0;
	return (t[k - 1] > t[0] ? (u - t[0]) / (t[k - 1] - t[0]) * nurbs_basis(curve, i, k - 1, u) : 0) +
	       (t[k] > t[1] ? (t[k] - u) / (t[k] - t[1]) * nurbs_basis(curve, i + 1, k - 1, u) : 0);
}

static void nurbs_random(struct random *random, struct nurbs *curve)
{
	double u = random_in(random, -3, 3);
	bool doubled = false;

	curve->order = 2 + random_below(random, NURBS_ORDER - 1);
	curve->count = curve->order + random_below(random, NURBS_POINTS - curve->order + 1);
	for (int i = 0; i < curve->count + curve->order; i++) {
		/* A knot inside may stand twice, where the curve may bend at once. */
		doubled = !doubled && i > curve->order && i < curve->count && curve->order > 2 &&
			  random_below(random, 3) == 0;
		u += i >= curve->order && i <= curve->count && !doubled ? random_in(random, 0.1, 2) : 0;
		curve->knot[i] = u;
	}
	for (int i = 0; i < curve->count; i++) {
		curve->weight[i] = random_in(random, 0.3, 3);
		for (int k = 0; k < 3; k++)
			curve->point[i][k] = i ? random_in(random, -20, 20) : 0;
	}
}

static void nurbs_write(const struct nurbs *curve, struct strbuf *text)
{
	strbuf_addf(text, "G90 G94 F9.\nG6.2 P%d ", curve->order);
	for (int i = 0; i < curve->count + curve->order; i++) {
		strbuf_addf(text, "K%.14f", curve->knot[i]);
		if (i < curve->count)
			strbuf_addf(text, " X%.14f Y%.14f Z%.14f R%.14f", curve->point[i][0], curve->point[i][1],
				    curve->point[i][2], curve->weight[i]);
		strbuf_addf(text, "\n");
	}
	strbuf_addf(text, "G0 Z0.\nM30\n");
}

static size_t nurbs_run(const char *program, struct box boxes[NURBS_PIECES])
{
	struct gcode_case c;
	size_t count = 0;
	double at[3] = {0};

	case_init(&c);
	c.config.dialect = &dialect_fanuc;
	c.show_spread = true;
	ck_assert_msg(case_run(&c, program), "%s: %s", program, strbuf_text(&c.messages));
	for (const char *line = strbuf_text(&c.moves); *line == 'f'; line = strchr(line, '\n') + 1) {
		struct box *box = &boxes[count++];
		double a, b;

		ck_assert_uint_le(count, NURBS_PIECES);
		*box = (struct box){.from = {at[0], at[1], at[2]}};
		ck_assert_int_ge(sscanf(line, "feed %lf %lf %lf %lf %lf spread %lf %lf %lf", &box->to[0], &box->to[1],
					&box->to[2], &a, &b, &box->beside[0], &box->beside[1], &box->beside[2]), 5);
		memcpy(at, box->to, sizeof(at));
	}
	case_release(&c);
	return count;
}

static bool box_holds(const struct box *box, const double point[3])
{
	double low = 0, high = 1;

	for (int k = 0; k < 3; k++) {
		double way = box->to[k] - box->from[k], off = point[k] - box->from[k],
		       beside = box->beside[k] + ROUNDING;

		if (fabs(way) < 1e-12) {
			if (fabs(off) > beside)
				return false;
			continue;
		}
		low = fmax(low, fmin((off - beside) / way, (off + beside) / way));
		high = fmin(high, fmax((off - beside) / way, (off + beside) / way));
	}
	return low <= high;
}

/* Fanuc 15i/150i-MA (B-63324EN), "NURBS Interpolation (G06.2)": the curve by its definition lies in the boxes. */
START_TEST(nurbs_of_fanuc)
{
	const long cases = random_cases(40);
	struct box *boxes = malloc(NURBS_PIECES * sizeof(*boxes));

	for (long i = 0; i < cases; i++) {
		struct random random = random_case(62, i);
		struct strbuf text = {0};
		struct nurbs curve;
		size_t count;

		nurbs_random(&random, &curve);
		nurbs_write(&curve, &text);
		count = nurbs_run(text.text, boxes);
		for (int k = 0; k < 300; k++) {
			double first = curve.knot[0], last = curve.knot[curve.count], sum = 0, point[3] = {0};
			bool held = false;

			for (int p = 0; p < curve.count; p++) {
				double part = curve.weight[p] *
					      nurbs_basis(&curve, p, curve.order, first + (last - first) * k / 300);

				sum += part;
				for (int axis = 0; axis < 3; axis++)
					point[axis] += part * curve.point[p][axis];
			}
			for (int axis = 0; axis < 3; axis++)
				point[axis] /= sum;
			for (size_t b = 0; b < count && !held; b++)
				held = box_holds(&boxes[b], point);
			require(held, "case %ld: (%g, %g, %g) is outside of the boxes", i, point[0], point[1],
				point[2]);
		}
		for (int axis = 0; axis < 3; axis++)
			ck_assert_double_eq_tol(boxes[count - 1].to[axis], curve.point[curve.count - 1][axis],
						ROUNDING);
		strbuf_release(&text);
	}
	free(boxes);
}
END_TEST

/* A quarter of a circle, which a curve of rank 3 is exactly; and lines, rank 2, in few moves. */
START_TEST(nurbs_of_known_form)
{
	struct box *boxes = malloc(NURBS_PIECES * sizeof(*boxes));
	size_t count =
	    nurbs_run("F9.\nG6.2 P3 X0. Y0. K0.\nX10. Y0. K0. R.70710678118655\nX10. Y10. K0.\nK1.\nK1.\nK1.\n"
		      "M30\n",
		      boxes);

	ck_assert_uint_lt(count, 200);
	for (size_t i = 0; i < count; i++) {
		ck_assert_double_eq_tol(hypot(boxes[i].to[0], boxes[i].to[1] - 10), 10, 1e-7);
		ck_assert_double_le(boxes[i].beside[0] + boxes[i].beside[1] + boxes[i].beside[2], 2.1e-3);
	}
	ck_assert_uint_eq(nurbs_run("F9.\nG6.2 P2 K0.\nX9. Z5. K0.\nX9. Z8. K1.\nK2.\nK2.\nM30\n", boxes), 2);
	free(boxes);
}
END_TEST

#define NURBS "F9.\nG6.2 P3 X0. Y0. K0.\n"

static const struct bad nurbs_bads[] = {
    {"G6.2 P3 X1. Y0. K0.", "p.nc:1:1: error: the first control point of G6.2 must be the present position"},
    {"G6.2 P5 X0. K0.", "p.nc:1:6: error: P5 must be a whole number from 2 to 4"},
    {"G6.2 P3 X0. Y0.", "p.nc:1:1: error: every block of G6.2 needs K (knot)"},
    {"G91 G6.2 X0. K0.", "p.nc:1:5: error: G6.2 is not supported in G91 or in rotated, scaled or polar coordinates"},
    {"G95 G6.2 X0. K0.", "p.nc:1:5: error: G6.2 is not supported under tool centre point control, cutter compensation, G93"},
    {"G6.2 C0. K0.", "p.nc:1:6: error: C with G6.2 is not supported; its curve moves X, Y and Z"},
    {NURBS "X1. Y1. K-1.", "p.nc:3:9: error: this knot (K) is smaller than the one before"},
    {NURBS "X1. K0.", "p.nc:3:1: error: each control point of G6.2 needs a word for every axis of the curve"},
    {NURBS "X1. Y1. K0. R0.", "p.nc:3:13: error: R (weight of a control point) must be greater than 0"},
    {NURBS "X1. Y1. K0. R2", "p.nc:3:13: error: R (weight of a control point) needs a decimal point"},
    {"T1 M6 G6.2 P3 X0. Y0. K0.", "p.nc:1:4: error: M6 beside G6.2 is not supported"},
    {NURBS "G55 X1. Y1. K0.", "p.nc:3:1: error: the curve of G6.2 is not complete"},
    {NURBS "X1. Y1. K0. H1", "p.nc:3:1: error: the curve of G6.2 is not complete"},
    {NURBS "X1. Y1. K0. M6", "p.nc:3:1: error: the curve of G6.2 is not complete"},
    {"G6.2 P3 X0. Y0. K0. M2", "p.nc:1:1: error: the curve of G6.2 is not complete"},
    {NURBS "P3 X1. Y1. K0.", "p.nc:3:1: error: P (rank of the curve) is allowed only in the block with G6.2"},
    {NURBS "K0. R1.", "p.nc:3:5: error: a weight (R) without a control point"},
    {NURBS "K0.\nX1. Y1. K0.", "p.nc:4:1: error: a control point of G6.2 after knots without points"},
    {NURBS "X1. Y1. K0.\nG1 X2.", "p.nc:4:1: error: the curve of G6.2 is not complete"},
    {NURBS "X1. Y1. K0.\nM30", "p.nc:4:1: error: the curve of G6.2 is not complete"},
    {NURBS "X1. Y1. K0.\nK1.\nK1.\nK1.",
     "p.nc:6:1: error: a G6.2 curve of rank 3 needs at least as many control points"},
    {NURBS "X1. Y1. K0.\nX2. Y1. K.5\nK1.\nK1.\nK1.",
     "p.nc:7:1: error: the first and the last knot of a G6.2 curve of rank 3 must occur 3 times each"},
    {"F9.\nG6.2 P2 X0. K0.\nX1. K0.\nX2. K1.\nX3. K1.\nK2.\nK2.",
     "p.nc:7:1: error: a knot inside the G6.2 curve occurs too often: the curve would jump"},
};

START_TEST(nurbs_refused)
{
	struct gcode_case c;

	case_init(&c);
	c.config.dialect = &dialect_fanuc;
	c.config.controller.least_input = 0.001;
	c.config.controller.m6_with_move = M6_AFTER_MOVE;
	case_refuses(&c, nurbs_bads[_i].message, "%s\nM30\n", nurbs_bads[_i].program);
}
END_TEST

static const struct bad bads[] = {
    {"G5 X1 Y1 P1 Q1", "p.nc:2:1: error: the first G5 in a row needs I and J"},
    {"G5 X1 Y1 I1 P1 Q1", "p.nc:2:10: error: G5 needs both I and J, or none of them"},
    {"G5 X1 Y1 I1 J1", "p.nc:2:1: error: G5 needs P and Q"},
    {"G5.1 X1 Y1", "p.nc:2:1: error: G5.1 needs I or J"},
    {"G5 X1 Y1 Z1 I1 J1 P1 Q1", "p.nc:2:10: error: Z with a spline, which moves only X and Y"},
    {"G18 G5.1 X1 Y1 I1", "p.nc:2:5: error: a spline needs the plane of G17"},
    {"G91 G5.1 X1 Y1 I1", "p.nc:2:5: error: a spline is not supported in G91, under tool centre point control or"},
    {"G5.1 X1 Y0 I10", "this spline turns back on itself or has coincident points"},
    {"G5.3", "p.nc:2:1: error: G5.3 without G5.2 before it"},
    {"G5.2\nX1 Y1\nG5.3", "p.nc:4:1: error: a spline of order 3 needs at least as many control points"},
    {"G5.2\nX1 Y1\nG1 X2", "p.nc:4:1: error: only control points (X, Y and P) are allowed between G5.2 and G5.3"},
    {"G5.2\nX1 Y1 P1 G55", "p.nc:3:1: error: only control points (X, Y and P) are allowed between G5.2 and G5.3"},
    {"G5.2 M2", "p.nc:2:1: error: only control points (X, Y and P) are allowed between G5.2 and G5.3"},
    {"G5.2\nX1 Y1 P0", "p.nc:3:7: error: P (weight of a control point) must be greater than 0"},
    {"G5.2 X1",
     "p.nc:2:1: error: G5.2 with axis words is not supported; its first control point is the present position"},
};

START_TEST(refused)
{
	struct gcode_case c;

	case_init(&c);
	case_refuses(&c, bads[_i].message, "F9\n%s\nM2\n", bads[_i].program);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("gcode_spline");

	tcase_add_test(tcase, curves);
	tcase_add_test(tcase, goes_on);
	tcase_add_test(tcase, nurbs_of_fanuc);
	tcase_add_test(tcase, nurbs_of_known_form);
	tcase_add_loop_test(tcase, nurbs_refused, 0, COUNT(nurbs_bads));
	tcase_add_loop_test(tcase, refused, 0, COUNT(bads));
	return run_suite("gcode_spline", tcase);
}
