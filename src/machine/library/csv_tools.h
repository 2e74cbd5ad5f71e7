/* csv_tools.h - reads a table of tools with a first line of column names, separated by commas, semicolons or tabs. */
#ifndef FIVECHECK_MACHINE_LIBRARY_CSV_TOOLS_H
#define FIVECHECK_MACHINE_LIBRARY_CSV_TOOLS_H

#include <stdbool.h>

#include "base/diag.h"
#include "machine/library/tool_library.h"

/* Does the first line have a column `number` and another known column? */
bool csv_tools_is(const char *text);

/*
 * Column names may contain blanks, hyphens or underscores, in upper or lower case: number, name, units (mm or inch;
 * else `unit`, mm per unit of length), type (flat, ball, bull, drill, chamfer, probe; else corner radius and point
 * angle determine it), length (gauge line to tip), diameter, corner_radius, point_angle, tip_diameter, flute_length,
 * shank_diameter, stickout (tip to holder), holder_diameter: the shape of the tool; length_offset (H) and radius_offset
 * (D): the control's values for the number. A table without length and diameter has offsets only. A note lists the
 * other columns. False, reported: the file is faulty.
 */
bool csv_tools_read(struct tool_library *tools, const char *text, const char *path, double unit, struct diag *diag);

#endif
