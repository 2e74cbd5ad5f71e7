#include "oracle_job.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define LAST_CUT 24	/* moves besides probes */
#define PROBES 4	/* after a cut */
#define FEELS 80	/* pushes of the feeler */
#define FEELER_MIN 0.05	/* mm: its radius less what is allowed */
#define FEELER_MAX 0.3
#define CHANCE_OF_SPLIT 0.15
#define ABOVE 30	/* mm: over all of the stock */

const double job_home[4] = {0, 0, 80, 0};

/* ------------------------------------------------------------------ blank */

static void turn(double v[3], int axis, double degrees)
{
	const double c = cos(degrees * acos(-1) / 180), s = sin(degrees * acos(-1) / 180);
	double *a = &v[(axis + 1) % 3], *b = &v[(axis + 2) % 3];
	const double old = *a;

	*a = c * old - s * *b;
	*b = s * old + c * *b;
}

/* Most jobs have a blank that lies anyhow: its cells then meet the walls at all angles. */
static void make_blank(struct job *job, struct oracle_random *random)
{
	const bool tilted = uniform(random, 0, 1) < 0.7;
	double half = 0;

	for (int i = 0; i < 3; i++) {
		job->size[i] = rounded(i < 2 ? uniform(random, 8, 24) : uniform(random, 4, 10));
		job->angles[i] = tilted ? rounded(uniform(random, -180, 180)) : 0;
	}
	for (int i = 0; i < 3; i++) {
		job->axes[i][i] = 1;
		for (int k = 0; k < 3; k++)
			turn(job->axes[i], k, job->angles[k]);
		half += 0.5 * job->size[i] * fabs(job->axes[i][2]);
	}
	job->top = 2 * half;
}

void job_into_blank(const struct job *job, const double point[3], double inside[3])
{
	const double off[3] = {point[0], point[1], point[2] - 0.5 * job->top};

	for (int i = 0; i < 3; i++)
		inside[i] = off[0] * job->axes[i][0] + off[1] * job->axes[i][1] + off[2] * job->axes[i][2];
}

void job_from_blank(const struct job *job, const double inside[3], double point[3])
{
	for (int k = 0; k < 3; k++)
		point[k] = inside[0] * job->axes[0][k] + inside[1] * job->axes[1][k] + inside[2] * job->axes[2][k] +
			   (k == 2 ? 0.5 * job->top : 0);
}

bool job_in_blank(const struct job *job, const double point[3], double margin)
{
	double inside[3];

	job_into_blank(job, point, inside);
	for (int i = 0; i < 3; i++)
		if (fabs(inside[i]) > 0.5 * job->size[i] + margin)
			return false;
	return true;
}

/* ------------------------------------------------------------------ moves */

void job_to_machine(const double p[3], double degrees, double at[3])
{
	const double c = cos(degrees * acos(-1) / 180), s = sin(degrees * acos(-1) / 180);

	at[0] = c * p[0] + s * p[2];
	at[1] = p[1];
	at[2] = c * p[2] - s * p[0];
}

void job_to_work(const double at[3], double degrees, double p[3])
{
	job_to_machine(at, -degrees, p);
}

void job_place(const struct move *m, const double from[4], double share, double q[4])
{
	double start[3], end[3], work[3];

	for (int i = 0; i < 4; i++)
		q[i] = from[i] + share * (m->to[i] - from[i]);
	if (m->way == ARC) {
		const double x = from[0] - m->centre[0], y = from[1] - m->centre[1];
		const double first = hypot(x, y), last = hypot(m->to[0] - m->centre[0], m->to[1] - m->centre[1]);
		const double radius = first + share * (last - first), angle = atan2(y, x) + share * m->sweep;

		q[0] = m->centre[0] + radius * cos(angle);
		q[1] = m->centre[1] + radius * sin(angle);
	} else if (m->way == GUIDED) {
		job_to_work(from, from[3], start);
		job_to_work(m->to, m->to[3], end);
		for (int i = 0; i < 3; i++)
			work[i] = start[i] + share * (end[i] - start[i]);
		job_to_machine(work, q[3], q);
	}
}

