/*
 * stock_oracle.c - random jobs with stock, checked by fivecheck and by brute force.
 *
 *     stock_oracle FIVECHECK FOLDER JOBS [SEED]
 *
 * The brute force shares no code with fivecheck. It takes points of the blank and many instants of each move, and asks of
 * each point whether it was inside the cutter and whether it is inside something that must not touch it. Two questions
 * for each job:
 *
 * missed: a point that no cutter can have removed (one that is larger by what the tool moves between two instants) is
 *     inside the shank or the holder, or deep in the cutter at rapid, and fivecheck goes on past that block;
 * false: near the contact that fivecheck reports there is no point that a cutter smaller by STOCK_ERROR has left and
 *     that is as near as that to the body.
 *
 * The machine moves the tool by X, Y and Z and turns the stock by B about the Y axis. Exit status 1: something was missed
 * or false; its files stay in FOLDER.
 */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define POINTS 2500
#define INSTANT 0.08	/* mm: no point moves farther between two instants */
#define STOCK_ERROR 0.1	/* mm: --stock-tolerance */
#define ALLOWANCE 0.25	/* mm: of a cutter at rapid */
#define MOVES 24
#define OUTLINE 600

enum piece { HOLDER, SHANK, CUTTER, PIECES };
enum tip { FLAT, BALL, BULL, CONE, UNDERCUT, TIPS };

/* Radii by height over the tip, in steps. */
struct tool {
	double length[PIECES], radius[PIECES], neck, corner;
	enum tip tip;
};

struct move {
	bool rapid, turning;
	double to[4];	/* X Y Z B */
};

struct job {
	double size[3];
	struct tool tool;
	struct move moves[MOVES];
	int count;
};

static unsigned long long state;

static double uniform(double low, double high)
{
	state = state * 6364136223846793005ULL + 1442695040888963407ULL;
	return low + (high - low) * (double)(state >> 11) / 9007199254740992.0;
}

/* Written with so many digits, so that both sides have the same numbers. */
static double rounded(double x)
{
	return round(x * 1000) / 1000;
}

/* ------------------------------------------------------------------ tools */

static double bottom_of(const struct tool *t, enum piece piece)
{
	double z = 0;

	for (int i = CUTTER; i > (int)piece; i--)
		z += t->length[i];
	return z;
}

/* The radius of a piece at a height over the tip; negative: it is not there. */
static double radius_at(const struct tool *t, enum piece piece, double z)
{
	const double r = t->radius[piece], low = bottom_of(t, piece);

	if (z < low || z > low + t->length[piece])
		return -1;
	if (piece != CUTTER || t->tip == FLAT)
		return r;
	if (t->tip == CONE)
		return z < r ? z : r;	/* 90 degrees */
	if (t->tip == UNDERCUT && z > 0.5 * t->length[CUTTER])
		return t->neck;
	if (t->tip == BULL || t->tip == BALL) {
		const double c = t->tip == BALL ? r : t->corner;

		return z < c ? r - c + sqrt(fmax(c * c - (c - z) * (c - z), 0)) : r;
	}
	return r;
}

/* Distance to the piece's surface by its outline in many points; negative inside. Good to `error` above. */
static double surface_distance(const struct tool *t, enum piece piece, double r, double z)
{
	const double low = bottom_of(t, piece), high = low + t->length[piece];
	const double here = radius_at(t, piece, z);
	double best = 1e9, last = 0;

	for (int i = 0; i <= OUTLINE; i++) {
		const double at = low + (high - low) * i / OUTLINE, edge = fmax(radius_at(t, piece, at), 0);
		/* The outline goes level from the last radius to this one. */
		const double from = i ? fmin(last, edge) : 0, to = i ? fmax(last, edge) : edge;
		const double dr = r < from ? from - r : r > to ? r - to : 0;

		best = fmin(best, hypot(dr, z - at));
		if (i == OUTLINE)
			best = fmin(best, hypot(r > edge ? r - edge : 0, z - at));
		last = edge;
	}
	return here >= 0 && r <= here ? -best : best;
}

/* Is the point in the piece, made larger by `margin` in radius and height? */
static bool is_in_larger(const struct tool *t, enum piece piece, double r, double z, double margin)
{
	for (int i = -4; i <= 4; i++) {
		const double here = radius_at(t, piece, z + margin * i / 4);

		if (here >= 0 && r <= here + margin)
			return true;
	}
	return false;
}

/* ------------------------------------------------------------------- jobs */

