/* fusion_tools.h - reads tool libraries of Fusion 360 and HSM (.json): a list of tools in "data". */
#ifndef FIVECHECK_MACHINE_LIBRARY_FUSION_TOOLS_H
#define FIVECHECK_MACHINE_LIBRARY_FUSION_TOOLS_H

#include <stdbool.h>

#include "machine/library/tool_library.h"

/*
 * A tool becomes one of the setup, with the number of its post-process properties. The reader uses: of the geometry DC,
 * RE, SIG, TA and tip-diameter for the cutter's shape, LCF, shoulder-length, shoulder-diameter, SFDM and LB for its
 * shank; the segments of shaft and holder; the gauge line from assemblyGaugeLength, else from the holder, else from
 * where the holder would begin. A tool with a shape that a setup cannot describe is left out with a warning; so are
 * holders and lathe tools. False, reported: the file is faulty.
 */
bool fusion_tools_read(struct tool_library *tools, const char *path, struct diag *diag);

#endif
