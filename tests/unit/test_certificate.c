#include "scene/tri_pair.h"

#include "scene/coherence.h"
#include "solids.h"
#include "suite.h"

enum { INSTANTS = 65 };

/* Two triangles, one a body, on a random chain over a random straight move, and how near they come. */
struct trial {
	struct random random;
	long number;
	struct duo duo;
	struct chord chord;
	bool strays;	/* the chord has a deviation */
	double least;	/* sampled distance */
	double clearance;	/* a little less than that, or more */
};

static xform pose_at(const struct trial *t, double s, const axis_values *off)
{
	return duo_pose(&t->duo, &t->chord.q0, &t->chord.q1, s, off);
}

static double distance_at(const struct trial *t, const xform *pose)
{
	tri a = tri_of(&t->duo.a->mesh, 0), b = tri_of(&t->duo.b->mesh, 0), moved = tri_transform(&b, pose);
	vec3 x, y;

	return tri_distance(&a, &moved, &x, &y);
}

/* Anywhere within the deviation of the chord. */
static axis_values random_off(struct random *random, const axis_values *chord_error)
{
	axis_values off;

	for (int k = 0; k < SLOT_COUNT; k++)
		off.v[k] =
		    chord_error->v[k] * (random_below(random, 2) ? random_sign(random) : random_in(random, -1, 1));
	return off;
}

/* The least distance at many instants; confirmed by the independent distance where it is least. */
static double sampled_least(struct trial *t, int instants)
{
	double least = INFINITY;
	xform worst = xform_identity();
	tri a = tri_of(&t->duo.a->mesh, 0), b = tri_of(&t->duo.b->mesh, 0);

	for (int i = 0; i < instants; i++) {
		axis_values off = random_off(&t->random, &t->chord.chord_error);
		xform pose = pose_at(t, (double)i / (instants - 1), t->strays ? &off : NULL);
		double distance = distance_at(t, &pose);

		if (distance < least) {
			least = distance;
			worst = pose;
		}
	}
	b = tri_transform(&b, &worst);
	return true_distance(&a, &b);
}

static struct mesh random_triangle(struct random *random, double size)
{
	struct mesh mesh = {0};

	solid_add(&mesh, random_point(random, size), random_point(random, size), random_point(random, size));
	return mesh;
}

/* The joints move by at most `way` mm or hundredths of a radian. */
static void trial_init(struct trial *t, uint64_t test, long number, double way_least, double way_most)
{
	struct random *random = &t->random;
	struct chain chain;
	struct mesh a, b;
	xform place_a, place_b;
	axis_values middle;
	double way;

	*t = (struct trial){.random = random_case(test, number), .number = number};
	chain = random_chain(random, 1 + random_below(random, 5), 200);
	way = random_size(random, way_least, way_most);
	random_move(random, &chain, way, &t->chord.q0, &t->chord.q1);
	t->strays = random_below(random, 4) == 0;
	for (size_t i = 0; i < chain.count && t->strays; i++)
		t->chord.chord_error.v[chain.joints[i].slot] =
			random_size(random, 1e-3, 1) * (chain.joints[i].rotary ? 0.01 : 1);
	for (int k = 0; k < SLOT_COUNT; k++)
		middle.v[k] = 0.5 * (t->chord.q0.v[k] + t->chord.q1.v[k]);
	place_a = random_place(random, 200);
	place_b = place_near(random, &chain, &middle, &place_a,
			     vec3_scale(random_size(random, 0.1, 100), random_unit(random)));
	a = random_triangle(random, random_size(random, 1, 100));
	b = random_triangle(random, random_size(random, 1, 100));
	duo_init(&t->duo, &chain, &a, &b, &place_a, &place_b);
	t->least = sampled_least(t, 9);
	t->clearance =
	    t->least * (random_below(random, 3) ? random_in(random, 0, 1) : 1 - random_size(random, 1e-6, 1));
}

static struct leaf the_only_leaf(const struct bvh *bvh)
{
	return (struct leaf){bvh->nodes[0].first[0], bvh->nodes[0].count[0]};
}

static enum tri_pair_answer prove(const struct trial *t, const struct motion_interval *interval,
				  struct contact *contact)
{
	long certificates = 0;

	*contact = (struct contact){.s = INFINITY};
	return tri_pair_prove(interval, &t->duo.pair, the_only_leaf(t->duo.a), the_only_leaf(t->duo.b),
			      &(struct tri_pair_query){t->clearance, 0, false}, contact, &certificates);
}

