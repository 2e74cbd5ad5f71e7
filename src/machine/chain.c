#include "machine/chain.h"

static struct joint joint_of(const struct axis *axis, double sense)
{
	return (struct joint){axis->slot, axis->rotary, vec3_scale(sense, axis->direction), axis->location};
}

bool machine_link_is_on(const struct machine *machine, int link, int carrier)
{
	while (link > 0 && link != carrier)
		link = machine->axes[link - 1].parent;
	return link == carrier;
}

/* The links from `link` to the base, `link` first; returns their number, without the base. */
static size_t ancestors(const struct machine *machine, int link, int out[SLOT_COUNT])
{
	size_t count = 0;

	for (; link > 0; link = machine->axes[link - 1].parent)
		out[count++] = link;
	return count;
}

void chain_init(struct chain *chain, const struct machine *machine, int fixed, int moved)
{
	int down[SLOT_COUNT], up[SLOT_COUNT];
	size_t ndown = ancestors(machine, fixed, down);
	size_t nup = ancestors(machine, moved, up);

	/* A link that carries both does not move them relative to each other. */
	while (ndown && nup && down[ndown - 1] == up[nup - 1]) {
		ndown--;
		nup--;
	}
	chain->count = 0;
	for (size_t i = 0; i < ndown; i++)
		chain->joints[chain->count++] = joint_of(&machine->axes[down[i] - 1], -1);
	while (nup)
		chain->joints[chain->count++] = joint_of(&machine->axes[up[--nup] - 1], 1);
}

xform chain_pose(const struct chain *chain, const axis_values *q)
{
	xform pose = xform_identity();
	bool turned = false;

	for (size_t i = 0; i < chain->count; i++) {
		const struct joint *joint = &chain->joints[i];
		const double value = q->v[joint->slot];

		if (joint->rotary) {
			const xform turn = xform_turn(joint->location, joint->direction, value);

			pose = xform_mul_turned(&pose, turned, &turn);
			turned = true;
		} else {
			const vec3 way = vec3_scale(value, joint->direction);

			pose.translation =
			    vec3_add(turned ? mat3_apply(&pose.rotation, way) : way, pose.translation);
		}
	}
	return pose;
}

xform machine_pose(const struct machine *machine, int link, const axis_values *q)
{
	struct chain chain;

	chain_init(&chain, machine, 0, link);
	return chain_pose(&chain, q);
}
