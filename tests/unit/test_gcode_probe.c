/*
 * test_gcode_probe.c - what follows a probe is proved for every place at which it may have stopped: random programs, the
 * places chosen at random, and every point of the paths that come of it lies in what the moves of its block cover.
 */
#include "gcode_case.h"
#include "random.h"

#define BLOCKS 12
#define MOVES 64
/* Of a path, also where it is an arc. */
#define POINTS 16

/* The region that a block covers: a box that moves from start to end. */
struct covered {
	long line;
	bool rapid;
	const char *kind;
	vec3 start, end, spread, centre;
	double sweep;	/* of an arc about Z */
};

struct recorder {
	struct covered moves[MOVES];
	int count;
	vec3 at;
};

static bool record(void *context, const struct canon_event *event)
{
	struct recorder *recorder = context;
	const struct canon_move *move = event->of.move;
	struct covered *covered = &recorder->moves[recorder->count];

	if (event->kind != CANON_MOVE || move->kind > CANON_ARC)
		return true;
	ck_assert_int_lt(recorder->count++, MOVES);
	*covered = (struct covered){.line = move->line,
				    .rapid = move->kind == CANON_RAPID,
				    .start = recorder->at,
				    .end = {move->end.v[SLOT_X], move->end.v[SLOT_Y], move->end.v[SLOT_Z]},
				    .spread = {move->spread[0], move->spread[1], move->spread[2]},
				    .centre = move->arc.centre,
				    .sweep = move->kind == CANON_ARC ? move->arc.sweep : 0};
	recorder->at = covered->end;
	return true;
}

/* The path of a block from where the probe has really stopped: straight, but for full turns about a point. */
struct truth {
	bool rapid;
	vec3 start, end, centre;
	double sweep;
};

struct probe_case {
	struct random random;
	struct strbuf text;
	struct truth path[BLOCKS + 1];	/* by line */
	int lines;
	vec3 at;	/* where the tool really is */
	bool open[3];
};

static double *part(vec3 *point, int slot)
{
	return slot == 0 ? &point->x : slot == 1 ? &point->y : &point->z;
}

static vec3 between(vec3 a, vec3 b, double s)
{
	return vec3_lerp(a, b, s);
}

static vec3 turned(vec3 start, vec3 end, vec3 centre, double sweep, double s)
{
	vec3 point = between(start, end, s);
	double x = start.x - centre.x, y = start.y - centre.y, c = cos(s * sweep), w = sin(s * sweep);

	/* Full turns: start and end have the same X and Y. */
	if (fabs(sweep) > 0)
		point = (vec3){centre.x + c * x - w * y, centre.y + w * x + c * y, point.z};
	return point;
}

/* Does the share of the way with |start + s (end - start) - p| <= spread shrink to nothing? */
static void cut(double start, double end, double spread, double p, double *low, double *high)
{
	double slack = spread + 1e-9, way = end - start;

	if (fabs(way) < 1e-12) {
		*high = fabs(start - p) <= slack ? *high : -1;
		return;
	}
	*low = fmax(*low, fmin((p - slack - start) / way, (p + slack - start) / way));
	*high = fmin(*high, fmax((p - slack - start) / way, (p + slack - start) / way));
}

static bool covers(const struct covered *move, const struct truth *truth, vec3 point, double s)
{
	double low = 0, high = 1;
	vec3 aside = vec3_sub(turned(move->start, move->end, move->centre, move->sweep, s), point);

	if (fabs(truth->sweep) > 0)
		return fabs(aside.x) <= move->spread.x + 1e-9 && fabs(aside.y) <= move->spread.y + 1e-9 &&
		       fabs(aside.z) <= move->spread.z + 1e-9;
	cut(move->start.x, move->end.x, move->spread.x, point.x, &low, &high);
	cut(move->start.y, move->end.y, move->spread.y, point.y, &low, &high);
	cut(move->start.z, move->end.z, move->spread.z, point.z, &low, &high);
	return low <= high;
}

