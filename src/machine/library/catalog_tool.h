/* catalog_tool.h - a tool as makers describe it in their catalogues: without a number, a holder or a place in it. */
#ifndef FIVECHECK_MACHINE_LIBRARY_CATALOG_TOOL_H
#define FIVECHECK_MACHINE_LIBRARY_CATALOG_TOOL_H

#include <stdbool.h>

#include "machine/library/tool_library.h"

enum catalog_shape { CATALOG_MILL, CATALOG_BALL_MILL, CATALOG_DRILL };

/* Lengths in mm, from the tip if not said otherwise, and angles in degrees; NAN: not given. */
struct catalog_tool {
	const char *name;	/* or NULL */
	struct srcloc at;
	enum catalog_shape shape;
	double diameter, overall_length;	/* always needed */
	double corner_radius, chamfer_width, chamfer_angle;	/* of the corner */
	double point_angle;	/* the full one, of a drill */
	double cutting_length;	/* the edges, or the flutes of a drill; always needed */
	double neck_diameter, neck_end;
	double shank_diameter, shank_length;	/* the diameter is needed; the length counts from the other end */
};

/* Everything NAN but the place and the shape. */
struct catalog_tool catalog_tool_empty(struct srcloc at);

/*
 * Adds the tool with the next number of the library. What is not described is taken as thick as what
 * is beside it. Its gauge line is at the end of its shank; a warning says that the holder must be added. A tool whose
 * sizes are not enough, or contradict each other, is left out with a warning. False: reported, an error.
 */
bool catalog_tool_add(struct tool_library *tools, const struct catalog_tool *tool, struct diag *diag);

/* Leaves a tool out, and says why. */
void catalog_tool_leave_out(struct tool_library *tools, const struct catalog_tool *tool, const char *why,
			    struct diag *diag);

/* Tools of a catalogue have no numbers: may they get some (`number_all`)? False: reported. */
bool catalog_tools_are_numbered(bool number_all, const char *path, struct diag *diag);

#endif
