#include "scene/profile.h"

#include <math.h>

#include "base/minmax.h"

/*
 * A box whose half diagonal is at most this share of the part's is not opened. The excess of its corners is about that
 * of one of 32 rings on a ball.
 */
#define FINE_SHARE 0x1p-6

/* Opening a box of so few triangles does not pay: they have about as many corners as the box. */
enum { FEW_TRIANGLES = 8 };

struct gathering {
	const struct bvh *bvh;
	vec3 along, from;	/* the axis and its location, from the tree's origin */
	double start, per_mm;	/* the rings start at `start` mm along the axis */
	double fine;	/* mm: of half the diagonal of a box */
	struct profile *profile;	/* by position along the axis; rho below 0: empty */
	long visits;
};

static int ring_of(const struct gathering *g, double u)
{
	double k = (u - g->start) * g->per_mm;

	return k >= PROFILE_RINGS - 1 ? PROFILE_RINGS - 1 : k > 0 ? (int)k : 0;
}

/* Widens the k-th piece of the axis to include u and rho. */
static void widen_ring(struct profile *profile, int k, double u, double rho)
{
	bool first = profile->rho[k] < 0;

	profile->low[k] = first ? u : smaller(profile->low[k], u);
	profile->high[k] = first ? u : larger(profile->high[k], u);
	profile->rho[k] = larger(profile->rho[k], rho);
}

static void add_triangles(const struct gathering *g, size_t first, size_t count)
{
	for (size_t i = first; i < first + count; i++) {
		for (int k = 0; k < 3; k++) {
			vec3 p = vec3_sub(mesh_corner(&g->bvh->mesh.triangles[i], k), g->bvh->origin);
			vec3 to = vec3_sub(p, g->from);
			double u = vec3_dot(g->along, to);

			widen_ring(g->profile, ring_of(g, u), u, vec3_norm(vec3_cross(g->along, to)));
		}
	}
}

/* A ring that contains a box, with the pieces of the axis that contain its ends. */
struct box_ring {
	double low, high, rho;
	int first, last;
};

static struct box_ring ring_around(const struct gathering *g, vec3 centre, vec3 half, double radius)
{
	vec3 to = vec3_sub(centre, g->from);
	double u = vec3_dot(g->along, to);
	double off = fabs(g->along.x) * half.x + fabs(g->along.y) * half.y + fabs(g->along.z) * half.z;
	double rho = vec3_norm(vec3_cross(g->along, to)) + radius;

	return (struct box_ring){u - off, u + off, rho, ring_of(g, u - off), ring_of(g, u + off)};
}

/* Two rings that are wide enough contain everything between the start of one and the end of the other. */
static bool holds_ring(const struct profile *profile, const struct box_ring *ring)
{
	return profile->rho[ring->first] >= ring->rho && profile->low[ring->first] <= ring->low &&
	       profile->rho[ring->last] >= ring->rho && profile->high[ring->last] >= ring->high;
}

/* The depth of a tree is bounded (bvh.c). */
static void add_branch(struct gathering *g, uint32_t at)
{
	const struct bvh_node *node = &g->bvh->nodes[at];

	g->visits++;
	for (int i = 0; i < node->used; i++) {
		const vec3 half = bvh_child_half(node, i);
		const double radius = vec3_norm(half);
		struct box_ring ring;

		if (node->count[i]) {
			add_triangles(g, node->first[i], node->count[i]);
			continue;
		}
		ring = ring_around(g, bvh_child_centre(node, i), half, radius);
		if (holds_ring(g->profile, &ring))
			continue;
		if (radius <= g->fine && g->bvh->nodes[node->first[i]].total > FEW_TRIANGLES) {
			widen_ring(g->profile, ring.first, ring.low, ring.rho);
			widen_ring(g->profile, ring.last, ring.high, ring.rho);
		} else {
			add_branch(g, node->first[i]);
		}
	}
}

/* The part's box determines where rings begin and which boxes are small. */
static void begin_profile(struct gathering *g, vec3 centre, vec3 half)
{
	double off = fabs(g->along.x) * half.x + fabs(g->along.y) * half.y + fabs(g->along.z) * half.z;

	g->start = vec3_dot(g->along, vec3_sub(centre, g->from)) - off;
	g->per_mm = off > 0 ? PROFILE_RINGS / (2 * off) : 0;
	g->fine = FINE_SHARE * vec3_norm(half);
	for (int k = 0; k < PROFILE_RINGS; k++) {
		g->profile->low[k] = g->profile->high[k] = 0;
		g->profile->rho[k] = -1;
	}
}

/* Moves the rings in use to the front. */
static void close_up(struct profile *profile)
{
	profile->count = 0;
	for (int k = 0; k < PROFILE_RINGS; k++) {
		if (profile->rho[k] < 0)
			continue;
		profile->low[profile->count] = profile->low[k];
		profile->high[profile->count] = profile->high[k];
		profile->rho[profile->count++] = profile->rho[k];
	}
}

void profile_init(struct profile *profile, const struct bvh *bvh, struct leaf leaf, const xform *place, vec3 location,
		  vec3 axis, long *visits)
{
	const vec3 from = mat3_apply_transposed(&place->rotation, vec3_sub(location, place->translation));
	struct gathering g = {
		.bvh = bvh,
		.along = mat3_apply_transposed(&place->rotation, axis),
		.from = vec3_sub(from, bvh->origin),
		.profile = profile,
	};
	vec3 centre, half;

	leaf_box(bvh, leaf, &centre, &half);
	begin_profile(&g, centre, half);
	if (leaf.count)
		add_triangles(&g, leaf.first, leaf.count);
	else
		add_branch(&g, leaf.first);
	close_up(profile);
	*visits += g.visits;
}
