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
 *     inside the shank or the holder, or deep in the cutter at rapid, and fivecheck finds nothing in that block;
 * false: near a contact that fivecheck reports there is no point that a cutter smaller by STOCK_ERROR has left and
 *     that is as near as that to the body.
 *
 * An error is small, and so is its place. So after most cuts the cutter goes back at rapid and is pushed into the new
 * wall, to about the depth that is allowed; at the end a feeler, a small ball on a thin stem, does the same in many
 * places. Most points lie where only these pushes reach.
 *
 * The machine moves the tool by X, Y and Z and turns the stock by B about the Y axis. Exit status 1: something was missed
 * or false; its files stay in FOLDER.
 */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define POINTS 4000
#define INSTANT 0.05	/* mm: no point moves farther between two instants */
#define STOCK_ERROR 0.1	/* mm: --stock-tolerance */
#define MOVES 500
#define LAST_CUT 24	/* moves besides probes */
#define PROBES 4	/* after a cut */
#define FEELS 30	/* pushes of the feeler */
#define FEELER_MIN 0.1	/* mm: its radius less what is allowed */
#define FEELER_MAX 0.4
#define ABOVE 30	/* mm: over all of the stock */
#define CONTACTS 2	/* of a job that are looked at */
#define OUTLINE 600

enum piece { HOLDER, SHANK, CUTTER, PIECES };
enum tip { FLAT, BALL, BULL, CONE, UNDERCUT, TIPS };	/* of the first tool; the second is the feeler */

/* Radii by height over the tip, in steps. */
struct tool {
	double length[PIECES], radius[PIECES], neck, corner;
	enum tip tip;
};

struct move {
	bool rapid, turning;
	int tool;	/* 0, 1 */
	bool probe;	/* pushes into the wall that the cutter leaves where it stands at `wall` */
	double wall[4];
	double to[4];	/* X Y Z B */
};

struct job {
	double size[3];
	double allowance;	/* mm: of a cutter at rapid */
	struct tool tools[2];
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
	t->length[CUTTER] = rounded(uniform(1.2, 4) * t->radius[CUTTER]);
	t->corner = rounded(uniform(0.2, 0.9) * t->radius[CUTTER]);
	t->neck = rounded(uniform(0.4, 0.8) * t->radius[CUTTER]);
	/* Often as wide as the slots that it has to go through, but for a little. */
	t->radius[SHANK] = rounded(uniform(0, 1) < 0.5 ? t->radius[CUTTER] + uniform(-0.3, 0.3)
						       : uniform(0.5, 1.2) * t->radius[CUTTER]);
	t->length[SHANK] = rounded(uniform(4, 12));
	t->radius[HOLDER] = rounded(uniform(6, 14));
	t->length[HOLDER] = 100 - t->length[CUTTER] - t->length[SHANK];
}

/* The next move, from where the axes stand. */
static struct move *add_move(struct job *job, const double at[4], bool rapid, bool turning)
{
	struct move *m = &job->moves[job->count++];

	*m = (struct move){.rapid = rapid, .turning = turning};
	memcpy(m->to, at, sizeof(m->to));
	return m;
}

static void place(const double from[4], const double to[4], double s, double q[4])
{
	for (int i = 0; i < 4; i++)
		q[i] = from[i] + s * (to[i] - from[i]);
}

/* A share of a cut. It often comes from the air, so its end is where most is to be seen. */
static double somewhere(void)
{
	return uniform(0, 1) < 0.5 ? 1 : uniform(0, 1);
}

/* Pushes from `at` by a vector of this length, and goes back; it leads about `around` and `down`. */
static void add_push(struct job *job, const double at[4], const double wall[4], double length, double around,
		     double down)
{
	struct move *m = add_move(job, at, true, true);

	m->probe = true;
	memcpy(m->wall, wall, sizeof(m->wall));
	m->to[0] = rounded(at[0] + length * cos(down) * cos(around));
	m->to[1] = rounded(at[1] + length * cos(down) * sin(around));
	m->to[2] = rounded(at[2] - length * sin(down));
	add_move(job, at, true, true);
}