/* Axes from some instant of the move, and from nowhere. */
static void memory_init(struct coherence *coherence, struct trial *t)
{
	tri a = tri_of(&t->duo.a->mesh, 0), b = tri_of(&t->duo.b->mesh, 0);

	*coherence = (struct coherence){0};
	for (int i = 0; i < 3; i++) {
		xform pose = pose_at(t, random_in(&t->random, 0, 1), NULL);
		tri moved = tri_transform(&b, &pose);
		vec3 x, y, n = random_unit(&t->random);

		if (i && tri_distance(&a, &moved, &x, &y) > 0)
			n = vec3_scale(1 / vec3_norm(vec3_sub(y, x)), vec3_sub(y, x));
		coherence_learn(coherence, n, &pose);
	}
}

/* The gap that it shows at one pose is there. */
static void watch_memory_gap(struct trial *t, struct coherence *coherence)
{
	struct box a = box_whole(t->duo.a), b = box_whole(t->duo.b);
	xform pose = pose_at(t, random_in(&t->random, 0, 1), NULL);
	double gap = coherence_gap(coherence, &pose, &t->duo.pair, &a, &b), distance = distance_at(t, &pose);

	require(gap <= distance + 1e-9, "case %ld: coherence's gap %.12g, distance %.12g", t->number, gap, distance);
}

/* Of what the boxes claim: the distance is at least that. */
static double boxes_claim(const struct trial *t, const struct motion_interval *interval)
{
	struct box a = box_whole(t->duo.a), b = box_whole(t->duo.b);
	float apart[BVH_WIDTH], loose[BVH_WIDTH], single;
	double claim;

	boxes_apart(&interval->boxes, 0, &t->duo.a->nodes[0], &b, INFINITY, apart, loose);
	claim = apart[0];
	boxes_apart(&interval->boxes, 1, &t->duo.b->nodes[0], &a, INFINITY, apart, loose);
	claim = fmax(claim, apart[0]);
	single = box_pair_apart(&interval->boxes, &a, &b, loose);
	return fmax(claim, single);
}

static bool parted_as_branches(struct coherence *coherence, const struct trial *t,
			       const struct motion_interval *interval)
{
	const struct subtree a = subtree_root(t->duo.a), b = subtree_root(t->duo.b);

	coherence->idle = 0;
	return coherence_separates_subtrees(coherence, interval, &t->duo.pair, &a, &b, t->clearance);
}

START_TEST(what_is_proved_of_a_chord_is_so)
{
	long proved = 0, touched = 0, by_memory = 0, parted = 0, boxed = 0, cases = random_cases(30000);
	double tightest = 0;

	for (long n = 0; n < cases; n++) {
		struct trial t;
		struct motion_interval interval;
		struct coherence coherence;
		struct contact contact;
		double claim, least;
		bool apart, remembered, subtrees;

		trial_init(&t, 1, n, 0.1, 150);
		motion_interval_init(&interval, &t.duo.pair, INTERVAL_CHORD, &t.chord);
		memory_init(&coherence, &t);
		apart = prove(&t, &interval, &contact) == TRI_PAIR_APART;
		touched += contact.s < INFINITY;
		if (contact.s < INFINITY) {
			xform pose = pose_at(&t, contact.s, NULL);

			require(distance_at(&t, &pose) <= t.clearance + 1e-9, "case %ld: no contact at %g", n,
				contact.s);
		}
		t.duo.pair.coherence = &coherence;
		remembered = prove(&t, &interval, &contact) == TRI_PAIR_APART;
		subtrees = parted_as_branches(&coherence, &t, &interval);
		claim = boxes_claim(&t, &interval);
		if (apart || remembered || subtrees || claim > 0) {
			least = fmin(sampled_least(&t, INSTANTS), t.least);
			require(!apart || least > t.clearance - 1e-9, "case %ld: %.12g proved, %.12g is", n,
				t.clearance, least);
			require(!remembered || least > t.clearance - 1e-9,
				"case %ld: %.12g proved by coherence, %.12g is", n, t.clearance, least);
			require(!subtrees || least > t.clearance - 1e-9,
				"case %ld: %.12g proved of the subtrees, %.12g is", n, t.clearance, least);
			require(claim <= least, "case %ld: boxes %.12g apart, triangles %.12g", n, claim, least);
			if ((apart || remembered) && least > 0)
				tightest = fmax(tightest, t.clearance / least);
		}
		watch_memory_gap(&t, &coherence);
		proved += apart;
		by_memory += remembered && !apart;
		parted += subtrees;
		boxed += claim > 0;
		duo_release(&t.duo);
	}
	require(proved > cases / 4 && touched > cases / 1000 && by_memory > cases / 10000 && parted > cases / 10 &&
		    boxed > cases / 10,
		"proved %ld, touched %ld, only by coherence %ld, as subtrees %ld, boxes apart %ld", proved, touched,
		by_memory, parted, boxed);
	require(tightest > 0.999, "the proofs are slack: %g", tightest);
}
END_TEST

