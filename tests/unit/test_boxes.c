#include "geom/boxes.h"

#include <string.h>

#include "geom/simd_kernels.h"
#include "solids.h"
#include "suite.h"

/* Two soups and a motion of b against a, seen from one of both. */
struct meeting {
	struct random random;
	struct bvh *bodies[2];
	xform poses[2];	/* b in a, at both ends */
	int view;	/* 0: b moves in a's frame; 1: a in b's */
	vec3 axis_displacement[2];
	double displacement[2];
	struct box_motion motion;
};

static struct bvh *random_soup(struct random *random, double size, double offset)
{
	struct mesh mesh = {0};
	int count = 1 + random_below(random, 60);
	vec3 middle = random_point(random, offset);

	for (int i = 0; i < count; i++) {
		vec3 at = vec3_add(middle, random_point(random, size));
		double edge = size * random_size(random, 1e-3, 1);

		solid_add(&mesh, at, vec3_add(at, random_point(random, edge)),
			  vec3_add(at, random_point(random, edge)));
	}
	return bvh_new(&mesh);
}

static xform random_pose(struct random *random, double size)
{
	xform pose = random_place(random, 0);

	if (!random_below(random, 3))
		pose = xform_identity();
	pose.translation = vec3_scale(size, random_unit(random));
	return pose;
}

static void meeting_init(struct meeting *m, uint64_t test, long number)
{
	struct random *random = &m->random;
	double size, way;

	*m = (struct meeting){.random = random_case(test, number)};
	size = random_size(random, 1e-2, 1e4);
	way = size * random_size(random, 1e-4, 3);
	m->bodies[0] = random_soup(random, size * random_size(random, 0.01, 1), size * random_size(random, 1e-2, 10));
	m->bodies[1] = random_soup(random, size * random_size(random, 0.01, 1), size * random_size(random, 1e-2, 10));
	m->poses[0] = random_pose(random, size * random_size(random, 0.1, 10));
	/* Moves the centres of the bodies, not their mesh origins, near each other. */
	m->poses[0].translation = vec3_add(m->poses[0].translation,
					   vec3_sub(m->bodies[0]->origin,
						    mat3_apply(&m->poses[0].rotation, m->bodies[1]->origin)));
	m->poses[1] = m->poses[0];
	if (random_below(random, 3)) {
		xform turn = xform_turn(random_point(random, size), random_unit(random), random_size(random, 1e-4, 2));

		if (random_below(random, 2))
			turn = xform_identity();
		turn.translation = vec3_add(turn.translation, random_point(random, way));
		m->poses[1] = xform_mul(&turn, &m->poses[0]);
	}
	m->view = random_below(random, 2);
	/* The bound of the other view is made useless: results must hold with one view's bound alone. */
	m->displacement[1 - m->view] = 1e9;
	m->displacement[m->view] = random_below(random, 2) ? 0 : size * random_size(random, 1e-5, 0.1);
	if (random_below(random, 2))
		m->axis_displacement[m->view] = (vec3){random_in(random, 0, 0.1 * size), random_in(random, 0, 0.1 * size),
					  random_in(random, 0, 0.1 * size)};
	box_motion_init(&m->motion, m->bodies[0], m->bodies[1], m->poses, m->axis_displacement, m->displacement);
}

static double clamped(double x, double low, double high)
{
	return x < low ? low : x > high ? high : x;
}

static void get(vec3 p, double out[3])
{
	out[0] = p.x;
	out[1] = p.y;
	out[2] = p.z;
}

/*
 * How near a point of the standing box can come to one of the moving box that goes along its chord, with the
 * axis_displacement: by turns the best of each coordinate while the others stay, which goes downhill. All in the
 * standing frame.
 */
struct descent {
	const struct box *still, *moving;
	double maps[2][4][3];	/* images of the unit vectors and of the origin of the moving body, at both ends */
	double axis_displacement[3];
	/* of the moving point: where on the chord, where in the box, how much axis_displacement */
	double s, x[3], p[3];
};

static void place_of(const struct descent *d, double out[3])
{
	for (int k = 0; k < 3; k++) {
		double at[2];

		for (int e = 0; e < 2; e++)
			at[e] = d->maps[e][3][k] + d->maps[e][0][k] * d->x[0] + d->maps[e][1][k] * d->x[1] +
				d->maps[e][2][k] * d->x[2];
		out[k] = (1 - d->s) * at[0] + d->s * at[1] + d->p[k];
	}
}

/* From the nearest point of the standing box to the moving point. */
static double way_to(const struct descent *d, double out[3])
{
	double at[3], square = 0;

	place_of(d, at);
	for (int k = 0; k < 3; k++) {
		double c = d->still->centre[k], h = d->still->half[k];

		out[k] = at[k] - clamped(at[k], c - h, c + h);
		square += out[k] * out[k];
	}
	return sqrt(square);
}

/* Moves one variable by the best step along `rate`, the moving point's change with it. */
static void improve(const struct descent *d, double *variable, double low, double high, const double rate[3])
{
	double way[3], along = 0, square = 0;

	way_to(d, way);
	for (int k = 0; k < 3; k++) {
		along += way[k] * rate[k];
		square += rate[k] * rate[k];
	}
	if (square > 0)
		*variable = clamped(*variable - along / square, low, high);
}