/* Back along the cut that ends at `at` to some place, from there into the wall or the ground, and back again. */
static void add_probes(struct job *job, const double from[4], double at[4])
{
	for (int count = (int)uniform(1, PROBES + 1); count > 0; count--) {
		const double depth = job->allowance + uniform(-0.05, 0.3), around = uniform(0, 2 * acos(-1));

		place(from, at, somewhere(), at);
		for (int k = 0; k < 4; k++)
			at[k] = rounded(at[k]);
		add_move(job, at, true, true);
		add_push(job, at, at, depth, around, uniform(0, 1) < 0.3 ? uniform(0, 0.5 * acos(-1)) : 0);
	}
}

/* From above to a place on a cut, and from there with the feeler into its wall. */
static void add_feel(struct job *job, const double from[4], const double to[4])
{
	const struct tool *cutter = &job->tools[0];
	const double z = cutter->length[CUTTER] * pow(uniform(0, 1), 2), around = uniform(0, 2 * acos(-1));
	const double radius = radius_at(cutter, CUTTER, z);
	const double turn = atan2(radius_at(cutter, CUTTER, z + 1e-3) - radius, 1e-3), down = turn > 0 ? turn : 0;
	const double over = job->allowance + uniform(-0.05, 0.25) - job->tools[1].radius[CUTTER];
	const int first = job->count;
	double wall[4], at[4];

	place(from, to, somewhere(), wall);
	for (int k = 0; k < 4; k++)
		at[k] = wall[k] = rounded(wall[k]);
	at[2] = ABOVE;
	add_move(job, at, true, true);
	/* So that the feeler comes to stand `over` before the wall, level with it. */
	at[2] = rounded(wall[2] + z - job->tools[1].radius[CUTTER] - over * sin(down));
	add_move(job, at, true, true);
	add_push(job, at, wall, radius + over * cos(down), around, 0);
	at[2] = ABOVE;
	add_move(job, at, true, true);
	for (int i = first; i < job->count; i++)
		job->moves[i].tool = 1;
}

static void add_feels(struct job *job)
{
	const int cuts = job->count;
	double at[4];

	memcpy(at, job->moves[cuts - 1].to, sizeof(at));
	at[2] = ABOVE;
	add_move(job, at, true, true);
	for (int tries = 0, count = 0; tries < 20 * FEELS && count < FEELS; tries++) {
		const int i = (int)uniform(1, cuts);

		if (job->moves[i].rapid || !job->moves[i].turning)
			continue;
		add_feel(job, job->moves[i - 1].to, job->moves[i].to);
		count++;
	}
}