static void check_block(const struct recorder *recorder, long line, const struct truth *truth, const char *text)
{
	for (int i = 0; i <= POINTS; i++) {
		double s = (double)i / POINTS;
		vec3 point = turned(truth->start, truth->end, truth->centre, truth->sweep, s);
		bool covered = vec3_norm(vec3_sub(truth->end, truth->start)) < 1e-12 && !(fabs(truth->sweep) > 0);

		for (int k = 0; k < recorder->count && !covered; k++)
			covered = recorder->moves[k].line == line && recorder->moves[k].rapid == truth->rapid &&
				  covers(&recorder->moves[k], truth, point, s);
		require(covered, "line %ld: %g %g %g is not covered:\n%s", line, point.x, point.y, point.z, text);
	}
}

static int count_open(const struct probe_case *c)
{
	return c->open[0] + c->open[1] + c->open[2];
}

static struct truth *next_line(struct probe_case *c, bool rapid)
{
	struct truth *truth = &c->path[++c->lines];

	*truth = (struct truth){.rapid = rapid, .start = c->at, .end = c->at};
	return truth;
}

/* A probe in one or two axes that stops anywhere on its way. */
static void add_probe(struct probe_case *c, bool fanuc)
{
	struct truth *truth = next_line(c, false);
	int first = random_below(&c->random, 3), axes = count_open(c) ? 1 : 1 + random_below(&c->random, 2);
	double stop = random_below(&c->random, 3) ? random_in(&c->random, 0, 1) : random_below(&c->random, 2);

	strbuf_addf(&c->text, "G90 %s F100.", fanuc ? "G31" : "G38.3");
	for (int i = 0; i < axes; i++) {
		int slot = (first + i) % 3;
		double target = random_below(&c->random, 100) - 50;

		strbuf_addf(&c->text, " %c%.1f", "XYZ"[slot], target);
		*part(&truth->end, slot) = target;
	}
	truth->end = between(truth->start, truth->end, stop);
	for (int i = 0; i < axes; i++)
		c->open[(first + i) % 3] = true;
	strbuf_addf(&c->text, "\n");
	c->at = truth->end;
}

static void add_increment(struct probe_case *c)
{
	struct truth *truth = next_line(c, random_below(&c->random, 2));
	int slot = c->open[0] ? 0 : c->open[1] ? 1 : 2;
	double way = random_below(&c->random, 40) - 20;

	strbuf_addf(&c->text, "G91 %s %c%.1f\n", truth->rapid ? "G0" : "G1 F9.", "XYZ"[slot], way);
	*part(&truth->end, slot) += way;
	c->at = truth->end;
}

static void add_straight(struct probe_case *c)
{
	struct truth *truth = next_line(c, random_below(&c->random, 2));
	int axes = 1 + random_below(&c->random, 7);

	strbuf_addf(&c->text, "G90 %s", truth->rapid ? "G0" : "G1 F9.");
	for (int slot = 0; slot < 3; slot++) {
		double target = random_below(&c->random, 100) - 50;

		if (!(axes >> slot & 1))
			continue;
		strbuf_addf(&c->text, " %c%.1f", "XYZ"[slot], target);
		*part(&truth->end, slot) = target;
		c->open[slot] = false;
	}
	strbuf_addf(&c->text, "\n");
	c->at = truth->end;
}

static void add_turn(struct probe_case *c)
{
	struct truth *truth = next_line(c, false);

	strbuf_addf(&c->text, "G90 G17 G3 I10. J5. F9.");
	truth->centre = vec3_add(truth->start, (vec3){10, 5, 0});
	truth->sweep = 2 * acos(-1);
	if (random_below(&c->random, 2)) {
		double target = random_below(&c->random, 100) - 50;

		strbuf_addf(&c->text, " Z%.1f", target);
		truth->end.z = target;
		c->open[2] = false;
	}
	strbuf_addf(&c->text, "\n");
	c->at = truth->end;
}

