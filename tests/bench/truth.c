/*
 * truth.c - when bodies first meet, found the slow way: distances are computed exactly, and between two of them
 * no more motion is taken on trust than the distance allows.
 *
 *   truth first SCENE PATH
 *     contact A B LINE TIME        a pair's first contact, if none of another pair is earlier
 *     least A B DISTANCE           else a lower bound on its distance throughout (a tenth of the true one or more)
 *   truth at SCENE PATH A B T0 T1 Q...
 *     DISTANCE TRAVEL              of bodies named A and B at the axis positions Q, and their motion from time T0 to T1
 *   truth travel SCENE PATH
 *     LENGTH                       mm that the farthest point of any followed pair moves in all, to within some percent
 *
 * Output is separated by tabs. Numbers: mm, seconds, degrees.
 */
#include "mesh_apart.h"
#include "travel.h"

/* mm. A motion of GRAIN is not looked into; what is nearer than TOUCH touches. */
#define GRAIN 1e-5
#define TOUCH 1e-7

enum { SPANS_LOOKED_AT = 5000 };

/* The share of a distance that is spent before the next is computed; below NEAR mm all of it. */
#define SPENT 0.9
#define NEAR 0.01

struct search {
	const struct scene *scene;
	const struct track *track;
	struct box_tree *trees;	/* by body; built when needed */
	double end;	/* nothing later than this matters */
};

static const struct box_tree *tree_of(struct search *search, int body)
{
	struct box_tree *tree = &search->trees[body];

	if (!tree->nodes)
		*tree = box_tree_of(&search->scene->solids[body]);
	return tree;
}

static double distance_at(struct search *search, const struct solid_pair *pair, const double *q, struct hint *hint)
{
	pose rel = relative_pose(search->scene, pair, q);

	return mesh_apart(tree_of(search, pair->a), tree_of(search, pair->b), &rel, hint);
}

/* What is left of the last distance, and the least that was ever left. */
struct purse {
	double room, least;
	struct hint hint;
};

/* One span; the share of it at which the pair touches, or 2. */
static double touch_in_span(struct search *search, const struct solid_pair *pair, size_t row, struct purse *purse)
{
	const struct track *track = search->track;
	double s = 0, whole = travel_bound(search->scene, pair, track->rows[row - 1].q, track->rows[row].q);

	if (purse->room > whole) {
		purse->room -= whole;
		return 2;
	}
	for (;;) {
		double q[AXES_MAX], way, d, step;

		between(search->scene, track, row, s, q);
		d = distance_at(search, pair, q, &purse->hint) - pair->clearance;
		purse->least = fmin(purse->least, d < NEAR ? 0 : d * (1 - SPENT));
		if (d <= TOUCH)
			return s;
		way = travel_bound(search->scene, pair, q, track->rows[row].q);
		if (d * SPENT > way) {
			purse->room = d * SPENT - way;
			return 2;
		}
		step = fmax(d < NEAR ? d : d * SPENT, GRAIN) / way;
		s = s + step * (1 - s) < 1 ? s + step * (1 - s) : 1;
	}
}

static void first_of_pair(struct search *search, const struct solid_pair *pair)
{
	const struct scene *scene = search->scene;
	const struct track *track = search->track;
	struct purse purse = {0, INFINITY, {0, 0}};
	const char *a = scene->solids[pair->a].name, *b = scene->solids[pair->b].name;

	for (size_t i = 1; i < track->count && track->rows[i - 1].time <= search->end; i++) {
		double s;

		if (!is_there(scene, pair, track->rows[i].tool)) {
			purse.room = 0;
			continue;
		}
		s = touch_in_span(search, pair, i, &purse);
		if (s <= 1) {
			double t = (1 - s) * track->rows[i - 1].time + s * track->rows[i].time;

			search->end = fmin(search->end, t);
			printf("contact\t%s\t%s\t%ld\t%.12g\n", a, b, track->rows[i].line, t);
			return;
		}
	}
	printf("least\t%s\t%s\t%.9g\n", a, b, purse.least);
}

static void first(struct search *search)
{
	for (int i = 0; i < search->scene->pair_count; i++)
		first_of_pair(search, &search->scene->pairs[i]);
}

static int solid_named(const struct scene *scene, const char *name)
{
	for (int i = 0; i < scene->solid_count; i++)
		if (!strcmp(scene->solids[i].name, name))
			return i;
	die("is no body", name);
	return 0;
}

/* The motion of a pair between two times, span by span, with parts of spans at both ends. */
static double travel_between(const struct search *search, const struct solid_pair *pair, double t0, double t1)
{
	double sum = 0;

	for (size_t i = 1; i < search->track->count; i++) {
		double start = search->track->rows[i - 1].time, end = search->track->rows[i].time, q0[AXES_MAX],
		       q1[AXES_MAX];
		double from = fmax(start, fmin(t0, t1)), to = fmin(end, fmax(t0, t1));

		if (!(to > from))
			continue;
		between(search->scene, search->track, i, (from - start) / (end - start), q0);
		between(search->scene, search->track, i, (to - start) / (end - start), q1);
		sum += travel_seen(search->scene, pair, q0, q1);
	}
	return sum;
}

static void at(struct search *search, char **words)
{
	const struct scene *scene = search->scene;
	struct solid_pair pair = {solid_named(scene, words[0]), solid_named(scene, words[1]), 0, 1};
	double q[AXES_MAX];
	struct hint hint = {0, 0};

	for (int i = 0; i < scene->axis_count; i++)
		q[i] = atof(words[4 + i]);
	printf("%.12g\t%.12g\n", distance_at(search, &pair, q, &hint),
	       travel_between(search, &pair, atof(words[2]), atof(words[3])));
}

/* Of a long path some thousand spans are looked at, spread over it, each for as many as it stands for. */
static void travel(const struct search *search)
{
	const size_t stride = search->track->count / SPANS_LOOKED_AT + 1;
	double most = 0;

	for (int i = 0; i < search->scene->pair_count; i++) {
		const struct solid_pair *pair = &search->scene->pairs[i];
		double sum = 0;

		for (size_t k = 1; pair->looked && k < search->track->count; k += stride)
			sum += (double)stride *
			       travel_seen(search->scene, pair, search->track->rows[k - 1].q, search->track->rows[k].q);
		most = fmax(most, sum);
	}
	printf("%.9g\n", most);
}

int main(int argc, char **argv)
{
	struct search search = {NULL, NULL, NULL, INFINITY};
	struct track track;

	if (argc < 4)
		die("usage: truth first|at|travel SCENE PATH [A B T0 T1 Q...]", argv[0]);
	search.scene = read_scene(argv[2]);
	track = read_track(search.scene, argv[3]);
	search.track = &track;
	search.trees = calloc((size_t)search.scene->solid_count, sizeof(*search.trees));
	if (!strcmp(argv[1], "first"))
		first(&search);
	else if (!strcmp(argv[1], "travel"))
		travel(&search);
	else if (!strcmp(argv[1], "at") && argc == 8 + search.scene->axis_count)
		at(&search, argv + 4);
	else
		die("no such question, or not an axis position each", argv[1]);
	return 0;
}
