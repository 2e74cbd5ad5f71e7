#include "scene/convex.h"

#include <math.h>

#include "base/minmax.h"

/*
 * As a share of half the diagonal of the body's box: more than twice what boxes reach too far, as they are rounded
 * outward, and more than what the projection of a box in float is off. Each is below 8 roundings of 2^-24. The first
 * keeps boxes beside a flat face shut, all of which reach as far as the face.
 */
#define SUPPORT_SLACK 0x1p-20

/* The runs of triangles below a leaf or node. */
static void run_of(const struct bvh *bvh, struct leaf leaf, size_t *first, size_t *count)
{
	*first = leaf.count ? leaf.first : bvh->nodes[leaf.first].begin;
	*count = leaf.count ? leaf.count : bvh->nodes[leaf.first].total;
}

/* A corner as seen along an axis: how far along it, how far from it. */
static void about_axis(vec3 p, vec3 location, vec3 axis, double *u, double *rho)
{
	vec3 to = vec3_sub(p, location);

	*u = vec3_dot(axis, to);
	*rho = vec3_norm(vec3_cross(axis, to));
}

void profile_init(struct profile *profile, const struct bvh *bvh, struct leaf leaf, const xform *place, vec3 location,
		  vec3 axis)
{
	double least = INFINITY, greatest = -INFINITY, u, rho;
	size_t first, count;

	run_of(bvh, leaf, &first, &count);
	for (size_t i = 0; i < 3 * count; i++) {
		vec3 p = mesh_corner(&bvh->mesh.triangles[first + i / 3], (int)(i % 3));

		about_axis(xform_apply(place, p), location, axis, &u, &rho);
		least = smaller(least, u);
		greatest = larger(greatest, u);
	}
	for (int k = 0; k < PROFILE_RINGS; k++)
		profile->rho[k] = -1;
	for (size_t i = 0; i < 3 * count; i++) {
		vec3 p = mesh_corner(&bvh->mesh.triangles[first + i / 3], (int)(i % 3));
		int k;

		about_axis(xform_apply(place, p), location, axis, &u, &rho);
		k = greatest > least ? (int)((u - least) / (greatest - least) * PROFILE_RINGS) : 0;
		k = k < 0 ? 0 : k >= PROFILE_RINGS ? PROFILE_RINGS - 1 : k;
		profile->low[k] = profile->rho[k] < 0 ? u : smaller(profile->low[k], u);
		profile->high[k] = profile->rho[k] < 0 ? u : larger(profile->high[k], u);
		profile->rho[k] = larger(profile->rho[k], rho);
	}
	profile->count = 0;
	for (int k = 0; k < PROFILE_RINGS; k++) {
		if (profile->rho[k] < 0)
			continue;
		profile->low[profile->count] = profile->low[k];
		profile->high[profile->count] = profile->high[k];
		profile->rho[profile->count++] = profile->rho[k];
	}
}

struct convex convex_of_mesh(const struct bvh *bvh, struct leaf leaf, const xform *place)
{
	struct convex convex = {.bvh = bvh, .leaf = leaf, .place = place};
	vec3 least, greatest;
	size_t first, count;

	if (!leaf.count && !leaf.first) {
		convex.centre = xform_apply(place, bvh->origin);
		convex.radius = bvh->radius;
		return convex;
	}
	run_of(bvh, leaf, &first, &count);
	least = greatest = mesh_corner(&bvh->mesh.triangles[first], 0);
	for (size_t i = 0; i < 3 * count; i++) {
		vec3 p = mesh_corner(&bvh->mesh.triangles[first + i / 3], (int)(i % 3));

		least = vec3_min(least, p);
		greatest = vec3_max(greatest, p);
	}
	convex.centre = xform_apply(place, vec3_scale(0.5, vec3_add(least, greatest)));
	convex.radius = 0.5 * vec3_norm(vec3_sub(greatest, least));
	return convex;
}

struct convex convex_of_profile(const struct profile *profile, vec3 location, vec3 axis)
{
	struct convex convex = {.profile = profile, .location = location, .axis = axis};
	int last = profile->count - 1;
	double middle = 0.5 * (profile->low[0] + profile->high[last]), square = 0;