/* b's middle in a's mesh coordinates. */
static vec3 middle_of_b(const struct trial *t, double s)
{
	xform pose = pose_at(t, s, NULL);

	return xform_apply(&pose, t->duo.b->origin);
}

/* Puts a plate in a's place, along the chord of b's middle, where the bulge of its path is; false: there is none. */
static bool hold_plate_to_bulge(struct trial *t)
{
	vec3 first = middle_of_b(t, 0), top = middle_of_b(t, 0.5), last = middle_of_b(t, 1);
	vec3 along = vec3_sub(last, first), bulge = vec3_sub(top, vec3_lerp(first, last, 0.5)), n, across, at;
	double way = vec3_norm(along), height;
	struct mesh plate = {0};
	xform place_a = t->duo.pair.place_a, place_b = t->duo.pair.place_b;

	bulge = vec3_mad(bulge, -vec3_dot(bulge, along) / (way * way), along);
	height = vec3_norm(bulge);
	if (!(way > 1 && height > 1e-3))
		return false;
	n = vec3_scale(1 / height, bulge);
	across = vec3_scale(2000 / way, vec3_cross(n, along));
	along = vec3_scale(2000 / way, along);
	at = vec3_mad(top, t->duo.b->radius - height * random_in(&t->random, 0, 0.5), n);
	solid_add(&plate, vec3_sub(vec3_sub(at, along), across), vec3_add(vec3_sub(at, along), across),
		  vec3_add(at, along));
	bvh_free(t->duo.a);
	t->duo.a = bvh_new(&plate);
	body_pair_init(&t->duo.pair, t->duo.a, t->duo.b, &place_a, &place_b, &t->duo.chain);
	return true;
}

/* Without the second-order term, one axis or two would "prove" what is not so. */
START_TEST(the_bend_is_needed)
{
	long wrong = 0, cases = random_cases(10000);

	for (long n = 0; n < cases; n++) {
		struct trial t;
		struct motion_interval interval;
		struct contact contact;

		trial_init(&t, 2, n, 1, 150);
		if (!t.strays && hold_plate_to_bulge(&t)) {
			double least = sampled_least(&t, INSTANTS);

			t.clearance = 0;
			motion_interval_init(&interval, &t.duo.pair, INTERVAL_CHORD, &t.chord);
			require(least > 0 || prove(&t, &interval, &contact) != TRI_PAIR_APART, "case %ld: proved", n);
			interval.displacement[0] = 1e-9;
			wrong += least <= 0 && prove(&t, &interval, &contact) == TRI_PAIR_APART;
		}
		duo_release(&t.duo);
	}
	require(wrong > cases / 1000, "%ld", wrong);
}
END_TEST

START_TEST(what_is_proved_of_a_box_is_so)
{
	long proved = 0, boxed = 0, cases = random_cases(10000);

	for (long n = 0; n < cases; n++) {
		struct trial t;
		struct motion_interval interval;
		struct contact contact;
		axis_values middle, half;
		double claim, least = INFINITY;
		bool apart;

		trial_init(&t, 3, n, 0.1, 150);
		for (int k = 0; k < SLOT_COUNT; k++) {
			double low = fmin(t.chord.q0.v[k], t.chord.q1.v[k]),
			       high = fmax(t.chord.q0.v[k], t.chord.q1.v[k]);

			t.chord.q0.v[k] = low;
			t.chord.q1.v[k] = high;
			middle.v[k] = 0.5 * (low + high);
			half.v[k] = 0.5 * (high - low);
		}
		t.chord.chord_error = (axis_values){{0}};
		motion_interval_init(&interval, &t.duo.pair, INTERVAL_BOX, &t.chord);
		apart = prove(&t, &interval, &contact) == TRI_PAIR_APART;
		claim = boxes_claim(&t, &interval);
		for (int i = 0; i < INSTANTS && (apart || claim > 0); i++) {
			axis_values off = random_off(&t.random, &half);
			xform pose = duo_pose(&t.duo, &middle, &middle, 0, &off);

			least = fmin(least, distance_at(&t, &pose));
		}
		require(!apart || least > t.clearance - 1e-9, "case %ld: %.12g proved, %.12g is", n, t.clearance,
			least);
		require(claim <= least, "case %ld: boxes %.12g apart, triangles %.12g", n, claim, least);
		proved += apart;
		boxed += claim > 0;
		duo_release(&t.duo);
	}
	require(proved > cases / 10 && boxed > cases / 10, "proved %ld, boxes apart %ld", proved, boxed);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("certificates");

	tcase_add_test(tcase, what_is_proved_of_a_chord_is_so);
	tcase_add_test(tcase, the_bend_is_needed);
	tcase_add_test(tcase, what_is_proved_of_a_box_is_so);
	return run_suite("certificate", tcase);
}
