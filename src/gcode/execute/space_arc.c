#include "gcode/execute/space_arc.h"

#include "base/math/math_functions.h"
#include "base/units.h"
#include "gcode/execute/corner_insert.h"
#include "gcode/execute/endpoint.h"
#include "gcode/execute/motion_commands.h"
#include "gcode/execute/probed_axes.h"
#include "gcode/execute/rotated_frame.h"

/* The points are on one line if the sine of the angle between the two chords is less than this. */
#define LEAST_BEND 1e-9

/* An active mode under which these arcs are not supported; NULL: none. */
static const char *hindrance_of(const struct interp *interp)
{
	const struct state *state = &interp->state;

	if (state->tcp == TCP_BY_LENGTH || state->tcp == TCP_BY_MCODE)
		return "tool centre point control";
	if (interp->comp.side != 0)
		return "cutter compensation";
	if (state->feed_mode == FEED_INVERSE_TIME)
		return "inverse time feed (G93)";
	if (state->polar.on)
		return "polar coordinates (G16)";
	if (state->frame.distorts)
		return state->frame.scales ? "scaling (G51)" : "mirror image (G51.1)";
	if (state->cylinder.on)
		return "cylindrical interpolation (G7.1)";
	return state->polar_interpolation.on ? "polar coordinate interpolation (G12.1)" : NULL;
}

static bool check_allowed(struct interp *interp)
{
	const struct state *state = &interp->state;
	const struct block *block = &interp->block;
	const int column = block_motion_column(block);
	const char *hindrance = hindrance_of(interp);

	if (hindrance)
		return fault(&interp->at, column,
			     "G2.4 and G3.4 under %s are not supported; post lines or arcs in a plane", hindrance);
	if (corner_insert_concerns(interp))
		return fault(&interp->at, column, "a corner (,C or ,R) beside G2.4 or G3.4 is not supported");
	for (int slot = SLOT_A; slot < SLOT_COUNT; slot++) {
		if (block_has(block, AXIS_LETTERS[slot]))
			return fault(&interp->at, block_column(block, AXIS_LETTERS[slot]),
				     "%c with G2.4 or G3.4 is not supported; their arc moves X, Y and Z",
				     AXIS_LETTERS[slot]);
	}
	for (int slot = SLOT_X; slot <= SLOT_Z; slot++) {
		if (!interp->config->has_axis[slot])
			return fault(&interp->at, column, "the machine has no %c axis, which G2.4 and G3.4 need",
				     AXIS_LETTERS[slot]);
		if (state->probe_bounded[slot] && !probed_axes_is_known(interp, slot, column))
			return false;
	}
	return (block->letters & letter_bits("XYZ")) || fault(&interp->at, column, "G2.4 and G3.4 need X, Y or Z");
}

/* Finds the arc from the present position through the point to the end, all in straight coordinates. */
static bool find_arc(struct interp *interp, vec3 from, vec3 through, vec3 end, struct canon_arc *arc)
{
	const vec3 u = vec3_sub(through, from), v = vec3_sub(end, from), normal = vec3_cross(u, v);
	vec3 centre, axis;

	if (!(vec3_norm(normal) > LEAST_BEND * vec3_norm(u) * vec3_norm(v)))
		return fault(&interp->at, block_motion_column(&interp->block),
			     "G2.4 and G3.4 need three different points that do not lie on a line: start, point on the "
			     "way, end");
	/* The centre of the circle through the three points, from the start. */
	centre = vec3_scale(1 / (2 * vec3_norm2(normal)),
			    vec3_add(vec3_scale(vec3_norm2(u), vec3_cross(v, normal)),
				     vec3_scale(vec3_norm2(v), vec3_cross(normal, u))));
	axis = vec3_unit(normal);
	/* From the start through the point to the end the tool turns about u x v. */
	arc->sweep = math_atan2(vec3_dot(axis, vec3_cross(vec3_scale(-1, centre), vec3_sub(v, centre))),
				vec3_dot(vec3_scale(-1, centre), vec3_sub(v, centre)));
	if (arc->sweep < 0)
		arc->sweep += 2 * PI;
	arc->centre = rotated_frame_point(&interp->state, vec3_add(from, centre));
	arc->normal = rotated_frame_normal(&interp->state, axis);
	return true;
}

/* Words that the block does not give, and increments, count from the point on the way. */
static bool find_end(struct interp *interp, slot_values *end)
{
	struct state *state = &interp->state;
	const slot_values start = state->position;
	bool good;

	state->position = rotated_frame_position(state, &interp->space_arc.through);
	good = endpoint_find(interp, false, end);
	state->position = start;
	return good;
}

bool space_arc_run(struct interp *interp)
{
	struct space_arc *waiting = &interp->space_arc;
	const bool ends = waiting->on;
	const slot_values start = rotated_frame_straight(&interp->state);
	const bool lost = interp->lost & letter_bits("XYZ");
	struct canon_move move = {.kind = CANON_ARC};
	slot_values end;

	waiting->on = false;
	interp->state.motion = interp->state.path_motion = G2_4;
	if (!check_allowed(interp))
		return false;
	if (!ends) {
		waiting->on = endpoint_find(interp, false, &waiting->through);
		return waiting->on;
	}
	if (!motion_commands_feed(interp, &move.feed) || !find_end(interp, &end))
		return false;
	/* Where the arc starts is not known since a fault: its end is reached all the same. */
	if (lost)
		move.kind = CANON_FEED;
	else if (!find_arc(interp, slot_values_linear(&start), slot_values_linear(&waiting->through),
			   slot_values_linear(&end), &move.arc))
		return false;
	return motion_commands_go(interp, &end, &move);
}

static bool refuse_waiting(struct interp *interp)
{
	interp->space_arc.on = false;
	return fault(&interp->at, 1,
		     "the arc of G2.4 or G3.4 has no end: the block after the point on the way must give X, Y or Z of "
		     "the end, and have no other code");
}

bool space_arc_check_block(struct interp *interp)
{
	const struct block *block = &interp->block;
	bool codes = false;

	if (block->words == 0)
		return true;
	for (int group = 0; group < G_GROUPS; group++)
		codes = codes || (group != G_MOTION && block->g[group] != CODE_NONE);
	for (int group = 0; group < M_GROUPS; group++)
		codes = codes || block->m[group] != CODE_NONE;
	return (!codes && (block->motion == G2_4 || block->motion == G3_4)) || refuse_waiting(interp);
}

bool space_arc_check_end(struct interp *interp)
{
	return !interp->space_arc.on || refuse_waiting(interp);
}
