#include "gcode/dialect/linuxcnc/system_param_names.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "gcode/dialect/linuxcnc/linuxcnc_state.h"
#include "gcode/execute/program_position.h"

enum name {
	NAME_MACHINE,	/* known to the machine only */
	NAME_ABSOLUTE, NAME_ABS_POSITION, NAME_CALL_LEVEL, NAME_CCOMP, NAME_COORD_SYSTEM, NAME_CURRENT_TOOL, NAME_FEED,
	NAME_IJK_ABSOLUTE, NAME_IMPERIAL, NAME_INCREMENTAL, NAME_INVERSE_TIME, NAME_LATHE_DIAMETER,
	NAME_LATHE_RADIUS, NAME_LINE, NAME_METRIC, NAME_MOTION_MODE, NAME_PER_MINUTE, NAME_PER_REVOLUTION, NAME_PLANE,
	NAME_POSITION, NAME_REMAP_LEVEL, NAME_RETRACT_OLD, NAME_RETRACT_R, NAME_RPM, NAME_SELECTED_TOOL,
	NAME_SPINDLE_CSS, NAME_SPINDLE_CW, NAME_SPINDLE_ON, NAME_SPINDLE_RPM, NAME_TOOL_OFFSET, NAME_VALUE,
	NAME_VALUE_RETURNED
};

struct known_name {
	const char *name;
	enum name what;
	int slot;
};

/* Sorted. */
static const struct known_name names[] = {
	{"_a", NAME_POSITION, SLOT_A},
	{"_abs_a", NAME_ABS_POSITION, SLOT_A},
	{"_abs_b", NAME_ABS_POSITION, SLOT_B},
	{"_abs_c", NAME_ABS_POSITION, SLOT_C},
	{"_abs_u", NAME_ABS_POSITION, SLOT_U},
	{"_abs_v", NAME_ABS_POSITION, SLOT_V},
	{"_abs_w", NAME_ABS_POSITION, SLOT_W},
	{"_abs_x", NAME_ABS_POSITION, SLOT_X},
	{"_abs_y", NAME_ABS_POSITION, SLOT_Y},
	{"_abs_z", NAME_ABS_POSITION, SLOT_Z},
	{"_absolute", NAME_ABSOLUTE, 0},
	{"_adaptive_feed", NAME_MACHINE, 0},
	{"_b", NAME_POSITION, SLOT_B},
	{"_c", NAME_POSITION, SLOT_C},
	{"_call_level", NAME_CALL_LEVEL, 0},
	{"_ccomp", NAME_CCOMP, 0},
	{"_coord_system", NAME_COORD_SYSTEM, 0},
	{"_current_pocket", NAME_MACHINE, 0},
	{"_current_tool", NAME_CURRENT_TOOL, 0},
	{"_feed", NAME_FEED, 0},
	{"_feed_hold", NAME_MACHINE, 0},
	{"_feed_override", NAME_MACHINE, 0},
	{"_flood", NAME_MACHINE, 0},
	{"_ijk_absolute_mode", NAME_IJK_ABSOLUTE, 0},
	{"_imperial", NAME_IMPERIAL, 0},
	{"_incremental", NAME_INCREMENTAL, 0},
	{"_inverse_time", NAME_INVERSE_TIME, 0},
	{"_lathe_diameter_mode", NAME_LATHE_DIAMETER, 0},
	{"_lathe_radius_mode", NAME_LATHE_RADIUS, 0},
	{"_line", NAME_LINE, 0},
	{"_metric", NAME_METRIC, 0},
	{"_metric_machine", NAME_MACHINE, 0},
	{"_mist", NAME_MACHINE, 0},
	{"_motion_mode", NAME_MOTION_MODE, 0},
	{"_plane", NAME_PLANE, 0},
	{"_remap_level", NAME_REMAP_LEVEL, 0},
	{"_retract_old_z", NAME_RETRACT_OLD, 0},
	{"_retract_r_plane", NAME_RETRACT_R, 0},
	{"_rpm", NAME_RPM, 0},
	{"_selected_pocket", NAME_MACHINE, 0},
	{"_selected_tool", NAME_SELECTED_TOOL, 0},
	{"_speed_override", NAME_MACHINE, 0},
	{"_spindle_css_mode", NAME_SPINDLE_CSS, 0},
	{"_spindle_cw", NAME_SPINDLE_CW, 0},
	{"_spindle_on", NAME_SPINDLE_ON, 0},
	{"_spindle_rpm_mode", NAME_SPINDLE_RPM, 0},
	{"_task", NAME_MACHINE, 0},
	{"_tool_offset", NAME_TOOL_OFFSET, 0},
	{"_u", NAME_POSITION, SLOT_U},
	{"_units_per_minute", NAME_PER_MINUTE, 0},
	{"_units_per_rev", NAME_PER_REVOLUTION, 0},
	{"_v", NAME_POSITION, SLOT_V},
	{"_value", NAME_VALUE, 0},
	{"_value_returned", NAME_VALUE_RETURNED, 0},
	{"_vmajor", NAME_MACHINE, 0},
	{"_vminor", NAME_MACHINE, 0},
	{"_w", NAME_POSITION, SLOT_W},
	{"_x", NAME_POSITION, SLOT_X},
	{"_y", NAME_POSITION, SLOT_Y},
	{"_z", NAME_POSITION, SLOT_Z},
};

