#include "scene/pose_clearance.h"

#include <math.h>

#include "machine/chain.h"
#include "scene/coherence.h"

static bool is_present(const struct scene *scene, int body, int tool)
{
	const struct body *own = scene->bodies[body].body;

	return own->tool == 0 || own->tool == tool;
}

bool pose_clearance_counts(const struct scene *scene, const struct scene_pair *pair, int tool)
{
	return scene_pair_needs_check(pair) && pair->status != PAIR_OUT_OF_REACH && !pair->stock &&
	       (pair->steps & STEP_RAPID) && is_present(scene, pair->a, tool) && is_present(scene, pair->b, tool);
}

/* Takes the pair's distance if it is less than the least so far. */
static void measure(struct scene *scene, struct sweep *sweep, size_t index, const axis_values *q,
		    struct pose_clearance *out)
{
	const struct scene_pair *pair = &scene->pairs[index];
	const struct body *a = scene->bodies[pair->a].body;
	const struct chord still = {.q0 = *q, .q1 = *q};
	const struct body_pair bodies = scene_pair_bodies(scene, pair);
	struct nearest_triangles nearest;
	struct contact contact;
	xform pose;

	if (out->distance < INFINITY &&
	    sweep_chord_any(sweep, &bodies, &still, out->distance, 0, &contact) == SWEEP_APART)
		return;
	sweep_nearest_triangles(sweep, &bodies, q, 1, &nearest);
	if (!(nearest.distance < out->distance))
		return;
	pose = machine_pose(scene->machine, a->link, q);
	pose = xform_mul(&pose, &a->placement);
	out->pair = index;
	out->distance = nearest.distance;
	out->on_a = xform_apply(&pose, nearest.on_a);
	out->on_b = xform_apply(&pose, nearest.on_b);
}

void pose_clearance_find(struct scene *scene, struct sweep *sweep, const axis_values *q, int tool, double tolerance,
			 struct pose_clearance *out, enum pose_state *states, struct diag *diag)
{
	*out = (struct pose_clearance){.distance = INFINITY};
	for (size_t i = 0; i < scene->pair_count; i++) {
		const struct scene_pair *pair = &scene->pairs[i];
		struct contact contact;

		states[i] = POSE_CLEAR;
		if (!pose_clearance_counts(scene, pair, tool))
			continue;
		states[i] = static_query_pose(scene, sweep, pair, q, tolerance, &contact, diag);
		out->counts[states[i]]++;
		if (states[i] != POSE_OVERLAP && states[i] != POSE_FAILED)
			measure(scene, sweep, i, q, out);
	}
}
