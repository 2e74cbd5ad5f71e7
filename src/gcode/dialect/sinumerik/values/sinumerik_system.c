#include "gcode/dialect/sinumerik/values/sinumerik_system.h"

#include <string.h>

#include "gcode/dialect/sinumerik/frames/sinumerik_frame.h"
#include "gcode/dialect/sinumerik/frames/sinumerik_open_place.h"
#include "gcode/dialect/sinumerik/frames/sinumerik_place_check.h"
#include "gcode/execute/probed_axes.h"
#include "gcode/execute/work_offset_use.h"

bool sinumerik_system_constant(const char *name, double *value)
{
	/* 840D sl, "High speed settings (CYCLE832)": S_TOLM. */
	static const struct {
		const char *name;
		double value;
	} constants[] = {{"TRUE", 1}, {"FALSE", 0}, {"_OFF", 0}, {"_FINISH", 1}, {"_SEMIFIN", 2}, {"_ROUGH", 3},
			 {"_PRECISION", 4}, {"_ORI_FINISH", 11}, {"_ORI_SEMIFIN", 12}, {"_ORI_ROUGH", 13},
			 {"_ORI_PRECISION", 14}, {"_TOP_SURFACE_SMOOTH_OFF", 0}, {"_TOP_SURFACE_SMOOTH_ON", 100}};

	for (size_t i = 0; i < sizeof(constants) / sizeof(constants[0]); i++) {
		if (!strcmp(constants[i].name, name)) {
			*value = constants[i].value;
			return true;
		}
	}
	return false;
}

int sinumerik_system_of_offset(int n)
{
	return n <= 4 ? n - 1 : SYSTEM_SETTABLE + n - 5;
}

/* "Inch or metric (G70, G700, G71, G710)": with G70 and G71, variables of the control keep its basic unit. */
static double in_unit(const struct interp *interp, int slot, double value)
{
	return slot_is_rotary(slot) ? value : value / sinumerik_of(interp)->feed_scale;
}

/* 840D sl, system variables: actual positions. Here the program is never ahead of the axes. */
static bool read_position(struct interp *interp, const char *name, int slot, int column, double *value)
{
	struct state *state = &interp->state;

	if (!probed_axes_is_known(interp, slot, column) || !sinumerik_open_place_check(interp, column, "a position"))
		return false;
	if (!strcmp(name, "$AA_IM")) {
		if (state->tcp != TCP_OFF && !slot_is_rotary(slot))
			return fault(&interp->at, column, "$AA_IM of %c under TRAORI is not supported",
				     AXIS_LETTERS[slot]);
		*value = in_unit(interp, slot, state->position.v[slot]);
		return true;
	}
	if (!sinumerik_place_check(interp, slot, column))
		return false;
	if (sinumerik_of(interp)->frames.tool_frame && (slot == SLOT_X || slot == SLOT_Y))
		return fault(&interp->at, column, "%s of %c while TOROT or TOFRAME is in force; TOROTOF first", name,
			     AXIS_LETTERS[slot]);
	*value = in_unit(interp, slot, sinumerik_frame_place(interp)->v[slot]);
	return true;
}

static bool is_position(const char *name)
{
	return !strcmp(name, "$AA_IW") || !strcmp(name, "$P_EP") || !strcmp(name, "$AA_IM");
}

/* A program is checked as it runs: no block search, no simulation, no dry run. */
static bool is_zero(const char *name)
{
	static const char *const zero[] = {"$P_SEARCH", "$P_SIM", "$P_ISTEST", "$P_DRYRUN", "$P_SIMUL"};

	for (size_t i = 0; i < sizeof(zero) / sizeof(zero[0]); i++) {
		if (!strcmp(name, zero[i]))
			return true;
	}
	return false;
}

bool sinumerik_system_follows(const char *name, bool axis)
{
	return axis ? is_position(name) : is_zero(name) || !strcmp(name, "$P_TOOLNO") || !strcmp(name, "$P_TOOL");
}

bool sinumerik_system_is_scratch(const char *name)
{
	static const char *const scratch[] = {"$AC_TIMER", "$AC_MARKER", "$AC_PARAM"};

	for (size_t i = 0; i < sizeof(scratch) / sizeof(scratch[0]); i++) {
		if (!strncmp(name, scratch[i], strlen(scratch[i])) && strchr("[", name[strlen(scratch[i])]))
			return true;
	}
	return false;
}

bool sinumerik_system_read(struct interp *interp, const char *name, int slot, int column, double *value)
{
	const struct sinumerik *sinumerik = sinumerik_of(interp);

	if (slot >= 0)
		return read_position(interp, name, slot, column, value);
	if (!strcmp(name, "$P_TOOL") && !sinumerik_place_check_edge(interp, column))
		return false;
	*value = is_zero(name) ? 0 : !strcmp(name, "$P_TOOL") ? sinumerik->tool.edge : interp->state.tool;
	return true;
}

bool sinumerik_system_edge(struct interp *interp, const char *name, int tool, int edge, int column, double *value)
{
	const struct tool *found = tool_table_find(&interp->tools, tool);
	const bool length = !strcmp(name, "$TC_DP3"), radius = !strcmp(name, "$TC_DP6");
	double mm = -1;

	if (!length && !radius)
		return fault(&interp->at, column, "the value of %s is known to the control alone", name);
	if (found && edge == 1)
		mm = length ? found->length_offset : found->diameter / 2;
	for (size_t i = 0; found && i < interp->config->edge_count && edge > 1; i++) {
		const struct tool_edge *other = &interp->config->edges[i];

		if (other->tool == tool && other->number == edge)
			mm = length		       ? other->length + interp->config->length_change
			     : fabs(other->diameter) > 0 ? other->diameter / 2
						   : found->diameter / 2;
	}
	if (mm < 0 || (radius && !(mm > 0)))
		return fault(&interp->at, column, "%s[%d,%d]: the setup defines no %s of edge D%d of tool T%d", name,
			     tool, edge, length ? "length" : "radius", edge, tool);
	*value = in_unit(interp, SLOT_Z, mm);
	return true;
}

bool sinumerik_system_tool(struct interp *interp, int length, int column, double *value)
{
	const struct sinumerik *sinumerik = sinumerik_of(interp);

	if (!sinumerik_place_check_edge(interp, column))
		return false;
	*value = 0;
	/* The setup has the length along the tool, and no other lengths. */
	if (length > 1 || sinumerik->tool.edge == 0 || interp->state.tool == 0)
		return true;
	return sinumerik_system_edge(interp, length ? "$TC_DP3" : "$TC_DP6", interp->state.tool,
				     sinumerik->tool.edge, column, value);
}

bool sinumerik_system_offset(struct interp *interp, int n, int slot, const char *component, int column, double *value)
{
	const int system = sinumerik_system_of_offset(n);

	*value = 0;
	if (!strcmp(component, "FI") || !strcmp(component, "RT") || !strcmp(component, "MI"))
		return true;
	if (!strcmp(component, "SC")) {
		*value = 1;
		return true;
	}
	if (strcmp(component, "TR") != 0)
		return fault(&interp->at, column, "a component of $P_UIFR is TR, FI, RT, SC or MI");
	if (!work_offset_use_require(interp, system, column))
		return false;
	*value = in_unit(interp, slot, interp->state.work[system].v[slot]);
	return true;
}
