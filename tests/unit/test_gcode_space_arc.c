/* test_gcode_space_arc.c - G2.4 and G3.4 of Fanuc: arcs through a point, against closed forms. */
#include "gcode_refusal.h"

static const struct radius_offset radius = {1, 5};

static void init(struct gcode_case *c)
{
	case_init(c);
	c->config.dialect = &dialect_fanuc;
	c->config.radii = &radius;
	c->config.radius_count = 1;
	c->config.controller.comp_start = COMP_START_A;
	c->config.controller.comp_corner = COMP_CORNER_CIRCULAR;
}

static void run(const char *program, const char *moves)
{
	struct gcode_case c;

	init(&c);
	case_expect(&c, program, moves);
}

/*
 * Fanuc B-64484EN, "Three-dimensional Circular Interpolation". The circle of the second program has the centre
 * (1, 2, 3) and the radius 5, and contains the directions (1, 0, 0) and (0, 0.6, 0.8).
 */
START_TEST(arcs)
{
	run("F9. G2.4 X1. Y1.\nX2. Y0.\nM30\n", "arc 2 0 0 0 0 centre 1 0 0 normal 0 0 -1 sweep 180\n");
	run("G0 X6. Y2. Z3.\nF9. G3.4 X1. Y5. Z7.\nX-4. Y2. Z3.\nX1. Y-1. Z-1.\n(the end)\nX4. Y-.4 Z-.2\n"
	    "G91 G2.4 X2. Y2.4 Z3.2\nX-5. Y3. Z4.\nG90 G1 X0.\nM30\n",
	    "rapid 6 2 3 0 0\narc -4 2 3 0 0 centre 1 2 3 normal 0 -0.8 0.6 sweep 180\n"
	    "arc 4 -0.4 -0.2 0 0 centre 1 2 3 normal 0 -0.8 0.6 sweep 126.869898\n"
	    "arc 1 5 7 0 0 centre 1 2 3 normal 0 -0.8 0.6 sweep 143.130102\nfeed 0 5 7 0 0\n");
	/* A coordinate that the second block does not give is that of the point on the way. */
	run("F9. G3.4 X1. Y1.\nX2.\nM30\n", "arc 2 1 0 0 0 centre 1.5 -0.5 0 normal 0 0 -1 sweep 90\n");
	/* The code may be repeated, and is in force again after a canned cycle. */
	run("F9. G2.4 X1. Y1.\nG2.4 X2. Y0.\nG81 G99 X5. R-1. Z-2.\nG80\nX6. Y1. Z-1.\nX7. Y0.\nM30\n",
	    "arc 2 0 0 0 0 centre 1 0 0 normal 0 0 -1 sweep 180\nrapid 5 0 0 0 0\nrapid 5 0 -1 0 0\nfeed 5 0 -2 0 0\n"
	    "rapid 5 0 -1 0 0\narc 7 0 -1 0 0 centre 6 0 -1 normal 0 0 -1 sweep 180\n");
}
END_TEST

START_TEST(coordinates)
{
	run("G20 F9. G2.4 X1. Y1.\nX2. Y0.\nM30\n", "arc 50.8 0 0 0 0 centre 25.4 0 0 normal 0 0 -1 sweep 180\n");
	run("G10 L2 P1 X100. Z5.\nG54 F9. G0 X0. Y0. Z0.\nG2.4 X1. Y1.\nX2. Y0.\nM30\n",
	    "rapid 100 0 5 0 0\narc 102 0 5 0 0 centre 101 0 5 normal 0 0 -1 sweep 180\n");
	run("G68 X0. Y0. R90.\nF9. G2.4 X1. Y1.\nX2. Y0.\nG69\nM30\n",
	    "arc 0 2 0 0 0 centre 0 1 0 normal 0 0 -1 sweep 180\n");
	run("G68 X0. Y0. R90.\nG0 X1. Y0.\nF9. G91 G2.4 X1. Y1.\nX1. Y-1.\nG69\nM30\n",
	    "rapid 0 1 0 0 0\narc 0 3 0 0 0 centre 0 2 0 normal 0 0 -1 sweep 180\n");
}
END_TEST

