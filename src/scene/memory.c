#include "scene/memory.h"

#include <math.h>

#include "base/ablation.h"
#include "base/minmax.h"
#include "geom/support.h"
#include "geom/tolerance.h"

/* Unit vectors closer than this are one axis. */
#define SAME_AXIS 1e-3

/* Measured: 16 gain half as much, 256 cost more than they gain where surfaces are hollow. */
#define BRANCH_TRIANGLES 64

/* Branches left out at most after failures; 255 find less, without that many failures cost more than they gain. */
#define IDLENESS_MAX 15

static void put_first(struct memory *memory, struct memory_axis axis)
{
	int last = memory->axis_count < MEMORY_AXES ? memory->axis_count++ : MEMORY_AXES - 1;

	for (int i = last; i > 0; i--)
		memory->axes[i] = memory->axes[i - 1];
	memory->axes[0] = axis;
}

static void learn_in(struct memory *memory, vec3 n, int frame)
{
	for (int i = 0; i < memory->axis_count; i++) {
		struct memory_axis *known = &memory->axes[i];

		if (known->frame == frame && vec3_norm2(vec3_sub(known->n, n)) < SAME_AXIS * SAME_AXIS) {
			known->n = n;
			memory_prefer(memory, i);
			return;
		}
	}
	put_first(memory, (struct memory_axis){n, frame});
}

void memory_learn(struct memory *memory, vec3 n, const xform *pose)
{
	if (!WITH_CACHED_AXES)
		return;
	learn_in(memory, mat3_apply_transposed(&pose->rotation, n), 1);
	learn_in(memory, n, 0);
}

void memory_prefer(struct memory *memory, int axis)
{
	struct memory_axis first = memory->axes[axis];

	for (; axis > 0; axis--)
		memory->axes[axis] = memory->axes[axis - 1];
	memory->axes[0] = first;
}

/* The axis in a's mesh coordinates at a pose. */
static vec3 axis_at(const struct memory_axis *axis, const xform *pose)
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

/* The gap along n (a's mesh coordinates) between a's box and b's at a pose. */
static double box_gap(const struct body_pair *pair, const xform *pose, vec3 n, const struct box *a,
		      const struct box *b)
{
	vec3 to = vec3_sub(xform_apply(pose, centre_of(pair->b, b)), centre_of(pair->a, a));

	return vec3_dot(n, to) - extent(n, a) - extent(mat3_apply_transposed(&pose->rotation, n), b);
}

bool memory_parts_triangles(struct memory *memory, const struct region *region, const tri *a, const tri *b0,
			    const tri *b1, double clearance)
{
	for (int i = 0; i < memory->axis_count; i++) {
		const struct memory_axis *axis = &memory->axes[i];
		double apart = clearance + region->stray[axis->frame];

		if (tri_gap(a, b0, axis_at(axis, &region->poses[0])) > apart &&
		    tri_gap(a, b1, axis_at(axis, &region->poses[1])) > apart) {
			memory_prefer(memory, i);
			return true;
		}
	}
	return false;
}

/* The triangles under a branch. */
struct cluster {
	const mesh_triangle *triangles;
	size_t count;
};

static struct cluster cluster_of(const struct bvh *bvh, const struct branch *branch)
{
	const struct bvh_node *node;

	if (branch->leaf.count)
		return (struct cluster){&bvh->mesh.triangles[branch->leaf.first], branch->leaf.count};
	node = &bvh->nodes[branch->leaf.first];
	return (struct cluster){&bvh->mesh.triangles[node->begin], node->total};
}

/* Is the gap along an axis more than `apart` at both ends? One of the clusters stands still in the axis's frame. */
static bool clusters_apart(const struct memory_axis *axis, const xform poses[2], const struct cluster *a,
			   const struct cluster *b, double apart)
{
	const struct cluster *still = axis->frame ? b : a, *moving = axis->frame ? a : b;
	double own = 0;

	for (int e = 0; e < 2; e++) {
		vec3 in_a = axis_at(axis, &poses[e]), back = mat3_apply_transposed(&poses[e].rotation, in_a);
		vec3 in_b = vec3_scale(-1, axis->frame ? axis->n : back);

		if (!e)
			own = support(still->triangles, still->count, axis->frame ? in_b : in_a);
		if (!(vec3_dot(in_a, poses[e].translation) - own -
			      support(moving->triangles, moving->count, axis->frame ? in_a : in_b) >
		      apart))
			return false;
	}
	return true;
}

bool memory_parts_branches(struct memory *memory, const struct region *region, const struct body_pair *pair,
			   const struct branch *a, const struct branch *b, double clearance)
{
	struct cluster of_a, of_b;

	if (!WITH_SUPPORTS || region->kind != REGION_CHORD)
		return false;
	of_a = cluster_of(pair->a, a);
	of_b = cluster_of(pair->b, b);
	if (of_a.count > BRANCH_TRIANGLES || of_b.count > BRANCH_TRIANGLES)
		return false;
	if (memory->idle > 0) {
		memory->idle--;
		return false;
	}
	for (int i = 0; i < memory->axis_count; i++) {
		double apart = clearance + region->stray[memory->axes[i].frame] + SUPPORT_ROUNDING * pair->reach;

		if (clusters_apart(&memory->axes[i], region->poses, &of_a, &of_b, apart)) {
			memory_prefer(memory, i);
			memory->idleness = 0;
			return true;
		}
	}
	memory->idle = memory->idleness;
	memory->idleness = 2 * memory->idleness < IDLENESS_MAX ? 2 * memory->idleness + 1 : IDLENESS_MAX;
	return false;
}

double memory_gap(struct memory *memory, const xform *pose, const struct body_pair *pair, const struct box *a,
		  const struct box *b)
{
	double best = -INFINITY;

	for (int i = 0; i < memory->axis_count; i++)
		best = larger(best, box_gap(pair, pose, axis_at(&memory->axes[i], pose), a, b));
	return best;
}
