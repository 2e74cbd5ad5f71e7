/* toa_tools.h - tools from the tool data that a Sinumerik control archives (toa_file.h). */
#ifndef FIVECHECK_MACHINE_LIBRARY_TOA_TOOLS_H
#define FIVECHECK_MACHINE_LIBRARY_TOA_TOOLS_H

#include <stdbool.h>

#include "base/diag.h"
#include "machine/library/tool_library.h"

/* Does the text have such data? */
bool toa_tools_is(const char *text);

/*
 * Without `shapes`, adds the values of each edge: length 1 with wear and adapter ($TC_DP3 + $TC_DP12 + $TC_DP21), and
 * the radius with wear ($TC_DP6 + $TC_DP15). D1 is the tool itself. A tool with a name ($TC_TP2) is for the tool of the
 * setup with that name, because programs call it so; a name that is a number is the number that programs call.
 *
 * With `shapes`, each mill, drill and probe becomes a tool, as far as the data describe it: the radius, and the corner
 * of types 110 and 121, up to the gauge line, because the holder is not in the data. Wear may be worn off or an
 * allowance: the shape has the larger of both lengths and radii. D1 need not be at the lower end: the shape encloses
 * all edges.
 *
 * Lathe and grinding tools, angle heads, and, with `shapes`, tapered mills, L and star probes are left out with a
 * warning. A length beside the tool's axis (length 2 or 3) is an error. `unit` is mm per unit of length, for a file
 * without METRIC or INCH. False, reported: the file is faulty.
 *
 * Source: Programming Manual Job Planning, "Tool offsets" (offset memory; tool shapes for 3D offsets).
 */
bool toa_tools_read(struct tool_library *tools, const char *text, const char *path, double unit, bool shapes,
		    struct diag *diag);

#endif
