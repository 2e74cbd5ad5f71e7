#include "scene/head_check.h"

#include <math.h>

#include "base/math/math_functions.h"
#include "base/minmax.h"
#include "base/units.h"
#include "machine/kinematics_check.h"

/* mm: a head may reach this far past its gauge point (a ring around the spindle's nose, a guard). */
static const double NOSE = 40;
/* mm: a body drawn in the spindle, such as an arbor, begins at the gauge point to within this distance. */
static const double AT_GAUGE = 1;

/*
 * The number of lines around the spindle's axis, which miss bores and keys. The check finds where each crosses a body.
 */
enum { LINES = 8 };

/* mm: the distance of the lines from the axis. */
static const double LINES_OFF = 15;

struct lines {
	vec3 middle, along;	/* the spindle's axis, in the body's coordinates */
	vec3 across[2];	/* perpendicular to the axis and to each other */
	vec3 from[LINES];
	double ahead[LINES];	/* mm: the farthest crossing in the direction of the tool; 0: none */
	double behind[LINES];	/* mm: the same, the other way */
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

/* Is the triangle so far to one side of the axis that no line can meet it? Most triangles are. */
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
	lines->behind[line] = larger(-at, lines->behind[line]);
}

/* Where a body of the head lies, as most of the lines meet it. */
struct side_view {
	bool ahead, behind;	/* more than NOSE of it is on that side of the gauge point */
	bool any_ahead;	/* one line finds more than NOSE ahead */
	bool in_spindle;	/* the body begins at the gauge point and lies ahead of it */
	double most;	/* mm: how far it reaches ahead */
};

static struct side_view view(const struct scene *scene, int body)
{
	const struct mesh *mesh = &scene->bodies[body].bvh->mesh;
	struct lines lines = lines_of(scene, body);
	int ahead = 0, behind = 0, starts = 0;
	double most = 0;

	for (size_t t = 0; t < mesh->count; t++) {
		if (misses_lines(&lines, &mesh->triangles[t]))
			continue;
		for (int k = 0; k < LINES; k++)
			cross(&lines, k, &mesh->triangles[t]);
	}
	for (int k = 0; k < LINES; k++) {
		ahead += lines.ahead[k] > NOSE;
		behind += lines.behind[k] > NOSE;
		starts += lines.ahead[k] > NOSE && lines.behind[k] < AT_GAUGE;
		most = fmax(most, lines.ahead[k]);
	}
	return (struct side_view){
	    ahead > LINES / 2, behind > LINES / 2, ahead > 0, ahead > LINES / 2 && starts == ahead, most};
}

/* Removes a doubt; false: there was none of this kind. */
static bool remove_doubt(struct doubts *doubts, enum doubt_kind kind)
{
	const size_t before = doubts->count;
	size_t kept = 0;

	for (size_t i = 0; i < doubts->count; i++) {
		if (doubts->items[i].kind != kind)
			doubts->items[kept++] = doubts->items[i];
	}
	doubts->count = kept;
	return kept < before;
}

void head_check(const struct scene *scene, struct doubts *doubts)
{
	bool behind = false, ahead = false;

	for (int pass = 0; pass < 2; pass++) {
		for (size_t i = 0; i < scene->body_count; i++) {
			const struct body *body = scene->bodies[i].body;
			struct side_view seen;

			if (!body_is_of_link(body, scene->machine->spindle.link))
				continue;
			seen = view(scene, (int)i);
			if (pass == 0) {
				behind |= seen.behind && !seen.ahead;
				ahead |= seen.any_ahead;
			} else if (seen.ahead && !(seen.in_spindle && behind)) {
				doubts_add(doubts, &(struct doubt){.kind = DOUBT_SPINDLE_IN_HEAD,
								   .body = (int)i,
								   .value = seen.most});
			}
		}
	}
	if (behind && !ahead && remove_doubt(doubts, DOUBT_SPINDLE_ACROSS)) {
		remove_doubt(doubts, DOUBT_SPINDLE_AWAY);
		remove_doubt(doubts, DOUBT_WORKHOLDING_BESIDE);
	}
}