void job_start(const struct job *job, int move, double q[4])
{
	const struct move *before = &job->moves[move - 1];
	double from[4];

	if (move == 0 || move == job->split) {
		memcpy(q, job_home, 4 * sizeof(*q));
		return;
	}
	memcpy(q, before->to, 4 * sizeof(*q));
	if (!before->bounded)
		return;
	job_start(job, move - 1, from);
	job_place(before, from, before->stop, q);
}

/* The next move, from where the axes stand. */
static struct move *add_move(struct job *job, const double at[4], bool rapid, bool turning)
{
	struct move *m = &job->moves[job->count++];

	*m = (struct move){.rapid = rapid, .turning = turning, .way = job->guided ? GUIDED : STRAIGHT};
	memcpy(m->to, at, sizeof(m->to));
	return m;
}

static void place(const struct job *job, int move, double s, double q[4])
{
	double from[4];

	job_start(job, move, from);
	job_place(&job->moves[move], from, s, q);
	for (int i = 0; i < 4; i++)
		q[i] = rounded(q[i]);
}

/* A share of a cut. It often comes from the air, so its end is where most is to be seen. */
static double somewhere(struct oracle_random *random)
{
	return uniform(random, 0, 1) < 0.5 ? 1 : uniform(random, 0, 1);
}

