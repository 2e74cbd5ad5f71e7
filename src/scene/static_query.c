#include "scene/static_query.h"

#include <math.h>

#include "geom/topology.h"
#include "scene/box_query.h"

static bool in_box(vec3 p, const struct bvh *bvh)
{
	vec3 off = vec3_sub(p, bvh->origin);

	return fabs(off.x) <= bvh->half.x && fabs(off.y) <= bvh->half.y && fabs(off.z) <= bvh->half.z;
}

/* Two bodies at one pose; the coordinates of a are those of the pair's first body. */
struct placed_pair {
	struct box_query boxes;
	int bodies[2];
	xform to[2];	/* the other body's coordinates -> those of bodies[i] */
};

/*
 * One vertex of each component of the body's surface; for a single one, *own is its memory. `together`: the components
 * are either all inside the other body or all outside.
 */
static const vec3 *component_points(struct scene *scene, int body, bool together, vec3 *own, size_t *count)
{
	const struct topology *topology;

	/* A tool's piece that is made of sections is one surface (tool_solid_mesh). */
	if (together || scene->bodies[body].body->profile) {
		*own = mesh_corner(&scene_body_bvh(scene, body)->mesh.triangles[0], 0);
		*count = 1;
		return own;
	}
	topology = scene_body_topology(scene, body);
	*count = topology->component_count;
	return topology->component_point;
}

/* Is a component of the other body inside bodies[side]? *point is in the coordinates of bodies[side]. */
static enum inside holds(struct scene *scene, const struct placed_pair *at, int side, vec3 *point)
{
	const struct bvh *solid = scene_body_bvh(scene, at->bodies[side]);
	const bool together = box_query_parts_surface(&at->boxes, side) &&
			      scene_body_topology(scene, at->bodies[side])->plain;
	enum inside result = INSIDE_NO;
	size_t count;
	vec3 own;
	const vec3 *points = component_points(scene, at->bodies[1 - side], together, &own, &count);

	for (size_t i = 0; i < count; i++) {
		vec3 p = xform_apply(&at->to[side], points[i]);
		enum inside inside = INSIDE_NO;

		if (in_box(p, solid))
			inside = mesh_inside(solid, scene_body_topology(scene, at->bodies[side]), p);
		if (inside == INSIDE_YES) {
			*point = p;
			return INSIDE_YES;
		}
		if (inside == INSIDE_UNKNOWN)
			result = INSIDE_UNKNOWN;
	}
	return result;
}

enum inside static_query_contained(struct scene *scene, const struct scene_pair *pair, const axis_values *q,
				   vec3 *point)
{
	const struct body_pair bodies = scene_pair_bodies(scene, pair);
	struct placed_pair at = {.bodies = {pair->a, pair->b}};
	enum inside in_b, in_a;
	vec3 place;

	at.to[0] = body_pair_pose(&bodies, q);
	at.to[1] = xform_inverse(&at.to[0]);
	box_query_init(&at.boxes, bodies.a, bodies.b, &at.to[0]);
	if (box_query_parts_boxes(&at.boxes))
		return INSIDE_NO;
	in_a = holds(scene, &at, 0, point);
	if (in_a == INSIDE_YES)
		return INSIDE_YES;
	in_b = holds(scene, &at, 1, &place);
	if (in_b == INSIDE_YES)
		*point = xform_apply(&at.to[0], place);
	return in_b == INSIDE_NO ? in_a : in_b;
}

bool static_query_is_outside(struct scene *scene, const struct scene_pair *pair, const struct bvh *shell,
			     const axis_values *q)
{
	const struct bvh *solid = scene_body_bvh(scene, pair->a);
	const struct topology *topology = scene_body_topology(scene, pair->a);
	struct body_pair bodies;
	xform b_in_a, a_in_b;
	vec3 corner;

	body_pair_init(&bodies, solid, shell, &scene->bodies[pair->a].body->placement,
		       &scene->bodies[pair->b].body->placement, &pair->chain);
	b_in_a = body_pair_pose(&bodies, q);
	a_in_b = xform_inverse(&b_in_a);
	corner = xform_apply(&b_in_a, mesh_corner(&shell->mesh.triangles[0], 0));
	if (in_box(corner, solid) && mesh_inside(solid, topology, corner) != INSIDE_NO)
		return false;
	for (size_t i = 0; i < topology->component_count; i++)
		if (in_box(xform_apply(&a_in_b, topology->component_point[i]), shell))
			return false;
	return true;
}

static enum sweep_answer still(struct sweep *sweep, const struct body_pair *bodies, const axis_values *q,
			       double clearance, double tolerance, struct contact *contact)
{
	struct chord chord = {.q0 = *q, .q1 = *q};

	return sweep_chord(sweep, bodies, &chord, clearance, tolerance, contact);
}

enum pose_state static_query_pose(struct scene *scene, struct sweep *sweep, const struct scene_pair *pair,
				  const axis_values *q, double tolerance, struct contact *contact, struct diag *diag)
{
	const struct body_pair bodies = scene_pair_bodies(scene, pair);
	enum inside inside = INSIDE_NO;
	enum sweep_answer answer;
	vec3 point;

	answer = still(sweep, &bodies, q, 0, tolerance, contact);
	if (answer == SWEEP_CONTACT) {
		contact->distance = 0;
		return POSE_OVERLAP;
	}
	if (answer == SWEEP_APART)
		inside = static_query_contained(scene, pair, q, &point);
	if (inside == INSIDE_YES) {
		*contact = (struct contact){0, *q, 0, point, 0};
		return POSE_OVERLAP;
	}
	if (answer == SWEEP_APART && pair->clearance > 0)
		answer = still(sweep, &bodies, q, pair->clearance, tolerance, contact);
	if (answer == SWEEP_UNDECIDED && diag)
		static_query_report_undecided(scene, pair, tolerance, diag);
	if (answer != SWEEP_APART)
		return answer == SWEEP_UNDECIDED ? POSE_FAILED : POSE_NEAR;
	return inside == INSIDE_UNKNOWN ? POSE_UNKNOWN : POSE_CLEAR;
}

bool static_query_overlaps(struct scene *scene, const struct scene_pair *pair, const axis_values *q, double tolerance,
			   vec3 *point, struct diag *diag)
{
	const struct body *a = scene->bodies[pair->a].body;
	const xform link = machine_pose(scene->machine, a->link, q);
	struct contact contact;

	if (static_query_pose(scene, &scene->sweep, pair, q, tolerance, &contact, diag) != POSE_OVERLAP)
		return false;
	*point = xform_apply(&link, xform_apply(&a->placement, contact.point));
	return true;
}

void static_query_report_undecided(const struct scene *scene, const struct scene_pair *pair, double tolerance,
				   struct diag *diag)
{
	diag_error(diag, scene->bodies[pair->b].body->loc,
		   "'%s' and '%s' cannot be decided to within %g mm, because their coordinates are too large; give a "
		   "larger --tolerance or move the drawing nearer to the origin",
		   scene->bodies[pair->a].body->name, scene->bodies[pair->b].body->name, tolerance);
}