static void run_case(long number, bool fanuc)
{
	struct probe_case c = {.random = random_case(4711, number)};
	struct gcode_case g;
	struct recorder recorder = {.count = 0};
	struct canon_sink sink = {.context = &recorder, .event = record};
	struct interp *interp;
	FILE *in;

	add_straight(&c);
	add_probe(&c, fanuc);
	while (c.lines < BLOCKS) {
		switch (random_below(&c.random, 5)) {
		case 0:
			add_probe(&c, fanuc);
			break;
		case 1:
			if (count_open(&c) == 1)
				add_increment(&c);
			break;
		case 2:
			if (!c.open[0] && !c.open[1])
				add_turn(&c);
			break;
		default:
			add_straight(&c);
			break;
		}
	}
	case_init(&g);
	g.config.dialect = fanuc ? &dialect_fanuc : &dialect_linuxcnc;
	g.diag.context = &g;
	interp = interp_new(&g.config, &(struct kinematics){0}, &sink, &g.diag);
	in = tmpfile();
	ck_assert_ptr_nonnull(in);
	fputs(strbuf_text(&c.text), in);
	fputs("M30\n", in);
	rewind(in);
	require(interp_run(interp, in, "p.nc"), "case %ld: %s\n%s", number, strbuf_text(&g.messages),
		strbuf_text(&c.text));
	fclose(in);
	interp_free(interp);
	ck_assert_str_eq(strbuf_text(&g.messages), "");
	for (int line = 1; line <= c.lines; line++)
		check_block(&recorder, line, &c.path[line], strbuf_text(&c.text));
	strbuf_release(&c.text);
	case_release(&g);
}

START_TEST(every_place_is_covered)
{
	long cases = random_cases(20000);

	for (long number = 0; number < cases; number++)
		run_case(number, number % 2);
}
END_TEST

/* Fanuc B-64484EN and Haas, "G31": it is not modal, and its block may be one of G91. */
START_TEST(skip)
{
	const struct dialect *const dialects[] = {&dialect_fanuc, &dialect_haas};

	for (int i = 0; i < 2; i++) {
		struct gcode_case c;

		case_init(&c);
		c.config.dialect = dialects[i];
		case_expect(&c, "G90 G1 Z4. F9.\nG31 Z-2.\nZ5.\nG91 G31 Z-1. P1\nG90 Z5.\nM30\n",
			    "feed 0 0 4 0 0\nfeed 0 0 -2 0 0\nfeed 0 0 5 0 0\nfeed 0 0 4 0 0\nfeed 0 0 5 0 0\n");
	}
}
END_TEST

/* A program that retracts the probe along its way is followed as it is written, and no more is proved than can be. */
START_TEST(no_more_than_needed)
{
	expect_moves("G0 Z40 F9\nG38.2 Z-20\nG0 Z50\nX1\n", "rapid 0 0 40 0 0\nfeed 0 0 -20 0 0\nrapid 0 0 50 0 0\nrapid 1 0 50 0 0\n");
	expect_moves("G0 Z40 F9\nG38.2 X3 Z-20\nG0 X0 Z40\n", "rapid 0 0 40 0 0\nfeed 3 0 -20 0 0\nrapid 0 0 40 0 0\n");
	/* By an increment, all possible moves: up to 10 above the start. */
	expect_moves("G0 Z40 F9\nG38.2 Z-20\nG91 G0 Z10\n", "rapid 0 0 40 0 0\nfeed 0 0 -20 0 0\nrapid 0 0 50 0 0\n");
	/* Beside others from the middle. */
	expect_moves("G0 Z40 F9\nG38.2 Z-20\nG0 X7\nG53 Z1\n",
		     "rapid 0 0 40 0 0\nfeed 0 0 -20 0 0\nrapid 0 0 10 0 0\nrapid 7 0 10 0 0\n"
		     "rapid 7 0 -20 0 0\nrapid 7 0 40 0 0\nrapid 7 0 1 0 0\n");
	/* A tool change there is checked at all positions. */
	expect_moves("T1 G0 Z40 F9\nG38.2 Z-20\nM6\nG0 Z50\n",
		     "rapid 0 0 40 0 0\nfeed 0 0 -20 0 0\ntool 1\nrapid 0 0 -20 0 0\nrapid 0 0 40 0 0\nrapid 0 0 -20 0 0\n"
		     "rapid 0 0 50 0 0\n");
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("probe");

	tcase_add_test(tcase, every_place_is_covered);
	tcase_add_test(tcase, skip);
	tcase_add_test(tcase, no_more_than_needed);
	return run_suite("gcode_probe", tcase);
}