static void make_tool(struct tool *t)
{
	t->tip = (enum tip)uniform(0, TIPS);
	t->radius[CUTTER] = rounded(uniform(1.5, 4));
	t->length[CUTTER] = rounded(uniform(2, 4) * t->radius[CUTTER]);
	t->corner = rounded(uniform(0.2, 0.9) * t->radius[CUTTER]);
	t->neck = rounded(uniform(0.4, 0.8) * t->radius[CUTTER]);
	t->radius[SHANK] = rounded(uniform(0.5, 1.2) * t->radius[CUTTER]);
	t->length[SHANK] = rounded(uniform(4, 12));
	t->radius[HOLDER] = rounded(uniform(6, 14));
	t->length[HOLDER] = 100 - t->length[CUTTER] - t->length[SHANK];
}

static void make_job(struct job *job)
{
	bool turning = true, turned = uniform(0, 1) < 0.4;
	double at[4] = {0, 0, 80, 0};

	for (int i = 0; i < 3; i++)
		job->size[i] = rounded(i < 2 ? uniform(8, 24) : uniform(4, 10));
	make_tool(&job->tool);
	job->count = (int)uniform(4, MOVES);
	for (int i = 0; i < job->count; i++) {
		struct move *m = &job->moves[i];
		const double what = uniform(0, 1), reach = 0.5 * fmax(job->size[0], job->size[1]) + 5;

		if (uniform(0, 1) < 0.03)
			turning = !turning;
		m->rapid = what < 0.55;
		m->turning = turning;
		memcpy(m->to, at, sizeof(at));
		if (what < 0.25) {	/* out */
			m->to[2] = rounded(job->size[2] + uniform(0.5, 4) + (turned ? 15 : 0));
		} else if (what < 0.5 && at[2] > job->size[2]) {	/* across */
			m->to[0] = rounded(uniform(-reach, reach));
			m->to[1] = rounded(uniform(-reach, reach));
			m->to[3] = turned ? rounded(uniform(-40, 40)) : 0;
		} else if (what < 0.55) {	/* anywhere, little */
			for (int k = 0; k < 3; k++)
				m->to[k] = rounded(at[k] + uniform(-1, 1));
		} else if (what < 0.7) {	/* down */
			m->to[2] = rounded(uniform(0.2, 1.1) * job->size[2]);
		} else {	/* along */
			m->to[0] = rounded(at[0] + uniform(-8, 8));
			m->to[1] = rounded(at[1] + uniform(-8, 8));
			if (turned && uniform(0, 1) < 0.3)
				m->to[3] = rounded(at[3] + uniform(-10, 10));
			if (uniform(0, 1) < 0.3)
				m->to[2] = rounded(at[2] + uniform(-1.5, 1));
		}
		memcpy(at, m->to, sizeof(at));
	}
}

static FILE *create(const char *folder, const char *name)
{
	char path[4096];
	FILE *out;

	snprintf(path, sizeof(path), "%s/%s", folder, name);
	out = fopen(path, "w");
	if (!out) {
		perror(path);
		exit(2);
	}
	return out;
}

static void write_cutter(FILE *out, const struct tool *t)
{
	static const char *const tips[] = {"flat", "ball", "bull", "cone", "flat"};
	const double d = 2 * t->radius[CUTTER], half = 0.5 * t->length[CUTTER];

	fprintf(out, "<cutter tip=\"%s\"", tips[t->tip]);
	if (t->tip == BULL)
		fprintf(out, " corner=\"%.3f\"", t->corner);
	if (t->tip == CONE)
		fprintf(out, " angle=\"90\"");
	fprintf(out, ">");
	if (t->tip == UNDERCUT)
		fprintf(out, "<section length=\"%.6f\" diameter=\"%.6f\"/><section length=\"%.6f\" diameter=\"%.6f\"/>", half,
			2 * t->neck, half, d);
	else
		fprintf(out, "<section length=\"%.6f\" diameter=\"%.6f\"/>", t->length[CUTTER], d);
	fprintf(out, "</cutter>");
}