static void make_job(struct job *job)
{
	const bool turned = uniform(0, 1) < 0.4;
	double at[4] = {0, 0, 80, 0}, from[4], feeler;
	bool turning = true;
	int count;

	for (int i = 0; i < 3; i++)
		job->size[i] = rounded(i < 2 ? uniform(8, 24) : uniform(4, 10));
	job->allowance = uniform(0, 1) < 0.8 ? 0.1 : 0.25;
	feeler = rounded(job->allowance + uniform(FEELER_MIN, FEELER_MAX));
	make_tool(&job->tools[0]);
	job->tools[1] = (struct tool){.length = {0, 0, feeler}, .radius = {-1, -1, feeler}, .tip = BALL};
	count = (int)uniform(4, LAST_CUT);
	for (int i = 0; i < count; i++) {
		/* First across and down; then anything. */
		const double what = i == 0 ? 0.3 : i == 1 ? 0.5 : uniform(0, 1);
		const double reach = 0.5 * fmax(job->size[0], job->size[1]) + (i ? 5 : 0);
		struct move *m;

		if (uniform(0, 1) < 0.03)
			turning = !turning;
		m = add_move(job, at, what < 0.45, turning);
		if (what < 0.15) {	/* out */
			m->to[2] = rounded(job->size[2] + uniform(0.5, 4) + (turned ? 15 : 0));
		} else if (what < 0.4 && at[2] > job->size[2]) {	/* across */
			m->to[0] = rounded(uniform(-reach, reach));
			m->to[1] = rounded(uniform(-reach, reach));
			m->to[3] = turned ? rounded(uniform(-40, 40)) : 0;
		} else if (what < 0.45) {	/* anywhere, little */
			for (int k = 0; k < 3; k++)
				m->to[k] = rounded(at[k] + uniform(-1, 1));
		} else if (what < 0.6) {	/* down */
			m->to[2] = rounded(uniform(0.2, 1.1) * job->size[2]);
		} else {	/* along */
			m->to[0] = rounded(at[0] + uniform(-8, 8));
			m->to[1] = rounded(at[1] + uniform(-8, 8));
			if (turned && uniform(0, 1) < 0.3)
				m->to[3] = rounded(at[3] + uniform(-10, 10));
			if (uniform(0, 1) < 0.3)
				m->to[2] = rounded(at[2] + uniform(-1.5, 1));
		}
		memcpy(from, at, sizeof(at));
		memcpy(at, m->to, sizeof(at));
		if (what >= 0.45 && turning && uniform(0, 1) < 0.7)
			add_probes(job, from, at);
	}
	add_feels(job);
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
	const struct tool *tool = &job->tools[0];
	const double feeler = job->tools[1].length[CUTTER];
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
		"<stock box=\"%.3f %.3f %.3f\" rapid_allowance=\"%.3f\"/>\n<tool number=\"1\" length=\"100\">",
		job->size[0], job->size[1], job->size[2], job->allowance);
	fprintf(out, "<holder><section length=\"%.6f\" diameter=\"%.6f\"/></holder><shank><section length=\"%.6f\" "
		"diameter=\"%.6f\"/></shank>", tool->length[HOLDER], 2 * tool->radius[HOLDER],
		tool->length[SHANK], 2 * tool->radius[SHANK]);
	write_cutter(out, tool);
	fprintf(out, "</tool>\n<tool number=\"2\" length=\"100\" kind=\"probe\"><cutter tip=\"ball\"><section length=\"%.6f\" "
		"diameter=\"0.15\"/><section length=\"%.6f\" diameter=\"%.6f\"/></cutter></tool></setup>\n", 100 - feeler,
		feeler, 2 * feeler);
	fclose(out);
	out = create(folder, "p.nc");
	fprintf(out, "G21 G90 G94 G61 F600 S1000 M3\n");
	for (int i = 0; i < job->count; i++) {
		const struct move *m = &job->moves[i];

		if (m->tool && !m[-1].tool)
			fprintf(out, "T2 M6 ");
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

static int instants(const double from[4], const double to[4])
{
	const double way = hypot(hypot(to[0] - from[0], to[1] - from[1]), to[2] - from[2]) +
			   fabs(to[3] - from[3]) * acos(-1) / 180 * 30;

	return 1 + (int)(way / INSTANT);
}

/* Must the piece not touch stock in this move? *inset: how deep it may. */
static bool is_barred(const struct job *job, const struct move *m, enum piece piece, double *inset)
{
	*inset = piece == CUTTER ? job->allowance : 0;
	return piece != CUTTER || m->rapid || !m->turning;
}

static bool violates(const struct job *job, const struct move *m, double r, double z)
{
	const struct tool *tool = &job->tools[m->tool];

	for (int i = 0; i < PIECES; i++) {
		const enum piece piece = (enum piece)i;
		const double here = radius_at(tool, piece, z);
		double inset;

		if (here >= 0 && is_barred(job, m, piece, &inset) && r < here - inset &&
		    surface_distance(tool, piece, r, z) < -inset - 1e-6)
			return true;
	}
	return false;
}

/* The moves in which one of the points violates. */
static void find_violations(const struct job *job, double (*points)[3], bool *gone, bool *violated)
{
	const double *radius = job->tools[0].radius;
	const double widest = fmax(radius[HOLDER], fmax(radius[SHANK], radius[CUTTER])) + INSTANT;
	double at[4] = {0, 0, 80, 0};

	for (int i = 0; i < job->count; i++) {
		const struct move *m = &job->moves[i];
		const int count = instants(at, m->to);

		/* A block without motion says nothing again. */
		if (!memcmp(at, m->to, sizeof(at)))
			continue;
		for (int k = 0; k <= count; k++) {
			double q[4], c, s;

			place(at, m->to, (double)k / count, q);
			c = cos(q[3] * acos(-1) / 180);
			s = sin(q[3] * acos(-1) / 180);
			for (int n = 0; n < POINTS; n++) {
				const double *p = points[n], x = c * p[0] + s * p[2] - q[0], y = p[1] - q[1];
				const double z = -s * p[0] + c * p[2] - q[2], r2 = x * x + y * y;

				if (gone[n] || z < -INSTANT || r2 > widest * widest)
					continue;
				/* First what is cut: then the shank behind it finds less. */
				if (!m->rapid && m->turning &&
				    is_in_larger(&job->tools[0], CUTTER, sqrt(r2), z, 0.5 * INSTANT))
					gone[n] = true;
				else if (!violated[i] && violates(job, m, sqrt(r2), z))
					violated[i] = true;
			}
		}
		memcpy(at, m->to, sizeof(at));
	}
}

/* A point that only the probe reaches, deeper in it than is allowed. False: it is not, or not in the blank. */
static bool probed_point(const struct job *job, const struct move *m, double p[3])
{
	const struct tool *tool = &job->tools[m->tool];
	const double *q = m->to, b = q[3] * acos(-1) / 180, skin = job->allowance + 0.35;
	const bool ground = uniform(0, 1) < 0.3;
	const double z = ground ? uniform(0, skin) : tool->length[CUTTER] * pow(uniform(0, 1), m->tool ? 1 : 2);
	const double here = radius_at(tool, CUTTER, z);
	const double r = ground ? here * sqrt(uniform(0, 1)) : here - job->allowance - uniform(0, skin);
	const double ahead = atan2(q[1] - m->wall[1], q[0] - m->wall[0]);
	const double around = ground ? uniform(0, 2 * acos(-1)) : ahead + uniform(-1, 1);
	const double x = q[0] + r * cos(around), h = q[2] + z;
	double wall_r, wall_z;

	p[0] = cos(b) * x - sin(b) * h;
	p[1] = q[1] + r * sin(around);
	p[2] = sin(b) * x + cos(b) * h;
	if (!(r > 0) || fabs(p[0]) > 0.5 * job->size[0] || fabs(p[1]) > 0.5 * job->size[1] || p[2] < 0 ||
	    p[2] > job->size[2])
		return false;
	seen_by_tool(p, m->wall, &wall_r, &wall_z);
	return !is_in_larger(&job->tools[0], CUTTER, wall_r, wall_z, 0.5 * INSTANT) && violates(job, m, r, z);
}

static void make_points(const struct job *job, double (*points)[3])
{
	int n = 0;

	for (int tries = 0; tries < 50 * POINTS && n < 3 * POINTS / 4; tries++) {
		const struct move *m = &job->moves[(int)uniform(0, job->count)];

		n += m->probe && probed_point(job, m, points[n]);
	}
	for (; n < POINTS; n++)
		for (int k = 0; k < 3; k++)
			points[n][k] = k < 2 ? uniform(-0.5, 0.5) * job->size[k] : uniform(0, 1) * job->size[k];
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
			if (z > -1 && r <= radius_at(&job->tools[0], CUTTER, z) &&
			    surface_distance(&job->tools[0], CUTTER, r, z) < -STOCK_ERROR - INSTANT)
				return false;
		}
		memcpy(at, m->to, sizeof(at));
	}
	return true;
}

