/* catalog_tool.h - a tool as makers describe it in catalogues: without a number, and not in a holder. */
#ifndef FIVECHECK_MACHINE_LIBRARY_CATALOG_TOOL_H
#define FIVECHECK_MACHINE_LIBRARY_CATALOG_TOOL_H

#include <stdbool.h>

#include "machine/library/tool_library.h"

enum catalog_shape { CATALOG_MILL, CATALOG_BALL_MILL, CATALOG_DRILL };

/* Lengths in mm, from the tip unless noted, and angles in degrees; NAN: not given. */
struct catalog_tool {
	const char *name;	/* or NULL */
	struct srcloc at;
	enum catalog_shape shape;
	double diameter, overall_length;	/* always needed */
	double corner_radius, chamfer_width, chamfer_angle;	/* of the corner */
	double point_angle;	/* the full point angle of a drill */
	double cutting_length;	/* the edges, or the flutes of a drill; always needed */
	double neck_diameter, neck_end;
	double shank_diameter, shank_length;	/* the diameter is needed; the length counts from the other end */
};

/* All sizes are NAN; the place is set. */
struct catalog_tool catalog_tool_empty(struct srcloc at);

/*
 * Adds the tool with the next number of the library. A part without a description gets the larger diameter of its
 * neighbours. The gauge line is at the end of the shank; a warning says that the holder must be added. A tool whose
 * sizes are incomplete or contradict each other is left out with a warning. False: an error, reported.
 */
bool catalog_tool_add(struct tool_library *tools, const struct catalog_tool *tool, struct diag *diag);

/* Leaves a tool out and reports the reason. */
void catalog_tool_leave_out(struct tool_library *tools, const struct catalog_tool *tool, const char *why,
			    struct diag *diag);

/* Tools of a catalogue have no numbers: may numbers be assigned (`number_all`)? False: reported. */
bool catalog_tools_are_numbered(bool number_all, const char *path, struct diag *diag);

#endif