static void write_job(const struct job *job, const char *folder)
{
	FILE *out = create(folder, "m.xml");

	fprintf(out, "<machine version=\"1\" name=\"oracle\" units=\"mm\"><controller dialect=\"linuxcnc\" rapid=\"linear\"/><base>\n");
	for (int i = 0; i < 3; i++)
		fprintf(out, "<axis name=\"%c\" type=\"linear\" direction=\"%d %d %d\" limit_min=\"-500\" limit_max=\"500\" "
			"rate_max=\"6000\"%s>", "XYZ"[i], i == 0, i == 1, i == 2, i == 2 ? " home=\"80\"" : "");
	fprintf(out, "<spindle location=\"0 0 100\" direction=\"0 0 -1\"/></axis></axis></axis>\n<axis name=\"B\" "
		"type=\"rotary\" direction=\"0 1 0\" location=\"0 0 0\" limit_min=\"-180\" limit_max=\"180\" "
		"rate_max=\"3600\"><workholding location=\"0 0 0\"/></axis></base></machine>\n");
	fclose(out);
	out = create(folder, "s.xml");
	fprintf(out, "<setup version=\"1\" units=\"mm\" initial_tool=\"1\">\n<work_offset name=\"G54\"/>\n"
		"<stock box=\"%.3f %.3f %.3f\"/>\n<tool number=\"1\" length=\"100\">", job->size[0], job->size[1],
		job->size[2]);
	fprintf(out, "<holder><section length=\"%.6f\" diameter=\"%.6f\"/></holder><shank><section length=\"%.6f\" "
		"diameter=\"%.6f\"/></shank>", job->tool.length[HOLDER], 2 * job->tool.radius[HOLDER],
		job->tool.length[SHANK], 2 * job->tool.radius[SHANK]);
	write_cutter(out, &job->tool);
	fprintf(out, "</tool></setup>\n");
	fclose(out);
	out = create(folder, "p.nc");
	fprintf(out, "G21 G90 G94 G61 F600 S1000 M3\n");
	for (int i = 0; i < job->count; i++) {
		const struct move *m = &job->moves[i];

		fprintf(out, "G%d X%.3f Y%.3f Z%.3f B%.3f %s\n", !m->rapid, m->to[0], m->to[1], m->to[2], m->to[3],
			m->turning ? "M3" : "M5");
	}
	fclose(out);
}

/* ------------------------------------------------------------ brute force */

/* The stock's point as the tool sees it: radius from its axis and height over its tip. */
static void seen_by_tool(const double p[3], const double q[4], double *r, double *z)
{
	const double b = q[3] * acos(-1) / 180, x = cos(b) * p[0] + sin(b) * p[2], h = -sin(b) * p[0] + cos(b) * p[2];

	*r = hypot(x - q[0], p[1] - q[1]);
	*z = h - q[2];
}

static void place(const double from[4], const double to[4], double s, double q[4])
{
	for (int i = 0; i < 4; i++)
		q[i] = from[i] + s * (to[i] - from[i]);
}

static int instants(const double from[4], const double to[4])
{
	const double way = hypot(hypot(to[0] - from[0], to[1] - from[1]), to[2] - from[2]) +
			   fabs(to[3] - from[3]) * acos(-1) / 180 * 30;

	return 1 + (int)(way / INSTANT);
}

/* Must the piece not touch stock in this move? *inset: how deep it may. */
static bool is_barred(const struct move *m, enum piece piece, double *inset)
{
	*inset = piece == CUTTER ? ALLOWANCE : 0;
	return piece != CUTTER || m->rapid || !m->turning;
}

/* The first move in which one of the points violates, from 0; the number of moves: none does. */
static int first_violation(const struct job *job, double (*points)[3], bool *gone)
{
	double at[4] = {0, 0, 80, 0};

	for (int i = 0; i < job->count; i++) {
		const struct move *m = &job->moves[i];
		const int count = instants(at, m->to);

		for (int k = 0; k <= count; k++) {
			double q[4];

			place(at, m->to, (double)k / count, q);
			for (int n = 0; n < POINTS; n++) {
				double r, z, inset;

				if (gone[n])
					continue;
				seen_by_tool(points[n], q, &r, &z);
				/* First what is cut: then the shank behind it finds less. */
				if (!m->rapid && m->turning && is_in_larger(&job->tool, CUTTER, r, z, 0.5 * INSTANT)) {
					gone[n] = true;
					continue;
				}
				for (int piece = 0; piece < PIECES; piece++) {
					const double here = radius_at(&job->tool, (enum piece)piece, z);

					if (here >= 0 && r < here && is_barred(m, (enum piece)piece, &inset) &&
					    surface_distance(&job->tool, (enum piece)piece, r, z) < -inset - 1e-6)
						return i;
				}
			}
		}
		memcpy(at, m->to, sizeof(at));
	}
	return job->count;
}

/* Has no cutter that is smaller by STOCK_ERROR removed the point before this share of the move? */
static bool is_left(const struct job *job, const double p[3], int move, double share)
{
	double at[4] = {0, 0, 80, 0};

	for (int i = 0; i <= move; i++) {
		const struct move *m = &job->moves[i];
		const int count = instants(at, m->to);

		for (int k = 0; k <= count && (i < move || k <= share * count) && !m->rapid && m->turning; k++) {
			double q[4], r, z;

			place(at, m->to, (double)k / count, q);
			seen_by_tool(p, q, &r, &z);
			if (z > -1 && r <= radius_at(&job->tool, CUTTER, z) &&
			    surface_distance(&job->tool, CUTTER, r, z) < -STOCK_ERROR - INSTANT)
				return false;
		}
		memcpy(at, m->to, sizeof(at));
	}
	return true;
}

/* ---------------------------------------------------------------- verdict */

struct found {
	bool any;
	int move;	/* from 0 */
	double fraction, q[4], point[3];
};

