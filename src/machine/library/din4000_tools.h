/*
 * din4000_tools.h - reads tools of catalogues in the exchange formats of DIN 4000: XML with the root Tool-Data, or a
 * table with a column for each code.
 *
 * A tool is a list of codes with values; the class (NSM) and the picture (BLD) define the codes. The reader knows end
 * mills (DIN 4000-82, pictures 1 and 2), ball nose mills (82, picture 6) and drills (81, picture 1). Lengths are in mm.
 * Source: exports of eight makers for tools with known sizes.
 */
#ifndef FIVECHECK_MACHINE_LIBRARY_DIN4000_TOOLS_H
#define FIVECHECK_MACHINE_LIBRARY_DIN4000_TOOLS_H

#include <stdbool.h>

#include "machine/library/tool_library.h"

/* Does the first line of the text have the columns NSM and BLD? */
bool din4000_table_is(const char *text);

/*
 * Tools get numbers in the order of the file (catalog_tool.h); tools of other classes are left out with a warning.
 * False, reported: the file is faulty.
 */
bool din4000_table_read(struct tool_library *tools, const char *text, const char *path, struct diag *diag);
bool din4000_xml_read(struct tool_library *tools, const char *path, struct diag *diag);

#endif
