#include "geom/boxes.h"

#include <math.h>

#include "geom/tolerance.h"

static void map_init(struct box_map *map, const xform *pose, vec3 from_origin, vec3 to_origin)
{
	const mat3 *m = &pose->rotation;
	vec3 t = vec3_sub(xform_apply(pose, from_origin), to_origin);
	const double rows[3][3] = {{m->x.x, m->y.x, m->z.x}, {m->x.y, m->y.y, m->z.y}, {m->x.z, m->y.z, m->z.z}};

	for (int i = 0; i < 3; i++) {
		for (int j = 0; j < 3; j++) {
			map->r[i][j] = (float)rows[i][j];
			map->abs_r[i][j] = fabsf(map->r[i][j]);
		}
	}
	map->t[0] = (float)t.x;
	map->t[1] = (float)t.y;
	map->t[2] = (float)t.z;
}

static double map_reach(const struct box_map *map)
{
	return sqrt((double)map->t[0] * map->t[0] + (double)map->t[1] * map->t[1] + (double)map->t[2] * map->t[2]);
}

void box_motion_init(struct box_motion *motion, const struct bvh *a, const struct bvh *b, const xform *poses,
		     const vec3 *play, const double *stray)
{
	const struct bvh *own[2] = {a, b}, *other[2] = {b, a};

	for (int v = 0; v < 2; v++) {
		struct box_view *view = &motion->views[v];
		double size = a->radius + b->radius;

		for (int e = 0; e < 2; e++) {
			xform pose = v ? xform_inverse(&poses[e]) : poses[e];

			map_init(&view->ends[e], &pose, other[v]->origin, own[v]->origin);
		}
		size += fmax(map_reach(&view->ends[0]), map_reach(&view->ends[1]));
		size += stray[v] + vec3_norm(play[v]);
		view->play[0] = (float)play[v].x;
		view->play[1] = (float)play[v].y;
		view->play[2] = (float)play[v].z;
		view->stray = (float)(stray[v] + BOX_ROUNDING * size);
	}
}

struct box box_whole(const struct bvh *bvh)
{
	const double half[3] = {bvh->half.x, bvh->half.y, bvh->half.z};
	struct box box = {0};

	for (int k = 0; k < 3; k++)
		box.half[k] = (float)(half[k] * (1 + 0x1p-20)) + 0x1p-126f;
	return box;
}

/* The hull, in a frame, of a box of the other body at both ends of the motion. */
static inline void hull_of(const struct box_view *view, const struct box *box, float low[3], float high[3],
			   float shift[3])
{
	for (int i = 0; i < 3; i++) {
		float c[2], h[2];

		for (int e = 0; e < 2; e++) {
			const float *r = view->ends[e].r[i], *s = view->ends[e].abs_r[i];

			c[e] = r[0] * box->centre[0] + r[1] * box->centre[1] + r[2] * box->centre[2] +
			       view->ends[e].t[i];
			h[e] = s[0] * box->half[0] + s[1] * box->half[1] + s[2] * box->half[2];
		}
		low[i] = (c[0] - h[0] < c[1] - h[1] ? c[0] - h[0] : c[1] - h[1]) - view->play[i];
		high[i] = (c[0] + h[0] > c[1] + h[1] ? c[0] + h[0] : c[1] + h[1]) + view->play[i];
		shift[i] = fabsf(c[1] - c[0]) + 2 * view->play[i];
	}
}

/* A hull is tight along one straight shift and loose by what goes across it: the second largest. */
static inline float second_largest(const float shift[3])
{
	float ab_least = shift[0] < shift[1] ? shift[0] : shift[1];
	float ab_most = shift[0] < shift[1] ? shift[1] : shift[0];
	float c_or_less = ab_most < shift[2] ? ab_most : shift[2];

	return ab_least > c_or_less ? ab_least : c_or_less;
}

