#include "scene/tool_contact.h"

#include <math.h>

#include "machine/motion_bound.h"
#include "machine/tool_solid.h"

/* mm: a corner counts as inside only at this depth, many times the rounding of a pose. */
#define DEPTH 0.01

/* Linear axes that are not perpendicular need more than one round to bring two points together. */
enum { ROUNDS = 3 };

/* The number of corners of the body that are tried, spread over the order of its tree's leaves. */
enum { CORNERS = 128 };

/* The positions of the rotary joints while the linear ones search for a contact: shares of their travel. */
static const double shares[] = {0.5, 0, 1};
enum { SHARES = sizeof(shares) / sizeof(*shares) };

struct look {
	const struct body *piece;
	const struct chain *chain;
	const axis_values *low, *high;
	xform to_piece;	/* machine coordinates at the zero pose -> the piece's */
	vec3 middle;	/* of the piece's longest section, in machine coordinates at the zero pose */
	double radius;	/* mm: the whole piece is within this distance of its middle */
};

static void set_middle(struct look *look)
{
	const struct tool_solid *solid = look->piece->profile;
	double z = solid->top, longest = 0, at = z;

	for (size_t i = 0; i < solid->count; i++) {
		const struct tool_section *s = &solid->sections[i];

		if (s->length > longest) {
			longest = s->length;
			at = z - 0.5 * longest;
		}
		z -= s->length;
		look->radius = fmax(look->radius, 0.5 * fmax(s->diameter, s->diameter_end));
	}
	/* No point of the piece is farther from its middle. */
	look->radius += fmax(solid->top - at, at - z);
	look->middle = xform_apply(&look->piece->placement, (vec3){0, 0, at});
}

/* The linear joints at the position `at`, whose rotary joints stay. */
struct stand {
	axis_values at;
	struct chain_state state;
	vec3 middle;	/* of the piece, in the body's coordinates */
};

static struct stand stand_at(const struct look *look, const axis_values *at)
{
	const struct ball nothing = {{0, 0, 0}, 0};
	struct stand stand = {.at = *at};

	chain_state_init(&stand.state, look->chain, at, &nothing, &nothing);
	stand.middle = xform_apply(&stand.state.pose, look->middle);
	return stand;
}

/* Moves the linear joints so that the piece's middle comes to the corner; returns the remaining distance in mm. */
static double approach(const struct look *look, const struct stand *stand, vec3 corner, axis_values *q)
{
	const struct chain *chain = look->chain;
	vec3 way = vec3_sub(corner, stand->middle);

	*q = stand->at;
	for (int k = 0; k < ROUNDS; k++) {
		for (size_t i = 0; i < chain->count; i++) {
			int slot = chain->joints[i].slot;
			double from = q->v[slot], to = from + vec3_dot(way, stand->state.direction[i]);

			if (chain->joints[i].rotary)
				continue;
			q->v[slot] = fmin(fmax(to, look->low->v[slot]), look->high->v[slot]);
			way = vec3_mad(way, from - q->v[slot], stand->state.direction[i]);
		}
	}
	return vec3_norm(way);
}

/* Is the corner inside the piece at q? */
static bool is_inside(const struct look *look, vec3 corner, const axis_values *q)
{
	const xform pose = chain_pose(look->chain, q), back = xform_inverse(&pose);

	corner = xform_apply(&back, corner);
	return tool_solid_contains(look->piece->profile, xform_apply(&look->to_piece, corner), DEPTH);
}

static bool try_corner(struct tool_contact *last, const struct look *look, const struct stand *stand, vec3 corner)
{
	axis_values q;

	if (approach(look, stand, corner, &q) > look->radius || !is_inside(look, corner, &q))
		return false;
	*last = (struct tool_contact){true, q, corner};
	return true;
}

static axis_values share_of_travel(const struct look *look, double share)
{
	axis_values q;

	for (int k = 0; k < SLOT_COUNT; k++)
		q.v[k] = look->low->v[k] + share * (look->high->v[k] - look->low->v[k]);
	return q;
}

/* The position, moved into the travel. */
static axis_values within_travel(const struct look *look, axis_values q)
{
	for (int k = 0; k < SLOT_COUNT; k++)
		q.v[k] = fmin(fmax(q.v[k], look->low->v[k]), look->high->v[k]);
	return q;
}

static bool try_corners(struct tool_contact *last, const struct look *look, const axis_values *at,
			const struct body *body, const struct mesh *mesh)
{
	const struct stand stand = stand_at(look, at);

	for (size_t i = 0; i < mesh->count; i += mesh->count / CORNERS + 1) {
		vec3 corner = xform_apply(&body->placement, mesh_corner(&mesh->triangles[i], 0));

		if (try_corner(last, look, &stand, corner))
			return true;
	}
	return false;
}

bool tool_contact_finds(struct tool_contact *last, const struct body *body, const struct bvh *tree,
			const struct body *piece, const struct chain *chain, const axis_values *low,
			const axis_values *high)
{
	struct look look = {piece, chain, low, high, xform_inverse(&piece->placement), {0, 0, 0}, 0};

	set_middle(&look);
	if (last->known) {
		const axis_values near = within_travel(&look, last->at);
		const struct stand stand = stand_at(&look, &near);

		if (try_corner(last, &look, &stand, last->corner))
			return true;
	}
	for (int s = 0; s < SHARES; s++) {
		const axis_values at = share_of_travel(&look, shares[s]);

		if (try_corners(last, &look, &at, body, &tree->mesh))
			return true;
	}
	return false;
}