	for (int k = 0; k <= last; k++) {
		double along = larger(fabs(profile->low[k] - middle), fabs(profile->high[k] - middle));

		square = larger(square, along * along + profile->rho[k] * profile->rho[k]);
	}
	convex.centre = vec3_mad(location, middle, axis);
	convex.radius = sqrt(square);
	return convex;
}

static double support_of_profile(const struct convex *convex, vec3 m, vec3 *at)
{
	const struct profile *profile = convex->profile;
	double along = vec3_dot(m, convex->axis), most = -INFINITY, across;
	vec3 out = vec3_mad(m, -along, convex->axis);
	int best = 0;

	across = vec3_norm(out);
	for (int k = 0; k < profile->count; k++) {
		double reach = larger(along * profile->low[k], along * profile->high[k]) + across * profile->rho[k];

		best = reach > most ? k : best;
		most = larger(most, reach);
	}
	*at = vec3_mad(convex->location, along > 0 ? profile->high[best] : profile->low[best], convex->axis);
	if (across > 0)
		*at = vec3_mad(*at, profile->rho[best] / across, out);
	return vec3_dot(m, convex->location) + most;
}

struct farthest {
	const struct bvh *bvh;
	vec3 m;
	float direction[3], size[3];	/* m and its absolute values */
	float slack;	/* what reaches at most so much farther is not looked for */
	double base, most;	/* mm times |m|: of the tree's origin, and of what reaches farthest, from there */
	vec3 at;
	long visits;
};

static void try_triangle(struct farthest *f, uint32_t triangle)
{
	for (int k = 0; k < 3; k++) {
		vec3 p = mesh_corner(&f->bvh->mesh.triangles[triangle], k);
		double along = vec3_dot(f->m, p) - f->base;

		if (along > f->most) {
			f->most = along;
			f->at = p;
		}
	}
}

/* The child that may reach farthest is looked at first. The depth of a tree is bounded (bvh.c). */
static void try_node(struct farthest *f, const struct bvh_node *node)
{
	const struct bvh *bvh = f->bvh;
	const float *n = f->direction, *size = f->size;
	float reach[BVH_WIDTH];

	f->visits += node->used;
	for (int i = 0; i < BVH_WIDTH; i++)
		reach[i] = n[0] * node->centre[0][i] + n[1] * node->centre[1][i] + n[2] * node->centre[2][i] +
			   size[0] * node->half[0][i] + size[1] * node->half[1][i] + size[2] * node->half[2][i] -
			   f->slack;
	for (;;) {
		int best = 0;

		for (int i = 1; i < node->used; i++)
			best = reach[i] > reach[best] ? i : best;
		if (!(reach[best] > f->most))
			return;
		reach[best] = -INFINITY;
		if (!node->count[best])
			try_node(f, &bvh->nodes[node->first[best]]);
		for (uint32_t i = 0; i < node->count[best]; i++)
			try_triangle(f, node->first[best] + i);
	}
}

static double support_of_mesh(const struct convex *convex, vec3 m, vec3 *at, long *visits)
{
	const struct bvh *bvh = convex->bvh;
	double slack = SUPPORT_SLACK * vec3_norm(m) * vec3_norm(bvh->half);
	struct farthest f = {
		.bvh = bvh,
		.m = m,
		.direction = {(float)m.x, (float)m.y, (float)m.z},
		.size = {fabsf((float)m.x), fabsf((float)m.y), fabsf((float)m.z)},
		.slack = (float)slack,
		.base = vec3_dot(m, bvh->origin),
		.most = -INFINITY,
	};

	for (uint32_t i = 0; i < convex->leaf.count; i++)
		try_triangle(&f, convex->leaf.first + i);
	if (!convex->leaf.count)
		try_node(&f, &bvh->nodes[convex->leaf.first]);
	*visits += f.visits + 1;
	*at = f.at;
	return f.base + f.most + 2 * slack;
}