static const struct {
	const char *program, *words;
} bads[] = {
    {"F9. G2.4 X1. Y1.\nM30\n", "p.nc:2:1: error: the arc of G2.4 or G3.4 has no end"},
    {"F9. G2.4 X1. Y1.\nG1 X2.\nM30\n", "p.nc:2:1: error: the arc of G2.4 or G3.4 has no end"},
    {"F9. G2.4 X1. Y1.\nM6 T1\nM30\n", "p.nc:2:1: error: the arc of G2.4 or G3.4 has no end"},
    {"F9. G2.4 X1. Y1.\nG90 X2.\nM30\n", "p.nc:2:1: error: the arc of G2.4 or G3.4 has no end"},
    {"F9. G2.4 X1. Y1.\nF8.\nM30\n", "p.nc:2:1: error: the arc of G2.4 or G3.4 has no end"},
    {"F9. G2.4 X1. Y1.\nG28 Z0.\nM30\n", "p.nc:2:1: error: the arc of G2.4 or G3.4 has no end"},
    {"F9. G2.4 X1. Y1.\n", "the arc of G2.4 or G3.4 has no end"},
    {"F9. G3.4 X1.\nX2.\nM30\n", "p.nc:2:1: error: G2.4 and G3.4 need three different points that do not lie on a line"},
    {"F9. G3.4 X1. Y1.\nX0. Y0.\nM30\n", "three different points"},
    {"F9. G2.4\nX1. Y1.\nM30\n", "p.nc:1:5: error: G2.4 and G3.4 need X, Y or Z"},
    {"F9. G3.4\nX1. Y1.\nM30\n", "p.nc:1:5: error: G2.4 and G3.4 need X, Y or Z"},
    {"F9. G2.4 X1. Y1. A5.\nX2. Y0.\nM30\n", "p.nc:1:18: error: A with G2.4 or G3.4 is not supported"},
    {"F9. G2.4 X1. Y1.\nX2. Y0. C5.\nM30\n", "p.nc:2:9: error: C with G2.4 or G3.4 is not supported"},
    {"F9. G2.4 X1. Y1. I5.\nX2. Y0.\nM30\n", "p.nc:1:18: error: no code in the block uses the word I"},
    {"F9. G2.4 X1. Y1.\nX2. Y0. R5.\nM30\n", "p.nc:2:9: error: no code in the block uses the word R"},
    {"G93 G2.4 X1. Y1. F9.\nX2. Y0. F9.\nM30\n", "G2.4 and G3.4 under inverse time feed (G93) are not supported"},
    {"F9. G41 D1 G1 X9.\nG2.4 X10. Y1.\nX11. Y0.\nG40 X20.\nM30\n", "p.nc:2:1: error: G2.4 while cutter compensation is on"},
    {"F9. G51 X0. Y0. Z0. P2.\nG2.4 X1. Y1.\nX2. Y0.\nM30\n", "G2.4 and G3.4 under scaling (G51) are not supported"},
    {"F9. G51.1 X0.\nG2.4 X1. Y1.\nX2. Y0.\nM30\n", "G2.4 and G3.4 under mirror image (G51.1) are not supported"},
    {"F9. G16\nG2.4 X1. Y1.\nX2. Y0.\nM30\n", "G2.4 and G3.4 under polar coordinates (G16) are not supported"},
    {"F9. G68.2 G2.4 X1. Y1. I0. J0. K0.\nM30\n", "p.nc:1:11: error: G68.2 needs a block without motion"},
    {"F9. G1 X1. ,R1.\nG2.4 X1. Y1.\nX2. Y0.\nM30\n", "corner"},
    {"F9. G2.4 X1. Y1.\n#1=#4001\nX2. Y0.\nM30\n", "#4001"},
};

START_TEST(refused)
{
	struct gcode_case c;

	init(&c);
	case_refuses(&c, bads[_i].words, "%s", bads[_i].program);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("gcode_space_arc");

	tcase_add_test(tcase, arcs);
	tcase_add_test(tcase, coordinates);
	tcase_add_loop_test(tcase, refused, 0, COUNT(bads));
	return run_suite("gcode_space_arc", tcase);
}