/* In the node's frame: the moving box has one hull, the children stand still. */
static void apart_in_own(const struct box_view *view, const struct bvh_node *node, const struct box *other,
			 float square[BVH_WIDTH], float *loose)
{
	float low[3], high[3], shift[3];

	hull_of(view, other, low, high, shift);
	for (int l = 0; l < BVH_WIDTH; l++)
		square[l] = 0;
	for (int i = 0; i < 3; i++) {
		for (int l = 0; l < BVH_WIDTH; l++) {
			float below = low[i] - (node->centre[i][l] + node->half[i][l]);
			float above = (node->centre[i][l] - node->half[i][l]) - high[i];
			float gap = below > above ? below : above;

			gap = gap > 0 ? gap : 0;
			square[l] += gap * gap;
		}
	}
	*loose = second_largest(shift) + view->stray;
}

/* In the box's frame: every child has a hull of its own. */
static void apart_in_other(const struct box_view *view, const struct bvh_node *node, const struct box *other,
			   float square[BVH_WIDTH], float loose[BVH_WIDTH])
{
	float shift[3][BVH_WIDTH];

	for (int l = 0; l < BVH_WIDTH; l++)
		square[l] = 0;
	for (int i = 0; i < 3; i++) {
		const float *r0 = view->ends[0].r[i], *s0 = view->ends[0].abs_r[i], t0 = view->ends[0].t[i];
		const float *r1 = view->ends[1].r[i], *s1 = view->ends[1].abs_r[i], t1 = view->ends[1].t[i];
		float least = other->centre[i] - other->half[i] - view->play[i];
		float most = other->centre[i] + other->half[i] + view->play[i];

		for (int l = 0; l < BVH_WIDTH; l++) {
			float x = node->centre[0][l], y = node->centre[1][l], z = node->centre[2][l];
			float u = node->half[0][l], v = node->half[1][l], w = node->half[2][l];
			float c0 = r0[0] * x + r0[1] * y + r0[2] * z + t0, h0 = s0[0] * u + s0[1] * v + s0[2] * w;
			float c1 = r1[0] * x + r1[1] * y + r1[2] * z + t1, h1 = s1[0] * u + s1[1] * v + s1[2] * w;
			float low = c0 - h0 < c1 - h1 ? c0 - h0 : c1 - h1;
			float high = c0 + h0 > c1 + h1 ? c0 + h0 : c1 + h1;
			float below = least - high, above = low - most;
			float gap = below > above ? below : above;

			gap = gap > 0 ? gap : 0;
			square[l] += gap * gap;
			shift[i][l] = fabsf(c1 - c0) + 2 * view->play[i];
		}
	}
	for (int l = 0; l < BVH_WIDTH; l++)
		loose[l] = second_largest((float[3]){shift[0][l], shift[1][l], shift[2][l]}) + view->stray;
}

void boxes_apart(const struct box_motion *motion, int side, const struct bvh_node *node, const struct box *other,
		 float apart[BVH_WIDTH], float loose[BVH_WIDTH])
{
	float own[BVH_WIDTH], others[BVH_WIDTH], own_loose;

	apart_in_own(&motion->views[side], node, other, own, &own_loose);
	apart_in_other(&motion->views[1 - side], node, other, others, loose);
	for (int l = 0; l < BVH_WIDTH; l++) {
		float in_own = sqrtf(own[l]) * (1 - 0x1p-20f) - motion->views[side].stray;
		float in_other = sqrtf(others[l]) * (1 - 0x1p-20f) - motion->views[1 - side].stray;
		float best = in_own > in_other ? in_own : in_other;

		apart[l] = best > 0 ? best : 0;
		loose[l] = loose[l] < own_loose ? loose[l] : own_loose;
	}
}

float box_pair_apart(const struct box_motion *motion, const struct box *a, const struct box *b, float *loose)
{
	struct bvh_node node = {0};
	float apart[BVH_WIDTH], looses[BVH_WIDTH];

	for (int k = 0; k < 3; k++) {
		for (int l = 0; l < BVH_WIDTH; l++) {
			node.centre[k][l] = a->centre[k];
			node.half[k][l] = a->half[k];
		}
	}
	boxes_apart(motion, 0, &node, b, apart, looses);
	*loose = looses[0];
	return apart[0];
}