double convex_support(const struct convex *convex, vec3 m, vec3 *at, long *visits)
{
	double most;

	if (convex->profile) {
		*visits += 1;
		return support_of_profile(convex, m, at);
	}
	most = support_of_mesh(convex, mat3_apply_transposed(&convex->place->rotation, m), at, visits);
	*at = xform_apply(convex->place, *at);
	return most + vec3_dot(m, convex->place->translation);
}

/* ------------------------------------------------------------------ direction */

/* The search ends where the gap along the direction is within this share of the distance. */
#define DIRECTION_SHARE 0.02

/* Differences of a point of b and a point of a. */
struct simplex {
	int count;
	vec3 p[4];
};

/* Solves the symmetric n x n system; false: it is singular. */
static bool solve(int n, double m[3][4])
{
	for (int i = 0; i < n; i++) {
		if (!(m[i][i] > 1e-12 * m[0][0]))
			return false;
		for (int r = i + 1; r < n; r++) {
			double share = m[r][i] / m[i][i];

			for (int c = i; c <= n; c++)
				m[r][c] -= share * m[i][c];
		}
	}
	for (int i = n; i-- > 0;) {
		for (int c = i + 1; c < n; c++)
			m[i][n] -= m[i][c] * m[c][n];
		m[i][n] /= m[i][i];
	}
	return true;
}

/* The point nearest to the origin in the affine hull of the corners in `mask`, if it lies within them. */
static bool nearest_of(const struct simplex *simplex, unsigned mask, vec3 *out)
{
	vec3 edges[3], from = {0, 0, 0};
	double m[3][4], sum = 0;
	int n = -1;

	for (int i = 0; i < simplex->count; i++) {
		if (!(mask & (1u << i)))
			continue;
		if (n < 0)
			from = simplex->p[i];
		else
			edges[n] = vec3_sub(simplex->p[i], from);
		n++;
	}
	for (int i = 0; i < n; i++) {
		for (int k = 0; k < n; k++)
			m[i][k] = vec3_dot(edges[i], edges[k]);
		m[i][n] = -vec3_dot(edges[i], from);
	}
	if (!solve(n, m))
		return false;
	*out = from;
	for (int i = 0; i < n; i++) {
		if (!(m[i][n] > 0))
			return false;
		sum += m[i][n];
		*out = vec3_mad(*out, m[i][n], edges[i]);
	}
	return sum < 1;
}

/* Reduces the simplex to the corners that hold the point nearest to the origin, which becomes *nearest. */
static void reduce(struct simplex *simplex, vec3 *nearest)
{
	double least = INFINITY;
	unsigned best = 1;
	int kept = 0;

	for (unsigned mask = 1; mask < 1u << simplex->count; mask++) {
		vec3 p;

		if (nearest_of(simplex, mask, &p) && vec3_norm2(p) < least) {
			least = vec3_norm2(p);
			*nearest = p;
			best = mask;
		}
	}
	for (int i = 0; i < simplex->count; i++)
		if (best & (1u << i))
			simplex->p[kept++] = simplex->p[i];
	simplex->count = kept;
}

bool convex_direction(const struct convex *a, const struct convex *b, struct convex_search *search, long *visits)
{
	vec3 v = vec3_sub(b->centre, a->centre), on_a, on_b;
	struct simplex simplex = {0};
	bool found = false;

	search->count = 0;
	for (int step = 0; step < CONVEX_STEPS && simplex.count < 4; step++) {
		double norm = vec3_norm(v), along;

		if (!(norm > 1e-9))
			return found;
		convex_support(a, v, &on_a, visits);
		convex_support(b, vec3_scale(-1, v), &on_b, visits);
		simplex.p[simplex.count] = vec3_sub(on_b, on_a);
		search->seen[search->count++] = simplex.p[simplex.count];
		along = vec3_dot(v, simplex.p[simplex.count]);
		if (along > 0) {
			found = true;
			search->direction = vec3_scale(1 / norm, v);
			if (step && along >= (1 - DIRECTION_SHARE) * norm * norm)
				return true;
		}
		simplex.count++;
		reduce(&simplex, &v);
	}
	return found;
}
