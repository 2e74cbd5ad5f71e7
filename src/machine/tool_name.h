/* tool_name.h - the diameter in the name of a tool, such as "ball 10" or "EM D6". */
#ifndef FIVECHECK_MACHINE_TOOL_NAME_H
#define FIVECHECK_MACHINE_TOOL_NAME_H

#include <stdbool.h>

#include "control/offset_tables.h"

/*
 * Does the name contain twice the tool's diameter, in mm or inch, and not the diameter itself? A number after a single
 * letter other than D, such as R2, L50, Z4 and M8, is not a diameter, nor is the tool's own number.
 */
bool tool_name_tells_twice(const struct tool *tool);

#endif