/* mm: how much deeper than is allowed a push goes: mostly little, so that a small fault hides it. */
static double push_depth(struct oracle_random *random)
{
	return uniform(random, 0, 1) < 0.7 ? uniform(random, 0.005, 0.05) : uniform(random, -0.05, 0.3);
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
static void add_probes(struct job *job, struct oracle_random *random, double at[4])
{
	const int cut = job->count - 1;

	for (int count = (int)uniform(random, 1, PROBES + 1); count > 0; count--) {
		const double depth = job->allowance + push_depth(random), around = uniform(random, 0, 2 * acos(-1));

		place(job, cut, somewhere(random), at);
		add_move(job, at, true, true);
		add_push(job, at, at, depth, around,
			 uniform(random, 0, 1) < 0.3 ? uniform(random, 0, 0.5 * acos(-1)) : 0);
	}
}

/* From above to a place on a cut, and from there with the feeler into its wall. */
static void add_feel(struct job *job, struct oracle_random *random, int cut)
{
	const struct tool *cutter = &job->tools[0];
	const double z = cutter->length[CUTTER] * pow(uniform(random, 0, 1), 2);
	const double around = uniform(random, 0, 2 * acos(-1)), radius = tool_radius_at(cutter, CUTTER, z);
	const double slope = atan2(tool_radius_at(cutter, CUTTER, z + 1e-3) - radius, 1e-3);
	const double down = slope > 0 ? slope : 0;
	const double over = job->allowance + push_depth(random) - job->tools[1].radius[CUTTER];
	const int first = job->count;
	double wall[4], at[4];

	place(job, cut, somewhere(random), wall);
	memcpy(at, wall, sizeof(at));
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

/* A point of the blank as the machine sees it: with B at this angle. */
static void into_machine(const struct job *job, const double inside[3], double degrees, double at[3])
{
	double p[3];

	job_from_blank(job, inside, p);
	job_to_machine(p, degrees, at);
}

/* mm: of a point of the machine to the cutter that stands at q; negative inside. */
static double cutter_distance(const struct job *job, const double p[3], const double q[4])
{
	return tool_distance(&job->tools[0], CUTTER, hypot(p[0] - q[0], p[1] - q[1]), p[2] - q[2]);
}

/*
 * fivecheck takes the stock in cubes, whose edges are 0.025 mm (a quarter of the tolerance) times a power of two, and
 * whose corners lie evenly about the middle of the blank. Looks for a cube of which one corner alone is outside of the
 * cutter at q, by *beyond mm: where a faulty proof would take too much. *corner: in the machine.
 */
static bool find_corner(const struct job *job, struct oracle_random *random, const double q[4], double corner[3],
			double *beyond)
{
	const double edge = 0.025 * pow(2, floor(uniform(random, 4, 7))), most = job->tools[0].radius[CUTTER];
	double low[3], at[3];
	int outside = 0;

	for (int k = 0; k < 3; k++)
		low[k] = edge * floor(uniform(random, -0.5, 0.5) * job->size[k] / edge);
	into_machine(job, low, q[3], at);
	if (hypot(at[0] - q[0], at[1] - q[1]) > most + edge || at[2] < q[2] - edge)
		return false;
	for (int i = 0; i < 8; i++) {
		const double inside[3] = {low[0] + edge * (i & 1), low[1] + edge * (i >> 1 & 1), low[2] + edge * (i >> 2)};
		double distance;

		into_machine(job, inside, q[3], at);
		distance = cutter_distance(job, at, q);
		if (distance < 0)
			continue;
		outside++;
		*beyond = distance;
		memcpy(corner, at, sizeof(at));
	}
	return outside == 1 && *beyond > 0.05;
}

/* The same as add_feel, into such a corner. False: there is none, or not found. */
static bool add_corner_feel(struct job *job, struct oracle_random *random, int cut)
{
	const double radius = job->tools[1].radius[CUTTER], step = 1e-4;
	const int first = job->count;
	double wall[4], at[4], corner[3], beyond, normal[3];
	bool found = false;

	place(job, cut, somewhere(random), wall);
	for (int tries = 0; tries < 3000 && !found; tries++)
		found = find_corner(job, random, wall, corner, &beyond);
	if (!found)
		return false;
	for (int k = 0; k < 3; k++) {
		double moved[3] = {corner[0], corner[1], corner[2]};

		moved[k] += step;
		normal[k] = (cutter_distance(job, moved, wall) - beyond) / step;
	}
	memcpy(at, wall, sizeof(at));
	at[2] = ABOVE;
	add_move(job, at, true, true);
	/* What is allowed, and a third of the way to the corner. */
	for (int k = 0; k < 3; k++)
		at[k] = rounded(corner[k] - normal[k] * (2 * beyond / 3 + radius - job->allowance) - (k == 2 ? radius : 0));
	add_move(job, (const double[]){wall[0], wall[1], at[2], wall[3]}, true, true);
	add_move(job, at, true, true)->probe = true;
	memcpy(job->moves[job->count - 1].wall, wall, sizeof(wall));
	add_move(job, (const double[]){wall[0], wall[1], at[2], wall[3]}, true, true);
	add_move(job, (const double[]){wall[0], wall[1], ABOVE, wall[3]}, true, true);
	for (int i = first; i < job->count; i++)
		job->moves[i].tool = 1;
	return true;
}

static void add_feels(struct job *job, struct oracle_random *random)
{
	const int cuts = job->count;
	double at[4];

	memcpy(at, job->moves[cuts - 1].to, sizeof(at));
	at[2] = ABOVE;
	add_move(job, at, true, true);
	for (int tries = 0, count = 0; tries < 20 * FEELS && count < FEELS; tries++) {
		const int i = (int)uniform(random, 1, cuts);

		if (job->moves[i].rapid || !job->moves[i].turning || job->moves[i].bounded)
			continue;
		if (count % 2 == 0)
			add_feel(job, random, i);
		else if (!add_corner_feel(job, random, i))
			continue;
		count++;
	}
}

/* The end of a move of this kind, 0 to 1, from `at`. */
static void choose_end(const struct job *job, struct oracle_random *random, double what, bool turned, bool first,
		       const double at[4], double to[4])
{
	const double reach = 0.5 * fmax(job->size[0], job->size[1]) + (first ? 0 : 5);

	if (what < 0.15) {	/* out */
		to[2] = rounded(job->top + uniform(random, 0.5, 4) + (turned ? 15 : 0));
	} else if (what < 0.4 && at[2] > job->top) {	/* across */
		to[0] = rounded(uniform(random, -reach, reach));
		to[1] = rounded(uniform(random, -reach, reach));
		to[3] = turned ? rounded(uniform(random, -40, 40)) : 0;
	} else if (what < 0.45) {	/* anywhere, little */
		for (int k = 0; k < 3; k++)
			to[k] = rounded(at[k] + uniform(random, -1, 1));
	} else if (what < 0.6) {	/* down */
		to[2] = rounded(uniform(random, 0.2, 1.1) * job->top);
	} else {	/* along */
		to[0] = rounded(at[0] + uniform(random, -8, 8));
		to[1] = rounded(at[1] + uniform(random, -8, 8));
		if (turned && uniform(random, 0, 1) < 0.3)
			to[3] = rounded(at[3] + uniform(random, -10, 10));
		if (uniform(random, 0, 1) < 0.3)
			to[2] = rounded(at[2] + uniform(random, -1.5, 1));
	}
}

/* Turns a move along into an arc, or a helix, from `at`. */
static void make_arc(struct move *m, struct oracle_random *random, const double at[4])
{
	const double radius = uniform(random, 1, 8), around = uniform(random, 0, 2 * acos(-1));
	const double sweep = uniform(random, 0.3, 5.5);
	double from[2];

	m->way = ARC;
	m->sweep = uniform(random, 0, 1) < 0.5 ? sweep : -sweep;
	m->centre[0] = at[0] + rounded(radius * cos(around));
	m->centre[1] = at[1] + rounded(radius * sin(around));
	for (int i = 0; i < 2; i++)
		from[i] = at[i] - m->centre[i];
	m->to[0] = rounded(m->centre[0] + from[0] * cos(m->sweep) - from[1] * sin(m->sweep));
	m->to[1] = rounded(m->centre[1] + from[0] * sin(m->sweep) + from[1] * cos(m->sweep));
	m->to[3] = at[3];
}

/* Up and home: there the second program begins. */
static void split(struct job *job, double at[4])
{
	at[2] = ABOVE + 10;
	add_move(job, at, true, true);
	memcpy(at, job_home, sizeof(job_home));
	add_move(job, at, true, true);
	job->split = job->count;
}

/* The way beside the path, and ends as they are written. */
static void settle(struct job *job, struct oracle_random *random)
{
	for (int i = 0; i < job->count; i++) {
		struct move *m = &job->moves[i];
		double work[3];

		for (int k = 0; k < 3; k++)
			m->off[k] = job->tolerance * uniform(random, -1, 1);
		if (!job->guided)
			continue;
		job_to_work(m->to, m->to[3], work);
		for (int k = 0; k < 3; k++)
			work[k] = rounded(work[k]);
		job_to_machine(work, m->to[3], m->to);
	}
}

void job_make(struct job *job, struct oracle_random *random)
{
	const bool turned = uniform(random, 0, 1) < 0.5;
	bool turning = true, after_bounded = false;
	int count, middle;
	double at[4];

	*job = (struct job){.guided = turned && uniform(random, 0, 1) < 0.5,
			    .tolerance = uniform(random, 0, 1) < 0.25 ? 0.03 : 0};
	memcpy(at, job_home, sizeof(at));
	make_blank(job, random);
	job->allowance = uniform(random, 0, 1) < 0.8 ? 0.1 : 0.25;
	tool_make_feeler(&job->tools[1], rounded(job->allowance + uniform(random, FEELER_MIN, FEELER_MAX)));
	tool_make(&job->tools[0], random);
	count = (int)uniform(random, 4, LAST_CUT);
	middle = uniform(random, 0, 1) < CHANCE_OF_SPLIT ? count / 2 : -1;
	for (int i = 0; i < count; i++) {
		/* First across and down; then anything. */
		const double what = i == 0 ? 0.3 : i == 1 ? 0.5 : uniform(random, 0, 1);
		struct move *m;

		/* Where the axes stand after such a motion is not known, and the spindle may not stop there. */
		if (uniform(random, 0, 1) < 0.03 && !after_bounded)
			turning = !turning;
		if (i == middle)
			split(job, at);
		m = add_move(job, at, what < 0.45, turning);
		choose_end(job, random, what, turned, i == 0, at, m->to);
		if (what >= 0.6 && !job->guided && !after_bounded && uniform(random, 0, 1) < 0.3)
			make_arc(m, random, at);
		else if (what >= 0.45 && !job->guided && uniform(random, 0, 1) < 0.04)
			m->bounded = m->to[3] == at[3];
		m->stop = uniform(random, 0, 1);
		after_bounded = m->bounded;
		memcpy(at, m->to, sizeof(at));
		if (what >= 0.45 && turning && !m->bounded && uniform(random, 0, 1) < 0.7)
			add_probes(job, random, at);
	}
	add_feels(job, random);
	settle(job, random);
}
