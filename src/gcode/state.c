#include "gcode/state.h"

#include <math.h>
#include <string.h>

#include "base/units.h"

/* Files hold degrees of at most so many steps a unit; their way through radians and back is undone exactly. */
#define DEGREE_STEPS 1e9

double state_from_canonical(int slot, double value)
{
	double exact, rounded;

	if (!slot_is_rotary(slot))
		return value;
	exact = degrees(value);
	rounded = round(exact * DEGREE_STEPS) / DEGREE_STEPS;
	return fabs(radians(rounded) - value) <= 1e-15 * fabs(value) ? rounded : exact;
}

static slot_values from_canonical(const axis_values *values)
{
	slot_values result;

	for (int slot = 0; slot < SLOT_COUNT; slot++)
		result.v[slot] = state_from_canonical(slot, values->v[slot]);
	return result;
}

const char *state_system_name(int system)
{
	static const char *const names[SYSTEM_COUNT] = {"G54", "G55",   "G56",   "G57",  "G58",
							"G59", "G59.1", "G59.2", "G59.3"};

	return names[system];
}

/* "G54" ... "G59.3" to 0 ... 8, or -1. */
static int system_of_name(const char *name)
{
	for (int i = 0; i < SYSTEM_COUNT; i++) {
		if (!strcmp(name, state_system_name(i)))
			return i;
	}
	return -1;
}

void state_set_position(struct state *state, int slot, double value)
{
	state->position.v[slot] = value;
	state->canonical.v[slot] = slot_is_rotary(slot) ? radians(value) : value;
}

void state_update_offset(struct state *state)
{
	for (int slot = 0; slot < SLOT_COUNT; slot++)
		state->offset.v[slot] = state->work[state->system].v[slot] + state->shift.v[slot];
	/* Under TCP the length acts along the spindle and is the sink's business. */
	if (state->tcp == TCP_OFF)
		state->offset.v[SLOT_Z] += state->length;
}

void state_init(struct state *state, const struct gcode_config *config)
{
	*state = (struct state){.motion = CODE_NONE, .plane = G17, .scale = 1, .selected = -1};
	state->tool = config->initial_tool;
	for (size_t i = 0; i < config->work_offset_count; i++) {
		int system = system_of_name(config->work_offsets[i].name);

		if (system < 0)
			continue;
		state->work[system] = from_canonical(&config->work_offsets[i].value);
		state->work_known[system] = true;
	}
	state->reference[0] = state->reference[1] = from_canonical(&config->home);
	for (int slot = 0; slot < SLOT_COUNT; slot++)
		state_set_position(state, slot, state->reference[0].v[slot]);
	state_update_offset(state);
}