static int compare_names(const void *key, const void *row)
{
	return strcmp(key, ((const struct known_name *)row)->name);
}

static const struct known_name *find_name(const char *name)
{
	if (name[0] != '_')
		return NULL;
	return bsearch(name, names, sizeof(names) / sizeof(*names), sizeof(*names), compare_names);
}

bool system_param_names_has(const char *name)
{
	return find_name(name) != NULL;
}

static bool is_nonzero(double value)
{
	return fpclassify(value) != FP_ZERO;
}

/* Values of modes: codes times ten, or 1 for the active mode. */
static double mode_value(const struct interp *interp, enum name what)
{
	const struct state *state = &interp->state;

	switch (what) {
	case NAME_ABSOLUTE:
		return !state->incremental;
	case NAME_INCREMENTAL:
		return state->incremental;
	case NAME_IJK_ABSOLUTE:
		return state->arc_absolute;
	case NAME_METRIC:
		return !(state->scale > 1);
	case NAME_IMPERIAL:
		return state->scale > 1;
	case NAME_INVERSE_TIME:
		return state->feed_mode == FEED_INVERSE_TIME;
	case NAME_PER_MINUTE:
		return state->feed_mode == FEED_PER_MINUTE;
	case NAME_PER_REVOLUTION:
		return state->feed_mode == FEED_PER_REVOLUTION;
	case NAME_MOTION_MODE:
		return state->motion == CODE_NONE ? G80 : state->motion;
	case NAME_PLANE:
		return state->plane;
	case NAME_COORD_SYSTEM:
		return state->system < 6 ? G54 + 10 * state->system : G59 + state->system - 5;
	case NAME_RETRACT_OLD:
		return state->retract == G98;
	case NAME_RETRACT_R:
		return state->retract != G98;
	case NAME_SPINDLE_ON:
		return state->spindle != SPINDLE_STOPPED;
	case NAME_SPINDLE_CW:
		return state->spindle == SPINDLE_CLOCKWISE;
	case NAME_SPINDLE_RPM:
	case NAME_LATHE_RADIUS:
		return 1;
	case NAME_CCOMP:
		return interp->comp.side > 0 ? 410 : interp->comp.side < 0 ? 420 : 400;
	default:
		return 0;	/* NAME_SPINDLE_CSS, NAME_LATHE_DIAMETER, NAME_REMAP_LEVEL */
	}
}

static bool position_value(struct interp *interp, const struct known_name *known, int column, double *value)
{
	const struct state *state = &interp->state;
	int slot = known->slot;

	if (!program_position_check(interp, slot, column))
		return false;
	if (known->what == NAME_ABS_POSITION && state->tcp != TCP_OFF)
		return fault(&interp->at, column, "#<%s>: machine positions cannot be read under TCP", known->name);
	*value = state->position.v[slot] - (known->what == NAME_POSITION ? state->offset.v[slot] : 0);
	if (!slot_is_rotary(slot))
		*value /= state->scale;
	return true;
}

bool system_param_names_read(struct interp *interp, const char *name, int column, double *value)
{
	const struct params *params = &linuxcnc_of(interp)->params;
	const struct state *state = &interp->state;
	const struct known_name *known = find_name(name);

	assert(known);
	switch (known->what) {
	case NAME_MACHINE:
		return fault(&interp->at, column,
			     "#<%s> depends on the state of the machine, which is not known before the program runs",
			     name);
	case NAME_POSITION:
	case NAME_ABS_POSITION:
		return position_value(interp, known, column, value);
	case NAME_FEED:
		if (state->feed_mode == FEED_INVERSE_TIME)
			return fault(&interp->at, column, "#<_feed> is undefined in inverse time mode (G93)");
		*value = state->feed_linear / state->scale;
		return true;
	case NAME_RPM:
		*value = fabs(state->speed);
		return true;
	case NAME_CURRENT_TOOL:
		*value = state->tool;
		return true;
	case NAME_SELECTED_TOOL:
		*value = state->selected < 0 ? 0 : state->selected;
		return true;
	case NAME_TOOL_OFFSET:
		*value = is_nonzero(state->length);
		return true;
	case NAME_LINE:
		*value = (double)interp->at.line;
		return true;
	case NAME_CALL_LEVEL:
		*value = params->level;
		return true;
	case NAME_VALUE:
	case NAME_VALUE_RETURNED:
		if (params->value_unclear)
			return fault(&interp->at, column,
				     "#<%s> directly after a sub whose endsub has a value: LinuxCNC evaluates that "
				     "value even without a call",
				     name);
		*value = known->what == NAME_VALUE ? params->returned : params->value_returned;
		return true;
	default:
		*value = mode_value(interp, known->what);
		return true;
	}
}

bool system_param_names_check_write(struct interp *interp, const char *name, int column)
{
	if (system_param_names_has(name))
		return fault(&interp->at, column, "#<%s> is read-only", name);
	return true;
}

bool system_param_names_fault_unknown(struct interp *interp, const char *name, int column)
{
	if (!strncmp(name, "_ini[", 5))
		return fault(&interp->at, column,
			     "#<%s> is set in the machine's INI file, which fivecheck does not read", name);
	if (!strncmp(name, "_hal[", 5))
		return fault(&interp->at, column,
			     "#<%s> depends on the state of the machine, which is not known before the program runs",
			     name);
	return fault(&interp->at, column, "there is no parameter #<%s>", name);
}
