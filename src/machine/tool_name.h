/* tool_name.h - the diameter that the name of a tool tells, such as "ball 10" or "EM D6". */
#ifndef FIVECHECK_MACHINE_TOOL_NAME_H
#define FIVECHECK_MACHINE_TOOL_NAME_H

#include <stdbool.h>

#include "control/offset_tables.h"

/*
 * Does the name tell twice the diameter of the tool, in mm or inch, and nowhere the diameter itself? A number behind a
 * single letter other than D, such as R2, L50, Z4 and M8, is no diameter, and neither is the tool's own number.
 */
bool tool_name_tells_twice(const struct tool *tool);

#endif
