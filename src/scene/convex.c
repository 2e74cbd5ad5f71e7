#include "scene/convex.h"

#include <math.h>

#include "base/minmax.h"

/*
 * As a share of half the diagonal of the body's box: more than twice what boxes reach too far, as they are rounded
 * outward; more than what the projection of a box in float is off; more than what a corner of a run and its projection
 * are. Each is below 8 roundings of 2^-24. The first keeps boxes beside a flat face shut, all of which reach as far as
 * the face.
 */
#define SUPPORT_SLACK 0x1p-20

/* The runs of triangles below a leaf or node. */
static void run_of(const struct bvh *bvh, struct leaf leaf, size_t *first, size_t *count)
{
	*first = leaf.count ? leaf.first : bvh->nodes[leaf.first].begin;
	*count = leaf.count ? leaf.count : bvh->nodes[leaf.first].total;
}

/* Into the piece of the axis that holds u. */
static void widen_ring(struct profile *profile, int k, double u, double rho)
{
	bool first = profile->rho[k] < 0;

	profile->low[k] = first ? u : smaller(profile->low[k], u);
	profile->high[k] = first ? u : larger(profile->high[k], u);
	profile->rho[k] = larger(profile->rho[k], rho);
}

void profile_init(struct profile *profile, const struct bvh *bvh, struct leaf leaf, const xform *place, vec3 location,
		  vec3 axis)
{
	const vec3 along = mat3_apply_transposed(&place->rotation, axis);
	const vec3 from = mat3_apply_transposed(&place->rotation, vec3_sub(location, place->translation));
	double least = INFINITY, greatest = -INFINITY;
	size_t first, count;

	run_of(bvh, leaf, &first, &count);
	for (size_t i = 0; i < 3 * count; i++) {
		double u = vec3_dot(along, mesh_corner(&bvh->mesh.triangles[first + i / 3], (int)(i % 3)));

		least = smaller(least, u);
		greatest = larger(greatest, u);
	}
	for (int k = 0; k < PROFILE_RINGS; k++)
		profile->rho[k] = -1;
	for (size_t i = 0; i < 3 * count; i++) {
		vec3 p = mesh_corner(&bvh->mesh.triangles[first + i / 3], (int)(i % 3)), to = vec3_sub(p, from);
		double way = vec3_dot(along, p) - least;
		int k = greatest > least ? (int)(way / (greatest - least) * PROFILE_RINGS) : 0;

		widen_ring(profile, k < 0 ? 0 : k >= PROFILE_RINGS ? PROFILE_RINGS - 1 : k, vec3_dot(along, to),
			   vec3_norm(vec3_cross(along, to)));
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

struct mesh_part mesh_part_of(const struct bvh *bvh, const struct corner_runs *corners, struct leaf leaf)
{
	struct mesh_part part = {bvh, corners, leaf, bvh->origin, bvh->radius};
	vec3 least, greatest;
	size_t first, count;

	if (!leaf.count && !leaf.first)
		return part;
	run_of(bvh, leaf, &first, &count);
	least = greatest = mesh_corner(&bvh->mesh.triangles[first], 0);
	for (size_t i = 0; i < 3 * count; i++) {
		vec3 p = mesh_corner(&bvh->mesh.triangles[first + i / 3], (int)(i % 3));

		least = vec3_min(least, p);
		greatest = vec3_max(greatest, p);
	}
	part.centre = vec3_scale(0.5, vec3_add(least, greatest));
	part.radius = 0.5 * vec3_norm(vec3_sub(greatest, least));
	return part;
}

struct convex convex_of_mesh(const struct mesh_part *part, const xform *place)
{
	return (struct convex){
		.mesh = part,
		.place = place,
		.centre = xform_apply(place, part->centre),
		.radius = part->radius,
	};
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
	if (!at)
		return vec3_dot(m, convex->location) + most;
	*at = vec3_mad(convex->location, along > 0 ? profile->high[best] : profile->low[best], convex->axis);
	if (across > 0)
		*at = vec3_mad(*at, profile->rho[best] / across, out);
	return vec3_dot(m, convex->location) + most;
}

/* All from the tree's origin. */
struct farthest {
	const struct bvh *bvh;
	const struct corner_runs *corners;
	vec3 m;
	float direction[3];	/* m */
	double slack;	/* what reaches at most so much farther is not looked for */
	double most;	/* mm times |m|: of what reaches farthest */
	vec3 at;	/* a triangle's corner; or anywhere in the run */
	const struct corner_run *run;	/* or NULL */
	long visits;
};

static void try_triangle(struct farthest *f, uint32_t triangle)
{
	for (int k = 0; k < 3; k++) {
		vec3 p = vec3_sub(mesh_corner(&f->bvh->mesh.triangles[triangle], k), f->bvh->origin);
		double along = vec3_dot(f->m, p);

		if (along > f->most) {
			f->most = along;
			f->at = p;
			f->run = NULL;
		}
	}
}

static void try_run(struct farthest *f, const struct corner_run *run)
{
	const float *points = &f->corners->points[(size_t)run->first * 3 * BVH_WIDTH];
	double along = f->corners->kernels->points_reach(points, run->groups, f->direction);

	if (along > f->most) {
		f->most = along;
		f->run = run;
	}
}

/* The child that reaches farthest of those that reach far enough; the others are closed. None: BVH_WIDTH. */
static int next_child(const float reach[BVH_WIDTH], double enough, unsigned *open)
{
	int best = BVH_WIDTH;

	for (int i = 0; i < BVH_WIDTH && *open >> i; i++) {
		if (!(*open >> i & 1))
			continue;
		if (!(reach[i] > enough))
			*open &= ~(1u << i);
		else if (best == BVH_WIDTH || reach[i] > reach[best])
			best = i;
	}
	return best;
}

/* The child that may reach farthest is looked at first. The depth of a tree is bounded (bvh.c). */
static void try_node(struct farthest *f, uint32_t at)
{
	const struct bvh_node *node = &f->bvh->nodes[at];
	float reach[BVH_WIDTH];
	unsigned open;
	int best;

	f->visits += node->used;
	if (f->corners->runs[at].groups) {
		try_run(f, &f->corners->runs[at]);
		return;
	}
	open = f->corners->kernels->boxes_reach(node, f->direction, (float)(f->most + f->slack), reach);
	while ((best = next_child(reach, f->most + f->slack, &open)) < BVH_WIDTH) {
		open &= ~(1u << best);
		if (!node->count[best])
			try_node(f, node->first[best]);
		for (uint32_t i = 0; i < node->count[best]; i++)
			try_triangle(f, node->first[best] + i);
	}
}

static double support_of_mesh(const struct mesh_part *part, vec3 m, vec3 *at, long *visits)
{
	const struct bvh *bvh = part->bvh;
	double slack = SUPPORT_SLACK * vec3_norm(m) * vec3_norm(bvh->half);
	struct farthest f = {
		.bvh = bvh,
		.corners = part->corners,
		.m = m,
		.direction = {(float)m.x, (float)m.y, (float)m.z},
		.slack = slack,
		.most = -INFINITY,
	};

	for (uint32_t i = 0; i < part->leaf.count; i++)
		try_triangle(&f, part->leaf.first + i);
	if (!part->leaf.count)
		try_node(&f, part->leaf.first);
	*visits += f.visits + 1;
	if (at && f.run)
		f.at = corner_runs_farthest(part->corners, f.run, f.direction);
	if (at)
		*at = vec3_add(f.at, bvh->origin);
	return vec3_dot(m, bvh->origin) + f.most + 3 * slack;
}

double convex_support(const struct convex *convex, vec3 m, vec3 *at, long *visits)
{
	double most;

	if (convex->profile) {
		*visits += 1;
		return support_of_profile(convex, m, at);
	}
	most = support_of_mesh(convex->mesh, mat3_apply_transposed(&convex->place->rotation, m), at, visits);
	if (at)
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
