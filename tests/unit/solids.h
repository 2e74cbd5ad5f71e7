/* solids.h - small closed meshes, pairs of them on random chains, and their distance by brute force: for tests. */
#ifndef FIVECHECK_TESTS_SOLIDS_H
#define FIVECHECK_TESTS_SOLIDS_H

#include <float.h>
#include <stdlib.h>

#include "base/mem.h"
#include "geom/moved_tri.h"
#include "scene/motion_interval.h"
#include "truth.h"

static inline void solid_add(struct mesh *mesh, vec3 a, vec3 b, vec3 c)
{
	const vec3 corners[3] = {a, b, c};
	mesh_triangle t;

	for (int k = 0; k < 3; k++) {
		t.v[k][0] = (float)corners[k].x;
		t.v[k][1] = (float)corners[k].y;
		t.v[k][2] = (float)corners[k].z;
	}
	/* Room for the next power of two. */
	if (!(mesh->count & (mesh->count - 1)))
		mesh->triangles = mem_realloc(mesh->triangles, mesh->count ? 2 * mesh->count : 1, sizeof(t));
	mesh->triangles[mesh->count++] = t;
}

static inline void solid_quad(struct mesh *mesh, vec3 a, vec3 b, vec3 c, vec3 d)
{
	solid_add(mesh, a, b, c);
	solid_add(mesh, a, c, d);
}

/* A straight prism over a regular polygon of n corners, along z; its side faces are `rows` high. */
static inline void solid_prism(struct mesh *mesh, int n, double radius, double half, int rows)
{
	for (int i = 0; i < n; i++) {
		double a0 = 2 * PI * i / n, a1 = 2 * PI * ((i + 1) % n) / n;
		vec3 p = {radius * cos(a0), radius * sin(a0), 0}, q = {radius * cos(a1), radius * sin(a1), 0};
		const vec3 up = {0, 0, 1};

		for (int r = 0; r < rows; r++) {
			double z0 = half * (2.0 * r / rows - 1), z1 = half * (2.0 * (r + 1) / rows - 1);

			solid_quad(mesh, vec3_mad(p, z0, up), vec3_mad(q, z0, up), vec3_mad(q, z1, up),
				   vec3_mad(p, z1, up));
		}
		solid_add(mesh, vec3_scale(half, up), vec3_mad(p, half, up), vec3_mad(q, half, up));
		solid_add(mesh, vec3_scale(-half, up), vec3_mad(q, -half, up), vec3_mad(p, -half, up));
	}
}

static inline void solid_box(struct mesh *mesh, vec3 half)
{
	vec3 p[8];

	for (int i = 0; i < 8; i++)
		p[i] = (vec3){i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y, i & 4 ? half.z : -half.z};
	solid_quad(mesh, p[0], p[2], p[3], p[1]);
	solid_quad(mesh, p[4], p[5], p[7], p[6]);
	solid_quad(mesh, p[0], p[1], p[5], p[4]);
	solid_quad(mesh, p[2], p[6], p[7], p[3]);
	solid_quad(mesh, p[0], p[4], p[6], p[2]);
	solid_quad(mesh, p[1], p[3], p[7], p[5]);
}

static inline void solid_tetrahedron(struct mesh *mesh, struct random *random, double size)
{
	vec3 p[4];

	for (int i = 0; i < 4; i++)
		p[i] = random_point(random, size);
	solid_add(mesh, p[0], p[1], p[2]);
	solid_add(mesh, p[0], p[2], p[3]);
	solid_add(mesh, p[0], p[3], p[1]);
	solid_add(mesh, p[1], p[3], p[2]);
}

/* 2 n (m - 1) triangles. */
static inline void solid_sphere(struct mesh *mesh, double radius, int n, int m)
{
	for (int i = 0; i < n; i++) {
		for (int j = 0; j < m; j++) {
			vec3 p[4];

			for (int k = 0; k < 4; k++) {
				double around = 2 * PI * ((i + (k == 1 || k == 2)) % n) / n,
				       down = PI * (j + (k >= 2)) / m;

				p[k] = (vec3){radius * sin(down) * cos(around), radius * sin(down) * sin(around),
					      radius * cos(down)};
			}
			if (j > 0)
				solid_add(mesh, p[0], p[2], p[1]);
			if (j < m - 1)
				solid_add(mesh, p[0], p[3], p[2]);
		}
	}
}

/* A box, prism, tetrahedron or, rarely, a sphere of some hundred triangles; `size` mm. */
static inline struct mesh random_solid(struct random *random, double size)
{
	struct mesh mesh = {0};

	switch (random_below(random, 13)) {
	case 0:
		solid_sphere(&mesh, size, 6 + random_below(random, 10), 5 + random_below(random, 10));
		break;
	case 1:
	case 2:
	case 3:
	case 4:
		solid_tetrahedron(&mesh, random, size);
		break;
	case 5:
	case 6:
	case 7:
		solid_prism(&mesh, 3 + random_below(random, 8), size, size * random_size(random, 0.05, 1), 1);
		break;
	default:
		solid_box(&mesh, (vec3){size * random_size(random, 0.01, 1), size * random_size(random, 0.1, 1), size});
	}
	return mesh;
}

