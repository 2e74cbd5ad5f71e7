#include "scene/model_check.h"

#include <math.h>

#include "base/math/math_functions.h"
#include "base/minmax.h"
#include "base/units.h"
#include "machine/kinematics_check.h"
#include "scene/missing_check.h"
#include "scene/placed_box.h"
#include "scene/ring_check.h"
#include "scene/setup_check.h"

/* mm: a gauge point or a workholding may be this far from the body that it belongs to (nose rings, cut-outs). */
static const double SPINDLE_OFF = 30;
static const double WORKHOLDING_OFF = 50;
/* mm: a head may reach this far past its gauge point (a ring around the spindle's nose, a guard). */
static const double NOSE = 40;
/*
 * The size of the drawing divided by the longest travel. Outside of this range the units are doubted; real machines
 * have 1 to 8.
 */
static const double SIZE_LEAST = 0.1, SIZE_MOST = 25;

/* The body of a link whose box is nearest to a point; -1: the link has no body. */
static int nearest_body(const struct scene *scene, int link, vec3 point, double *distance)
{
	int nearest = -1;

	*distance = INFINITY;
	for (size_t i = 0; i < scene->body_count; i++) {
		const struct body *body = scene->bodies[i].body;
		double d;

		if (body->link != link || body->role != ROLE_MACHINE)
			continue;
		d = placed_box_distance(placed_box_of(scene, (int)i), point);
		if (d < *distance) {
			*distance = d;
			nearest = (int)i;
		}
	}
	return nearest;
}

static void check_mount(const struct scene *scene, enum doubt_kind kind, int link, vec3 point, double most,
			struct doubts *doubts)
{
	struct doubt doubt = {.kind = kind};

	doubt.body = nearest_body(scene, link, point, &doubt.value);
	if (doubt.body >= 0 && doubt.value > most)
		doubts_add(doubts, &doubt);
}

/* Lines around the spindle's axis, so that they miss bores and keys, and how far each crosses a body. */
enum { LINES = 8 };

/* mm: how far the lines are from the axis. */
static const double LINES_OFF = 15;

struct lines {
	vec3 middle, along;	/* the spindle's axis, in the body's coordinates */
	vec3 across[2];	/* at right angles to it and to each other */
	vec3 from[LINES];
	double ahead[LINES];	/* mm: the farthest crossing in the direction of the tool */
};

static struct lines lines_of(const struct scene *scene, int body)
{
	const struct spindle *spindle = &scene->machine->spindle;
	const xform back = xform_inverse(&scene->bodies[body].body->placement);
	struct lines lines = {.middle = xform_apply(&back, spindle->location),
			      .along = mat3_apply(&back.rotation, spindle->direction)};

	kinematics_sideways(scene->machine, lines.across);
	for (int i = 0; i < 2; i++)
		lines.across[i] = mat3_apply(&back.rotation, lines.across[i]);
	for (int k = 0; k < LINES; k++) {
		double angle = 2 * PI * (k + 0.31) / LINES;
		vec3 p = vec3_mad(lines.middle, LINES_OFF * math_cos(angle), lines.across[0]);

		lines.from[k] = vec3_mad(p, LINES_OFF * math_sin(angle), lines.across[1]);
	}
	return lines;
}

/* Is the triangle so far to one side of the axis that no line meets it? That is so for most of them. */
static bool misses_lines(const struct lines *lines, const mesh_triangle *t)
{
	const double off = 1.1 * LINES_OFF;
	bool misses = false;

	for (int i = 0; i < 2; i++) {
		double a = vec3_dot(lines->across[i], vec3_sub(mesh_corner(t, 0), lines->middle));
		double b = vec3_dot(lines->across[i], vec3_sub(mesh_corner(t, 1), lines->middle));
		double c = vec3_dot(lines->across[i], vec3_sub(mesh_corner(t, 2), lines->middle));

		misses |= (a > off && b > off && c > off) || (a < -off && b < -off && c < -off);
	}
	return misses;
}

static void cross(struct lines *lines, int line, const mesh_triangle *t)
{
	vec3 a = vec3_sub(mesh_corner(t, 0), lines->from[line]), b = vec3_sub(mesh_corner(t, 1), lines->from[line]);
	vec3 c = vec3_sub(mesh_corner(t, 2), lines->from[line]);
	double ab = vec3_dot(lines->along, vec3_cross(a, b)), bc = vec3_dot(lines->along, vec3_cross(b, c));
	double ca = vec3_dot(lines->along, vec3_cross(c, a)), at;

	if (!(ab > 0 && bc > 0 && ca > 0) && !(ab < 0 && bc < 0 && ca < 0))
		return;
	at = vec3_dot(a, vec3_cross(b, c)) / (ab + bc + ca);
	lines->ahead[line] = larger(at, lines->ahead[line]);
}

