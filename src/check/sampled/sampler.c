#include "check/sampled/sampler.h"

#include <math.h>

#include "check/sampled/axis_cache.h"
#include "geom/moved_tri.h"
#include "geom/tolerance.h"
#include "scene/bvh_pair.h"

/* One motion and the pose of one of its samples. */
struct sample {
	struct sampler *sampler;
	const xform *ends;	/* b in a at the ends of the motion */
	xform pose;
	double s;
};

void sampler_init(struct sampler *sampler, const struct body_pair *bodies, double clearance, bool interpolated,
		  double step)
{
	*sampler = (struct sampler){.bodies = *bodies, .clearance = clearance, .interpolated = interpolated,
				    .step = step};
	if (interpolated)
		sampler->cache = axis_cache_new();
}

void sampler_release(struct sampler *sampler)
{
	axis_cache_free(sampler->cache);
	sampler->cache = NULL;
}

/* Does the axis, which may have any length, leave a gap of more than the clearance? */
static bool separates(const tri *a, const tri *b, vec3 n, double clearance)
{
	double length = vec3_norm(n), gap = tri_gap(a, b, n), other = tri_gap(b, a, n);

	return fmax(gap, other) > clearance * length + tri_gap_error(tri_pair_size(a, b), n);
}

static bool meet_conventional(const tri *a, const tri *b, double clearance)
{
	vec3 axes[TRI_AXES_MAX];
	int count = tri_axes(a, b, axes);

	for (int i = 0; i < count; i++)
		if (separates(a, b, axes[i], clearance))
			return false;
	return true;
}

static const struct axis_pair *axes_of(const struct sample *sample, const tri *a, const tri *b, uint32_t i, uint32_t j)
{
	struct axis_cache *cache = sample->sampler->cache;
	const struct axis_pair *known = axis_cache_find(cache, i, j);
	struct axis_pair *fresh;
	tri start, end;

	if (known)
		return known;
	start = tri_transform(b, &sample->ends[0]);
	end = tri_transform(b, &sample->ends[1]);
	fresh = axis_cache_add(cache, i, j);
	paper_axes(a, &start, fresh->start);
	paper_axes(a, &end, fresh->end);
	return fresh;
}

static bool meet_interpolated(const struct sample *sample, const tri *a, const tri *b, const tri *at, uint32_t i,
			      uint32_t j)
{
	const struct axis_pair *axes = axes_of(sample, a, b, i, j);

	for (int k = 0; k < PAPER_AXES; k++)
		if (separates(a, at, vec3_lerp(axes->start[k], axes->end[k], sample->s), sample->sampler->clearance))
			return false;
	return true;
}

static bool leaves_meet(const struct sample *sample, struct leaf of_a, struct leaf of_b, struct contact *contact)
{
	const struct body_pair *bodies = &sample->sampler->bodies;

	for (uint32_t i = of_a.first; i < of_a.first + of_a.count; i++) {
		tri a = tri_of(&bodies->a->mesh, i);

		for (uint32_t j = of_b.first; j < of_b.first + of_b.count; j++) {
			tri b = tri_of(&bodies->b->mesh, j), at = tri_transform(&b, &sample->pose);
			vec3 on_a, on_b;

			if (sample->sampler->interpolated ? !meet_interpolated(sample, &a, &b, &at, i, j)
							  : !meet_conventional(&a, &at, sample->sampler->clearance))
				continue;
			contact->distance = tri_distance(&a, &at, &on_a, &on_b);
			contact->point = vec3_lerp(on_a, on_b, 0.5);
			return true;
		}
	}
	return false;
}

/* Do the bodies meet at the sample's pose? Triangles are tested wherever the boxes overlap. */
static bool bodies_meet(const struct sample *sample, struct sweep *sweep, struct contact *contact)
{
	const struct body_pair *bodies = &sample->sampler->bodies;
	const vec3 no_axis_displacement[VIEWS] = {{0, 0, 0}, {0, 0, 0}};
	const double no_displacement[VIEWS] = {0, 0};
	const xform ends[2] = {sample->pose, sample->pose};
	struct box_motion boxes;
	size_t depth = 1;

	box_motion_init(&boxes, bodies->a, bodies->b, ends, no_axis_displacement, no_displacement);
	sweep_queue_reserve(sweep, 1)[0] = (struct bvh_pair){subtree_root(bodies->a), subtree_root(bodies->b), 0};
	while (depth) {
		struct bvh_pair at = sweep->queue[--depth];
		float apart[BVH_WIDTH], lost[BVH_WIDTH];
		const struct bvh_node *node;
		bool open_a;

		if (at.a.leaf.count && at.b.leaf.count) {
			if (leaves_meet(sample, at.a.leaf, at.b.leaf, contact))
				return true;
			continue;
		}
		open_a = bvh_pair_opens_a(&at.a, &at.b);
		node = &(open_a ? bodies->a : bodies->b)->nodes[open_a ? at.a.leaf.first : at.b.leaf.first];
		boxes_apart(&boxes, open_a ? 0 : 1, node, open_a ? &at.b.box : &at.a.box,
			    (float)sample->sampler->clearance * (1 + FLOAT_MARGIN), apart, lost);
		for (int l = 0; l < node->used; l++) {
			struct subtree child = subtree_child(node, l);

			if (apart[l] > sample->sampler->clearance)
				continue;
			sweep_queue_reserve(sweep, depth + 1)[depth] =
				open_a ? (struct bvh_pair){child, at.b, 0} : (struct bvh_pair){at.a, child, 0};
			depth++;
		}
	}
	return false;
}

/* A position on the path itself: the chord of a curved step may be farther from the path than the tolerance. */
static axis_values position_at(const struct span *span, double s)
{
	axis_values q;

	if (!path_is_straight(span->path))
		return path_position(span->path, (1 - s) * span->u0 + s * span->u1);
	for (int i = 0; i < SLOT_COUNT; i++)
		q.v[i] = (1 - s) * span->q0.v[i] + s * span->q1.v[i];
	return q;
}

static bool look_at_pose(struct sampler *sampler, struct sweep *sweep, const struct motion_step *step,
			 const xform ends[2], double s, struct contact *contact)
{
	struct sample sample = {.sampler = sampler, .ends = ends, .s = s};

	contact->q = position_at(&step->span, s);
	sample.pose = body_pair_pose(&sampler->bodies, &contact->q);
	contact->s = s;
	sampler->samples++;
	return bodies_meet(&sample, sweep, contact);
}

bool sampler_step(struct sampler *sampler, struct sweep *sweep, const struct motion_step *step,
		  struct contact *contact)
{
	double first = floor(step->time / sampler->step) + 1, end = step->time + step->seconds;
	bool started = sampler->started;
	xform ends[2];

	sampler->started = true;
	if (started && first * sampler->step > end)
		return false;
	ends[0] = body_pair_pose(&sampler->bodies, &step->span.q0);
	ends[1] = body_pair_pose(&sampler->bodies, &step->span.q1);
	if (sampler->cache)
		axis_cache_clear(sampler->cache);
	if (!started && look_at_pose(sampler, sweep, step, ends, 0, contact))
		return true;
	for (long n = 0; (first + (double)n) * sampler->step <= end && !sweep->broken_off; n++) {
		sweep->broken_off = cancel_asked(sweep->cancel);
		if (look_at_pose(sampler, sweep, step, ends,
				 ((first + (double)n) * sampler->step - step->time) / step->seconds, contact))
			return true;
	}
	return false;
}
