/* sinumerik_case.h - the machine, the setup and the answers of the control for tests of the sinumerik dialect. */
#ifndef SINUMERIK_CASE_H
#define SINUMERIK_CASE_H

#include "gcode_case.h"

static const struct tool tools[] = {
	{.number = 1, .name = "MILL10", .length = 100, .length_offset = 100, .diameter = 10},
	{.number = 2, .name = "DRILL", .length = 50, .length_offset = 50, .diameter = 5},
	{.number = 3, .name = "TWIN", .length = 50, .length_offset = 50, .diameter = 5},
	{.number = 4, .name = "twin", .length = 60, .length_offset = 60, .diameter = 5},
};
static const struct tool_edge edges[] = {{1, 2, 90, 8}};
static const struct work_offset offsets[] = {{.name = "G54", .value = {{10, 20, 30}}},
					     {.name = "G505", .value = {{1, 2, 3}}}};

/* A table that turns with C on which A tilts the tool (gcode_case.h), a setup, and a control that answers. */
static inline void sinumerik_case_init(struct gcode_case *c)
{
	struct controller *controller = &c->config.controller;

	case_init(c);
	c->config.dialect = &dialect_sinumerik;
	c->config.has_setup = true;
	c->config.tools = tools;
	c->config.tool_count = COUNT(tools);
	c->config.edges = edges;
	c->config.edge_count = 1;
	c->config.work_offsets = offsets;
	c->config.work_offset_count = COUNT(offsets);
	controller->least_input = 0;
	controller->edge_after_tool_change = EDGE_AFTER_TOOL_CHANGE_FIRST;
	controller->mirror_toggle = ANSWER_YES;
	controller->frames_outlive_traori = ANSWER_YES;
	controller->orientation_interpolation = ORIENTATION_INTERPOLATION_AXES;
	controller->rotation_order = ROTATION_ORDER_RPY;
	controller->swivel_axis = SLOT_A;
	controller->tool_change.given = true;
	controller->swivel_retract =
	    (struct control_place){.given = true, .has = {true, true, true}, .value = {{-7, -8, 400}}};
	for (int i = 0; i < 3; i++) {
		controller->references[i].given = true;
		for (int slot = SLOT_X; slot <= SLOT_B; slot++) {
			controller->references[i].has[slot] = true;
			controller->references[i].value.v[slot] = slot > SLOT_Z ? 0 : 100 * (i + 1) + slot;
		}
	}
}

#endif