static double nearest(struct descent *d, struct random *random)
{
	double way[3];

	d->s = random_in(random, 0, 1);
	for (int j = 0; j < 3; j++) {
		d->x[j] = d->moving->centre[j] + random_in(random, -1, 1) * d->moving->half[j];
		d->p[j] = random_in(random, -1, 1) * d->axis_displacement[j];
	}
	for (int round = 0; round < 40; round++) {
		double rate[3];

		for (int j = 0; j < 3; j++) {
			const double c = d->moving->centre[j], h = d->moving->half[j];
			const double unit[3] = {j == 0, j == 1, j == 2};

			for (int k = 0; k < 3; k++)
				rate[k] = (1 - d->s) * d->maps[0][j][k] + d->s * d->maps[1][j][k];
			improve(d, &d->x[j], c - h, c + h, rate);
			improve(d, &d->p[j], -d->axis_displacement[j], d->axis_displacement[j], unit);
		}
		for (int k = 0; k < 3; k++) {
			rate[k] = d->maps[1][3][k] - d->maps[0][3][k];
			for (int j = 0; j < 3; j++)
				rate[k] += (d->maps[1][j][k] - d->maps[0][j][k]) * d->x[j];
		}
		improve(d, &d->s, 0, 1, rate);
	}
	return way_to(d, way);
}

static double least_of(struct meeting *m, const struct box *a, const struct box *b)
{
	struct descent d = {.still = m->view ? b : a, .moving = m->view ? a : b};
	const struct bvh *own = m->bodies[m->view], *other = m->bodies[1 - m->view];
	double least = INFINITY;

	for (int e = 0; e < 2; e++) {
		xform pose = m->view ? xform_inverse(&m->poses[e]) : m->poses[e];

		get(pose.rotation.x, d.maps[e][0]);
		get(pose.rotation.y, d.maps[e][1]);
		get(pose.rotation.z, d.maps[e][2]);
		get(vec3_sub(xform_apply(&pose, other->origin), own->origin), d.maps[e][3]);
	}
	get(m->axis_displacement[m->view], d.axis_displacement);
	for (int start = 0; start < 3; start++)
		least = fmin(least, nearest(&d, &m->random));
	return fmax(least - m->displacement[m->view], 0);
}

static const struct bvh_node *some_node(struct random *random, const struct bvh *bvh)
{
	return &bvh->nodes[random_below(random, (int)bvh->node_count)];
}

/* Every SIMD level gives the same bits as the scalar version: no verdict may depend on the processor. */
START_TEST(every_level_gives_the_same_bits)
{
	long cases = random_cases(4000);

	ck_assert_int_ge(simd_level(), LANES_SCALAR);
	for (long n = 0; n < cases; n++) {
		struct meeting m;

		meeting_init(&m, 1, n);
		for (int i = 0; i < 8; i++) {
			int side = random_below(&m.random, 2);
			const struct bvh_node *node = some_node(&m.random, m.bodies[side]);
			const struct bvh_node *across = some_node(&m.random, m.bodies[1 - side]);
			struct box other = box_of(across, random_below(&m.random, across->used));
			float enough = (float)random_in(&m.random, 0, 100);
			float want[2][BVH_WIDTH], got[2][BVH_WIDTH];

			simd_kernels_scalar.boxes_apart(&m.motion, side, node, &other, enough, want[0], want[1]);
			for (int level = LANES_SCALAR + 1; level <= simd_level(); level++) {
				simd_kernels_at_level(level)->boxes_apart(&m.motion, side, node, &other, enough, got[0],
									  got[1]);
				require(!memcmp(want, got, sizeof(want)), "case %ld: level %d differs", n, level);
			}
		}
		bvh_free(m.bodies[0]);
		bvh_free(m.bodies[1]);
	}
}
END_TEST

START_TEST(nothing_is_nearer_than_claimed)
{
	long claimed = 0, cases = random_cases(8000);
	double tightest = 0;

	for (long n = 0; n < cases; n++) {
		struct meeting m;

		meeting_init(&m, 1, n);
		for (int i = 0; i < 3; i++) {
			int side = random_below(&m.random, 2);
			const struct bvh_node *node = some_node(&m.random, m.bodies[side]);
			const struct bvh_node *across = some_node(&m.random, m.bodies[1 - side]);
			struct box other = box_of(across, random_below(&m.random, across->used));
			float apart[BVH_WIDTH], loose[BVH_WIDTH], single;

			if (!random_below(&m.random, 4))
				other = box_whole(m.bodies[1 - side]);
			boxes_apart(&m.motion, side, node, &other,
				    random_below(&m.random, 2) ? INFINITY : (float)random_in(&m.random, 0, 20), apart,
				    loose);
			for (int l = 0; l < node->used; l++) {
				struct box own = box_of(node, l);
				const struct box *a = side ? &other : &own, *b = side ? &own : &other;
				double least;

				single = box_pair_apart(&m.motion, a, b, loose);
				if (!(apart[l] > 0) && !(single > 0))
					continue;
				least = least_of(&m, a, b);
				require(apart[l] <= least, "case %ld: the node claims %.9g, %.9g is", n, apart[l],
					least);
				require(single <= least, "case %ld: one claims %.9g, %.9g is", n, single, least);
				claimed++;
				if (least > 0)
					tightest = fmax(tightest, apart[l] / least);
			}
		}
		bvh_free(m.bodies[0]);
		bvh_free(m.bodies[1]);
	}
	require(claimed > cases && tightest > 0.999, "%ld claims, the best %g", claimed, tightest);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("lower bound");

	tcase_add_test(tcase, every_level_gives_the_same_bits);
	tcase_add_test(tcase, nothing_is_nearer_than_claimed);
	return run_suite("boxes", tcase);
}
