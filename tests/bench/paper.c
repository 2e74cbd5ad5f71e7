/*
 * paper.c - the paper's comparison on its own terms: two whole meshes of N triangles, every pair of them, no trees and no
 * boxes, at samples of one motion. Chen, Lin and Chang, "Efficient Web-Learning Collision Detection Tool on Five-Axis
 * Machine".
 *
 *   paper N STEP
 *     METHOD MILLISECONDS TESTS MEETING
 *
 * N: about so many triangles in each mesh; STEP: seconds between samples. TESTS: pairs of triangles times samples;
 * MEETING: those that no axis keeps apart. The bodies stay apart, so each of these is a false alarm of the method.
 *
 *   anew          conventional: all eleven axes are computed and projected on at every sample
 *   first         conventional, but it stops at the first axis that separates
 *   interpolated  all eleven axes are computed at both ends of the motion, and interpolated and projected on in between
 *   kept          of each pair one axis that separates at both ends is kept, interpolated, and tried in between; where
 *                 it does not separate, the first axis of the sample that does
 */
#include <time.h>

#include "plain_scene.h"

enum { AXES = 11 };

/* The paper's block with its last word read as C: 300, -200, -200 mm at 15 m/min, A and C -3 degrees. */
static const double WAY[3] = {300, -200, -200};
static const double TURN = -3, FEED = 15000;

struct triangles {
	vec (*corners)[3];
	size_t count;
};

/* Axes of each pair of triangles at both ends of the motion: all of them, or one. */
struct ends {
	vec start[AXES], end[AXES];
};

struct kept {
	vec start, end;
};

/* Of one run; NULL where the method has no use for them. */
struct axes {
	struct ends *all;
	struct kept *kept;
};

struct tally {
	double tests, meeting;
};

/* A ball of about `count` triangles. */
static struct triangles ball(size_t count, double radius, vec centre)
{
	const int rows = (int)ceil(sqrt((double)count / 4)), columns = 2 * rows;
	const double half_turn = acos(-1);
	struct triangles out = {malloc(sizeof(*out.corners) * 2 * (size_t)rows * (size_t)columns), 0};

	if (!out.corners)
		die("out of memory", "ball");
	for (int i = 0; i < rows; i++) {
		for (int k = 0; k < columns; k++) {
			vec p[4];

			for (int c = 0; c < 4; c++) {
				double down = half_turn * (i + (c >> 1)) / rows;
				double round = 2 * half_turn * (k + (c & 1)) / columns;
				vec out_of = vec_of(sin(down) * cos(round), sin(down) * sin(round), cos(down));

				p[c] = add(centre, times(radius, out_of));
			}
			for (int t = 0; t < 2; t++) {
				/* At the poles one of the two is a line. */
				if ((i == 0 && t == 1) || (i == rows - 1 && t == 0))
					continue;
				out.corners[out.count][0] = p[0];
				out.corners[out.count][1] = p[t ? 3 : 2];
				out.corners[out.count++][2] = p[t ? 1 : 3];
			}
		}
	}
	return out;
}

static vec turned(vec p, int axis, double degrees)
{
	const double angle = degrees * acos(-1) / 180, c = cos(angle), s = sin(angle);

	return axis == 0 ? vec_of(p.x, c * p.y - s * p.z, s * p.y + c * p.z)
			 : vec_of(c * p.x - s * p.y, s * p.x + c * p.y, p.z);
}

/* The tool's triangles as the table sees them: X, Y and Z carry the tool, A and C the table. */
static void pose_all(const struct triangles *tool, double s, struct triangles *out)
{
	for (size_t i = 0; i < tool->count; i++) {
		for (int k = 0; k < 3; k++) {
			vec p = add(tool->corners[i][k], times(s, vec_of(WAY[0], WAY[1], WAY[2])));

			out->corners[i][k] = turned(turned(p, 0, -s * TURN), 2, -s * TURN);
		}
	}
	out->count = tool->count;
}

/* Axis k: the normals of both, then the products of their edges. */
static vec axis_of(const vec *a, const vec *b, int k)
{
	if (k == 0)
		return cross(sub(a[1], a[0]), sub(a[2], a[0]));
	if (k == 1)
		return cross(sub(b[1], b[0]), sub(b[2], b[0]));
	k -= 2;
	return cross(sub(a[(k / 3 + 1) % 3], a[k / 3]), sub(b[(k % 3 + 1) % 3], b[k % 3]));
}

/* fmin and fmax ask for NaN, which costs more than the projections. */
static double least(double a, double b, double c)
{
	double ab = a < b ? a : b;

	return ab < c ? ab : c;
}

static double most(double a, double b, double c)
{
	double ab = a > b ? a : b;

	return ab > c ? ab : c;
}

static int separates(const vec *a, const vec *b, vec n)
{
	double a0 = dot(n, a[0]), a1 = dot(n, a[1]), a2 = dot(n, a[2]);
	double b0 = dot(n, b[0]), b1 = dot(n, b[1]), b2 = dot(n, b[2]);

	return least(a0, a1, a2) > most(b0, b1, b2) || least(b0, b1, b2) > most(a0, a1, a2);
}

static int apart_anew(const vec *a, const vec *b)
{
	int apart = 0;

	for (int k = 0; k < AXES; k++)
		apart |= separates(a, b, axis_of(a, b, k));
	return apart;
}

