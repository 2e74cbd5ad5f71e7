/* config.h - the control, machine and setup data that the interpreter needs. */
#ifndef FIVECHECK_GCODE_CONFIG_H
#define FIVECHECK_GCODE_CONFIG_H

#include <stdbool.h>
#include <stddef.h>

#include "base/axes.h"
#include "base/file_names.h"
#include "control/controller.h"
#include "control/offset_tables.h"
#include "gcode/dialect.h"
#include "gcode/read_options.h"
#include "geom/vec3.h"

/* All pointers are borrowed; the data is constant while a program runs. Lengths in mm, angles in radians. */
struct gcode_config {
	const struct dialect *dialect;
	struct controller controller;
	bool has_axis[SLOT_COUNT];	/* a word for an axis that the machine lacks is an error */
	enum wrap wrap[SLOT_COUNT];
	int half_turn[SLOT_COUNT];	/* with WRAP_SHORTEST: 1 or -1, the direction of half a turn; 0: not known */
	axis_values home;	/* the start of the program; also the default of the first two reference positions */
	bool has_setup;	/* tools, lengths and offsets are known; else any T is accepted, and an H is an error */
	/*
	 * Without a setup, if a program is only read and its path does not matter (fivecheck scan): stands for every
	 * tool and edge that is in no table, whatever its number or name; or NULL.
	 */
	const struct tool *any_tool;
	int initial_tool;
	const struct work_offset *work_offsets;
	size_t work_offset_count;
	const struct tool *tools;
	size_t tool_count;
	const struct tool_edge *edges;
	size_t edge_count;
	const struct length_offset *lengths;
	size_t length_count;
	const struct radius_offset *radii;
	size_t radius_count;
	vec3 work_change;	/* mm: added to the initial value of every work offset, named or not */
	double length_change;	/* mm: added to the initial value of every length offset */
	struct read_options read;
	/* owns the names of the program's files; NULL: the names live as long as the interpreter */
	struct file_names *names;
};

#endif
