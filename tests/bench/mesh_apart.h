/* mesh_apart.h - the distance of two solids by a plain binary tree of boxes over each, tried in both frames. */
#ifndef BENCH_MESH_APART_H
#define BENCH_MESH_APART_H

#include "tri_apart.h"

/* Children, or with left < 0 the triangles from first on. */
struct box_node {
	vec middle, half;
	int left, right;
	int first, count;
};

struct box_tree {
	struct triangle *triangles;	/* a copy in the order of the leaves */
	struct box_node *nodes;
	int node_count;
};

enum { LEAF_TRIANGLES = 1 };

struct sort_key {
	double at;
	struct triangle triangle;
};

static inline int by_key(const void *a, const void *b)
{
	double x = ((const struct sort_key *)a)->at, y = ((const struct sort_key *)b)->at;

	return (x > y) - (x < y);
}

static inline void sort_along(struct triangle *t, int count, int k)
{
	struct sort_key *keys = (struct sort_key *)malloc((size_t)count * sizeof(*keys));

	for (int i = 0; i < count; i++) {
		vec s = add(t[i].p[0], add(t[i].p[1], t[i].p[2]));

		keys[i].at = k == 0 ? s.x : k == 1 ? s.y : s.z;
		keys[i].triangle = t[i];
	}
	qsort(keys, (size_t)count, sizeof(*keys), by_key);
	for (int i = 0; i < count; i++)
		t[i] = keys[i].triangle;
	free(keys);
}

static inline int box_build(struct box_tree *tree, int first, int count)
{
	struct triangle *t = tree->triangles + first;
	int id = tree->node_count++;
	struct box_node node = {{0, 0, 0}, {0, 0, 0}, -1, -1, first, count};
	vec low = {INFINITY, INFINITY, INFINITY}, high = {-INFINITY, -INFINITY, -INFINITY}, size;

	for (int i = 0; i < count; i++) {
		for (int k = 0; k < 3; k++) {
			vec p = t[i].p[k];

			low = vec_of(fmin(low.x, p.x), fmin(low.y, p.y), fmin(low.z, p.z));
			high = vec_of(fmax(high.x, p.x), fmax(high.y, p.y), fmax(high.z, p.z));
		}
	}
	node.middle = times(0.5, add(low, high));
	node.half = times(0.5, sub(high, low));
	if (count > LEAF_TRIANGLES) {
		size = sub(high, low);
		sort_along(t, count, size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2);
		node.left = box_build(tree, first, count / 2);
		node.right = box_build(tree, first + count / 2, count - count / 2);
	}
	tree->nodes[id] = node;
	return id;
}

static inline struct box_tree box_tree_of(const struct solid *solid)
{
	struct box_tree tree = {NULL, NULL, 0};

	tree.triangles = (struct triangle *)malloc(solid->count * sizeof(struct triangle));
	memcpy(tree.triangles, solid->triangles, solid->count * sizeof(struct triangle));
	tree.nodes = (struct box_node *)malloc(2 * solid->count * sizeof(struct box_node));
	box_build(&tree, 0, (int)solid->count);
	return tree;
}

/* The triangles that were nearest last; any two will do, better ones save time. */
struct hint {
	int a, b;
};

struct apart_walk {
	const struct box_tree *a, *b;
	const pose *rel;
	double size[3][3];	/* of rel's rotation, entry by entry */
	double best;	/* mm */
	struct hint nearest;
};

static inline double triangles_apart(const struct apart_walk *walk, int i, int j)
{
	struct triangle moved;

	for (int k = 0; k < 3; k++)
		moved.p[k] = apply(walk->rel, walk->b->triangles[j].p[k]);
	return sqrt(tri_apart2(&walk->a->triangles[i], &moved));
}

/* What is left between two boxes on three axes of a frame: the other box reaches `reach` along them. */
static inline double gap_on_axes(vec way, vec half, vec reach)
{
	double x = fabs(way.x) - half.x - reach.x, y = fabs(way.y) - half.y - reach.y,
	       z = fabs(way.z) - half.z - reach.z;

	x = x > 0 ? x : 0;
	y = y > 0 ? y : 0;
	z = z > 0 ? z : 0;
	return sqrt(x * x + y * y + z * z);
}

static inline double boxes_gap(const struct apart_walk *walk, int i, int j)
{
	const struct box_node *a = &walk->a->nodes[i], *b = &walk->b->nodes[j];
	const double (*r)[3] = walk->rel->r, (*s)[3] = walk->size;
	vec way = sub(apply(walk->rel, b->middle), a->middle);
	vec back = vec_of(r[0][0] * way.x + r[1][0] * way.y + r[2][0] * way.z,
			  r[0][1] * way.x + r[1][1] * way.y + r[2][1] * way.z,
			  r[0][2] * way.x + r[1][2] * way.y + r[2][2] * way.z);
	vec reach_b = vec_of(s[0][0] * b->half.x + s[0][1] * b->half.y + s[0][2] * b->half.z,
			     s[1][0] * b->half.x + s[1][1] * b->half.y + s[1][2] * b->half.z,
			     s[2][0] * b->half.x + s[2][1] * b->half.y + s[2][2] * b->half.z);
	vec reach_a = vec_of(s[0][0] * a->half.x + s[1][0] * a->half.y + s[2][0] * a->half.z,
			     s[0][1] * a->half.x + s[1][1] * a->half.y + s[2][1] * a->half.z,
			     s[0][2] * a->half.x + s[1][2] * a->half.y + s[2][2] * a->half.z);

	return fmax(gap_on_axes(way, a->half, reach_b), gap_on_axes(back, b->half, reach_a));
}

static inline void apart_visit(struct apart_walk *walk, int i, int j, double bound)
{
	const struct box_node *a = &walk->a->nodes[i], *b = &walk->b->nodes[j];
	int left[2], right[2];
	double d0, d1;

	if (bound >= walk->best)
		return;
	if (a->left < 0 && b->left < 0) {
		for (int k = a->first; k < a->first + a->count; k++) {
			for (int l = b->first; l < b->first + b->count; l++) {
				double d = triangles_apart(walk, k, l);

				if (d < walk->best) {
					walk->best = d;
					walk->nearest.a = k;
					walk->nearest.b = l;
				}
			}
		}
		return;
	}
	if (b->left < 0 || (a->left >= 0 && dot(a->half, a->half) >= dot(b->half, b->half))) {
		left[0] = a->left;
		right[0] = a->right;
		left[1] = right[1] = j;
	} else {
		left[0] = right[0] = i;
		left[1] = b->left;
		right[1] = b->right;
	}
	d0 = boxes_gap(walk, left[0], left[1]);
	d1 = boxes_gap(walk, right[0], right[1]);
	if (d0 <= d1) {
		apart_visit(walk, left[0], left[1], d0);
		apart_visit(walk, right[0], right[1], d1);
	} else {
		apart_visit(walk, right[0], right[1], d1);
		apart_visit(walk, left[0], left[1], d0);
	}
}

/* The distance, b in a's coordinates by rel; 0 when surfaces cross. */
static inline double mesh_apart(const struct box_tree *a, const struct box_tree *b, const pose *rel, struct hint *hint)
{
	struct apart_walk walk = {a, b, rel, {{0}}, INFINITY, *hint};

	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++)
			walk.size[i][j] = fabs(rel->r[i][j]);
	walk.best = triangles_apart(&walk, hint->a, hint->b);
	apart_visit(&walk, 0, 0, boxes_gap(&walk, 0, 0));
	*hint = walk.nearest;
	return walk.best;
}

#endif
