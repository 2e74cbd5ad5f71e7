/* fusion_tools.h - reads tool libraries of Fusion 360 and HSM (.json): a list of tools in "data". */
#ifndef FIVECHECK_MACHINE_LIBRARY_FUSION_TOOLS_H
#define FIVECHECK_MACHINE_LIBRARY_FUSION_TOOLS_H

#include <stdbool.h>

#include "machine/library/tool_library.h"

/*
 * A tool becomes one of the setup by the number of its post-process properties. Taken over are: of the geometry DC, RE,
 * SIG, TA and tip-diameter as the cutter's shape, LCF, shoulder-length, shoulder-diameter, SFDM and LB as its shank;
 * the segments of shaft and holder; the gauge line from assemblyGaugeLength, else from the holder, else where the
 * holder would begin. Tools of shapes that a setup cannot have are left out with a warning each, and so are holders and
 * the tools of lathes. False, reported: the file is faulty.
 */
bool fusion_tools_read(struct tool_library *tools, const char *path, struct diag *diag);

#endif