static int apart_first(const vec *a, const vec *b)
{
	for (int k = 0; k < AXES; k++)
		if (separates(a, b, axis_of(a, b, k)))
			return 1;
	return 0;
}

static vec mixed(vec start, vec end, double s)
{
	return add(times(1 - s, start), times(s, end));
}

static int apart_interpolated(const vec *a, const vec *b, const struct ends *ends, double s)
{
	int apart = 0;

	for (int k = 0; k < AXES; k++)
		apart |= separates(a, b, mixed(ends->start[k], ends->end[k], s));
	return apart;
}

static int apart_kept(const vec *a, const vec *b, const struct kept *kept, double s)
{
	return separates(a, b, mixed(kept->start, kept->end, s)) || apart_first(a, b);
}

static void keep_one(const vec *a, const vec *start, const vec *end, struct kept *kept)
{
	for (int k = 0; k < AXES; k++) {
		*kept = (struct kept){axis_of(a, start, k), axis_of(a, end, k)};
		if (separates(a, start, kept->start) && separates(a, end, kept->end))
			return;
	}
}

/* What the method needs of both ends of the motion. */
static void fill(const struct triangles *table, const struct triangles ends[2], const struct axes *axes)
{
	for (size_t i = 0; i < table->count; i++) {
		for (size_t j = 0; j < ends[0].count; j++) {
			const vec *a = table->corners[i], *start = ends[0].corners[j], *end = ends[1].corners[j];
			size_t pair = i * ends[0].count + j;

			if (axes->kept)
				keep_one(a, start, end, &axes->kept[pair]);
			for (int k = 0; k < AXES && axes->all; k++) {
				axes->all[pair].start[k] = axis_of(a, start, k);
				axes->all[pair].end[k] = axis_of(a, end, k);
			}
		}
	}
}

enum method { ANEW, FIRST, INTERPOLATED, KEPT };

static int are_apart(const vec *a, const vec *b, enum method method, const struct axes *axes, size_t pair, double s)
{
	switch (method) {
	case ANEW:
		return apart_anew(a, b);
	case INTERPOLATED:
		return apart_interpolated(a, b, &axes->all[pair], s);
	case KEPT:
		return apart_kept(a, b, &axes->kept[pair], s);
	case FIRST:
		break;
	}
	return apart_first(a, b);
}

static void sample(const struct triangles *table, const struct triangles *tool, double s, enum method method,
		   const struct axes *axes, struct tally *tally)
{
	for (size_t i = 0; i < table->count; i++)
		for (size_t j = 0; j < tool->count; j++)
			tally->meeting += !are_apart(table->corners[i], tool->corners[j], method, axes,
						     i * tool->count + j, s);
	tally->tests += (double)table->count * (double)tool->count;
}

static void *room(size_t count, size_t size)
{
	void *block = malloc(count * size);

	if (!block)
		die("out of memory", "paper");
	return block;
}

static struct tally run(const struct triangles *table, const struct triangles *tool, double step, enum method method)
{
	const double seconds = 60 * sqrt(WAY[0] * WAY[0] + WAY[1] * WAY[1] + WAY[2] * WAY[2]) / FEED;
	const size_t pairs = table->count * tool->count;
	struct triangles ends[2], at = {room(tool->count, sizeof(*at.corners)), 0};
	struct axes axes = {method == INTERPOLATED ? room(pairs, sizeof(*axes.all)) : NULL,
			    method == KEPT ? room(pairs, sizeof(*axes.kept)) : NULL};
	struct tally tally = {0, 0};

	for (int i = 0; i < 2; i++) {
		ends[i].corners = room(tool->count, sizeof(*ends[i].corners));
		pose_all(tool, i, &ends[i]);
	}
	fill(table, ends, &axes);
	for (double t = 0; t <= seconds; t += step) {
		pose_all(tool, t / seconds, &at);
		sample(table, &at, t / seconds, method, &axes, &tally);
	}
	for (int i = 0; i < 2; i++)
		free(ends[i].corners);
	free(axes.all);
	free(axes.kept);
	free(at.corners);
	return tally;
}

static double processor_ms(void)
{
	struct timespec t;

	clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
	return 1e3 * (double)t.tv_sec + 1e-6 * (double)t.tv_nsec;
}

int main(int argc, char **argv)
{
	static const char *const names[] = {"anew", "first", "interpolated", "kept"};
	struct triangles table, tool;
	long count = argc == 3 ? atol(argv[1]) : 0;
	double step = argc == 3 ? atof(argv[2]) : 0;

	if (count < 8 || count > 5000 || !(step > 0))
		die("usage: paper N STEP, N from 8 to 5000", argv[0]);
	table = ball((size_t)count, 100, vec_of(0, 0, 0));
	tool = ball((size_t)count, 30, vec_of(-100, 300, 300));
	for (int method = ANEW; method <= KEPT; method++) {
		double start = processor_ms();
		struct tally tally = run(&table, &tool, step, (enum method)method);

		printf("%s\t%.3f\t%.0f\t%.0f\n", names[method], processor_ms() - start, tally.tests, tally.meeting);
	}
	free(table.corners);
	free(tool.corners);
	return 0;
}