/* Reads one number after a key. */
static double number_after(const char *text, const char *key)
{
	const char *at = strstr(text, key);

	return at ? strtod(at + strlen(key), NULL) : NAN;
}

/* False: fivecheck failed. */
static bool ask(const char *program, const char *folder, struct found *found)
{
	char command[8192], line[65536];
	bool clear = false;
	FILE *in;

	snprintf(command, sizeof(command), "%s -q -f ndjson -s %s/s.xml %s/m.xml %s/p.nc", program, folder, folder, folder);
	in = popen(command, "r");
	*found = (struct found){.any = false};
	while (in && fgets(line, sizeof(line), in)) {
		const char *point = strstr(line, "\"point\":");

		if (strstr(line, "\"verdict\":\"clear\"") || strstr(line, "\"verdict\": \"clear\""))
			clear = true;
		if (found->any || !point || !strstr(line, "\"fraction\""))
			continue;
		found->any = true;
		found->move = (int)number_after(line, "\"line\":") - 2;
		found->fraction = number_after(line, "\"fraction\":");
		found->q[0] = number_after(line, "\"X\":");
		found->q[1] = number_after(line, "\"Y\":");
		found->q[2] = number_after(line, "\"Z\":");
		found->q[3] = number_after(line, "\"B\":");
		point = strchr(point, '[') + 1;
		for (int i = 0; i < 3; i++) {
			char *end;

			found->point[i] = strtod(point, &end);
			point = end + 1;
		}
	}
	return in && pclose(in) != -1 && (found->any || clear);
}

/* Is there, near the reported contact, a point of what may be left that is near enough to a body? */
static bool is_true(const struct job *job, const struct found *found)
{
	const double b = found->q[3] * acos(-1) / 180, reach = STOCK_ERROR;
	const struct move *m = &job->moves[found->move < 0 ? 0 : found->move];

	for (int n = 0; n < 729; n++) {
		const double m0 = found->point[0] + reach * (n % 9 - 4) / 4, m1 = found->point[1] + reach * (n / 9 % 9 - 4) / 4;
		const double m2 = found->point[2] + reach * (n / 81 - 4) / 4;
		/* From the machine to the stock. */
		const double p[3] = {cos(b) * m0 - sin(b) * m2, m1, sin(b) * m0 + cos(b) * m2};
		double r, z, inset;
		bool near = false;

		if (fabs(p[0]) > 0.5 * job->size[0] + reach || fabs(p[1]) > 0.5 * job->size[1] + reach || p[2] < -reach ||
		    p[2] > job->size[2] + reach)
			continue;
		seen_by_tool(p, found->q, &r, &z);
		for (int piece = 0; piece < PIECES; piece++)
			near = near || (is_barred(m, (enum piece)piece, &inset) &&
					surface_distance(&job->tool, (enum piece)piece, r, z) < reach - inset);
		if (near && is_left(job, p, found->move, found->fraction))
			return true;
	}
	return false;
}

int main(int argc, char **argv)
{
	static double points[POINTS][3];
	static bool gone[POINTS];
	int jobs = argc > 3 ? atoi(argv[3]) : 0, missed = 0, wrong = 0, failed = 0, clear = 0;
	long seed = argc > 4 ? atol(argv[4]) : 1;

	if (argc < 4) {
		fprintf(stderr, "usage: stock_oracle FIVECHECK FOLDER JOBS [SEED]\n");
		return 2;
	}
	setvbuf(stdout, NULL, _IOLBF, 0);
	for (int i = 0; i < jobs; i++) {
		struct job job = {0};
		struct found found;
		int violation;

		state = (unsigned long long)(seed + i) * 2654435761ULL + 12345;
		uniform(0, 1);
		make_job(&job);
		for (int n = 0; n < POINTS; n++) {
			gone[n] = false;
			for (int k = 0; k < 3; k++)
				points[n][k] = k < 2 ? uniform(-0.5, 0.5) * job.size[k] : uniform(0, 1) * job.size[k];
		}
		write_job(&job, argv[2]);
		if (!ask(argv[1], argv[2], &found)) {
			printf("job %ld: fivecheck failed\n", seed + i);
			failed++;
			break;
		}
		violation = first_violation(&job, points, gone);
		clear += !found.any;
		if (violation < (found.any ? found.move : job.count)) {
			printf("job %ld: missed in line %d\n", seed + i, violation + 2);
			missed++;
			break;
		}
		if (found.any && !is_true(&job, &found)) {
			printf("job %ld: false in line %d\n", seed + i, found.move + 2);
			wrong++;
			break;
		}
	}
	printf("stock_oracle: %d jobs from seed %ld, %d of them clear: %d missed, %d false, %d failed\n", jobs, seed, clear,
	       missed, wrong, failed);
	return missed + wrong + failed > 0;
}
