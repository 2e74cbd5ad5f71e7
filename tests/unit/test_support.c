#include "geom/support.h"

#include "geom/simd_kernels.h"
#include "geom/tolerance.h"
#include "solids.h"
#include "suite.h"

/* Triangles of all sizes, anywhere; their number is around those at which the vector loop begins and ends. */
static struct mesh random_triangles(struct random *random)
{
	struct mesh mesh = {0};
	double size = random_size(random, 1e-3, 1e5), edge = size * random_size(random, 1e-6, 1);
	vec3 middle = random_point(random, size);
	int count = 1 + random_below(random, 40);

	for (int i = 0; i < count; i++) {
		vec3 at = vec3_add(middle, random_point(random, edge));

		solid_add(&mesh, at, vec3_add(at, random_point(random, edge)), vec3_add(at, random_point(random, edge)));
	}
	return mesh;
}

/* By the definition. */
static long double true_support(const struct mesh *mesh, vec3 n, double *farthest)
{
	long double greatest = -INFINITY;

	*farthest = 0;
	for (size_t i = 0; i < mesh->count; i++) {
		for (int k = 0; k < 3; k++) {
			vec3 p = mesh_corner(&mesh->triangles[i], k);
			long double along = (long double)n.x * p.x + (long double)n.y * p.y + (long double)n.z * p.z;

			greatest = fmaxl(greatest, along);
			*farthest = fmax(*farthest, vec3_norm(p));
		}
	}
	return greatest;
}

START_TEST(it_is_within_its_rounding)
{
	double worst = 0;

	for (long n = 0; n < random_cases(100000); n++) {
		struct random random = random_case(1, n);
		struct mesh mesh = random_triangles(&random);
		vec3 direction = random_unit(&random);
		double farthest, got = support(mesh.triangles, mesh.count, direction, simd_level());
		double off = fabs((double)(true_support(&mesh, direction, &farthest) - got));

		require(off <= SUPPORT_ROUNDING * farthest, "case %ld: off by %g of %g", n, off, farthest);
		worst = fmax(worst, off / (SUPPORT_ROUNDING * farthest));
		mesh_release(&mesh);
	}
	require(worst > 0.1, "the bound is slack: %g of it", worst);
}
END_TEST

START_TEST(every_level_gives_the_same_bits)
{
	for (long n = 0; n < random_cases(20000); n++) {
		struct random random = random_case(2, n);
		struct mesh mesh = random_triangles(&random);
		vec3 unit = random_unit(&random);
		const float direction[3] = {(float)unit.x, (float)unit.y, (float)unit.z};
		float want = simd_kernels_scalar.support(mesh.triangles, mesh.count, direction);

		for (int level = LANES_SCALAR + 1; level <= simd_level(); level++) {
			float got = simd_kernels_at_level(level)->support(mesh.triangles, mesh.count, direction);

			require(!(got < want) && !(got > want), "case %ld: level %d says %a, the scalar one %a", n, level,
				(double)got, (double)want);
		}
		mesh_release(&mesh);
	}
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("greatest projection");

	tcase_add_test(tcase, it_is_within_its_rounding);
	tcase_add_test(tcase, every_level_gives_the_same_bits);
	return run_suite("support", tcase);
}
