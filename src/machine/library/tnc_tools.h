/* tnc_tools.h - reads the tool table of a TNC control (Heidenhain, TOOL.T). */
#ifndef FIVECHECK_MACHINE_LIBRARY_TNC_TOOLS_H
#define FIVECHECK_MACHINE_LIBRARY_TNC_TOOLS_H

#include <stdbool.h>

#include "base/diag.h"
#include "machine/library/tool_library.h"

/* Does the text begin like a table with the columns T, L and R? */
bool tnc_tools_is(const char *text);

/*
 * Without `shapes`, adds the values of each row: its name, and the length (L + DL) and the radius (R + DR) with which
 * the control compensates. A row with an index, such as 5.1, is for the tool with this name.
 *
 * With `shapes`, each row becomes a tool, as far as the table describes it: R, R2, LCUTS, and T-ANGLE of drills, up to
 * the gauge line, because the holder is not in the table. Whether DL and DR are wear or an allowance is not known, so
 * the shape has the larger of both lengths and radii. Rows without a length or a radius are left out with a warning,
 * and only their values are added.
 *
 * Turning, grinding and dressing tools are left out with a warning. With `shapes`, a row with an index must stand below
 * the main one.
 *
 * `unit` is mm per unit of length, for a table that does not say MM or INCH. False, reported: the file is faulty.
 *
 * Sources: iTNC 530 and TNC 640 user's manuals, "Tool data" and "Tool compensation"; TNC7, "Tool table tool.t" and
 * "Indexed tool".
 */
bool tnc_tools_read(struct tool_library *tools, const char *text, const char *path, double unit, bool shapes,
		    struct diag *diag);

#endif