/* The head is doubted if most of the lines leave it far ahead of the gauge point. */
static void check_head(const struct scene *scene, struct doubts *doubts)
{
	const struct spindle *spindle = &scene->machine->spindle;

	for (size_t i = 0; i < scene->body_count; i++) {
		struct doubt doubt = {.kind = DOUBT_SPINDLE_IN_HEAD, .body = (int)i};
		const struct mesh *mesh;
		struct lines lines;
		int against = 0;

		if (scene->bodies[i].body->link != spindle->link || scene->bodies[i].body->role != ROLE_MACHINE)
			continue;
		mesh = &scene->bodies[i].bvh->mesh;
		lines = lines_of(scene, (int)i);
		for (size_t t = 0; t < mesh->count; t++) {
			if (misses_lines(&lines, &mesh->triangles[t]))
				continue;
			for (int k = 0; k < LINES; k++)
				cross(&lines, k, &mesh->triangles[t]);
		}
		for (int k = 0; k < LINES; k++) {
			against += lines.ahead[k] > NOSE;
			doubt.value = fmax(doubt.value, lines.ahead[k]);
		}
		if (against > LINES / 2)
			doubts_add(doubts, &doubt);
	}
}

static bool is_carried(const struct machine *machine, int link, int carrier)
{
	while (link > 0 && link != carrier)
		link = machine->axes[link - 1].parent;
	return link == carrier;
}

/* The distance of a line from a box. Along the line the distance is convex, so a ternary search finds the least. */
static double line_to_box(vec3 point, vec3 along, struct placed_box box)
{
	double reach = placed_box_distance(box, point) + 2 * placed_box_size(box), low = -reach, high = reach;

	for (int i = 0; i < 200; i++) {
		double a = low + (high - low) / 3, b = high - (high - low) / 3;

		if (placed_box_distance(box, vec3_mad(point, a, along)) <
		    placed_box_distance(box, vec3_mad(point, b, along)))
			high = b;
		else
			low = a;
	}
	return placed_box_distance(box, vec3_mad(point, low, along));
}

/* The box of all bodies of the machine that move with the link; false: there are none, or one has not been read. */
static bool carried_box(const struct scene *scene, int link, struct placed_box *box)
{
	*box = placed_box_empty();
	for (size_t k = 0; k < scene->body_count; k++) {
		const struct body *body = scene->bodies[k].body;

		if (body->role != ROLE_MACHINE || !is_carried(scene->machine, body->link, link))
			continue;
		if (!scene->bodies[k].bvh)
			return false;
		*box = placed_box_union(*box, placed_box_of(scene, (int)k));
	}
	return !isinf(box->least.x);
}

static void check_turning(const struct scene *scene, struct doubts *doubts)
{
	const struct machine *machine = scene->machine;

	for (size_t i = 0; i < machine->axis_count; i++) {
		const struct axis *axis = &machine->axes[i];
		struct doubt doubt = {.kind = DOUBT_ROTARY_MISSES, .axis = (int)i};
		struct placed_box box;

		if (!axis->rotary || axis->checked || !carried_box(scene, (int)i + 1, &box))
			continue;
		doubt.value = line_to_box(axis->location, axis->direction, box);
		if (doubt.value > 1)
			doubts_add(doubts, &doubt);
	}
}

/* Only if all bodies were read can their size be measured. */
static void check_size(const struct scene *scene, struct doubts *doubts)
{
	struct placed_box box = placed_box_empty();
	struct doubt doubt = {.limit = kinematics_longest_travel(scene->machine)};

	for (size_t i = 0; i < scene->body_count; i++) {
		const struct scene_body *body = &scene->bodies[i];

		if (body->body->role != ROLE_MACHINE)
			continue;
		if (!body->bvh || body->body->checked)
			return;
		box = placed_box_union(box, placed_box_of(scene, (int)i));
	}
	if (!(doubt.limit > 0) || isinf(box.least.x))
		return;
	doubt.value = placed_box_size(box);
	doubt.kind = doubt.value < doubt.limit ? DOUBT_BODIES_SMALL : DOUBT_BODIES_LARGE;
	if (doubt.value < SIZE_LEAST * doubt.limit || doubt.value > SIZE_MOST * doubt.limit)
		doubts_add(doubts, &doubt);
}

/* Reads what the checks below look at. */
static bool read_meshes(struct scene *scene, struct diag *diag)
{
	const struct machine *machine = scene->machine;
	bool good = true;

	for (size_t i = 0; i < scene->body_count; i++) {
		const struct body *body = scene->bodies[i].body;

		if (body->role == ROLE_FIXTURE || body->role == ROLE_PART ||
		    (body->role == ROLE_MACHINE &&
		     ((machine->spindle.present && body->link == machine->spindle.link) ||
		      (machine->workholding.present && body->link == machine->workholding.link))))
			good = scene_body_bvh(scene, (int)i, diag) && good;
	}
	return good;
}

bool model_check(struct scene *scene, struct diag *diag)
{
	struct doubts *doubts = &scene->doubts;
	const struct machine *machine = scene->machine;
	const struct spindle *spindle = &machine->spindle;
	const struct workholding *workholding = &machine->workholding;

	kinematics_check(machine, doubts);
	if (!read_meshes(scene, diag))
		return false;
	check_turning(scene, doubts);
	ring_check(scene, doubts);
	if (spindle->present && !spindle->checked) {
		check_head(scene, doubts);
		check_mount(scene, DOUBT_SPINDLE_FAR, spindle->link, spindle->location, SPINDLE_OFF, doubts);
	}
	if (workholding->present && !workholding->checked)
		check_mount(scene, DOUBT_WORKHOLDING_FAR, workholding->link, workholding->frame.translation,
			    WORKHOLDING_OFF, doubts);
	check_size(scene, doubts);
	missing_check(scene, doubts);
	setup_check(scene, doubts, diag);
	return true;
}
