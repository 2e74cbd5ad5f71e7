#include "gcode/execute/rotated_frame.h"

#include <math.h>

#include "geom/tolerance.h"

/* The offsets contain the length along Z; this is the correction if the length acts along the turned Z. */
static vec3 turned_length(const struct state *state)
{
	const vec3 along = {0, 0, state->length};

	if (!state->frame.turns_length)
		return (vec3){0, 0, 0};
	return vec3_sub(mat3_apply(&state->frame.turn, along), along);
}

/* The origin of the turned coordinates, relative to the offsets. */
static vec3 frame_origin(const struct state *state)
{
	return vec3_add(state->frame.origin, turned_length(state));
}

vec3 rotated_frame_point(const struct state *state, vec3 straight)
{
	vec3 offset = slot_values_linear(&state->offset);

	if (!state->frame.on)
		return straight;
	return vec3_add(vec3_add(offset, frame_origin(state)),
			mat3_apply(&state->frame.turn, vec3_sub(straight, offset)));
}

vec3 rotated_frame_direction(const struct state *state, vec3 direction)
{
	return state->frame.on ? mat3_apply(&state->frame.turn, direction) : direction;
}

vec3 rotated_frame_normal(const struct state *state, vec3 normal)
{
	vec3 turned = rotated_frame_direction(state, normal);

	if (!state->frame.on || !state->frame.distorts)
		return turned;
	return vec3_scale((state->frame.mirrors ? -1 : 1) / vec3_norm(turned), turned);
}

static vec3 turn_back(const struct rotated_frame *frame, vec3 from_origin)
{
	return frame->distorts ? mat3_apply(&frame->back, from_origin)
			       : mat3_apply_transposed(&frame->turn, from_origin);
}

vec3 rotated_frame_straight_point(const struct state *state, vec3 position)
{
	const vec3 offset = slot_values_linear(&state->offset);

	if (!state->frame.on)
		return position;
	return vec3_add(offset, turn_back(&state->frame, vec3_sub(vec3_sub(position, offset), frame_origin(state))));
}

vec3 rotated_frame_straight_direction(const struct state *state, vec3 direction)
{
	return state->frame.on ? turn_back(&state->frame, direction) : direction;
}

slot_values rotated_frame_straight(const struct state *state)
{
	slot_values straight = state->position;

	if (state->frame.on)
		slot_values_set_linear(&straight,
				       rotated_frame_straight_point(state, slot_values_linear(&state->position)));
	return straight;
}

slot_values rotated_frame_position(const struct state *state, const slot_values *straight)
{
	slot_values position = *straight;

	if (state->frame.on)
		slot_values_set_linear(&position, rotated_frame_point(state, slot_values_linear(straight)));
	return position;
}

void rotated_frame_mark_unsure(struct state *state, const slot_values *before, int code)
{
	slot_values now = rotated_frame_straight(state);
	bool any = false;

	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		bool moved = fabs(now.v[slot] - before->v[slot]) > SAME_COORDINATE;

		state->unsure[slot] = moved;
		any = any || moved;
	}
	state->unsure_code = any ? code : CODE_NONE;
}

const char *rotated_frame_conflict(const struct block *block, int *column)
{
	if (block->g[G_SYSTEM] != CODE_NONE) {
		*column = block->g_column[G_SYSTEM];
		return "a change of offsets";
	}
	if (block->g[G_LENGTH] != CODE_NONE && block->g[G_LENGTH] != G43 && block->g[G_LENGTH] != G49) {
		*column = block->g_column[G_LENGTH];
		return "tool centre point control";
	}
	if (block->m[M_TCP] != CODE_NONE) {
		*column = block->m_column[M_TCP];
		return "tool centre point control";
	}
	if (block->g[G_ROTATION] != CODE_NONE && block->g[G_ROTATION] != G69) {
		*column = block->g_column[G_ROTATION];
		return "a rotation";
	}
	return NULL;
}