/* Turns and shifts a mesh; its coordinates are rounded to float again. */
static inline void solid_place(struct mesh *mesh, const xform *place)
{
	for (size_t i = 0; i < mesh->count; i++) {
		for (int k = 0; k < 3; k++) {
			vec3 p = xform_apply(place, mesh_corner(&mesh->triangles[i], k));
			float *v = mesh->triangles[i].v[k];

			v[0] = (float)p.x;
			v[1] = (float)p.y;
			v[2] = (float)p.z;
		}
	}
}

/* Two bodies on a chain; the pair borrows the rest. */
struct duo {
	struct chain chain;
	struct bvh *a, *b;
	struct body_pair pair;
};

/* Takes over the meshes. */
static inline void duo_init(struct duo *duo, const struct chain *chain, struct mesh *a, struct mesh *b,
			    const xform *place_a, const xform *place_b)
{
	duo->chain = *chain;
	duo->a = bvh_new(a);
	duo->b = bvh_new(b);
	body_pair_init(&duo->pair, duo->a, duo->b, place_a, place_b, &duo->chain);
}

static inline void duo_release(struct duo *duo)
{
	bvh_free(duo->a);
	bvh_free(duo->b);
}

/* b in a's mesh coordinates at (1-s) q0 + s q1 + off, by the independent kinematics. */
static inline xform duo_pose(const struct duo *duo, const axis_values *q0, const axis_values *q1, double s,
			     const axis_values *off)
{
	struct turned pose = true_pose(&duo->chain, q0, q1, s, off);

	return true_mesh_pose(&pose, &duo->pair.place_a, &duo->pair.place_b);
}

/* A place for b so that its mesh origin is `offset` from a's when the chain stands at q. */
static inline xform place_near(struct random *random, const struct chain *chain, const axis_values *q,
			       const xform *place_a, vec3 offset)
{
	struct turned pose = true_pose(chain, q, q, 0, NULL);
	xform identity = xform_identity(), p = true_mesh_pose(&pose, &identity, &identity);
	xform back = xform_inverse(&p), wanted = random_place(random, 0);

	wanted.translation = offset;
	wanted = xform_mul(place_a, &wanted);
	return xform_mul(&back, &wanted);
}

struct centred_tri {
	tri t;
	vec3 centre;
	double radius;
};

static inline struct centred_tri centred(tri t)
{
	struct centred_tri c = {t, vec3_scale(1 / 3.0, vec3_add(t.p[0], vec3_add(t.p[1], t.p[2]))), 0};

	for (int k = 0; k < 3; k++)
		c.radius = fmax(c.radius, vec3_norm(vec3_sub(t.p[k], c.centre)));
	return c;
}

/* mm: the gap between two triangles along n, less far more than its rounding; no gap along what is nearly no direction. */
static inline double gap_along(const tri *a, const tri *b, vec3 n)
{
	double length = vec3_norm(n), least = INFINITY, greatest = -INFINITY;

	if (!(length > 1e-9))
		return -INFINITY;
	for (int k = 0; k < 3; k++) {
		least = fmin(least, vec3_dot(n, b->p[k]));
		greatest = fmax(greatest, vec3_dot(n, a->p[k]));
	}
	return (least - greatest) / length - 1e-9;
}

static inline vec3 normal_of(const tri *t)
{
	return vec3_cross(vec3_sub(t->p[1], t->p[0]), vec3_sub(t->p[2], t->p[0]));
}

/*
 * mm: the distance of two triangles is greater than this, or it is negative: the widest gap along five directions. It
 * spares most pairs true_distance, which takes a hundred times as long.
 */
static inline double gap_between(const struct centred_tri *a, const struct centred_tri *b)
{
	const vec3 na = normal_of(&a->t), nb = normal_of(&b->t);
	const vec3 directions[5] = {vec3_sub(b->centre, a->centre), na, vec3_scale(-1, na), nb, vec3_scale(-1, nb)};
	double gap = -INFINITY;

	for (int k = 0; k < 5; k++)
		gap = fmax(gap, gap_along(&a->t, &b->t, directions[k]));
	return gap;
}

/* Are two corners, or the middles, less than `most` mm apart? */
static inline bool surely_within(const struct centred_tri *a, const struct centred_tri *b, double most)
{
	double least2 = vec3_norm2(vec3_sub(a->centre, b->centre));

	for (int i = 0; i < 3; i++)
		for (int k = 0; k < 3; k++)
			least2 = fmin(least2, vec3_norm2(vec3_sub(a->t.p[i], b->t.p[k])));
	return most > 0 && least2 < (1 - 1e-12) * most * most;
}

/* The least distance of all pairs of triangles, but no more than `most`. */
static inline double brute_distance(const struct bvh *a, const struct bvh *b, const xform *pose, double most)
{
	struct centred_tri *of_a = mem_alloc(a->mesh.count * sizeof(*of_a));
	double best = most;

	for (size_t i = 0; i < a->mesh.count; i++)
		of_a[i] = centred(tri_of(&a->mesh, i));
	for (size_t j = 0; j < b->mesh.count && best > 0; j++) {
		tri t = tri_of(&b->mesh, j);
		struct centred_tri of_b = centred(tri_transform(&t, pose));

		for (size_t i = 0; i < a->mesh.count && best > 0; i++) {
			double reach = best + of_a[i].radius + of_b.radius;

			if (vec3_norm2(vec3_sub(of_a[i].centre, of_b.centre)) <= reach * reach &&
			    !(gap_between(&of_a[i], &of_b) >= best))
				best = fmin(best, true_distance(&of_a[i].t, &of_b.t));
		}
	}
	free(of_a);
	return best;
}

#endif
