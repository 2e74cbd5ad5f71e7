#include "machine/chain.h"

static xform joint_motion(const struct joint *joint, const axis_values *q)
{
	double value = q->v[joint->slot];

	if (joint->rotary)
		return xform_turn(joint->location, joint->direction, value);
	return (xform){mat3_identity(), vec3_scale(value, joint->direction)};
}

static struct joint joint_of(const struct axis *axis, double sense)
{
	return (struct joint){axis->slot, axis->rotary, vec3_scale(sense, axis->direction), axis->location};
}

/* The links from `link` to the base, `link` first; returns how many, the base not counted. */
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

	/* A link that carries both moves neither against the other. */
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
	xform pose;

	if (chain->count == 0)
		return xform_identity();
	pose = joint_motion(&chain->joints[0], q);
	for (size_t i = 1; i < chain->count; i++) {
		const xform motion = joint_motion(&chain->joints[i], q);

		pose = xform_mul(&pose, &motion);
	}
	return pose;
}

xform machine_pose(const struct machine *machine, int link, const axis_values *q)
{
	struct chain chain;

	chain_init(&chain, machine, 0, link);
	return chain_pose(&chain, q);
}
