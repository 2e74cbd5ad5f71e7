#include "scene/body_shapes.h"

#include <math.h>
#include <string.h>

#include "base/parallel_for.h"
#include "solids.h"
#include "suite.h"

enum { AXES = 3, ASKED = 60, THREADS = 4 };

/* A body, the axes in question, and the result of each thread. */
struct asked {
	struct bvh *bvh;
	xform place;
	struct body_shapes *shapes;
	vec3 locations[AXES], axes[AXES];
	struct profile profiles[ASKED];
	long visits[ASKED];
	const struct corner_runs *corners[ASKED];
};

static void init_asked(struct asked *asked, struct random *random)
{
	const double size = random_size(random, 1, 1e3);
	struct mesh mesh = random_solid(random, size);

	asked->bvh = bvh_new(&mesh);
	asked->place = random_place(random, size);
	asked->shapes = body_shapes_new(asked->bvh, &asked->place);
	for (int i = 0; i < AXES; i++) {
		asked->locations[i] = random_point(random, size);
		asked->axes[i] = random_unit(random);
	}
	/* The same joint from the other side. */
	asked->locations[1] = asked->locations[0];
	asked->axes[1] = vec3_scale(-1, asked->axes[0]);
}

static void ask(void *context, int worker, size_t i)
{
	struct asked *asked = context;
	struct body_shapes *shapes = body_shapes_hold(asked->shapes);

	(void)worker;
	asked->visits[i] = (long)i;
	body_shapes_profile(shapes, asked->locations[i % AXES], asked->axes[i % AXES], &asked->profiles[i],
			    &asked->visits[i]);
	asked->corners[i] = body_shapes_corners(shapes);
	body_shapes_release(shapes);
}

static void require_same(const struct profile *got, const struct profile *want, long n)
{
	require(got->count == want->count, "case %ld: %d rings, not %d", n, got->count, want->count);
	for (int k = 0; k < want->count; k++)
		require(!memcmp(&got->low[k], &want->low[k], sizeof(double)) &&
				!memcmp(&got->high[k], &want->high[k], sizeof(double)) &&
				!memcmp(&got->rho[k], &want->rho[k], sizeof(double)),
			"case %ld: ring %d differs", n, k);
}

START_TEST(each_pair_gets_what_it_would_make_for_itself_at_the_same_price)
{
	for (long n = 0; n < random_cases(100); n++) {
		struct random random = random_case(1, n);
		static struct asked asked;

		init_asked(&asked, &random);
		parallel_for(ASKED, THREADS, ask, &asked);
		for (size_t i = 0; i < ASKED; i++) {
			struct profile want;
			long visits = (long)i;

			profile_init(&want, asked.bvh, (struct leaf){0, 0}, &asked.place, asked.locations[i % AXES],
				     asked.axes[i % AXES], &visits);
			require_same(&asked.profiles[i], &want, n);
			require(asked.visits[i] == visits, "case %ld: %ld visits, not %ld", n, asked.visits[i], visits);
			require(asked.corners[i] == asked.corners[0], "case %ld: the corners are made again", n);
		}
		body_shapes_release(asked.shapes);
		bvh_free(asked.bvh);
	}
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("body_shapes");

	tcase_add_test(tcase, each_pair_gets_what_it_would_make_for_itself_at_the_same_price);
	return run_suite("body_shapes", tcase);
}
