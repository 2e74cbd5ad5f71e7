/* dialects.h - the only table of the dialects of programs: a row for each control. */
#ifndef FIVECHECK_CONTROL_DIALECTS_H
#define FIVECHECK_CONTROL_DIALECTS_H

#include <stdbool.h>

#include "control/control_presets.h"

/*
 * ROW(name, title, ...): the name is used in the machine file and after --dialect, and src/gcode/dialect/NAME/ defines
 * dialect_NAME; the title is used in messages; the rest are the members of struct dialect_row that are not 0. The first
 * row is the default.
 */
#define DIALECTS(ROW)                                                                                                  \
	ROW(linuxcnc, "LinuxCNC", .straight_rapids = true)                                                             \
	ROW(fanuc, "Fanuc", .has_parameters = true, .has_tool_vectors = true, .has_length_axis = true,                 \
	    .reads_idle_blocks = true, .presets = presets_of_parameters)                                               \
	ROW(haas, "Haas", .has_parameters = true, .presets = presets_of_settings)                                      \
	ROW(sinumerik, "Sinumerik", .has_parameters = true, .has_frames = true, .reads_idle_blocks = true)             \
	ROW(klartext, "Heidenhain Klartext", .straight_rapids = true, .has_planes = true,                              \
	    .unknown_path =                                                                                            \
		"the control may leave the programmed path by an amount that is not known, and only that path "        \
		"was checked; give CYCL DEF 32 with T, or <controller path_tolerance=\"\">")

/* The properties of a control that are known before any program is read. */
struct dialect_row {
	const char *name;
	const char *title;
	/* Every G0 moves straight to its end. Otherwise a parameter decides, which the machine file gives. */
	bool straight_rapids;
	/*
	 * Parameters of the control define the meaning of a number without a decimal point, and whether axes move when
	 * the length compensation changes. Otherwise the machine file must not have these attributes: least_input,
	 * length_offset_moves, length_after_reference, g53_with_g91.
	 */
	bool has_parameters;
	/*
	 * Programs have frames, edges of tools and planes that a cycle swivels, and parameters say how. Otherwise the
	 * machine file must not tell it: rotation_order, orientation_interpolation, edge_after_tool_change,
	 * t_changes_tool, mirror_toggle, frames_outlive_traori, frames_outlive_cycle800, tool_length_axis,
	 * swivel_axis, swivel_pole, orientation_pole, power_on_work_offset, increments_after_shift.
	 */
	bool has_frames;
	/* A parameter says along which axis G43 acts: tool_length_axis. */
	bool has_length_axis;
	/* A parameter says how many blocks without a move cutter compensation reads past: cutter_comp_idle_blocks. */
	bool reads_idle_blocks;
	/* Blocks may give the direction of the tool (G43.5): orientation_interpolation. */
	bool has_tool_vectors;
	/*
	 * PLANE and cycle 19 tilt the plane, and what the control does there depends on its parameters and its
	 * generation: cycle_19_angles, cycle_11_axes, swivel_pole, plane_retract, plane_rotation, rotary_way,
	 * rotary_angle, m6, tool_def, shift_behind_plane, increments_after_shift.
	 * Cycles of the builder have numbers: <macro> says of one what it does.
	 */
	bool has_planes;
	/* The caution where the control may leave the path by no known amount; NULL: G64 and its like may. */
	const char *unknown_path;
	const struct control_preset *presets;	/* its generations; NULL: none are known */
};

/* In the order of the table. */
extern const struct dialect_row dialect_rows[];

/* The names alone, in the same order, with a NULL behind them. */
extern const char *const dialect_names[];

/* The row with this name, or -1. */
int dialect_row_find(const char *name);

#endif