/* ---------------------------------------------------------------- verdict */

struct contact {
	int move;	/* from 0 */
	double fraction, q[4], point[3];
};

struct found {
	bool moves[MOVES];	/* in which something was found */
	int count;	/* of all findings */
	struct contact contacts[CONTACTS];	/* the first of them */
};

/* Reads one number after a key. */
static double number_after(const char *text, const char *key)
{
	const char *at = strstr(text, key);

	return at ? strtod(at + strlen(key), NULL) : NAN;
}

/* A line of the report. */
static void take_finding(const char *line, struct found *found)
{
	static const char *const axes[] = {"\"X\":", "\"Y\":", "\"Z\":", "\"B\":"};
	const int move = (int)number_after(line, "\"line\":") - 2;
	const char *point = strstr(line, "\"point\":[");
	struct contact *contact;

	if (!point || move < 0 || move >= MOVES)
		return;
	found->moves[move] = true;
	if (found->count++ >= CONTACTS || !strstr(line, "\"fraction\":"))
		return;
	contact = &found->contacts[found->count - 1];
	contact->move = move;
	contact->fraction = number_after(line, "\"fraction\":");
	for (int i = 0; i < 4; i++)
		contact->q[i] = number_after(line, axes[i]);
	point = strchr(point, '[') + 1;
	for (int i = 0; i < 3; i++) {
		char *end;

		contact->point[i] = strtod(point, &end);
		point = end + 1;
	}
}

