#include "scene/coherence.h"

#include <math.h>

#include "base/ablation.h"
#include "base/minmax.h"
#include "geom/support.h"
#include "geom/tolerance.h"

/* Unit vectors closer than this are one axis. */
#define SAME_AXIS 1e-3

/* Measured: with 16 the gain is half as large; 256 costs more than it gains on hollow surfaces. */
#define SUBTREE_TRIANGLES 64

/*
 * The largest number of subtrees that are skipped after failures. Measured: with 255 fewer axes are found; without
 * skipping, the failures cost more than the successes gain.
 */
#define IDLENESS_MAX 15

static void put_first(struct coherence *coherence, struct coherence_axis axis)
{
	int last = coherence->axis_count < COHERENCE_AXES ? coherence->axis_count++ : COHERENCE_AXES - 1;

	for (int i = last; i > 0; i--)
		coherence->axes[i] = coherence->axes[i - 1];
	coherence->axes[0] = axis;
}

/* Moves the axis, which has just proved something, to the front. */
static void move_to_front(struct coherence *coherence, int axis)
{
	struct coherence_axis first = coherence->axes[axis];

	for (; axis > 0; axis--)
		coherence->axes[axis] = coherence->axes[axis - 1];
	coherence->axes[0] = first;
}

static void learn_in(struct coherence *coherence, vec3 n, int frame)
{
	for (int i = 0; i < coherence->axis_count; i++) {
		struct coherence_axis *known = &coherence->axes[i];

		if (known->frame == frame && vec3_norm2(vec3_sub(known->n, n)) < SAME_AXIS * SAME_AXIS) {
			known->n = n;
			move_to_front(coherence, i);
			return;
		}
	}
	put_first(coherence, (struct coherence_axis){n, frame});
}

void coherence_learn(struct coherence *coherence, vec3 n, const xform *pose)
{
	if (!WITH_CACHED_AXES)
		return;
	learn_in(coherence, mat3_apply_transposed(&pose->rotation, n), 1);
	learn_in(coherence, n, 0);
}

/* The axis in a's mesh coordinates at a pose. */
static vec3 axis_at(const struct coherence_axis *axis, const xform *pose)
{
	return axis->frame ? mat3_apply(&pose->rotation, axis->n) : axis->n;
}

/* The extent of a box, |n| . half. */
static double extent(vec3 n, const struct box *box)
{
	return fabs(n.x) * box->half[0] + fabs(n.y) * box->half[1] + fabs(n.z) * box->half[2];
}

static vec3 centre_of(const struct bvh *bvh, const struct box *box)
{
	return (vec3){bvh->origin.x + box->centre[0], bvh->origin.y + box->centre[1], bvh->origin.z + box->centre[2]};
}

/* The gap along n (in a's mesh coordinates) between a's box and b's at a pose. */
static double box_gap(const struct body_pair *pair, const xform *pose, vec3 n, const struct box *a,
		      const struct box *b)
{
	vec3 to = vec3_sub(xform_apply(pose, centre_of(pair->b, b)), centre_of(pair->a, a));

	return vec3_dot(n, to) - extent(n, a) - extent(mat3_apply_transposed(&pose->rotation, n), b);
}

bool coherence_separates_triangles(struct coherence *coherence, const struct motion_interval *interval, const tri *a,
				   const tri *b0, const tri *b1, double clearance)
{
	for (int i = 0; i < coherence->axis_count; i++) {
		const struct coherence_axis *axis = &coherence->axes[i];
		double apart = clearance + interval->displacement[axis->frame];

		if (tri_gap(a, b0, axis_at(axis, &interval->poses[0])) > apart &&
		    tri_gap(a, b1, axis_at(axis, &interval->poses[1])) > apart) {
			move_to_front(coherence, i);
			return true;
		}
	}
	return false;
}

/* The triangles under a subtree. */
struct cluster {
	const mesh_triangle *triangles;
	size_t count;
	int level;	/* of SIMD */
};

static struct cluster cluster_of(const struct bvh *bvh, const struct subtree *subtree)
{
	const struct bvh_node *node;

	if (subtree->leaf.count)
		return (struct cluster){&bvh->mesh.triangles[subtree->leaf.first], subtree->leaf.count,
					bvh->simd_level};
	node = &bvh->nodes[subtree->leaf.first];
	return (struct cluster){&bvh->mesh.triangles[node->begin], node->total, bvh->simd_level};
}

/*
 * Is the gap along an axis more than `apart` at both ends? One of the two sets of triangles is fixed in the axis's
 * frame.
 */
static bool clusters_apart(const struct coherence_axis *axis, const xform poses[2], const struct cluster *a,
			   const struct cluster *b, double apart)
{
	const struct cluster *still = axis->frame ? b : a, *moving = axis->frame ? a : b;
	double own = 0;

	for (int e = 0; e < 2; e++) {
		vec3 in_a = axis_at(axis, &poses[e]), back = mat3_apply_transposed(&poses[e].rotation, in_a);
		vec3 in_b = vec3_scale(-1, axis->frame ? axis->n : back);

		if (!e)
			own = support(still->triangles, still->count, axis->frame ? in_b : in_a,
				      still->level);
		if (!(vec3_dot(in_a, poses[e].translation) - own -
			      support(moving->triangles, moving->count, axis->frame ? in_a : in_b, moving->level) >
		      apart))
			return false;
	}
	return true;
}

bool coherence_separates_subtrees(struct coherence *coherence, const struct motion_interval *interval,
				  const struct body_pair *pair, const struct subtree *a, const struct subtree *b,
				  double clearance)
{
	struct cluster of_a, of_b;

	if (!WITH_SUPPORTS || interval->kind != INTERVAL_CHORD)
		return false;
	of_a = cluster_of(pair->a, a);
	of_b = cluster_of(pair->b, b);
	if (of_a.count > SUBTREE_TRIANGLES || of_b.count > SUBTREE_TRIANGLES)
		return false;
	if (coherence->idle > 0) {
		coherence->idle--;
		return false;
	}
	for (int i = 0; i < coherence->axis_count; i++) {
		double apart =
		    clearance + interval->displacement[coherence->axes[i].frame] + SUPPORT_ROUNDING * pair->extent;

		if (clusters_apart(&coherence->axes[i], interval->poses, &of_a, &of_b, apart)) {
			move_to_front(coherence, i);
			coherence->idleness = 0;
			return true;
		}
	}
	coherence->idle = coherence->idleness;
	coherence->idleness = 2 * coherence->idleness < IDLENESS_MAX ? 2 * coherence->idleness + 1 : IDLENESS_MAX;
	return false;
}

double coherence_gap(struct coherence *coherence, const xform *pose, const struct body_pair *pair, const struct box *a,
		     const struct box *b)
{
	double best = -INFINITY;

	for (int i = 0; i < coherence->axis_count; i++)
		best = larger(best, box_gap(pair, pose, axis_at(&coherence->axes[i], pose), a, b));
	return best;
}
