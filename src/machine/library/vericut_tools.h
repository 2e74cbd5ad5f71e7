/* vericut_tools.h - reads tool libraries of VERICUT (.tls), which are XML with the root CGTechToolLibrary. */
#ifndef FIVECHECK_MACHINE_LIBRARY_VERICUT_TOOLS_H
#define FIVECHECK_MACHINE_LIBRARY_VERICUT_TOOLS_H

#include <stdbool.h>

#include "machine/library/tool_library.h"

/*
 * A tool becomes one of the setup if its ID is a whole number; if `number_all`, those of other IDs get the numbers that
 * are free, in the order of the library. Cutters and holders are taken over as outlines (SOR) or as the shapes of APT
 * that a setup knows (flat, ball, bull, drill). What cannot be taken over, such as inserts of lathe tools, is left out
 * with a warning, and the whole tool with it. False, reported: the file is faulty.
 */
bool vericut_tools_read(struct tool_library *tools, const char *path, bool number_all, struct diag *diag);

#endif
