/* vericut_tools.h - reads tool libraries of VERICUT (.tls), which are XML with the root CGTechToolLibrary. */
#ifndef FIVECHECK_MACHINE_LIBRARY_VERICUT_TOOLS_H
#define FIVECHECK_MACHINE_LIBRARY_VERICUT_TOOLS_H

#include <stdbool.h>

#include "machine/library/tool_library.h"

/*
 * A tool becomes one of the setup if its ID is a whole number; if `number_all`, tools with other IDs get the free
 * numbers, in the order of the library. Cutters and holders are read as outlines (SOR) or as the shapes of APT that a
 * setup can describe (flat, ball, bull, drill). A tool with any part that cannot be read, such as an insert of a lathe
 * tool, is left out with a warning. False, reported: the file is faulty.
 */
bool vericut_tools_read(struct tool_library *tools, const char *path, bool number_all, struct diag *diag);

#endif
