#include "scene/convex.h"

#include <math.h>

#include "base/minmax.h"

/*
 * As a share of half the diagonal of the body's box. It exceeds twice the error of boxes, which are rounded outward;
 * the error of the projection of a box and its cap in float; and the error of a corner of a run and its projection. The
 * second of these is below 16 roundings of 2^-24, the others below 8. Because of the first, boxes beside a flat face
 * are not opened, although all of them extend as far as the face.
 */
#define SUPPORT_SLACK 0x1p-20

struct mesh_part mesh_part_of(const struct bvh *bvh, const struct corner_runs *corners, struct leaf leaf)
{
	struct mesh_part part = {bvh, corners, leaf, bvh->origin, bvh->radius};
	vec3 centre, half;

	if (!leaf.count && !leaf.first)
		return part;
	leaf_box(bvh, leaf, &centre, &half);
	part.centre = vec3_add(bvh->origin, centre);
	part.radius = vec3_norm(half);
	return part;
}

struct convex convex_of_mesh(const struct mesh_part *part, const xform *place, struct seen_corners *seen)
{
	return (struct convex){
		.mesh = part,
		.place = place,
		.seen = seen,
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

/* All points are relative to the tree's origin. */
struct farthest {
	const struct bvh *bvh;
	const struct corner_runs *corners;
	vec3 m;
	float direction[3];	/* m */
	double slack;	/* mm times |m|, like the next two: a gain of at most this much is not searched */
	double closed;	/* the largest extent of the boxes that were not opened */
	double most;	/* the largest extent of the corners so far */
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

static void try_child(struct farthest *f, const struct bvh_node *node, int i);

/*
 * The child with the largest extent is opened first. After it, most of the others are not large enough any more. The
 * depth of a tree is bounded (bvh.c).
 */
static void try_node(struct farthest *f, uint32_t at)
{
	const struct bvh_node *node = &f->bvh->nodes[at];
	const struct corner_run *run = &f->corners->runs[at];
	unsigned closed = (1u << node->used) - 1;
	float reach[BVH_WIDTH];

	f->visits += node->used;
	if (run->groups) {
		try_run(f, run);
		return;
	}
	if (run->caps)
		f->corners->kernels->caps_reach(node, &f->corners->caps[run->caps - 1], f->direction, reach);
	else
		f->corners->kernels->boxes_reach(node, f->direction, reach);
	while (closed) {
		const int best = f->corners->kernels->greatest_of(reach, closed);

		if (!(reach[best] > f->most + f->slack)) {
			f->closed = larger(f->closed, reach[best]);
			return;
		}
		closed &= ~(1u << best);
		try_child(f, node, best);
	}
}

static void try_child(struct farthest *f, const struct bvh_node *node, int i)
{
	if (!node->count[i])
		try_node(f, node->first[i]);
	for (uint32_t k = 0; k < node->count[i]; k++)
		try_triangle(f, node->first[i] + k);
}

/* The seen corner that reaches farthest along m; at least one was seen. */
static vec3 farthest_seen(const struct seen_corners *seen, vec3 m)
{
	const float n[3] = {(float)m.x, (float)m.y, (float)m.z};
	float most = -INFINITY;
	int best = 0;

	for (int i = 0; i < seen->count; i++) {
		const float along = n[0] * seen->x[i] + n[1] * seen->y[i] + n[2] * seen->z[i];

		best = along > most ? i : best;
		most = along > most ? along : most;
	}
	return (vec3){seen->x[best], seen->y[best], seen->z[best]};
}

/* Rounded to float, as the corners of a run are. */
static void add_seen(struct seen_corners *seen, vec3 p)
{
	const int i = seen->next;

	seen->x[i] = (float)p.x;
	seen->y[i] = (float)p.y;
	seen->z[i] = (float)p.z;
	seen->next = (i + 1) % SEEN_CORNERS;
	seen->count = seen->count < SEEN_CORNERS ? seen->count + 1 : SEEN_CORNERS;
}

static double support_of_mesh(const struct mesh_part *part, struct seen_corners *seen, vec3 m, double slack, vec3 *at,
			      long *visits)
{
	const struct bvh *bvh = part->bvh;
	const double norm = vec3_norm(m), rounding = SUPPORT_SLACK * norm * vec3_norm(bvh->half);
	struct farthest f = {
		.bvh = bvh,
		.corners = part->corners,
		.m = m,
		.direction = {(float)m.x, (float)m.y, (float)m.z},
		.slack = rounding + norm * slack,
		.closed = -INFINITY,
		.most = -INFINITY,
	};
	double known = -INFINITY;

	if (seen && seen->count) {
		f.at = farthest_seen(seen, m);
		f.most = known = vec3_dot(m, f.at);
	}
	for (uint32_t i = 0; i < part->leaf.count; i++)
		try_triangle(&f, part->leaf.first + i);
	if (!part->leaf.count)
		try_node(&f, part->leaf.first);
	*visits += f.visits + 1;
	if ((at || seen) && f.run)
		f.at = corner_runs_farthest(part->corners, f.run, f.direction);
	/* What is farther by rounding alone is known. */
	if (seen && f.most > known + rounding)
		add_seen(seen, f.at);
	if (at)
		*at = vec3_add(f.at, bvh->origin);
	return vec3_dot(m, bvh->origin) + (slack > 0 ? larger(f.most, f.closed) : f.most) + 3 * rounding;
}

double convex_support(const struct convex *convex, vec3 m, double slack, vec3 *at, long *visits)
{
	double most;

	if (convex->profile) {
		*visits += 1;
		return support_of_profile(convex, m, at);
	}
	most = support_of_mesh(convex->mesh, convex->seen, mat3_apply_transposed(&convex->place->rotation, m), slack,
			       at, visits);
	if (at)
		*at = xform_apply(convex->place, *at);
	return most + vec3_dot(m, convex->place->translation);
}

/* ------------------------------------------------------------------ direction */

/* The search ends when the gap along the direction is within this share of the distance. */
#define DIRECTION_SHARE 0.02

/* The permitted error of a support, as a share of the same part of the distance. */
#define SLACK_SHARE 0x1p-4

/* Differences between a point of b and a point of a. */
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

/* The point nearest to the origin in the affine hull of the corners in `mask`, if it is between them. */
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

/*
 * Reduces the simplex, to which a corner has just been added, to the corners whose hull contains the point nearest to
 * the origin. *nearest is that point of the other corners, and becomes that of all. If the new corner brings the hull
 * nearer, it is one of those that remain; otherwise the others remain.
 */
static void reduce(struct simplex *simplex, vec3 *nearest)
{
	const unsigned newest = 1u << (simplex->count - 1);
	double least = newest > 1 ? vec3_norm2(*nearest) : INFINITY;
	unsigned best = newest > 1 ? newest - 1 : newest;
	int kept = 0;

	for (unsigned mask = newest; mask < 2 * newest; mask++) {
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

/* A point of the part that reaches far along m: a seen corner, or the farthest point of the rings. */
static vec3 guess_farthest(const struct convex *convex, vec3 m)
{
	vec3 at, back;

	if (convex->profile) {
		support_of_profile(convex, m, &at);
		return at;
	}
	back = mat3_apply_transposed(&convex->place->rotation, m);
	return xform_apply(convex->place, vec3_add(farthest_seen(convex->seen, back), convex->mesh->bvh->origin));
}

static bool has_guess(const struct convex *convex)
{
	return convex->profile || (convex->seen && convex->seen->count);
}

/* The difference of two points that reach far along v and against it. */
static vec3 guess_difference(const struct convex *a, const struct convex *b, vec3 v)
{
	return vec3_sub(guess_farthest(b, vec3_scale(-1, v)), guess_farthest(a, v));
}

static void add_corner(struct simplex *simplex, struct convex_search *search, vec3 p, vec3 *nearest)
{
	search->seen[search->count++] = p;
	simplex->p[simplex->count++] = p;
	reduce(simplex, nearest);
}

/*
 * Approaches the point nearest to the origin with corners that were seen before, as far as they go: a few of them cost
 * much less than a support of a large mesh.
 */
static void approach(const struct convex *a, const struct convex *b, struct simplex *simplex,
		     struct convex_search *search, vec3 *v)
{
	if (!has_guess(a) || !has_guess(b))
		return;
	while (search->count < CONVEX_GUESSES && simplex->count < 4) {
		const double norm = vec3_norm(*v);
		const vec3 p = guess_difference(a, b, *v);

		if (!(norm > 1e-9) || (simplex->count && vec3_dot(*v, p) >= (1 - DIRECTION_SHARE) * norm * norm))
			return;
		add_corner(simplex, search, p, v);
	}
}

bool convex_direction(const struct convex *a, const struct convex *b, struct convex_search *search, long *visits)
{
	vec3 v = vec3_sub(b->centre, a->centre), on_a, on_b, p;
	struct simplex simplex = {0};
	bool found = false;

	search->count = 0;
	approach(a, b, &simplex, search, &v);
	for (int step = 0; step < CONVEX_STEPS && simplex.count < 4; step++) {
		double norm = vec3_norm(v), along;

		if (!(norm > 1e-9))
			return found;
		convex_support(a, v, SLACK_SHARE * norm, &on_a, visits);
		convex_support(b, vec3_scale(-1, v), SLACK_SHARE * norm, &on_b, visits);
		p = vec3_sub(on_b, on_a);
		along = vec3_dot(v, p);
		if (along > 0) {
			found = true;
			search->direction = vec3_scale(1 / norm, v);
			if (simplex.count && along >= (1 - DIRECTION_SHARE) * norm * norm)
				return true;
		}
		add_corner(&simplex, search, p, &v);
	}
	return found;
}
