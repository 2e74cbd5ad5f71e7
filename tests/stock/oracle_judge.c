#include "oracle_judge.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define POINTS 4000
#define STOCK_ERROR 0.1	/* mm: --stock-tolerance */
#define SLACK 0.004	/* mm: distances over a motion are told apart by so much */
#define CONTACTS 2	/* of a job that are looked at */
#define SAMPLES 3000	/* points that are tried to confirm a contact that is certain */

/* ----------------------------------------------------------------- motion */

/* A move, as a point of the workholding sees it. */
struct motion {
	const struct tool *tool;
	const struct move *move;
	double from[4];
	const double *point;
	double until;	/* the share at which it stops */
	bool beside;	/* as far beside its path as it may have gone; else exact */
	double speed;	/* mm: the point moves no farther over the whole move, as the tool sees it */
};

static double length3(const double v[3])
{
	return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

static double speed_of(const struct move *m, const double from[4], const double point[3])
{
	const double way[3] = {m->to[0] - from[0], m->to[1] - from[1], m->to[2] - from[2]};
	const double turn = fabs(m->to[3] - from[3]) * acos(-1) / 180;
	double start[3], end[3], along[3];

	if (m->way == ARC)
		return hypot(way[2], fabs(m->sweep) * (0.01 + hypot(from[0] - m->centre[0], from[1] - m->centre[1])));
	if (m->way == STRAIGHT)
		return length3(way) + turn * length3(point);
	job_to_work(from, from[3], start);
	job_to_work(m->to, m->to[3], end);
	for (int i = 0; i < 3; i++)
		along[i] = end[i] - start[i];
	return length3(along) + turn * (length3(point) + fmax(length3(start), length3(end)));
}

static struct motion motion_of(const struct job *job, int move, const double point[3], bool beside)
{
	const struct move *m = &job->moves[move];
	struct motion motion = {&job->tools[m->tool], m, {0}, point, m->bounded ? m->stop : 1, beside, 0};

	job_start(job, move, motion.from);
	motion.speed = motion.until * speed_of(m, motion.from, point);
	return motion;
}

static bool moves(const struct motion *motion)
{
	return motion->move->way == ARC || memcmp(motion->from, motion->move->to, sizeof(motion->from)) != 0;
}

/* The point as the tool sees it: radius from its axis and height over its tip. */
static void seen_by_tool(const double p[3], const double q[4], double *r, double *z)
{
	const double b = q[3] * acos(-1) / 180, x = cos(b) * p[0] + sin(b) * p[2], h = -sin(b) * p[0] + cos(b) * p[2];

	*r = hypot(x - q[0], p[1] - q[1]);
	*z = h - q[2];
}

/*
 * The first share of the move from `low` to `high`, to SLACK mm of way, at which the distance of the point to the piece
 * is below `level`; INFINITY: it never is. What happens between is bounded by the speed.
 */
static double first_below(const struct motion *motion, enum piece piece, double level, double low, double high)
{
	const double middle = 0.5 * (low + high), reach = 0.5 * (high - low) * motion->speed;
	double q[4], r, z, distance, found;

	job_place(motion->move, motion->from, motion->until * middle, q);
	for (int i = 0; i < 3 && motion->beside; i++)
		q[i] += motion->move->off[i];
	seen_by_tool(motion->point, q, &r, &z);
	distance = tool_least_distance(motion->tool, piece, r, z);
	if (distance - reach >= level)
		return INFINITY;
	distance = tool_distance(motion->tool, piece, r, z);
	if (distance - reach >= level)
		return INFINITY;
	if (reach < SLACK)
		return distance < level ? low : INFINITY;
	found = first_below(motion, piece, level, low, middle);
	return isinf(found) ? first_below(motion, piece, level, middle, high) : found;
}

static bool cuts(const struct move *m)
{
	return !m->rapid && m->turning && !m->tool;
}

/* How deep may the piece be in the stock in this move? INFINITY: it cuts. */
static double allowed_depth(const struct job *job, const struct move *m, enum piece piece)
{
	if (piece != CUTTER)
		return 0;
	return m->rapid || !m->turning ? job->allowance : INFINITY;
}

/* The first share of the move before `end` at which something is deeper at the point than is allowed, by `beyond`. */
static double first_violation(const struct job *job, const struct move *m, const struct motion *motion, double beyond,
			      double end)
{
	double first = INFINITY;

	for (int i = 0; i < PIECES; i++) {
		const double depth = allowed_depth(job, m, (enum piece)i);

		if (!isinf(depth))
			first = fmin(first, first_below(motion, (enum piece)i, -depth - beyond, 0, end));
	}
	return first;
}

/* ----------------------------------------------------------------- points */

/* A point that only the probe reaches, deeper in it than is allowed. False: it is not, or not in the blank. */
static bool probed_point(const struct job *job, struct oracle_random *random, const struct move *m, double p[3])
{
	const struct tool *tool = &job->tools[m->tool];
	const double *q = m->to, b = q[3] * acos(-1) / 180, skin = m->tool ? 0.12 : 0.35;
	const bool ground = uniform(random, 0, 1) < 0.3;
	const double z = ground ? job->allowance + uniform(random, 0, skin)
				: tool->length[CUTTER] * pow(uniform(random, 0, 1), m->tool ? 1 : 2);
	const double here = tool_radius_at(tool, CUTTER, z);
	const double r = ground ? here * sqrt(uniform(random, 0, 1)) : here - job->allowance - uniform(random, 0, skin);
	const double ahead = atan2(q[1] - m->wall[1], q[0] - m->wall[0]);
	const double around = ground ? uniform(random, 0, 2 * acos(-1)) : ahead + uniform(random, -1, 1);
	const double x = q[0] + r * cos(around), h = q[2] + z;
	double wall_r, wall_z;

	p[0] = cos(b) * x - sin(b) * h;
	p[1] = q[1] + r * sin(around);
	p[2] = sin(b) * x + cos(b) * h;
	if (!(r > 0) || !job_in_blank(job, p, -1e-6))
		return false;
	seen_by_tool(p, m->wall, &wall_r, &wall_z);
	return tool_distance(&job->tools[0], CUTTER, wall_r, wall_z) > SLACK &&
	       tool_distance(tool, CUTTER, r, z) < -job->allowance - SLACK;
}

static void make_points(const struct job *job, struct oracle_random *random, double (*points)[3])
{
	int n = 0;

	for (int tries = 0; tries < 50 * POINTS && n < 3 * POINTS / 4; tries++) {
		const struct move *m = &job->moves[(int)uniform(random, 0, job->count)];

		n += m->probe && probed_point(job, random, m, points[n]);
	}
	for (; n < POINTS; n++) {
		double inside[3];

		for (int k = 0; k < 3; k++)
			inside[k] = uniform(random, -0.5, 0.5) * job->size[k];
		job_from_blank(job, inside, points[n]);
	}
}

/* Marks the moves in which the point violates before any cutter can have removed it. */
static void find_violations(const struct job *job, const double point[3], bool *violated)
{
	for (int i = 0; i < job->count; i++) {
		const struct move *m = &job->moves[i];
		const struct motion motion = motion_of(job, i, point, true);
		double gone = INFINITY;

		/* A block without motion says nothing again. */
		if (!moves(&motion))
			continue;
		if (cuts(m))
			gone = first_below(&motion, CUTTER, SLACK, 0, 1);
		violated[i] = violated[i] || first_violation(job, m, &motion, SLACK, fmin(gone, 1)) <= 1;
		if (gone <= 1)
			return;
	}
}

/* mm: what is left is known so exactly. */
static double error_of(const struct job *job)
{
	return STOCK_ERROR + 1.75 * job->tolerance;
}

/* Has no cutter that is smaller by the error surely removed the point before this share of the move? */
static bool is_left(const struct job *job, const double point[3], int move, double share)
{
	for (int i = 0; i <= move; i++) {
		const struct move *m = &job->moves[i];
		const struct motion motion = motion_of(job, i, point, false);

		if (cuts(m) && !m->bounded && !(i > 0 && m[-1].bounded) &&
		    first_below(&motion, CUTTER, -error_of(job) - SLACK, 0, i < move ? 1 : share) <= 1)
			return false;
	}
	return true;
}

/* ---------------------------------------------------------------- verdict */

struct contact {
	int move;	/* from 0 */
	bool certain;
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
static void take_finding(const struct job *job, int first, const char *line, struct found *found)
{
	static const char *const axes[] = {"\"X\":", "\"Y\":", "\"Z\":", "\"B\":"};
	const int number = (int)number_after(line, "\"line\":");
	const char *point = strstr(line, "\"point\":[");
	struct contact *contact;
	int move = first;

	while (move < job->count && job->moves[move].line != number)
		move++;
	if (!point || move == job->count)
		return;
	found->moves[move] = true;
	if (found->count++ >= CONTACTS || !strstr(line, "\"fraction\":"))
		return;
	contact = &found->contacts[found->count - 1];
	contact->move = move;
	contact->certain = strstr(line, "\"certain\":true") != NULL;
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
static bool ask(const struct job *job, const char *program, const char *folder, bool second, struct found *found)
{
	const char *more = second ? "2" : "", *last = second || !job->split ? "" : "--stock-out=rest.stl";
	char command[8192], line[65536];
	bool complete = false;
	FILE *in;

	snprintf(command, sizeof(command), "cd '%s' && '%s' -q -a %s -f ndjson -s s%s.xml m.xml p%s.nc", folder, program, last,
		 more, more);
	in = popen(command, "r");
	while (in && fgets(line, sizeof(line), in)) {
		if (strstr(line, "\"verdict\":\"clear\"") || strstr(line, "\"verdict\":\"found\""))
			complete = true;
		take_finding(job, second ? job->split : 0, line, found);
	}
	return in && pclose(in) != -1 && complete;
}

/* Is a piece that must not be there within `reach` mm of the point? */
static bool is_near(const struct job *job, const struct contact *found, const double point[3], double reach)
{
	const struct move *m = &job->moves[found->move];
	double r, z;

	seen_by_tool(point, found->q, &r, &z);
	for (int i = 0; i < PIECES; i++) {
		const double depth = allowed_depth(job, m, (enum piece)i);

		if (!isinf(depth) && tool_distance(&job->tools[m->tool], (enum piece)i, r, z) < reach - depth)
			return true;
	}
	return false;
}

/* Is there, near the reported contact, a point of what may be left that is near enough to a body? */
static bool is_true(const struct job *job, const struct contact *found)
{
	const double b = found->q[3] * acos(-1) / 180, reach = error_of(job);

	for (int n = 0; n < 729; n++) {
		const double m0 = found->point[0] + reach * (n % 9 - 4) / 4;
		const double m1 = found->point[1] + reach * (n / 9 % 9 - 4) / 4;
		const double m2 = found->point[2] + reach * (n / 81 - 4) / 4;
		/* From the machine to the stock. */
		const double p[3] = {cos(b) * m0 - sin(b) * m2, m1, sin(b) * m0 + cos(b) * m2};

		if (job_in_blank(job, p, reach) && is_near(job, found, p, reach) &&
		    is_left(job, p, found->move, found->fraction))
			return true;
	}
	return false;
}

/* Is there a point near the contact that no cutter has removed and that violates in its move? Found by chance. */
static bool is_confirmed(const struct job *job, struct oracle_random *random, const struct contact *found)
{
	const double b = found->q[3] * acos(-1) / 180;

	for (int n = 0; n < SAMPLES; n++) {
		const double reach = n % 3 == 0 ? 0.5 : n % 3 == 1 ? 3 : 12;
		bool violated[MOVES] = {false};
		double m[3], p[3];

		for (int k = 0; k < 3; k++)
			m[k] = found->point[k] + uniform(random, -reach, reach);
		/* From the machine to the stock. */
		p[0] = cos(b) * m[0] - sin(b) * m[2];
		p[1] = m[1];
		p[2] = sin(b) * m[0] + cos(b) * m[2];
		if (!job_in_blank(job, p, -1e-6))
			continue;
		find_violations(job, p, violated);
		if (violated[found->move])
			return true;
	}
	return false;
}

/*
 * Is a finding there to be held against points? Not of the feeler, whose stem is left out here, nor with the cubes of
 * a second blank, nor where the way is known as a set only: how far beside its middle it may go counts in every
 * direction.
 */
static bool is_exact(const struct job *job, int move)
{
	const struct move *m = &job->moves[move];

	return !m->tool && !(job->split && move >= job->split) && !m->bounded && !(move > 0 && m[-1].bounded);
}

static void judge_contacts(const struct job *job, struct oracle_random *random, const struct found *found,
			   const bool *violated, long seed, struct judgement *sum)
{
	for (int i = 0; i < found->count && i < CONTACTS; i++) {
		const struct contact *contact = &found->contacts[i];

		if (contact->certain) {
			sum->certain++;
			sum->confirmed += violated[contact->move] || is_confirmed(job, random, contact);
		}
		if (is_exact(job, contact->move) && !is_true(job, contact)) {
			printf("job %ld: false in line %d\n", seed, job->moves[contact->move].line);
			sum->wrong++;
		}
	}
}

void judgement_add(struct judgement *sum, const struct judgement *some)
{
	int *to = (int *)sum;
	const int *from = (const int *)some;

	for (size_t i = 0; i < sizeof(*sum) / sizeof(*to); i++)
		to[i] += from[i];
}

/* What the job has. */
static void count(const struct job *job, struct judgement *sum)
{
	bool arcs = false, bounded = false;

	for (int i = 0; i < job->count; i++) {
		arcs |= job->moves[i].way == ARC;
		bounded |= job->moves[i].bounded;
	}
	judgement_add(sum, &(struct judgement){.jobs = 1,
					       .arcs = arcs,
					       .guided = job->guided,
					       .tolerant = job->tolerance > 0,
					       .bounded = bounded,
					       .split = job->split > 0,
					       .undercut = job->tools[0].tip == UNDERCUT});
}

void judge(struct job *job, struct oracle_random *random, const char *program, const char *folder, long seed,
	   struct judgement *sum)
{
	static double points[POINTS][3];
	bool violated[MOVES] = {false};
	struct found found = {.count = 0};
	char path[4096];

	count(job, sum);
	make_points(job, random, points);
	job_write(job, folder);
	snprintf(path, sizeof(path), "%s/rest.stl", folder);
	/* Where nothing remains there is no second blank. */
	if (!ask(job, program, folder, false, &found) ||
	    (job->split && access(path, R_OK) == 0 && !ask(job, program, folder, true, &found))) {
		printf("job %ld: fivecheck failed\n", seed);
		sum->failed++;
		return;
	}
	for (int i = 0; i < POINTS; i++)
		find_violations(job, points[i], violated);
	for (int i = 0; i < job->count; i++) {
		sum->violated += violated[i];
		sum->found += found.moves[i];
		if (violated[i] && !found.moves[i]) {
			printf("job %ld: missed in line %d of %s\n", seed, job->moves[i].line,
			       job->split && i >= job->split ? "p2.nc" : "p.nc");
			sum->missed++;
		}
	}
	judge_contacts(job, random, &found, violated, seed, sum);
}