/* False: fivecheck failed. */
static bool ask(const char *program, const char *folder, struct found *found)
{
	char command[8192], line[65536];
	bool complete = false;
	FILE *in;

	snprintf(command, sizeof(command), "%s -q -a -f ndjson -s %s/s.xml %s/m.xml %s/p.nc", program, folder, folder, folder);
	in = popen(command, "r");
	*found = (struct found){.count = 0};
	while (in && fgets(line, sizeof(line), in)) {
		if (strstr(line, "\"verdict\":\"clear\"") || strstr(line, "\"verdict\":\"found\""))
			complete = true;
		take_finding(line, found);
	}
	return in && pclose(in) != -1 && complete;
}

/* Is there, near the reported contact, a point of what may be left that is near enough to a body? */
static bool is_true(const struct job *job, const struct contact *found)
{
	const double b = found->q[3] * acos(-1) / 180, reach = STOCK_ERROR;
	const struct move *m = &job->moves[found->move];

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
			near = near || (is_barred(job, m, (enum piece)piece, &inset) &&
					surface_distance(&job->tools[m->tool], (enum piece)piece, r, z) < reach - inset);
		if (near && is_left(job, p, found->move, found->fraction))
			return true;
	}
	return false;
}

/* What is wrong with fivecheck's answers to a job. */
struct judgement {
	int missed, wrong, failed;
	int violated, found;	/* moves */
};

static void judge(const struct job *job, const char *program, const char *folder, long seed, struct judgement *sum)
{
	static double points[POINTS][3];
	bool gone[POINTS] = {false}, violated[MOVES] = {false};
	struct found found;

	make_points(job, points);
	write_job(job, folder);
	if (!ask(program, folder, &found)) {
		printf("job %ld: fivecheck failed\n", seed);
		sum->failed++;
		return;
	}
	find_violations(job, points, gone, violated);
	for (int i = 0; i < job->count; i++) {
		sum->violated += violated[i];
		sum->found += found.moves[i];
		if (violated[i] && !found.moves[i]) {
			printf("job %ld: missed in line %d\n", seed, i + 2);
			sum->missed++;
		}
	}
	for (int i = 0; i < found.count && i < CONTACTS; i++) {
		/* The stem of the feeler is left out here. */
		if (!job->moves[found.contacts[i].move].tool && !is_true(job, &found.contacts[i])) {
			printf("job %ld: false in line %d\n", seed, found.contacts[i].move + 2);
			sum->wrong++;
		}
	}
}

int main(int argc, char **argv)
{
	const int jobs = argc > 3 ? atoi(argv[3]) : 0;
	const long seed = argc > 4 ? atol(argv[4]) : 1;
	struct judgement sum = {0};
	int done = 0;

	if (argc < 4) {
		fprintf(stderr, "usage: stock_oracle FIVECHECK FOLDER JOBS [SEED]\n");
		return 2;
	}
	setvbuf(stdout, NULL, _IOLBF, 0);
	while (done < jobs && !(sum.missed || sum.wrong || sum.failed)) {
		struct job job = {0};

		state = (unsigned long long)(seed + done) * 2654435761ULL + 12345;
		uniform(0, 1);
		make_job(&job);
		judge(&job, argv[1], argv[2], seed + done, &sum);
		done++;
	}
	printf("stock_oracle: %d jobs from seed %ld; of their moves %d violate and %d are found: %d missed, %d false, "
	       "%d failed\n", done, seed, sum.violated, sum.found, sum.missed, sum.wrong, sum.failed);
	return sum.missed || sum.wrong || sum.failed;
}
