#include "gcode/state.h"

#include <math.h>
#include <string.h>

#include "base/same_double.h"
#include "base/units.h"

/* Steps per degree: values without finer digits are restored from radians exactly as in the file. */
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

#define NINE(prefix) \
	prefix "1", prefix "2", prefix "3", prefix "4", prefix "5", prefix "6", prefix "7", prefix "8", prefix "9"
#define TEN(prefix) prefix "0", NINE(prefix)
#define NINE_TENS(prefix) \
	TEN(prefix "1"), TEN(prefix "2"), TEN(prefix "3"), TEN(prefix "4"), TEN(prefix "5"), TEN(prefix "6"), \
	    TEN(prefix "7"), TEN(prefix "8"), TEN(prefix "9")

const char *state_system_name(int system)
{
	static const char *const names[SYSTEMS_ALL] = {
	    "G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3",
	    NINE("G54.1 P"), NINE_TENS("G54.1 P"),
	    TEN("G54.1 P10"), NINE_TENS("G54.1 P1"),
	    TEN("G54.1 P20"), NINE_TENS("G54.1 P2"), "G54.1 P300",
	    "G505", "G506", "G507", "G508", "G509", NINE_TENS("G5"), "G500"};

	return names[system];
}

/* The number of a work offset by its name, or -1. */
static int system_of_name(const char *name)
{
	for (int i = 0; i < SYSTEM_NONE; i++) {
		if (!strcmp(name, state_system_name(i)))
			return i;
	}
	return -1;
}

static double to_canonical(int slot, double value)
{
	return slot_is_rotary(slot) ? radians(value) : value;
}

static void update_origin(struct state *state)
{
	struct canon_origin *origin = &state->origin;

	origin->work_offset = state_system_name(state->system);
	for (int slot = 0; slot < SLOT_COUNT; slot++) {
		bool carried = state->dynamic.on && slot <= SLOT_Z;
		double work = carried ? state->dynamic.zero.v[slot] : state->work[state->system].v[slot];

		origin->work.v[slot] = to_canonical(slot, work);
		origin->shift.v[slot] = carried ? 0 : to_canonical(slot, state->shift.v[slot]);
	}
}

void state_update_offset(struct state *state)
{
	update_origin(state);
	for (int slot = 0; slot < SLOT_COUNT; slot++)
		state->offset.v[slot] = state->work[state->system].v[slot] + state->shift.v[slot];
	for (int slot = SLOT_X; slot <= SLOT_Z && state->dynamic.on; slot++)
		state->offset.v[slot] = state->dynamic.zero.v[slot];
	/* Under TCP the length acts along the spindle: the kinematics applies it. */
	if (state->tcp == TCP_OFF)
		state->offset.v[SLOT_Z] += state->length;
}

/* Axes without a reference position use home. */
static void init_references(struct state *state, const struct gcode_config *config)
{
	for (int i = 0; i < 2; i++) {
		state->reference[i] = from_canonical(&config->home);
		for (int slot = 0; slot < SLOT_COUNT; slot++) {
			if (config->controller.references[i].has[slot])
				state->reference[i].v[slot] =
				    state_from_canonical(slot, config->controller.references[i].value.v[slot]);
		}
	}
}

enum feed_mode state_feed_mode(int code)
{
	return code == G93 ? FEED_INVERSE_TIME : code == G95 ? FEED_PER_REVOLUTION : FEED_PER_MINUTE;
}

double state_unit(int code)
{
	return code == G20 ? MM_PER_INCH : 1;
}

int state_motion_after_g80(const struct state *state, const struct dialect_traits *traits)
{
	return traits->cycles_apart == ANSWER_YES ? state->path_motion : CODE_NONE;
}

/* The modes at power-on: those of the dialect, or else of the machine file. */
static struct power_on power_on_of(const struct gcode_config *config)
{
	static const int units[] = {0, G21, G20}, distances[] = {0, G90, G91}, planes[] = {0, G17, G18, G19};
	struct power_on on = config->dialect->traits.power_on;

	if (on.units_of_control && same_double(config->controller.unit, MM_PER_INCH))
		on.units = G20;
	on.units = on.units ? on.units : units[config->controller.power_on_units];
	on.distance = on.distance ? on.distance : distances[config->controller.power_on_distance];
	on.plane = on.plane ? on.plane : planes[config->controller.power_on_plane];
	return on;
}

static void init_modes(struct state *state, const struct gcode_config *config)
{
	const struct dialect_traits *traits = &config->dialect->traits;
	const struct power_on own = power_on_of(config), *on = &own;

	if (on->asks_motion && config->controller.power_on_motion != POWER_ON_MOTION_UNKNOWN)
		state->motion = state->path_motion =
		    config->controller.power_on_motion == POWER_ON_RAPID ? G0 : G1;
	state->plane = on->plane ? on->plane : G17;
	state->incremental = on->distance == G91;
	state->arc_absolute = traits->arc_centre == ARC_CENTRE_ABSOLUTE;
	state->scale = state_unit(on->units);
	state->feed_mode = state_feed_mode(on->feed_mode);
	/* If the path mode is not known, the control may leave the path. */
	state->blend = on->path != G61;
	state->unknown_modes = (on->units ? 0U : 1U << G_UNITS) | (on->distance ? 0U : 1U << G_DISTANCE) |
			       (on->plane ? 0U : 1U << G_PLANE) | (on->feed_mode ? 0U : 1U << G_FEED_MODE) |
			       (traits->arc_centre ? 0U : 1U << G_ARC_DISTANCE);
}

void state_init(struct state *state, const struct gcode_config *config)
{
	*state = (struct state){.motion = CODE_NONE,
				.path_motion = CODE_NONE,
				.retract = CODE_NONE,
				.selected = -1,
				.selected_next = -1,
				.length_number = -1,
				.length_code = G49,
				.length_doubt = CODE_NONE,
				.unsure_code = CODE_NONE,
				.dynamic.unsure_code = CODE_NONE};
	init_modes(state, config);
	state->tool = config->initial_tool;
	for (size_t i = 0; i < config->work_offset_count; i++) {
		int system = system_of_name(config->work_offsets[i].name);

		if (system < 0)
			continue;
		state->work[system] = from_canonical(&config->work_offsets[i].value);
		state->work_known[system] = true;
	}
	for (int system = 0; system < SYSTEM_NONE; system++) {
		const double change[3] = {config->work_change.x, config->work_change.y, config->work_change.z};

		for (int slot = SLOT_X; slot <= SLOT_Z; slot++)
			state->work[system].v[slot] += config->has_axis[slot] ? change[slot] : 0;
	}
	init_references(state, config);
	for (int slot = 0; slot < SLOT_COUNT; slot++)
		state_set_position(state, slot, state_from_canonical(slot, config->home.v[slot]));
	state_update_offset(state);
}
