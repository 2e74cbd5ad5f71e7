#include "check/finding.h"

const char *const finding_kind_names[FINDING_KINDS + 1] = {
	[FINDING_COLLISION] = "collision", [FINDING_CLEARANCE] = "clearance", [FINDING_LIMIT] = "limit",
	[FINDING_START_OVERLAP] = "start-overlap", [FINDING_RAPID_CONTACT] = "rapid-contact",
	[FINDING_GOUGE] = "gouge",
};

static const char *link_of(const struct scene *scene, int body)
{
	return machine_link_name(scene->machine, scene->bodies[body].body->link);
}

struct finding finding_of_pair(const struct scene *scene, const struct scene_pair *pair, enum finding_kind kind,
			       const struct contact *contact, int tool)
{
	const struct body *a = scene->bodies[pair->a].body, *b = scene->bodies[pair->b].body;
	xform pose = machine_pose(scene->machine, a->link, &contact->q);

	return (struct finding){
		.kind = kind,
		.axes = contact->q,
		.tool = tool,
		.of.pair = {
			.a = a->name,
			.b = b->name,
			.link_a = link_of(scene, pair->a),
			.link_b = link_of(scene, pair->b),
			.point = xform_apply(&pose, xform_apply(&a->placement, contact->point)),
			.clearance = contact->distance,
			.path_displacement = contact->path_displacement,
			.required = pair->clearance,
			.with_stock = pair->stock,
			.b_is_cutter = b->role == ROLE_CUTTER,
			/* Exactly one of the two is a core; in a pair with the stock none is. */
			.depth = scene->bodies[pair->a].depth + scene->bodies[pair->b].depth + pair->inset,
		},
	};
}

const char *finding_kind_name(enum finding_kind kind)
{
	return finding_kind_names[kind];
}
